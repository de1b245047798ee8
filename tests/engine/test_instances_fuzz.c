/* test_instances_fuzz - the target fuzz_instances with deterministic mutations
 *
 * PLANELET_SOAK=1 runs a hundred times as many.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/fuzz/fuzz_instances.c"

#include "tests/fuzz/image_mutations.h"
#include "tests/reference/instances_rig.h"

enum { SEEDS = 6, MUTATIONS = 1500 };

static packed seed_image(uint32_t seed) {
    const instances_config c = {
        rig_config_of(1 + seed % 2, rig_is_tiny() ? 1 : 4, PLT_BUILD_HOST, PLT_SPLIT_SAH),
        1 + 2 * seed,
        (enum instances_kind)(seed % 3),
        3.0f,
        1,
        seed};
    return instances_rig_image(&c);
}

/* Most damage is to the header's fields of instances, to bodies and to matrices. */
static uint32_t place(const unsigned char *image, uint32_t size, random_state *r) {
    const uint32_t bodies = hostile_begin(image, 2);
    switch (random_below(r, 5)) {
    case 0:
        return 188 + random_below(r, 28);
    case 1:
        return random_below(r, size);
    case 2:
        return bodies + random_below(r, 3 * PLT_BODY_BYTES + 8);
    default:
        return bodies + random_below(r, size - bodies);
    }
}

int main(void) {
    const uint32_t mutations = mutations_of(MUTATIONS);
    test("mutated images with instances are refused with a reason, or all frames are shown or are");
    for (uint32_t seed = 0; seed < SEEDS; seed++) {
        fuzz(seed, mutations);
    }
    test("of the mutated images some open and some do not, and so do their frames");
    const unsigned long all = SEEDS * (unsigned long)mutations;
    CHECK(images_opened > all / 4 && images_opened < all * 15 / 16, "%lu of %lu", images_opened,
          all);
    CHECK(hostile_frames_all.shown > all && hostile_frames_all.refused > all / 32, "%u and %u",
          hostile_frames_all.shown, hostile_frames_all.refused);
    return test_done();
}

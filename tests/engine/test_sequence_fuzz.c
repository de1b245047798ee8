/* test_sequence_fuzz - the target fuzz_sequence with deterministic mutations
 *
 * PLANELET_SOAK=1 runs a hundred times as many.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/fuzz/fuzz_sequence.c"

#include "tests/fuzz/image_mutations.h"
#include "tests/reference/sequence_rig.h"

enum { SEEDS = 14, FIRST_OF_BLOCKS = 8, MUTATIONS = 3000 };

static packed seed_image(uint32_t seed) {
    static const uint32_t bits[4] = {0, 12, 16, 21};
    const int is_compact = seed >= FIRST_OF_BLOCKS;
    const uint8_t build = (uint8_t)(is_compact ? PLT_BUILD_HOST : seed % 3);
    const sequence_config c = {
        .scene = rig_config_of(1 + seed % 2, rig_is_tiny() ? 1 : 8, build, PLT_SPLIT_SAH),
        .frames = 2 + seed % FIRST_OF_BLOCKS,
        .key_every = 1 + seed % 4,
        .lattice_bits = is_compact ? bits[1 + seed % 3] : bits[seed % 4],
        .is_mapped = 1,
        .is_compact = is_compact,
        .without_ids = seed % 2};
    return sequence_rig_image(&c, rig_triangles(3 + 9 * seed, 1), seed);
}

/* Half of the damage is to the header's fields of the sequence, or to its sections. */
static uint32_t place(const unsigned char *image, uint32_t size, random_state *r) {
    const uint32_t frames = hostile_begin(image, 2);
    switch (random_below(r, 4)) {
    case 0:
        return 168 + random_below(r, 44);
    case 1:
        return random_below(r, size);
    default:
        return frames < size ? frames + random_below(r, size - frames) : 0;
    }
}

int main(void) {
    const uint32_t mutations = mutations_of(MUTATIONS);
    test("mutated images with frames are refused with a reason, or all frames are shown or are");
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

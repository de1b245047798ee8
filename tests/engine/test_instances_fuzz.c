/* test_instances_fuzz - the target fuzz_instances with deterministic mutations
 *
 * PLANELET_SOAK=1 runs a hundred times as many.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/fuzz/fuzz_instances.c"

#include "tests/reference/instances_rig.h"
#include "tests/test.h"

enum { SEEDS = 6, MUTATIONS = 1500 };

typedef struct input {
    unsigned char *bytes; /* the byte that selects options, then the image */
    size_t size;
} input;

static input seed_input(uint32_t seed) {
    const instances_config c = {
        rig_config_of(1 + seed % 2, rig_is_tiny() ? 1 : 4, PLT_BUILD_HOST, PLT_SPLIT_SAH),
        1 + 2 * seed,
        (enum instances_kind)(seed % 3),
        3.0f,
        1,
        seed};
    instances_rig s;
    instances_rig_pack(&s, &c);
    const input in = {malloc(s.image.size + 1), s.image.size + 1};
    memcpy(in.bytes + 1, s.image.bytes, s.image.size);
    instances_rig_close(&s);
    return in;
}

static const uint32_t words[] = {0,          1,          2,          3,          48,
                                 0x7FC00000, 0x7F800000, 0xFF800000, 0x80000000, 0x7FFFFFFF,
                                 0xFFFFFFFF, 0x53800000, 0x53800001, 0x07FFFFFF, 0x00000001};

/* Most damage is to the header's fields of instances, to bodies and to matrices. */
static uint32_t place(const input *in, random_state *r) {
    const uint32_t image = (uint32_t)in->size - 1;
    const uint32_t bodies = plt_get_u32(in->bytes + 1 + 104 + 16 * 2 + 4);
    switch (random_below(r, 5)) {
    case 0:
        return 188 + random_below(r, 28);
    case 1:
        return random_below(r, image);
    case 2:
        return bodies + random_below(r, 3 * PLT_BODY_BYTES + 8);
    default:
        return bodies + random_below(r, image - bodies);
    }
}

static void mutate(input *in, random_state *r) {
    const uint32_t image = (uint32_t)in->size - 1;
    for (uint32_t times = 1 + random_below(r, 3); times > 0; times--) {
        const uint32_t at = place(in, r);
        unsigned char *word = in->bytes + 1 + (at & ~3u) % (image - 3);
        switch (random_below(r, 4)) {
        case 0:
            in->bytes[1 + at] ^= (unsigned char)(1u << random_below(r, 8));
            break;
        case 1:
            in->bytes[1 + at] = (unsigned char)random_bits(r);
            break;
        case 2:
            plt_put_u32(word, words[random_below(r, sizeof words / sizeof words[0])]);
            break;
        default:
            plt_put_u32(word, plt_get_u32(word) + random_below(r, 7) - 3);
        }
    }
}

static void fuzz(uint32_t seed, uint32_t mutations) {
    random_state r = {seed};
    const input in = seed_input(seed);
    for (uint32_t i = 0; i < mutations; i++) {
        input one = {malloc(in.size), in.size};
        memcpy(one.bytes, in.bytes, in.size);
        one.bytes[0] = (unsigned char)(random_bits(&r) | 16);
        mutate(&one, &r);
        CHECK(LLVMFuzzerTestOneInput(one.bytes, one.size) == 0, "seed %u, mutation %u", seed, i);
        free(one.bytes);
    }
    free(in.bytes);
}

int main(void) {
    const char *soak = getenv("PLANELET_SOAK");
    const uint32_t mutations = MUTATIONS * (soak != NULL && soak[0] == '1' ? 100 : 1);
    test("mutated images with instances are refused with a reason, or all frames are shown or are");
    for (uint32_t seed = 0; seed < SEEDS; seed++) {
        fuzz(seed, mutations);
    }
    test("of the mutated images some open and some do not, and so do their frames");
    const unsigned long all = SEEDS * (unsigned long)mutations;
    CHECK(images_opened > all / 4 && images_opened < all * 15 / 16, "%lu of %lu", images_opened,
          all);
    CHECK(hostile_placed_all.shown > all && hostile_placed_all.refused > all / 32, "%u and %u",
          hostile_placed_all.shown, hostile_placed_all.refused);
    return test_done();
}

/* test_compact_fuzz - the target fuzz_blocks with deterministic mutations, for a few seconds
 *
 * PLANELET_SOAK=1 runs a hundred times as many.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/fuzz/fuzz_blocks.c"

#include "tests/hostile/mutations.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { SEEDS = 16, MUTATIONS = 2000, INPUT_MOST = 1 << 14 };

/* The byte that selects options, then the first block of a packed scene. */
static uint32_t seed_input(uint32_t seed, unsigned char input[INPUT_MOST]) {
    mesh m = {0};
    packed image;
    fail f = {""};
    lattice_loss loss;
    const compact_options options = {.build = PLT_BUILD_HOST,
                                     .splits = (uint8_t)(seed & 1),
                                     .lattice_bits = seed & 4 ? 21 : 14,
                                     .floats = (uint8_t)(seed >> 3 & 1),
                                     .leaf_triangles = (seed & 3) == 3 ? 2 : 1u << (seed & 3)};
    if (seed % 3 == 1) { /* shared corners: long strips, references */
        shape_icosphere(&m, 1);
    } else {
        shape_soup(&m, 2 + 2 * seed, seed % 5 == 0 ? 0.01f : 0.7f, seed);
    }
    CHECK(pack_compact(&image, &m, &options, "test", &loss, &f) == 0, "%s", f.text);
    const uint32_t bytes = image.info.node_bytes + image.info.triangle_bytes;
    input[0] = (unsigned char)(seed & 15);
    memcpy(input + 1, compact_section(&image, 0), bytes);
    pack_free(&image);
    mesh_free(&m);
    return bytes + 1;
}

static void mutate(unsigned char *bytes, uint32_t count, random_state *r) {
    for (uint32_t times = 1 + random_below(r, 3); times > 0; times--) {
        const uint32_t at = random_below(r, random_below(r, 2) ? count : 40) % count;
        switch (random_below(r, 4)) {
        case 0:
            bytes[at] ^= (unsigned char)(1u << random_below(r, 8));
            break;
        case 1:
            bytes[at] = (unsigned char)random_bits(r);
            break;
        case 2:
            bytes[at] = random_below(r, 2) ? 0x00 : 0xFF;
            break;
        default:
            bytes[at] = bytes[random_below(r, count)];
        }
    }
}

static void fuzz(uint32_t seed, uint32_t mutations) {
    static unsigned char input[INPUT_MOST], one[INPUT_MOST];
    random_state r = {seed};
    const uint32_t size = seed_input(seed, input);
    const unsigned long before = blocks_valid;
    CHECK(LLVMFuzzerTestOneInput(input, size) == 0 && blocks_valid == before + 1,
          "seed %u: the block itself is not valid", seed);
    for (uint32_t i = 0; i < mutations; i++) {
        memcpy(one, input, size);
        one[0] |= 16;
        mutate(one + 1, size - 1, &r);
        const uint32_t cut = random_below(&r, 30) ? size : random_below(&r, size);
        CHECK(LLVMFuzzerTestOneInput(one, cut) == 0, "seed %u, mutation %u", seed, i);
    }
}

int main(void) {
    const uint32_t mutations = mutations_of(MUTATIONS);
    test("mutated blocks are refused, or are decoded and traced without harm");
    for (uint32_t seed = 0; seed < SEEDS; seed++) {
        fuzz(seed, mutations);
    }
    test("of the mutated blocks some are valid and many are not");
    const unsigned long all = (unsigned long)SEEDS * mutations;
    CHECK(blocks_valid > all / 50 && blocks_valid < all * 9 / 10, "%lu of %lu", blocks_valid, all);
    CHECK(blocks_traced > blocks_valid / 4, "%lu of %lu traced", blocks_traced, blocks_valid);
    printf("    %lu of %lu blocks valid, %lu traced\n", blocks_valid, all, blocks_traced);
    return test_done();
}

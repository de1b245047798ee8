/* test_image_fuzz - the target fuzz_image with deterministic mutations, for a few seconds
 *
 * PLANELET_SOAK=1 runs a hundred times as many.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/fuzz/fuzz_image.c"

#include "tests/fuzz/image_mutations.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"

#define SEEDS 9          /* of thesis images */
#define COMPACT_SEEDS 12 /* and of compact ones */
#define MUTATIONS 5000

/* All bits, list lengths, formats and builds; two of them almost empty. */
static packed compact_image(int seed) {
    static const uint8_t bits[3] = {12, 14, 21};
    mesh m = {0};
    packed image;
    lattice_loss loss;
    fail f = {""};
    const compact_options options = {.splits = (uint8_t)(seed & 1),
                                     .build = seed % 4 == 3 ? PLT_BUILD_DEVICE : PLT_BUILD_HOST,
                                     .lattice_bits = bits[seed % 3],
                                     .numbers = seed % 5 != 0,
                                     .checks = seed % 3 != 0,
                                     .floats = seed % 6 == 2,
                                     .leaf_triangles = 1u << seed / 4 % 3};
    shape_soup(&m, seed < 2 ? (uint32_t)seed : rig_triangles(17 * (uint32_t)seed, 1), 0.7f,
               (uint64_t)seed);
    CHECK(pack_compact(&image, &m, &options, "test", &loss, &f) == 0, "%s", f.text);
    mesh_free(&m);
    return image;
}

static packed thesis_image(int seed) {
    mesh m = {0};
    packed image;
    fail f = {""};
    const pack_options options = {(uint8_t)(seed & 1),
                                  (uint8_t)(seed % 3),
                                  1u + (uint32_t)seed % 2,
                                  1u + (uint32_t)seed,
                                  NULL,
                                  seed < 6,
                                  NULL,
                                  0,
                                  0};
    shape_soup(&m, seed == 8 ? 0 : 3u + 5u * (uint32_t)seed, 0.7f, (uint64_t)seed);
    CHECK(pack_mesh(&image, &m, &options, "test", &f) == 0, "%s", f.text);
    mesh_free(&m);
    return image;
}

static packed seed_image(uint32_t seed) {
    return seed < SEEDS ? thesis_image((int)seed) : compact_image((int)seed - SEEDS);
}

/* Half of the damage is to the header. */
static uint32_t place(const unsigned char *image, uint32_t size, random_state *r) {
    return random_below(r, random_below(r, 2) ? size : image[98] == 1 ? 228 : 144);
}

int main(void) {
    const uint32_t mutations = mutations_of(MUTATIONS);
    test("mutated images are refused with a reason or traced without harm");
    for (uint32_t seed = 0; seed < SEEDS; seed++) {
        fuzz(seed, mutations);
    }
    test("the same for mutated compact images whose block checks are made right");
    const unsigned long before = images_opened;
    for (uint32_t seed = SEEDS; seed < SEEDS + COMPACT_SEEDS; seed++) {
        fuzz(seed, mutations);
    }
    test("of the mutated images some open and most do not");
    const unsigned long all = SEEDS * (unsigned long)mutations;
    const unsigned long compact = COMPACT_SEEDS * (unsigned long)mutations;
    const unsigned long opened = images_opened - before;
    CHECK(before > all / 50 && before < all / 2, "%lu of %lu", before, all);
    CHECK(opened > compact / 50 && opened < compact / 2, "compact: %lu of %lu", opened, compact);
    printf("    %lu of %lu thesis images opened, %lu of %lu compact ones\n", before, all, opened,
           compact);
    return test_done();
}

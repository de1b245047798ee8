/* test_surface_fuzz - the target fuzz_surface with deterministic mutations
 *
 * PLANELET_SOAK=1 runs a hundred times as many.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/fuzz/fuzz_surface.c"

#include "tests/fuzz/image_mutations.h"
#include "tests/reference/surface_rig.h"

enum { SEEDS = 8, MUTATIONS = 1500 };

static packed seed_image(uint32_t seed) {
    mesh m = {0};
    mesh_corners c = {0};
    const rig_config config =
        rig_config_of(1 + seed % 2, rig_is_tiny() ? 1 : 4, (uint8_t)(seed % 3), PLT_SPLIT_SAH);
    shape_cube(&m);
    shape_soup(&m, 6 * seed, 0.7f, seed);
    CHECK(mesh_smooth(&m, 30.0 * seed, &c) == 0, "no memory");
    if (seed % 2) {
        surface_rig_colour(&m, &c, seed + 1);
    }
    if (seed % 4 >= 2) {
        surface_rig_unwrap(&m, &c, 1.0f + (float)seed);
        c.has_fine_texcoords = seed > 4;
    }
    const packed image = seed < 4 || rig_is_tiny() ? surface_rig_image(&m, &c, &config.pack)
                                                   : surface_rig_compact(&m, &c, seed % 2);
    corners_free(&c);
    mesh_free(&m);
    return image;
}

/* Most damage is to the number of further sections, to their table, their heads and tables. */
static uint32_t place(const unsigned char *image, uint32_t size, random_state *r) {
    const uint32_t table = hostile_further_at(image) % (size - 160); /* it may be damaged */
    switch (random_below(r, 6)) {
    case 0:
        return HOSTILE_AT_FURTHER + random_below(r, 4);
    case 1:
        return random_below(r, size);
    case 2:
        return table + random_below(r, 64);
    case 3:
        return table + 64 + random_below(r, 32);
    default:
        return table + random_below(r, size - table);
    }
}

int main(void) {
    const uint32_t mutations = mutations_of(MUTATIONS);
    test("mutated images with normals are refused with a reason, or hits have some of length 1");
    for (uint32_t seed = 0; seed < SEEDS; seed++) {
        fuzz(seed, mutations);
    }
    test("of the mutated images some open and some do not");
    const unsigned long all = SEEDS * (unsigned long)mutations;
    CHECK(images_opened > all / 8 && images_opened < all * 15 / 16, "%lu of %lu", images_opened,
          all);
    return test_done();
}

/* test_texture_fuzz - the target fuzz_texture with deterministic mutations
 *
 * PLANELET_SOAK=1 runs a hundred times as many.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/fuzz/fuzz_texture.c"

#include "tests/fuzz/image_mutations.h"
#include "tests/reference/texture_rig.h"

enum { SEEDS = 4, MUTATIONS = 1200 };

static uint32_t textures_at, tiles_at; /* of the seed's image */

static packed seed_image(uint32_t seed) {
    texture_scene s;
    texture_scene_make(&s, (uint8_t)(seed % 2), seed);
    const packed image = s.image;
    textures_at = s.at;
    tiles_at = s.tiles_at;
    s.image = (packed){.bytes = NULL};
    texture_scene_free(&s);
    return image;
}

/* Most damage is to the directory, some to the table of sections, and to tiles. */
static uint32_t place(const unsigned char *image, uint32_t size, random_state *r) {
    (void)image;
    switch (random_below(r, 8)) {
    case 0:
        return HOSTILE_AT_FURTHER + random_below(r, 4);
    case 1:
        return random_below(r, size);
    case 2:
        return tiles_at + random_below(r, size - tiles_at);
    case 3:
        return textures_at - 4096 % textures_at + random_below(r, 4096 % textures_at);
    default:
        return textures_at + random_below(r, 200);
    }
}

int main(void) {
    const uint32_t mutations = mutations_of(MUTATIONS);
    test("mutated images with textures are refused with a reason, or have texels that are light");
    for (uint32_t seed = 0; seed < SEEDS; seed++) {
        fuzz(seed, mutations);
    }
    test("of the mutated images some open and some do not");
    const unsigned long all = SEEDS * (unsigned long)mutations;
    CHECK(images_opened > all / 16 && images_opened < all * 15 / 16, "%lu of %lu", images_opened,
          all);
    return test_done();
}

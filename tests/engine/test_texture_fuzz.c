/* test_texture_fuzz - the target fuzz_texture with deterministic mutations
 *
 * PLANELET_SOAK=1 runs a hundred times as many.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/fuzz/fuzz_texture.c"

#include "tests/fuzz/image_mutations.h"
#include "tests/reference/texture_rig.h"

enum { SEEDS = 8, MUTATIONS = 900 };

static uint32_t textures_at, tiles_at, pages_at; /* of the seed's image; pages_at 0: it has none */

static packed seed_image(uint32_t seed) {
    texture_scene s;
    const enum lit_image paged = seed % 4 < 2 ? LIT_THESIS : LIT_LATTICE;
    texture_scene_make_as(&s, (uint8_t)(seed % 2), seed, seed < 4 ? LIT_LIST : paged,
                          seed < 4 ? TEXTURE_TABLE : TEXTURE_PAGES);
    const packed image = s.image;
    textures_at = s.at;
    tiles_at = s.tiles_at;
    pages_at = seed < 4 ? 0 : s.tiles_at + s.tile_bytes;
    s.image = (packed){.bytes = NULL};
    texture_scene_free(&s);
    return image;
}

/* Most damage is to the directory and to pages, some to the table of sections, and to tiles. */
static uint32_t place(const unsigned char *image, uint32_t size, random_state *r) {
    (void)image;
    if (pages_at > 0 && random_below(r, 2)) { /* their head, where they are, and pages */
        return pages_at + random_below(r, random_below(r, 2) ? 400 : size - pages_at);
    }
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

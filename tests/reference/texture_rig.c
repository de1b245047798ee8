/* texture_rig - see texture_rig.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/texture_rig.h"

#include <math.h>
#include <string.h>

#include "engine/image/further.h"
#include "host_tools/pack/material_section.h"
#include "host_tools/pack/surface_pages.h"
#include "tests/reference/surface_rig.h"
#include "tests/test.h"

static void paint(picture *p, unsigned width, unsigned height, int is_smooth, random_state *r) {
    fail f = {""};
    CHECK(picture_make(p, width, height, &f) == 0, "%s", f.text);
    for (unsigned i = 0; i < width * height; i++) {
        const unsigned x = i % width, y = i / width;
        const uint8_t smooth[3] = {(uint8_t)(255 * x / width), (uint8_t)(255 * y / height),
                                   (uint8_t)(3 * x + 2 * y)};
        for (int c = 0; c < 3; c++) {
            p->rgb[3 * i + c] = is_smooth ? smooth[c] : (uint8_t)random_bits(r);
        }
    }
}

static void find_sections(texture_scene *s) {
    const plt_source source = {.mapped = s->image.bytes, .bytes = s->image.size};
    plt_header h;
    plt_fault fault;
    CHECK(plt_header_read(&h, s->image.bytes, s->image.size, &fault) == PLT_OK &&
              plt_further_read(&source, &h, &fault) == PLT_OK,
          "%s", fault.message);
    const plt_section *textures = plt_further_section(&h, PLT_SECTION_TEXTURES);
    const plt_section *tiles = plt_further_section(&h, PLT_SECTION_TILES);
    CHECK(textures != NULL && tiles != NULL, "sections");
    s->at = textures->offset;
    s->bytes = textures->bytes;
    s->tiles_at = tiles->offset;
    s->tile_bytes = tiles->bytes;
}

static void add_coordinates(texture_scene *s, uint32_t shift) {
    mesh_corners c = {0};
    surface_stats stats;
    fail f = {""};
    surface_rig_unwrap(&s->lit.m, &c, 2.0f);
    const int status = shift > 0 ? surface_pages_add(&s->image, &c, shift, "test", &stats, &f)
                                 : surface_add(&s->image, &c, "test", &stats, &f);
    CHECK(status == 0, "%s", f.text);
    corners_free(&c);
}

void texture_scene_make(texture_scene *s, uint8_t format, uint32_t seed) {
    texture_scene_make_as(s, format, seed, LIT_LIST, TEXTURE_TABLE);
}

void texture_scene_make_as(texture_scene *s, uint8_t format, uint32_t seed, enum lit_image kind,
                           uint32_t shift) {
    static const unsigned sides[TEXTURE_PICTURES][2] = {{64, 64}, {1, 1},  {70, 33},
                                                        {5, 17},  {16, 1}, {31, 64}};
    random_state r = {seed};
    fail f = {""};
    memset(s, 0, sizeof *s);
    lit_scene_make(&s->lit);
    CHECK(lit_pack(&s->image, &s->lit, kind) == 0, "packed");
    add_coordinates(s, shift);
    for (unsigned i = 0; i < TEXTURE_PICTURES; i++) {
        paint(&s->picture[i], sides[i][0], sides[i][1], i % 2 == 0, &r);
        s->paint[i] = (texture_paint){.texture = 1 + i, .clamp = i % 3 == 1, .scale = {1, 1}};
    }
    s->paint[2].scale[0] = 2.5f;
    s->paint[2].scale[1] = -0.5f;
    s->paint[3].offset[0] = 0.25f;
    s->paint[3].offset[1] = -7.75f;
    const texture_set set = {s->picture, TEXTURE_PICTURES, s->paint, LIT_MATERIALS + 1, format};
    CHECK(texture_section_add(&s->image, &set, "test", &s->stats, &f) == 0, "%s", f.text);
    find_sections(s);
}

void texture_scene_free(texture_scene *s) {
    for (unsigned i = 0; i < TEXTURE_PICTURES; i++) {
        picture_free(&s->picture[i]);
    }
    pack_free(&s->image);
    lit_scene_free(&s->lit);
}

static int start(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    (void)tag;
    memcpy(to, (const unsigned char *)context + offset, count);
    return 0;
}

static int wait(void *context, uint32_t tags) {
    (void)context;
    (void)tags;
    return 0;
}

void texture_scene_flip_tiles(const texture_scene *s) {
    for (uint32_t at = s->tiles_at; at + 132 <= s->tiles_at + s->tile_bytes; at += 132) {
        s->image.bytes[at] ^= 1;
    }
}

int texture_scene_open(const texture_scene *s, plt_textures *t, plt_source *source, void *room,
                       uint32_t room_bytes) {
    plt_fault fault;
    memset(t, 0, sizeof *t);
    memset(source, 0, sizeof *source);
    source->bytes = s->image.size;
    source->mapped = room == NULL ? s->image.bytes : NULL;
    source->context = s->image.bytes;
    source->start = start;
    source->wait = wait;
    t->filter = PLT_TEXTURES_BILINEAR;
    plt_tiles_init(&t->tiles, source, s->tiles_at, room, room_bytes);
    return plt_directory_read(&t->directory, s->image.bytes + s->at, s->bytes, s->tile_bytes, s->at,
                              &fault);
}

static unsigned word16(const unsigned char *at) {
    return at[0] + 256u * at[1];
}

static uint32_t word32(const unsigned char *at) {
    return word16(at) + 65536u * word16(at + 2);
}

texture_reference texture_reference_level(const texture_scene *s, uint32_t number, unsigned level) {
    const unsigned char *entry = s->image.bytes + s->at + 16 + 12 * number;
    texture_reference r = {word16(entry), word16(entry + 2), word32(entry + 8), entry[5],
                           s->image.bytes + s->tiles_at};
    const double side = entry[5] == 1 ? 16.0 : 8.0;
    for (unsigned i = 0; i < level; i++) {
        r.first += (uint32_t)(ceil(r.width / side) * ceil(r.height / side));
        r.width = r.width / 2 > 0 ? r.width / 2 : 1;
        r.height = r.height / 2 > 0 ? r.height / 2 : 1;
    }
    return r;
}

static void of_565(unsigned code, double rgb[3]) {
    rgb[0] = (double)(code / 2048 * 8 + code / 2048 / 4);
    rgb[1] = (double)(code / 32 % 64 * 4 + code / 32 % 64 / 16);
    rgb[2] = (double)(code % 32 * 8 + code % 32 / 4);
}

void texture_reference_texel(const texture_reference *r, uint32_t x, uint32_t y, double rgb[3]) {
    const uint32_t side = r->format == 1 ? 16 : 8, along = (r->width + side - 1) / side;
    const unsigned char *tile = r->tiles + 132 * (size_t)(r->first + y / side * along + x / side);
    const uint32_t i = x % side, j = y % side;
    double end[2][3];
    if (r->format == 0) {
        of_565(word16(tile + 16 * j + 2 * i), rgb);
        return;
    }
    const unsigned char *block = tile + 8 * (j / 4 * 4 + i / 4);
    const unsigned number = word32(block + 4) >> (2 * (j % 4 * 4 + i % 4)) & 3;
    of_565(word16(block), end[0]);
    of_565(word16(block + 2), end[1]);
    for (int c = 0; c < 3; c++) {
        const double share[4] = {0, 1, 1.0 / 3, 2.0 / 3};
        rgb[c] = floor(end[0][c] + share[number] * (end[1][c] - end[0][c]) + 0.5 - 1e-9);
    }
}

double texture_reference_light(double byte) {
    const double x = byte / 255;
    return x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4);
}

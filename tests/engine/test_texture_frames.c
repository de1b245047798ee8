/* test_texture_frames - frames whose surfaces have textures: the same from mapped images and
 * fetched ones, by packets of any size, on every machine; and tiles that are damaged
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "tests/reference/frames.h"
#include "tests/reference/texture_rig.h"
#include "tests/test.h"

static const plt_options textured = {
    .packet_side = 2, .surface = 1, .whitted = 4, .textures = PLT_TEXTURES_BILINEAR};

static const plt_frame frame = {
    .camera = {.eye = {1, 4, 9}, .look = {0, 0.5f, 0}, .up = {0, 1, 0}, .tan_half_fov = 0.6f},
    .width = 64,
    .height = 48,
    .shader = PLT_SHADE_WHITTED};

static int open_lit(rig *r, const texture_scene *s, const plt_options *options, int fetched) {
    const plt_lighting l = lit_lights(3);
    *r = (rig){.image = s->image};
    const int status = lit_open(r, options, fetched);
    return status == PLT_OK ? plt_lighting_set(r->engine, &l) : status;
}

/* The frame of an image; 0: it is refused, or fails. */
static uint64_t hash_of(const texture_scene *s, const plt_options *options, int fetched,
                        plt_texture_stats *stats) {
    rig r;
    uint64_t hash = 0;
    if (open_lit(&r, s, options, fetched) == PLT_OK) {
        hash = frame_hash(r.engine, &frame, 1000);
        plt_texture_stats_get(r.engine, stats);
    }
    free(r.arena);
    return hash;
}

enum { KINDS = 4, PAGED = 3 };

static uint64_t by_all_ways(const texture_scene s[KINDS], uint8_t filter) {
    uint64_t first = 0;
    for (unsigned i = 0; i < 4 * KINDS; i++) {
        const unsigned way = i / KINDS;
        plt_options o = textured;
        plt_texture_stats stats = {0};
        o.residency = i % KINDS == PAGED ? PLT_RESIDENCY_STREAMED : PLT_RESIDENCY_WHOLE;
        o.packet_side = way % 2 && !rig_is_tiny() ? 8 : 2;
        o.textures = filter;
        o.texture_bytes = way == 3 ? PLT_TEXTURE_LEAST : 0;
        const uint64_t hash = hash_of(&s[i % KINDS], &o, way > 1, &stats);
        first = i == 0 ? hash : first;
        CHECK(hash == first && hash != 0, "kind %u, way %u: %llx, not %llx", i % KINDS, way,
              (unsigned long long)hash, (unsigned long long)first);
        CHECK((stats.fetched > 0) == (way > 1), "fetched %llu", (unsigned long long)stats.fetched);
    }
    return first;
}

static void same(void) {
    static const enum lit_image kinds[KINDS] = {LIT_THESIS, LIT_LIST, LIT_COMPACT, LIT_THESIS};
    static const uint64_t golden[2] = {UINT64_C(0xDE7B9E7DDC06E14A), UINT64_C(0xAFDAA5C0C00D2C3C)};
    test(
        "frames are the same from a tree, streamed or not, a list and blocks, mapped or fetched, "
        "by any packet, "
        "and what they were on other machines");
    texture_scene s[KINDS];
    for (unsigned i = 0; i < KINDS; i++) {
        texture_scene_make_as(&s[i], PLT_TEXTURE_RGB565, 4, kinds[i],
                              i == PAGED ? TEXTURE_PAGES : TEXTURE_TABLE);
    }
    for (unsigned i = 0; i < 2; i++) {
        const uint64_t hash = by_all_ways(s, (uint8_t)(PLT_TEXTURES_NEAREST + i));
        CHECK(hash == golden[i] || rig_is_tiny(), "%llx, not %llx", (unsigned long long)hash,
              (unsigned long long)golden[i]);
    }
    for (unsigned i = 0; i < KINDS; i++) {
        texture_scene_free(&s[i]);
    }
}

static void differ(void) {
    texture_scene s;
    plt_options o = textured;
    plt_texture_stats stats;
    test("without textures, nearest and bilinear are three pictures");
    texture_scene_make(&s, PLT_TEXTURE_RGB565, 4);
    const uint64_t bilinear = hash_of(&s, &o, 0, &stats);
    o.textures = PLT_TEXTURES_NEAREST;
    const uint64_t nearest = hash_of(&s, &o, 0, &stats);
    o.textures = PLT_TEXTURES_NONE;
    const uint64_t none = hash_of(&s, &o, 0, &stats);
    CHECK(bilinear != nearest && nearest != none && none != bilinear, "they differ");
    test("options that textures do not go with are refused");
    const plt_options wrong[] = {
        {.packet_side = 2, .whitted = 1, .textures = 1},
        {.packet_side = 2, .surface = 1, .whitted = 1, .textures = 3},
        {.packet_side = 2, .surface = 1, .whitted = 1, .textures = 1, .texture_bytes = 139},
        {.packet_side = 2, .surface = 1, .whitted = 1, .texture_bytes = 140},
        {.packet_side = 2, .textures = 1}};
    for (unsigned i = 0; i < sizeof wrong / sizeof wrong[0]; i++) {
        CHECK(plt_arena_need(&s.image.info, 1, &wrong[i]) == 0, "%u has a need", i);
    }
    texture_scene_free(&s);
}

static int render(plt_engine *e) {
    int status = plt_render_begin(e, &frame);
    if (status == PLT_OK) {
        do {
            status = plt_render_step(e, 1000);
        } while (status > PLT_OK);
    }
    return status;
}

static void counts(plt_engine *e) {
    plt_texture_stats stats;
    test("statistics of tiles are counted from a reset on");
    plt_texture_stats_get(e, &stats);
    CHECK(stats.fetched > 0 && stats.found > 0 && stats.bytes_fetched >= 132 * stats.fetched,
          "counted");
    plt_stats_reset(e);
    plt_texture_stats_get(e, &stats);
    CHECK(stats.fetched + stats.found + stats.bytes_fetched + stats.retries == 0, "reset");
}

static void damaged(void) {
    texture_scene s;
    rig r;
    plt_fault fault;
    plt_texture_stats stats;
    test("a tile that is damaged ends the frame, which says so, and not the next one");
    texture_scene_make(&s, PLT_TEXTURE_RGB565, 4);
    const uint64_t good = hash_of(&s, &textured, 1, &stats);
    texture_scene_flip_tiles(&s);
    CHECK(open_lit(&r, &s, &textured, 1) == PLT_OK, "%s", r.fault.message);
    const int status = render(r.engine);
    plt_fault_get(r.engine, &fault);
    CHECK(status == PLT_ERR_IMAGE && fault.kind == 'I' && fault.rule == 30 &&
              fault.offset >= s.tiles_at && (fault.offset - s.tiles_at) % 132 == 0,
          "%d: %c%u at %u", status, fault.kind, fault.rule, fault.offset);
    free(r.arena);
    CHECK(open_lit(&r, &s, &textured, 0) == PLT_ERR_IMAGE && r.fault.rule == 13 &&
              r.fault.offset == s.tiles_at,
          "mapped: %c%u", r.fault.kind, r.fault.rule);
    free(r.arena);
    CHECK(open_lit(&r, &s, &textured, 1) == PLT_OK && render(r.engine) == PLT_ERR_IMAGE, "again");
    texture_scene_flip_tiles(&s);
    CHECK(frame_hash(r.engine, &frame, 1000) == good, "the next frame");
    plt_fault_get(r.engine, &fault);
    CHECK(fault.rule == 0, "%s", fault.message);
    counts(r.engine);
    free(r.arena);
    texture_scene_free(&s);
}

/* Tiles that a frame of so many pixels takes, each of them once. */
static uint64_t tiles_of(const texture_scene *s, uint16_t width, uint16_t height, uint8_t samples) {
    plt_options o = textured;
    plt_texture_stats stats = {0};
    plt_frame f = frame;
    rig r;
    f.width = width;
    f.height = height;
    f.samples = samples;
    f.camera.tan_half_fov = 0.2f;
    o.packet_side = 4;
    o.whitted = 1;
    o.texture_bytes = 4096 * PLT_TEXTURE_LEAST;
    plt_lighting l = lit_lights(0);
    r = (rig){.image = s->image};
    CHECK(lit_open(&r, &o, 1) == PLT_OK && plt_lighting_set(r.engine, &l) == PLT_OK, "%s",
          r.fault.message);
    CHECK(frame_hash(r.engine, &f, 1000) != 0, "rendered");
    plt_texture_stats_get(r.engine, &stats);
    free(r.arena);
    return stats.fetched;
}

static void samples(void) {
    texture_scene s;
    if (PLT_PACKET_SIDE_MAX < 4) {
        return;
    }
    test("samples have the levels of textures that pixels as small as they have");
    texture_scene_make(&s, PLT_TEXTURE_RGB565, 4);
    const uint64_t coarse = tiles_of(&s, 20, 15, PLT_SAMPLES_ONE);
    for (unsigned across = 2; across <= 4; across *= 2) {
        const uint64_t mixed =
            tiles_of(&s, 20, 15, across == 2 ? PLT_SAMPLES_FOUR : PLT_SAMPLES_SIXTEEN);
        const uint64_t fine =
            tiles_of(&s, (uint16_t)(20 * across), (uint16_t)(15 * across), PLT_SAMPLES_ONE);
        CHECK((across == 2 || 4 * coarse < 3 * fine) && 8 * mixed > 7 * fine &&
                  7 * mixed < 8 * fine,
              "%u across: %u tiles, of small pixels %u, of large ones %u", across, (unsigned)mixed,
              (unsigned)fine, (unsigned)coarse);
    }
    texture_scene_free(&s);
}

int main(void) {
    same();
    samples();
    differ();
    damaged();
    return test_done();
}

/* surface - opens untrusted images with normals, colours and texture coordinates, and asks for
 * those of hits
 *
 * As hostile/images.h has it of others.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOSTILE_SURFACE_H
#define HOSTILE_SURFACE_H

#include "engine/surface/surface_pages.h"
#include "tests/hostile/images.h"
#include "tests/reference/room.h"

enum { HOSTILE_AT_FURTHER = 228, HOSTILE_FURTHER_MOST = 7 };

/* Where the sections of the header's table end, as it says. */
static inline uint32_t hostile_further_at(const unsigned char *bytes) {
    const uint32_t sections = plt_get_u32(bytes + 100);
    const unsigned char *last =
        bytes + HOSTILE_SECTION + 16 * (sections >= 1 && sections <= 4 ? sections - 1 : 0);
    return plt_get_u32(last + 4) + plt_get_u32(last + 8);
}

/* Makes the checks of pages right, and of where they are, as far as they lie in their section of
 * `bytes`. */
static inline void hostile_seal_pages(unsigned char *section, uint32_t bytes, uint32_t triangles) {
    const uint32_t shift = bytes >= PLT_PAGES_HEAD ? plt_get_u32(section + 4) : 0;
    const uint32_t palette = bytes >= PLT_PAGES_HEAD ? plt_get_u32(section + 8) : 0;
    if (bytes < PLT_PAGES_HEAD || shift > 31 || palette > (bytes - PLT_PAGES_HEAD) / 4) {
        return;
    }
    const uint32_t chunks = PLT_PAGES_HEAD + 4 * palette;
    const uint64_t pages = ((uint64_t)triangles + (1u << shift) - 1) >> shift;
    plt_put_u32(section + 12, plt_pages_head_check(section, chunks));
    for (uint32_t i = 0; i < pages; i++) {
        const uint32_t number = i / PLT_PAGES_IN_CHUNK;
        const uint64_t at = chunks + (uint64_t)PLT_PAGES_CHUNK * number;
        if (at + PLT_PAGES_CHUNK > bytes) {
            return;
        }
        unsigned char *chunk = section + at;
        const uint32_t begin = plt_pages_offset(chunk, i), end = plt_pages_end(chunk, i);
        plt_put_u32(chunk, plt_pages_check(number, chunk + 4, PLT_PAGES_CHUNK - 4));
        if (begin < end && end <= bytes && end - begin >= 4) {
            plt_put_u32(section + begin, plt_pages_check(i, section + begin + 4, end - begin - 4));
        }
    }
}

/* Makes the CRCs of further sections and their table right, and all others. */
static inline void hostile_seal_surface(unsigned char *bytes, uint32_t size) {
    hostile_seal(bytes, size);
    if (size < HOSTILE_HEADER) {
        return;
    }
    const uint32_t count = plt_get_u32(bytes + HOSTILE_AT_FURTHER), at = hostile_further_at(bytes);
    const uint32_t table = (16 + 16 * (count & 7u) + 63) / 64 * 64;
    if (count > HOSTILE_FURTHER_MOST || at > size || table > size - at) {
        return;
    }
    for (uint32_t i = 0; i < count; i++) {
        unsigned char *entry = bytes + at + 16 + 16 * i;
        const uint32_t offset = plt_get_u32(entry + 4), bytes_of = plt_get_u32(entry + 8);
        if (offset <= size && bytes_of <= size - offset) {
            plt_put_u32(entry + 12, plt_crc32(0, bytes + offset, bytes_of));
        }
    }
    plt_put_u32(bytes + at, plt_crc32(0, bytes + at + 4, table - 4));
}

/* ... and those of pages, which tell damage in a page from pages that someone has made so. */
static inline void hostile_seal_paged(unsigned char *bytes, uint32_t size) {
    const uint32_t at = size >= HOSTILE_HEADER ? hostile_further_at(bytes) : size;
    for (uint32_t i = 0; i < HOSTILE_FURTHER_MOST && at < size && size - at >= 32 + 16 * i; i++) {
        const unsigned char *entry = bytes + at + 16 + 16 * i;
        const uint32_t offset = plt_get_u32(entry + 4), bytes_of = plt_get_u32(entry + 8);
        if (plt_get_u32(entry) == PLT_SECTION_PAGES && offset <= size &&
            bytes_of <= size - offset) {
            hostile_seal_pages(bytes + offset, bytes_of, plt_get_u32(bytes + 24));
        }
    }
    hostile_seal_surface(bytes, size);
}

static inline int hostile_is_unit(const float v[3]) {
    const float squared = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    return squared > 0.9999f && squared < 1.0001f;
}

/* Whatever tables hold is a normal, and a colour. */
static inline const char *hostile_point(const plt_engine *e, const plt_hit *hit) {
    plt_surface_point p;
    if (plt_surface_at(e, hit, &p) != PLT_OK) {
        return "a hit has no surface";
    }
    const int is_sliver = p.flat[0] == 0 && p.flat[1] == 0 && p.flat[2] == 0;
    if (!(is_sliver || hostile_is_unit(p.flat)) ||
        !(hostile_is_unit(p.normal) || (is_sliver && p.normal[0] == 0))) {
        return "a normal has not the length 1";
    }
    for (int c = 0; c < 3; c++) {
        if (!(p.colour[c] >= 0 && p.colour[c] <= 1)) {
            return "a colour is out of range";
        }
    }
    const float most = p.has_texcoord ? 0x1p20f : 0.0f;
    for (int a = 0; a < 2; a++) {
        if (!(p.texcoord[a] >= -most && p.texcoord[a] <= most)) {
            return "a texture coordinate is out of range";
        }
    }
    if (!(p.texcoord_scale >= 0 && p.texcoord_scale < 0x1p60f) ||
        (!p.has_texcoord && p.texcoord_scale != 0)) {
        return "a texture's scale is out of range";
    }
    return NULL;
}

static inline const char *hostile_trace_surface(plt_engine *e) {
    plt_ray rays[HOSTILE_RAYS];
    plt_hit hits[HOSTILE_RAYS];
    const char *sentence = hostile_trace(e);
    hostile_rays(rays, plt_engine_info(e));
    plt_trace(e, rays, hits, HOSTILE_RAYS, 0);
    for (uint32_t i = 0; i < HOSTILE_RAYS && sentence == NULL; i++) {
        if (hits[i].triangle != PLT_MISS) {
            sentence = hostile_point(e, &hits[i]);
        }
    }
    const plt_frame frame = {.camera = {{3, 2, 4}, {0, 0, 0}, {0, 1, 0}, 0.5f},
                             .width = 12,
                             .height = 12,
                             .shader = PLT_SHADE_SMOOTH};
    if (sentence == NULL && plt_render_begin(e, &frame) != PLT_OK) {
        return "a smooth frame is refused";
    }
    while (sentence == NULL && plt_render_step(e, 1000) > PLT_OK) {
    }
    return sentence;
}

/* hostile_try, of an engine that is asked for surfaces. */
static inline hostile_result hostile_try_surface(const unsigned char *bytes, uint32_t size,
                                                 hostile_config config) {
    hostile_result r = {0, {0, 0, 0, 0, NULL}, NULL};
    unsigned char *copy = room_get(size > 0 ? size : 1);
    hostile_stream stream = {copy, size, 0};
    const plt_source mapped = {copy, size, NULL, NULL, NULL},
                     streamed = {NULL, size, &stream, hostile_start, hostile_wait};
    const plt_source *source = config.streamed ? &streamed : &mapped;
    const plt_options options = {.packet_side = 2, .order = config.order, .surface = 1};
    memcpy(copy, bytes, size);
    const size_t arena_bytes = hostile_arena_bytes(source, &options);
    void *arena = room_get(arena_bytes);
    plt_engine *e = NULL;
    r.status = plt_open(&e, arena, arena_bytes, source, &options, &r.fault);
    r.sentence =
        r.status == PLT_OK ? hostile_trace_surface(e) : hostile_refusal(r.status, &r.fault, e);
    if (memcmp(copy, bytes, size) != 0) {
        r.sentence = "the image was written";
    }
    if (stream.beyond) {
        r.sentence = "the source was read beyond its end";
    }
    free(arena);
    free(copy);
    return r;
}

#endif

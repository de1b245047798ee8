/* textures - opens untrusted images with textures, samples them, and renders a frame, with lights
 * or by eye light alone, of a scene that is resident or streamed
 *
 * As hostile/images.h has it of others.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOSTILE_TEXTURES_H
#define HOSTILE_TEXTURES_H

#include "engine/engine.h"
#include "tests/hostile/surface.h"
#include "tests/reference/room.h"

enum { HOSTILE_SAMPLES = 60, HOSTILE_TEXTURE_ROOM = 5 * PLT_TEXTURE_LEAST };

/* Whatever tiles hold is light; of tiles that are fetched the check may be wrong. */
static inline const char *hostile_sample(plt_textures *t) {
    for (uint32_t i = 0; i < HOSTILE_SAMPLES; i++) {
        const float uv[2] = {(float)(i * 7 % 60) / 30.0f - 0.5f, (float)(i * 13 % 60) / 20.0f};
        const float area = i % 3 == 0 ? 0.0f : (float)i * 0.001f;
        float light[3];
        const int status = plt_texture_sample(t, i % 8, uv, area, light);
        if (status != PLT_OK) {
            return status != PLT_ERR_IMAGE           ? "a tile fails otherwise than by its check"
                   : t->tiles.mapped != NULL         ? "a mapped tile fails"
                   : t->tiles.fault.rule != 30       ? "a tile's fault has another rule"
                   : t->tiles.fault.kind != (int)'I' ? "a tile's fault is no invariant"
                   : t->tiles.fault.message == (char *)0 ? "a tile's fault has no message"
                                                         : NULL;
        }
        for (int c = 0; c < 3; c++) {
            if (!(light[c] >= 0 && light[c] <= 1)) {
                return "a texel is no light";
            }
        }
    }
    return NULL;
}

static inline const char *hostile_render_textures(plt_engine *e) {
    const int is_lit = e->rendering.whitted != NULL;
    const plt_lighting l = {.sky = {1, 1, 1}, .bounces = 1};
    const plt_frame frame = {.camera = {{3, 4, 9}, {0, 0, 0}, {0, 1, 0}, 0.5f},
                             .width = 12,
                             .height = 12,
                             .shader = is_lit ? PLT_SHADE_WHITTED : PLT_SHADE_SMOOTH};
    plt_textures *t = e->rendering.paint.textures;
    const char *sentence = t != NULL ? hostile_sample(t) : NULL;
    plt_fault fault;
    if (sentence == NULL &&
        ((is_lit && plt_lighting_set(e, &l) != PLT_OK) || plt_render_begin(e, &frame) != PLT_OK)) {
        return "a frame with textures is refused";
    }
    int status = PLT_OK;
    do {
        status = plt_render_step(e, 1000);
    } while (sentence == NULL && status > PLT_OK);
    plt_fault_get(e, &fault);
    const int is_streamed = e->options.residency == PLT_RESIDENCY_STREAMED;
    const int has_reason = is_streamed ? fault.rule > 0 : fault.rule == 30;
    return sentence == NULL && status < PLT_OK && !(status == PLT_ERR_IMAGE && has_reason)
               ? "a frame ends without a reason"
               : sentence;
}

/* How an image is tried. */
typedef struct hostile_textured {
    int fetched; /* through a source that is not mapped */
    int lit;
    uint8_t residency, filter; /* as plt_options has them */
} hostile_textured;

/* hostile_try, of an engine that is asked for textures. */
static inline hostile_result hostile_try_textures(const unsigned char *bytes, uint32_t size,
                                                  hostile_textured how) {
    hostile_result r = {0, {0, 0, 0, 0, NULL}, NULL};
    unsigned char *copy = room_get(size > 0 ? size : 1);
    hostile_stream stream = {copy, size, 0};
    const plt_source source = {how.fetched ? NULL : copy, size, &stream, hostile_start,
                               hostile_wait};
    const plt_options options = {.packet_side = 2,
                                 .surface = 1,
                                 .residency = how.residency,
                                 .whitted = how.lit ? 2 : 0,
                                 .textures = how.filter,
                                 .texture_bytes = HOSTILE_TEXTURE_ROOM};
    memcpy(copy, bytes, size);
    const size_t arena_bytes = hostile_arena_bytes(&source, &options);
    void *arena = room_get(arena_bytes);
    plt_engine *e = NULL;
    r.status = plt_open(&e, arena, arena_bytes, &source, &options, &r.fault);
    r.sentence =
        r.status == PLT_OK ? hostile_render_textures(e) : hostile_refusal(r.status, &r.fault, e);
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

/* materials - images with materials that were tampered with
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOSTILE_MATERIALS_H
#define HOSTILE_MATERIALS_H

#include <stdlib.h>
#include <string.h>

#include "engine/base/bytes.h"
#include "engine/image/further.h"
#include "engine/image/header_at.h"
#include "engine/planelet.h"
#include "engine/planelet_crc32.h"

/* Where the section of an image that is valid lies; bytes 0: there is none. */
static inline plt_section hostile_materials_at(const unsigned char *image, uint32_t size) {
    const plt_section none = {0, 0, 0, 0};
    const plt_source source = {.mapped = image, .bytes = size};
    plt_header h;
    plt_fault fault;
    if (size < PLT_HEADER_BYTES || plt_header_read(&h, image, size, &fault) != PLT_OK ||
        plt_further_read(&source, &h, &fault) != PLT_OK) {
        return none;
    }
    const plt_section *s = plt_further_section(&h, PLT_SECTION_MATERIALS);
    return s != NULL ? *s : none;
}

/* Makes the checks right again, of all that lies where the sizes say. */
static inline void hostile_seal_materials(unsigned char *image, uint32_t size) {
    plt_header h;
    plt_fault fault;
    if (size < PLT_HEADER_BYTES) {
        return;
    }
    plt_header_seal(image);
    if (plt_header_read(&h, image, size, &fault) != PLT_OK || h.further_count == 0 ||
        h.further_count > PLT_FURTHER_MOST) {
        return;
    }
    const uint32_t bytes = plt_further_table_bytes(h.further_count);
    if ((uint64_t)h.further_at + bytes > size) {
        return;
    }
    unsigned char *table = image + h.further_at;
    for (uint32_t i = 0; i < h.further_count; i++) {
        unsigned char *entry = table + PLT_FURTHER_HEAD + i * PLT_FURTHER_ENTRY;
        const uint32_t at = plt_get_u32(entry + 4), count = plt_get_u32(entry + 8);
        if ((uint64_t)at + count <= size) {
            plt_put_u32(entry + 12, plt_crc32(0, image + at, count));
        }
    }
    plt_put_u32(table, plt_further_check(table, bytes));
}

/* Opens any bytes with lights and renders a small frame: the status of opening. The arena is just
 * as large as is said to be needed, so that sanitizers see what is beyond it. */
static inline int hostile_try_materials(const unsigned char *image, uint32_t size,
                                        plt_fault *fault) {
    const plt_options options = {.packet_side = 2, .whitted = 4};
    plt_source source = {.mapped = image, .bytes = size};
    plt_lighting l = {.sky = {1, 1, 1}, .lights = 1, .bounces = 3};
    const plt_frame frame = {.camera = {.eye = {1, 4, 9}, .up = {0, 1, 0}, .tan_half_fov = 0.6f},
                             .width = 12,
                             .height = 9,
                             .shader = PLT_SHADE_WHITTED};
    plt_engine *engine;
    plt_info info;
    l.light[0] = (plt_light){{0, 3, 1}, {5, 5, 5}, 0.1f, PLT_LIGHT_POINT, 2};
    int status = plt_image_info(&source, &info, fault);
    const size_t need = status == PLT_OK ? plt_arena_need(&info, 1, &options) : 0;
    if (need == 0 || need > 64u << 20) {
        return status;
    }
    void *arena = aligned_alloc(PLT_ALIGN, need);
    status = plt_open(&engine, arena, need, &source, &options, fault);
    if (status == PLT_OK) {
        plt_lighting_set(engine, &l);
        plt_render_begin(engine, &frame);
        while (plt_render_step(engine, 100) > PLT_OK) {
        }
    }
    free(arena);
    return status;
}

#endif

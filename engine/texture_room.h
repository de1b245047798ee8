/* texture_room - the parts of the arena for textures
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TEXTURE_ROOM_H
#define PLT_TEXTURE_ROOM_H

#include "engine/engine.h"

#if PLT_WITH_TEXTURE

#define PLT_TEXTURE_STATE_BYTES ((sizeof(plt_textures) + 15u) & ~(size_t)15u)

/* What is kept of all textures, and the section of them if it is not mapped. */
static inline uint64_t plt_texture_room_bytes(const plt_info *info, int mapped) {
    return PLT_TEXTURE_STATE_BYTES + (mapped ? 0u : (uint64_t)info->texture_bytes);
}

/* ... and of tiles that are fetched. */
static inline uint32_t plt_texture_tiles_bytes(const plt_options *options) {
    return options->texture_bytes > 0 ? options->texture_bytes
                                      : PLT_TEXTURE_TILES * (uint32_t)sizeof(plt_tile_slot);
}

/* They are asked for, and there are some, on coordinates that there may be: of streamed scenes
 * these come in pages. */
static inline int plt_texture_room_is_wanted(const plt_info *info, const plt_options *options,
                                             enum plt_format format) {
#if PLT_WITH_PAGES
    const int has_coordinates = !plt_is_streamed(format) || info->page_bytes > 0;
#else
    const int has_coordinates = !plt_is_streamed(format);
#endif
    return options->textures > 0 && info->texture_bytes > 0 && has_coordinates;
}

/* Lays them out, if they are wanted, once the room for lights is: R13, R20.
 * `header` may be NULL if they are not. */
int plt_texture_room_set(plt_engine *e, const plt_header *header, void *const part[PLT_PARTS_COUNT],
                         plt_fault *fault);

/* The fetch of a tile has failed since it was forgotten; why. */
int plt_texture_failed(const plt_engine *e, plt_fault *fault);
void plt_texture_forget(plt_engine *e);
void plt_texture_stats_reset(plt_engine *e);
#else
static inline int plt_texture_room_set(const plt_engine *e, const plt_header *header,
                                       void *const part[PLT_PARTS_COUNT], const plt_fault *fault) {
    (void)e;
    (void)header;
    (void)part;
    (void)fault;
    return PLT_OK;
}

static inline int plt_texture_failed(const plt_engine *e, const plt_fault *fault) {
    (void)e;
    (void)fault;
    return 0;
}

static inline void plt_texture_forget(const plt_engine *e) {
    (void)e;
}

static inline void plt_texture_stats_reset(const plt_engine *e) {
    (void)e;
}
#endif

#endif

/* viewer_number - what there is to say of scene, engine and frame, as numbers; see viewer.h
 *
 * SPDX-License-Identifier: MIT */
#include "board/web/web.h"
#include "host_tools/web/viewer.h"
#include "host_tools/web/viewing.h"

static double of_scene(const plt_info *info, unsigned which) {
    switch (which) {
    case NUMBER_TRIANGLES:
        return info->placed_triangles > 0 ? info->placed_triangles : info->triangles;
    case NUMBER_HAS_SURFACE:
        return info->normal_bytes > 0 || info->colour_bytes > 0 || info->page_bytes > 0;
    case NUMBER_HAS_MATERIALS:
        return info->material_bytes > 0;
    default:
        return info->frames;
    }
}

static double of_engine(unsigned which) {
    plt_stats stats;
    plt_stats_get(viewed.engine, &stats);
    switch (which) {
    case NUMBER_ARENA_PEAK:
        return (double)plt_arena_peak(viewed.engine);
    case NUMBER_RAYS:
        return (double)stats.rays;
    case NUMBER_BYTES_FETCHED:
        return viewed.where == VIEW_STREAMED ? (double)stats.bytes_fetched : 0.0;
    case NUMBER_TILES_ALL:
        return viewed.is_rendering ? plt_render_tiles(viewed.engine) : viewed.tiles;
    default:
        return of_scene(plt_engine_info(viewed.engine), which);
    }
}

double viewer_number(unsigned which) {
    switch (which) {
    case NUMBER_IMAGE_BYTES:
        return viewed.source.bytes;
    case NUMBER_NEED_BYTES:
        return (double)viewed.need_bytes;
    case NUMBER_ARENA_BYTES:
        return viewed.arena_bytes;
    case NUMBER_STACK_USED:
        return web_stack_used();
    case NUMBER_STACK_BYTES:
        return web_stack_bytes();
    case NUMBER_WIDTH:
        return viewed.frame.width;
    case NUMBER_HEIGHT:
        return viewed.frame.height;
    case NUMBER_LEVEL:
        return viewed.level;
    case NUMBER_IS_DUE:
        return viewed.coarse.is_due || viewed.is_rendering;
    case NUMBER_STEPS:
        return viewed.steps;
    case NUMBER_LONGEST_MS:
        return viewed.longest_ms;
    case NUMBER_BUSY_MS:
        return viewed.busy_ms;
    case NUMBER_TILES:
        return viewed.tiles;
    case NUMBER_EYE_X:
    case NUMBER_EYE_Y:
    case NUMBER_EYE_Z:
        return (double)viewed.frame.camera.eye[which - NUMBER_EYE_X];
    case NUMBER_LOOK_X:
    case NUMBER_LOOK_Y:
    case NUMBER_LOOK_Z:
        return (double)viewed.frame.camera.look[which - NUMBER_LOOK_X];
    default:
        return viewed.engine != NULL && which < NUMBERS ? of_engine(which) : 0.0;
    }
}

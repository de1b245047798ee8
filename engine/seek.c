/* seek - the public calls for a frame that several engines share
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/seek.h"

#include "engine/task.h"

uint32_t plt_render_tiles(const plt_engine *e) {
    return plt_rendering_tiles(&e->rendering);
}

int plt_render_seek(plt_engine *e, uint32_t tile, uint32_t count) {
    const int status = plt_rendering_seek(&e->rendering, tile, count);
#if PLT_WITH_TASK
    if (status == PLT_OK) {
        plt_task_drop(e);
    }
#endif
    return status;
}

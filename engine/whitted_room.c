/* whitted_room - see whitted_room.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/whitted_room.h"

#include "engine/materials_room.h"
#include "engine/whitted/lights.h"
#include "engine/whitted/whitted.h"

#if PLT_WITH_WHITTED

int plt_whitted_room_set(plt_engine *e, const plt_header *h, void *const part[PLT_PARTS_COUNT],
                         plt_fault *fault) {
    if (e->options.whitted == 0) {
        return PLT_OK; /* and there may be no header */
    }
    plt_whitted *w =
        plt_whitted_init(part[PLT_PART_WHITTED], e->options.packet_side, e->options.whitted - 1u);
#if PLT_WITH_WAVE
    w->rays_kind = e->options.rays & 3u;
#endif
    e->rendering.whitted = w;
    return plt_materials_room_set(e, h, part, &w->materials, fault);
}

int plt_lighting_set(plt_engine *e, const plt_lighting *lighting) {
    plt_whitted *w = e->rendering.whitted;
    if (w == NULL || !plt_lighting_valid(lighting) || lighting->bounces > w->room) {
        return PLT_ERR_ARGUMENT;
    }
    w->lighting = *lighting;
    e->rendering.done = 1;
    return PLT_OK;
}

#endif

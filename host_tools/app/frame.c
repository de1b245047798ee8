/* frame - see frame.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/frame.h"

#include <string.h>

unsigned frame_copy_tile(const plt_engine *engine, picture *to) {
    plt_tile t;
    plt_render_tile(engine, &t);
    for (unsigned y = 0; y < t.height; y++) {
        memcpy(to->rgb + 3 * ((size_t)(t.y + y) * to->width + t.x), t.rgb + 3 * (size_t)y * t.width,
               3 * (size_t)t.width);
    }
    return t.y + t.height;
}

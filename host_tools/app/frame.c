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

void frame_choose_chroma(args *a, picture_format *format) {
    static const char *const chroma[] = {"420", "444", NULL};
    const unsigned choice = args_choice(a, "--chroma", chroma, 0);
    if (picture_is_film(*format)) {
        *format = choice == 1 ? PICTURE_Y4M_444 : PICTURE_Y4M;
    } else if (args_has(a, "--chroma")) {
        args_complain(a, "--chroma is for films: give -o a name that ends in .y4m");
    }
}

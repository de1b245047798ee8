/* marks - see marks.h
 *
 * Each is a function of its own at an address of its own: the empty asm keeps them from being
 * left out, or taken for one another.
 *
 * SPDX-License-Identifier: MIT */
#include "board/played/marks.h"

#define MARK(name)                                                                                 \
    __attribute__((noinline)) void firmware_##name(void) {                                         \
        __asm__ volatile("" ::: "memory");                                                         \
    }

MARK(open_begin)
MARK(open_end)
MARK(read_begin)
MARK(read_end)
MARK(show_begin)
MARK(show_end)
MARK(rebuild_begin)
MARK(rebuild_end)
MARK(render_begin)
MARK(render_end)
MARK(frame_done)

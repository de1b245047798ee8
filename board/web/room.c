/* room - memory behind what is static, which grows
 *
 * Pages that were never touched cost a browser nothing but addresses, so memory is not given back.
 *
 * SPDX-License-Identifier: MIT */
#include "board/web/web.h"

enum { PAGE_BYTES = 65536 };

extern unsigned char __heap_base; /* the linker's: where static data ends */

static uint32_t room_at; /* an address; 0: the room has not begun */

void web_room_begin(void) {
    const uint32_t first = (uint32_t)(uintptr_t)&__heap_base;
    room_at = (first + PLT_ALIGN - 1) / PLT_ALIGN * PLT_ALIGN;
}

/* Whether memory ends at `end` or behind it. */
static int reach(uint64_t end) {
    const uint64_t have = (uint64_t)__builtin_wasm_memory_size(0) * PAGE_BYTES;
    if (end <= have) {
        return 1;
    }
    const uint64_t pages = (end - have + PAGE_BYTES - 1) / PAGE_BYTES;
    return end <= UINT32_MAX && __builtin_wasm_memory_grow(0, (uint32_t)pages) != UINT32_MAX;
}

void *web_room_take(uint32_t bytes) {
    const uint64_t end = ((uint64_t)room_at + bytes + PLT_ALIGN - 1) / PLT_ALIGN * PLT_ALIGN;
    void *taken = (void *)(uintptr_t)room_at;
    if (!reach(end)) {
        return NULL;
    }
    room_at = (uint32_t)end;
    return taken;
}

uint32_t web_room_mark(void) {
    return room_at;
}

void web_room_back(uint32_t mark) {
    room_at = mark;
}

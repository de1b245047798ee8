/* page - what a board needs of the page around it: a clock, and the bytes of scenes
 *
 * SPDX-License-Identifier: MIT */
#include "board/web/web.h"

#define OF_PAGE(name) __attribute__((import_module("page"), import_name(name)))

OF_PAGE("clock") extern double page_clock(void);
/* 0, or negative: the image has no such bytes. */
OF_PAGE("read") extern int page_read(uint32_t offset, void *to, uint32_t count);

double web_clock(void) {
    return page_clock();
}

static int start(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    (void)context;
    (void)tag;
    return page_read(offset, to, count);
}

static int wait(void *context, uint32_t tags) {
    (void)context;
    (void)tags;
    return 0;
}

void web_scene_of_page(plt_source *source, uint32_t bytes) {
    *source = (plt_source){.bytes = bytes, .start = start, .wait = wait};
}

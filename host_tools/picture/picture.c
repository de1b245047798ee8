/* picture - see picture.h
 *
 * Invariant of every picture that picture_make returned: 1 to
 * PICTURE_SIDE_MAX pixels on each side. 3 bytes per pixel and a filter byte
 * per row stay below 2^32.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/picture.h"

#include <stdlib.h>
#include <string.h>

int picture_check_size(unsigned width, unsigned height, fail *f) {
    if (width - 1 < PICTURE_SIDE_MAX && height - 1 < PICTURE_SIDE_MAX) {
        return 0;
    }
    return fail_set(f, NULL, "picture of %u x %u pixels: a side is 1 to %u; choose such a size",
                    width, height, PICTURE_SIDE_MAX);
}

int picture_make(picture *p, unsigned width, unsigned height, fail *f) {
    memset(p, 0, sizeof *p);
    if (picture_check_size(width, height, f)) {
        return -1;
    }
    uint8_t *rgb = calloc(3 * (size_t)width, height);
    if (!rgb) {
        return fail_set(f, NULL, "picture of %u x %u pixels: out of memory; choose a smaller size",
                        width, height);
    }
    *p = (picture){rgb, width, height};
    return 0;
}

void picture_free(picture *p) {
    free(p->rgb);
    memset(p, 0, sizeof *p);
}

int picture_resize(picture *p, unsigned width, unsigned height, fail *f) {
    if (p->rgb != NULL && p->width == width && p->height == height) {
        return 0;
    }
    picture_free(p);
    return picture_make(p, width, height, f);
}

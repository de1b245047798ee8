/* picture - 8-bit RGB frames to files and to the terminal
 *
 * Invariant of every picture that picture_make returned: 1 to
 * PICTURE_SIDE_MAX pixels on each side. 3 bytes per pixel and a filter byte
 * per row stay below 2^32.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/picture.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/picture/formats.h"

static int check_size(unsigned width, unsigned height, fail *f) {
    if (width - 1 < PICTURE_SIDE_MAX && height - 1 < PICTURE_SIDE_MAX) {
        return 0;
    }
    return fail_set(f, NULL, "picture of %u x %u pixels: a side is 1 to %u; choose such a size",
                    width, height, PICTURE_SIDE_MAX);
}

int picture_make(picture *p, unsigned width, unsigned height, fail *f) {
    memset(p, 0, sizeof *p);
    if (check_size(width, height, f)) {
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

static int ends_in(const char *path, const char *ending) {
    const size_t length = strlen(path), tail = strlen(ending);
    if (length < tail) {
        return 0;
    }
    for (size_t i = 0; i < tail; i++) {
        if (tolower((unsigned char)path[length - tail + i]) != ending[i]) {
            return 0;
        }
    }
    return 1;
}

int picture_format_of(const char *path, picture_format *format, fail *f) {
    static const struct {
        const char *ending;
        picture_format format;
    } known[] = {{".png", PICTURE_PNG}, {".ppm", PICTURE_PPM}, {".y4m", PICTURE_Y4M}};
    if (strcmp(path, "-") == 0) {
        return 0;
    }
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        if (ends_in(path, known[i].ending)) {
            *format = known[i].format;
            return 0;
        }
    }
    return fail_set(f, path, "no picture format has this ending; use .png, .ppm or .y4m");
}

int picture_begin(output *o, picture_format format, unsigned width, unsigned height,
                  unsigned frames_per_second, fail *f) {
    if (check_size(width, height, f)) {
        return -1;
    }
    if (format != PICTURE_Y4M) {
        return 0;
    }
    if (frames_per_second == 0) {
        return fail_set(f, NULL, "video at 0 frames per second; choose 1 or more");
    }
    return y4m_begin(o, width, height, frames_per_second, f);
}

int picture_frame(output *o, picture_format format, const picture *p, fail *f) {
    switch (format) {
    case PICTURE_PNG:
        return png_frame(o, p, f);
    case PICTURE_PPM:
        return ppm_frame(o, p, f);
    default:
        return y4m_frame(o, p, f);
    }
}

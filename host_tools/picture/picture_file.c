/* picture_file - see picture_file.h: which format, and its writer
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/picture_file.h"

#include <ctype.h>
#include <string.h>

#include "host_tools/picture/formats.h"

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

int picture_is_film(picture_format format) {
    return format == PICTURE_Y4M || format == PICTURE_Y4M_444;
}

static y4m_chroma chroma_of(picture_format format) {
    return format == PICTURE_Y4M_444 ? Y4M_444 : Y4M_420;
}

int picture_begin(output *o, picture_format format, unsigned width, unsigned height,
                  unsigned frames_per_second, fail *f) {
    if (picture_check_size(width, height, f)) {
        return -1;
    }
    if (!picture_is_film(format)) {
        return 0;
    }
    if (frames_per_second == 0) {
        return fail_set(f, NULL, "video at 0 frames per second; choose 1 or more");
    }
    return y4m_begin(o, chroma_of(format), width, height, frames_per_second, f);
}

int picture_frame(output *o, picture_format format, const picture *p, fail *f) {
    switch (format) {
    case PICTURE_PNG:
        return png_frame(o, p, f);
    case PICTURE_PPM:
        return ppm_frame(o, p, f);
    default:
        return y4m_frame(o, chroma_of(format), p, f);
    }
}

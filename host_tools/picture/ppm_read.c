/* ppm_read - a PPM or PGM picture of 8 bits, P6 and P5, that is in memory
 *
 * Any bytes may come. Source: J. Poskanzer, "ppm", "pgm", Netpbm manual, 1989-.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/picture_read.h"

#include <string.h>

typedef struct reader {
    const uint8_t *at, *end;
} reader;

static int is_blank(uint8_t c) {
    return c == ' ' || (c >= '\t' && c <= '\r');
}

/* A number after blanks and comments, and the one blank behind it; 0: there is none. */
static unsigned number(reader *r) {
    unsigned value = 0;
    while (r->at < r->end && (is_blank(*r->at) || *r->at == '#')) {
        const int comment = *r->at++ == '#';
        while (comment && r->at < r->end && *r->at != '\n') {
            r->at++;
        }
    }
    while (r->at < r->end && *r->at >= '0' && *r->at <= '9' && value < 1000000) {
        value = 10 * value + (unsigned)(*r->at++ - '0');
    }
    r->at += r->at < r->end;
    return value;
}

static void put_pixels(picture *p, const uint8_t *from, unsigned channels, unsigned most) {
    for (size_t i = 0; i < (size_t)p->width * p->height; i++, from += channels) {
        for (unsigned c = 0; c < 3; c++) {
            const unsigned v = (from[c < channels ? c : 0] * 255u + most / 2) / most;
            p->rgb[3 * i + c] = (uint8_t)(v < 255 ? v : 255);
        }
    }
}

int ppm_read(picture *to, const uint8_t *file, size_t bytes, const char *name, fail *f) {
    reader r = {file + 2, file + bytes};
    const unsigned channels = bytes > 1 && file[1] == '6' ? 3 : 1;
    if (bytes < 3 || file[0] != 'P' || (file[1] != '6' && file[1] != '5')) {
        return fail_set(f, name, "is no PNG picture, nor PPM of P6; convert it");
    }
    const unsigned width = number(&r), height = number(&r), most = number(&r);
    if (width == 0 || height == 0 || most == 0 || most > 255) {
        return fail_set(f, name, "only PPM of 8 bits, P6 or P5, is read; convert it");
    }
    if ((uint64_t)width * height * channels > (uint64_t)(r.end - r.at)) {
        return fail_set(f, name, "ends before the last of %u x %u pixels; write it again", width,
                        height);
    }
    if (picture_resize(to, width, height, f) != 0) {
        return -1;
    }
    put_pixels(to, r.at, channels, most);
    return 0;
}

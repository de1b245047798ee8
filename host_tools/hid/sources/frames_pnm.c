/* frames_pnm - PPM and PGM pictures of 8 bits, P6 and P5
 *
 * Source: J. Poskanzer, "ppm", "pgm", Netpbm manual, 1989-.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "host_tools/hid/sources/frames_kinds.h"

/* A number after blanks and comments; 0 when there is none. */
static unsigned number(stream *from) {
    unsigned value = 0;
    int c = stream_byte(from);
    while (c == '#' || c == ' ' || c == '\t' || c == '\n' || c == '\r') {
        while (c == '#' && (c = stream_byte(from)) >= 0 && c != '\n') {
            c = '#';
        }
        c = stream_byte(from);
    }
    while (c >= '0' && c <= '9' && value < 1000000) {
        value = 10 * value + (unsigned)(c - '0');
        c = stream_byte(from);
    }
    return value; /* one blank was taken */
}

static int read_pixels(stream *from, picture *p, unsigned channels, unsigned most) {
    if (channels == 3 && most == 255) {
        const size_t bytes = 3 * (size_t)p->width * p->height;
        return stream_read(from, p->rgb, bytes) == bytes ? 0 : -1;
    }
    for (size_t i = 0; i < (size_t)p->width * p->height; i++) {
        for (unsigned c = 0; c < 3; c++) {
            const int v = c < channels ? stream_byte(from) : p->rgb[3 * i];
            if (v == -1) {
                return -1;
            }
            const unsigned wide =
                c < channels ? ((unsigned)v * 255 + most / 2) / most : (unsigned)v;
            p->rgb[3 * i + c] = (uint8_t)(wide > 255 ? 255 : wide);
        }
    }
    return 0;
}

static int pnm_next(frames *s, picture *p, fail *f) {
    const int c = stream_byte(&s->from);
    if (c == -1) {
        return s->from.is_wrong ? frames_cut(s, "", f) : FRAMES_END;
    }
    const int kind = c == 'P' ? stream_byte(&s->from) : c;
    const unsigned width = number(&s->from), height = number(&s->from), most = number(&s->from);
    if (s->from.is_wrong) {
        return frames_cut(s, "", f);
    }
    if ((kind != '6' && kind != '5') || width == 0 || height == 0 || most == 0 || most > 255) {
        return fail_set(f, s->path, "is no P6 or P5 picture of 8 bits; convert it to one");
    }
    if (picture_resize(p, width, height, f) != 0) {
        return FRAMES_FAILED;
    }
    if (read_pixels(&s->from, p, kind == '6' ? 3 : 1, most) != 0) {
        return frames_cut(s, "ends before its last pixel; write it again", f);
    }
    return FRAMES_ONE;
}

int frames_pnm(frames *s, fail *f) {
    (void)f;
    s->next = pnm_next;
    return 0;
}

/* frames_y4m - films of 8-bit YCbCr, as ffmpeg and planelet render write them
 *
 * C444, C422, C420 of any siting, and Cmono; limited range unless the header
 * says XCOLORRANGE=FULL. The chroma of a pixel is that of the sample that
 * covers it. BT.601 in units of 2^-16:
 *
 *     R = Y + 1.402 Cr,  G = Y - 0.344136 Cb - 0.714136 Cr,  B = Y + 1.772 Cb
 *
 * Limited range is widened first: Y' = (Y - 16) 255/219, C' = C 255/224.
 *
 * Sources: yuv4mpeg(5), MJPEG tools; ITU-R BT.601-7, 2011.
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/hid/sources/frames_kinds.h"

enum { HEAD_BYTES = 512, PERIOD_MOST = 60 }; /* seconds */

typedef struct film {
    unsigned width, height;
    unsigned across, down; /* luma samples per chroma sample; 0: no chroma */
    int full;
    uint8_t *planes; /* Y, Cb, Cr of a frame; owned */
    size_t plane[3]; /* bytes of each */
} film;

static int sampling(film *y, const char *name) {
    static const struct {
        const char *name;
        unsigned across, down;
    } known[] = {{"444", 1, 1},      {"422", 2, 1},      {"420", 2, 2}, {"420jpeg", 2, 2},
                 {"420mpeg2", 2, 2}, {"420paldv", 2, 2}, {"mono", 0, 0}};
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        if (strcmp(known[i].name, name) == 0) {
            y->across = known[i].across;
            y->down = known[i].down;
            return 0;
        }
    }
    return -1;
}

static int read_side(frames *s, unsigned *side, const char *word, fail *f) {
    const unsigned long value = strtoul(word + 1, NULL, 10);
    if (value > PICTURE_SIDE_MAX) {
        return fail_set(f, s->path, "%s: a side of its frames is 1 to %u pixels; make it smaller",
                        word, PICTURE_SIDE_MAX);
    }
    *side = (unsigned)value;
    return 0;
}

static int read_rate(frames *s, const char *word, fail *f) {
    unsigned rate = 0, over = 1;
    if (sscanf(word + 1, "%9u:%9u", &rate, &over) != 2 || rate == 0) {
        return 0; /* not known */
    }
    s->period = (double)over / rate;
    return s->period <= PERIOD_MOST
               ? 0
               : fail_set(f, s->path, "%s: a frame every %.0f seconds; make it one in %d at least",
                          word, s->period, PERIOD_MOST);
}

static int read_word(frames *s, film *y, const char *word, fail *f) {
    if (word[0] == 'W' || word[0] == 'H') {
        return read_side(s, word[0] == 'W' ? &y->width : &y->height, word, f);
    }
    if (word[0] == 'F') {
        return read_rate(s, word, f);
    }
    if (word[0] == 'C' && sampling(y, word + 1) != 0) {
        return fail_set(f, s->path, "colour sampling %s is not known; use C444 or C420, 8 bits",
                        word);
    } else if (strcmp(word, "XCOLORRANGE=FULL") == 0) {
        y->full = 1;
    }
    return 0;
}

static int read_head(frames *s, film *y, fail *f) {
    char head[HEAD_BYTES];
    if (stream_line(&s->from, head, sizeof head) != 0 || strncmp(head, "YUV4MPEG2 ", 10) != 0) {
        return frames_cut(s, "has no Y4M header; make it with planelet render or ffmpeg", f);
    }
    for (char *word = strtok(head + 10, " "); word != NULL; word = strtok(NULL, " ")) {
        if (read_word(s, y, word, f) != 0) {
            return -1;
        }
    }
    if (y->width == 0 || y->height == 0) {
        return fail_set(f, s->path, "its frames are %u x %u pixels; write W and H from 1 to %u",
                        y->width, y->height, PICTURE_SIDE_MAX);
    }
    return 0;
}

static int make_planes(frames *s, film *y, fail *f) {
    y->plane[0] = (size_t)y->width * y->height;
    if (y->across > 0) {
        y->plane[1] = y->plane[2] = (size_t)((y->width + y->across - 1) / y->across) *
                                    ((y->height + y->down - 1) / y->down);
    }
    y->planes = malloc(y->plane[0] + y->plane[1] + y->plane[2]);
    return y->planes == NULL
               ? fail_set(f, s->path, "its frames are too large for memory; make them smaller")
               : 0;
}

static uint8_t clamp(int value) { /* of 2^-16 */
    const int whole = (value + 32768) / 65536;
    return (uint8_t)(value < 0 ? 0 : whole > 255 ? 255 : whole);
}

static void to_rgb(const film *y, int luma, int cb, int cr, uint8_t *rgb) {
    const int unit = y->full ? 65536 : 76309, colour = y->full ? 65536 : 74606;
    const int base = (y->full ? luma : luma - 16) * unit;
    const int64_t b = (int64_t)(cb - 128) * colour, r = (int64_t)(cr - 128) * colour;
    rgb[0] = clamp((int)(base + r * 91881 / 65536));
    rgb[1] = clamp((int)(base - (b * 22553 + r * 46802) / 65536));
    rgb[2] = clamp((int)(base + b * 116130 / 65536));
}

static void convert(const film *y, picture *p) {
    const uint8_t *luma = y->planes, *cb = luma + y->plane[0], *cr = cb + y->plane[1];
    const unsigned chroma = y->across > 0 ? (y->width + y->across - 1) / y->across : 0;
    for (unsigned j = 0; j < y->height; j++) {
        for (unsigned i = 0; i < y->width; i++) {
            const size_t k = chroma > 0 ? (size_t)(j / y->down) * chroma + i / y->across : 0;
            to_rgb(y, *luma++, chroma > 0 ? cb[k] : 128, chroma > 0 ? cr[k] : 128,
                   p->rgb + 3 * ((size_t)j * y->width + i));
        }
    }
}

static int film_next(frames *s, picture *p, fail *f) {
    film *y = s->state;
    char head[HEAD_BYTES];
    if (stream_byte(&s->from) < 0) {
        return s->from.is_wrong ? frames_cut(s, "", f) : FRAMES_END;
    }
    stream_back(&s->from);
    const size_t bytes = y->plane[0] + y->plane[1] + y->plane[2];
    if (stream_line(&s->from, head, sizeof head) != 0 || strncmp(head, "FRAME", 5) != 0 ||
        stream_read(&s->from, y->planes, bytes) != bytes) {
        return frames_cut(s, "ends inside a frame; write the film again", f);
    }
    if (picture_resize(p, y->width, y->height, f) != 0) {
        return FRAMES_FAILED;
    }
    convert(y, p);
    return FRAMES_ONE;
}

static void film_close(frames *s) {
    film *y = s->state;
    if (y != NULL) {
        free(y->planes);
        free(y);
    }
}

int frames_y4m(frames *s, fail *f) {
    film *y = calloc(1, sizeof *y);
    s->next = film_next;
    s->close = film_close;
    s->state = y;
    if (y == NULL) {
        return fail_set(f, s->path, "out of memory; close other programs");
    }
    y->across = y->down = 2; /* C420 when nothing is said */
    return read_head(s, y, f) != 0 || make_planes(s, y, f) != 0 ? -1 : 0;
}

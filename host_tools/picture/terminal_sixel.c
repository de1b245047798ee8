/* terminal_sixel - a picture in sixels, see terminal_graphics.h
 *
 * A band is six rows. Every colour in it is drawn over the whole band in a line of letters, a
 * letter per column, whose six bits are the rows that have the colour.
 *
 * Sources: Digital, "VT330/VT340 Programmer Reference Manual", volume 2, chapter 14 (DCS q, raster
 * attributes, # colours in per cent, ! repeats, $ and -); B. E. Bayer, "An optimum method for
 * two-level rendition of continuous-tone pictures", 1973 (the pattern).
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "host_tools/picture/terminal_graphics.h"

enum { REDS = 6, GREENS = 7, BLUES = 6, COLOURS = REDS * GREENS * BLUES, BAND = 6 };

/* The level, 0 .. levels - 1, with the threshold of this place in the pattern, 0 .. 15. */
static unsigned level(unsigned value, unsigned levels, unsigned threshold) {
    return (value * (levels - 1) * 16 + threshold * 255 + 127) / (255 * 16);
}

static unsigned colour_of(const uint8_t *rgb, unsigned x, unsigned y) {
    static const uint8_t bayer[4][4] = {
        {0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}};
    const unsigned t = bayer[y % 4][x % 4];
    return (level(rgb[0], REDS, t) * GREENS + level(rgb[1], GREENS, t)) * BLUES +
           level(rgb[2], BLUES, t);
}

static void put_palette(FILE *to) {
    for (unsigned i = 0; i < COLOURS; i++) {
        fprintf(to, "#%u;2;%u;%u;%u", i, i / (GREENS * BLUES) * 100 / (REDS - 1),
                i / BLUES % GREENS * 100 / (GREENS - 1), i % BLUES * 100 / (BLUES - 1));
    }
}

static void put_run(FILE *to, char letter, unsigned count) {
    if (count > 3) {
        fprintf(to, "!%u%c", count, letter);
        return;
    }
    while (count-- > 0) {
        fputc(letter, to);
    }
}

/* One colour of a band: blanks behind its last column are left out. */
static void put_line(FILE *to, const uint8_t *place, unsigned width, unsigned colour) {
    char last = 0;
    unsigned count = 0;
    fprintf(to, "#%u", colour);
    for (unsigned x = 0; x < width; x++) {
        unsigned sixel = 0;
        for (unsigned y = 0; y < BAND; y++) {
            sixel |= (unsigned)(place[y * width + x] == colour) << y;
        }
        const char letter = (char)('?' + sixel);
        if (letter != last) {
            put_run(to, last, count);
            count = 0;
        }
        last = letter;
        count++;
    }
    if (last != '?') {
        put_run(to, last, count);
    }
    fputc('$', to);
}

static void put_band(FILE *to, const picture *p, unsigned top, uint8_t *place) {
    uint8_t used[COLOURS] = {0};
    memset(place, 255, (size_t)BAND * p->width); /* no colour: below the picture */
    for (unsigned y = top; y < top + BAND && y < p->height; y++) {
        for (unsigned x = 0; x < p->width; x++) {
            const unsigned colour = colour_of(p->rgb + 3 * ((size_t)y * p->width + x), x, y);
            place[(y - top) * p->width + x] = (uint8_t)colour;
            used[colour] = 1;
        }
    }
    for (unsigned i = 0; i < COLOURS; i++) {
        if (used[i]) {
            put_line(to, place, p->width, i);
        }
    }
}

int terminal_sixel(FILE *to, const picture *p) {
    uint8_t *place = malloc((size_t)BAND * p->width);
    if (place == NULL) {
        return -1;
    }
    fprintf(to, "\x1bP0;1;0q\"1;1;%u;%u", p->width, p->height);
    put_palette(to);
    for (unsigned y = 0; y < p->height; y += BAND) {
        if (y > 0) {
            fputc('-', to); /* not behind the last: that could scroll the screen */
        }
        put_band(to, p, y, place);
    }
    fputs("\x1b\\", to);
    free(place);
    return 0;
}

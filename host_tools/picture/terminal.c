/* terminal - see terminal.h
 *
 * A cell is two pixels, one above the other. With half blocks it shows both: U+2580
 * (upper half block) in the colour of the upper on the colour of the lower. With a blank
 * or a character it shows their mean. A colour is sent only when it differs from the last
 * one sent on this line.
 *
 * Sources: ECMA-48, 1991, section 8.3.117 (SGR 1, 30 to 37); ITU-T T.416 | ISO/IEC 8613-6,
 * 1993 (SGR 38, 48).
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/terminal.h"

#include <errno.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "host_tools/base/temporary.h"
#include "host_tools/picture/fit.h"

#define CELLS_MAX 10000

static const char half_block[] = "\xE2\x96\x80";
static const char ramp[] = " .:-=+*#%@"; /* dark to bright */

static unsigned from_environment(const char *name, unsigned otherwise) {
    const char *text = getenv(name);
    char *end;
    const long value = text ? strtol(text, &end, 10) : 0;
    return value > 0 && value <= CELLS_MAX && !*end ? (unsigned)value : otherwise;
}

void picture_terminal_size(FILE *to, unsigned *columns, unsigned *rows) {
    *columns = from_environment("COLUMNS", 80);
    *rows = from_environment("LINES", 24);
#ifdef TIOCGWINSZ
    struct winsize size;
    if (ioctl(fileno(to), TIOCGWINSZ, &size) == 0 && size.ws_col && size.ws_row) {
        *columns = size.ws_col < CELLS_MAX ? size.ws_col : CELLS_MAX;
        *rows = size.ws_row < CELLS_MAX ? size.ws_row : CELLS_MAX;
    }
#else
    (void)to;
#endif
}

static unsigned in_proportion(unsigned side, unsigned to, unsigned from) {
    const uint64_t scaled = ((uint64_t)side * to + from / 2) / from;
    return scaled ? (unsigned)scaled : 1;
}

/* The largest size of p's aspect within `columns` x `lines` and p's own. */
static void choose_size(const picture *p, unsigned columns, unsigned lines, unsigned *w,
                        unsigned *h) {
    *w = p->width;
    *h = p->height;
    if (p->width <= columns && p->height <= lines) {
        return;
    }
    if ((uint64_t)p->width * lines >= (uint64_t)p->height * columns) {
        *w = columns;
        *h = in_proportion(p->height, columns, p->width);
    } else {
        *h = lines;
        *w = in_proportion(p->width, lines, p->height);
    }
}

static int scale(picture *small, const picture *p, unsigned columns, unsigned lines) {
    unsigned w, h;
    fail f = {""};
    choose_size(p, columns, lines, &w, &h);
    if (picture_make(small, w, h, &f)) {
        return -1;
    }
    fit_picture(p, small, FIT_STRETCH);
    return 0;
}

static int has_24_bits(picture_ink ink) {
    return ink == PICTURE_COLOUR || ink == PICTURE_COLOUR_BLANKS;
}

/* Sends `rgb` as SGR 38 (upper) or 48 (lower) unless `last` is the same.
 * Errors stay in the stream and are asked for at the end. */
static void colour(FILE *to, picture_ink ink, unsigned sgr, const uint8_t *rgb, int *last) {
    const int now =
        has_24_bits(ink) ? rgb[0] << 16 | rgb[1] << 8 | rgb[2] : (int)terminal_nearest_256(rgb);
    if (now == *last) {
        return;
    }
    *last = now;
    if (has_24_bits(ink)) {
        fprintf(to, "\x1b[%u;2;%u;%u;%um", sgr, rgb[0], rgb[1], rgb[2]);
    } else {
        fprintf(to, "\x1b[%u;5;%dm", sgr, now);
    }
}

typedef struct row_pair {
    const uint8_t *upper, *lower; /* NULL: the picture ends with the upper */
    unsigned width;
} row_pair;

static void half_block_line(FILE *to, picture_ink ink, const row_pair *r) {
    int last_upper = -1, last_lower = -1;
    for (unsigned x = 0; x < r->width; x++) {
        colour(to, ink, 38, r->upper + 3 * x, &last_upper);
        if (r->lower) {
            colour(to, ink, 48, r->lower + 3 * x, &last_lower);
        }
        fputs(half_block, to);
    }
    fputs("\x1b[0m\n", to);
}

/* A last row without a lower one has whole cells all the same. */
static void mean(const row_pair *r, unsigned x, uint8_t *rgb) {
    const uint8_t *upper = r->upper + 3 * x, *lower = r->lower ? r->lower + 3 * x : upper;
    for (unsigned i = 0; i < 3; i++) {
        rgb[i] = (uint8_t)((upper[i] + lower[i] + 1) / 2);
    }
}

static void blank_line(FILE *to, picture_ink ink, const row_pair *r) {
    int last = -1;
    for (unsigned x = 0; x < r->width; x++) {
        uint8_t rgb[3];
        mean(r, x, rgb);
        colour(to, ink, 48, rgb, &last);
        fputc(' ', to);
    }
    fputs("\x1b[0m\n", to);
}

/* Of a colour that is on the screen in full, as much as the brightest channel says. */
static void hue_line(FILE *to, const row_pair *r) {
    unsigned last = 8;
    for (unsigned x = 0; x < r->width; x++) {
        uint8_t rgb[3];
        mean(r, x, rgb);
        const unsigned red_green = rgb[0] > rgb[1] ? rgb[0] : rgb[1];
        const unsigned most = red_green > rgb[2] ? red_green : rgb[2];
        const char shade = ramp[most * (sizeof ramp - 1) / 256];
        const unsigned hue = terminal_hue(rgb);
        if (hue != last && shade != ' ') {
            fprintf(to, "\x1b[1;3%um", hue);
            last = hue;
        }
        fputc(shade, to);
    }
    fputs("\x1b[0m\n", to);
}

static unsigned brightness(const uint8_t *rgb) { /* BT.601, 0 .. 255000 */
    return 299u * rgb[0] + 587u * rgb[1] + 114u * rgb[2];
}

static void plain_line(FILE *to, const row_pair *r) {
    const uint8_t *lower = r->lower ? r->lower : r->upper;
    for (unsigned x = 0; x < r->width; x++) {
        const unsigned sum = brightness(r->upper + 3 * x) + brightness(lower + 3 * x);
        fputc(ramp[(size_t)sum * (sizeof ramp - 1) / 510001], to);
    }
    fputc('\n', to);
}

static void draw_line(FILE *to, const picture *p, picture_ink ink, unsigned y) {
    const uint8_t *upper = p->rgb + 3 * (size_t)y * p->width;
    const row_pair r = {upper, y + 1 < p->height ? upper + 3 * (size_t)p->width : NULL, p->width};
    switch (ink) {
    case PICTURE_256:
    case PICTURE_COLOUR:
        half_block_line(to, ink, &r);
        return;
    case PICTURE_256_BLANKS:
    case PICTURE_COLOUR_BLANKS:
        blank_line(to, ink, &r);
        return;
    case PICTURE_HUES:
        hue_line(to, &r);
        return;
    default:
        plain_line(to, &r);
    }
}

/* Ctrl-C waits for the end of the picture: the cursor is then below it. (Ctrl-C also
 * resumes a terminal that was stopped.) Other signals do not wait: a terminal may
 * never accept a byte again, and then keeps its colours. */
static int draw(FILE *to, const picture *small, picture_ink ink) {
    sigset_t interrupt, before;
    sigemptyset(&interrupt);
    sigaddset(&interrupt, SIGINT);
    sigprocmask(SIG_BLOCK, &interrupt, &before);
    if (ink != PICTURE_PLAIN && isatty(fileno(to))) {
        temporary_colours(fileno(to));
    }
    for (unsigned y = 0; y < small->height; y += 2) {
        draw_line(to, small, ink, y);
    }
    const int status = fflush(to) || ferror(to) ? -1 : 0;
    sigprocmask(SIG_SETMASK, &before, NULL);
    return status;
}

int picture_show(FILE *to, const picture *p, picture_ink ink, unsigned columns, unsigned rows) {
    picture small;
    if (columns == 0 || rows == 0) {
        picture_terminal_size(to, &columns, &rows);
    }
    rows = rows < CELLS_MAX ? rows : CELLS_MAX;
    if (scale(&small, p, columns, 2 * rows)) {
        errno = ENOMEM;
        return -1;
    }
    const int status = draw(to, &small, ink == PICTURE_AUTO ? terminal_ink(to) : ink);
    picture_free(&small);
    return status;
}

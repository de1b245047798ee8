/* terminal - see terminal.h
 *
 * A cell shows two pixels, one above the other: U+2580 (upper half block)
 * in the colour of the upper on the colour of the lower. A colour is sent
 * only when it differs from the last one sent on this line.
 *
 * Sources: ITU-T T.416 | ISO/IEC 8613-6, 1993 (SGR 38, 48);
 * https://no-color.org, 2017.
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

static int has_colour(FILE *to) {
    const char *no = getenv("NO_COLOR"), *term = getenv("TERM");
    return !(no && *no) && term && *term && strcmp(term, "dumb") != 0 && isatty(fileno(to));
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

/* Sends `rgb` as SGR 38 (upper) or 48 (lower) unless `last` is the same.
 * Errors stay in the stream and are asked for at the end. */
static void colour(FILE *to, unsigned sgr, const uint8_t *rgb, int *last) {
    const int now = rgb[0] << 16 | rgb[1] << 8 | rgb[2];
    if (now != *last) {
        fprintf(to, "\x1b[%u;2;%u;%u;%um", sgr, rgb[0], rgb[1], rgb[2]);
        *last = now;
    }
}

static void colour_line(FILE *to, const picture *p, unsigned y) {
    const uint8_t *upper = p->rgb + 3 * (size_t)y * p->width;
    const uint8_t *lower = y + 1 < p->height ? upper + 3 * (size_t)p->width : NULL;
    int last_upper = -1, last_lower = -1;
    for (unsigned x = 0; x < p->width; x++) {
        colour(to, 38, upper + 3 * x, &last_upper);
        if (lower) {
            colour(to, 48, lower + 3 * x, &last_lower);
        }
        fputs(half_block, to);
    }
    fputs("\x1b[0m\n", to);
}

static unsigned brightness(const uint8_t *rgb) { /* BT.601, 0 .. 255000 */
    return 299u * rgb[0] + 587u * rgb[1] + 114u * rgb[2];
}

static void plain_line(FILE *to, const picture *p, unsigned y) {
    const uint8_t *upper = p->rgb + 3 * (size_t)y * p->width;
    const uint8_t *lower = y + 1 < p->height ? upper + 3 * (size_t)p->width : upper;
    for (unsigned x = 0; x < p->width; x++) {
        const unsigned sum = brightness(upper + 3 * x) + brightness(lower + 3 * x);
        fputc(ramp[(size_t)sum * (sizeof ramp - 1) / 510001], to);
    }
    fputc('\n', to);
}

/* Ctrl-C waits for the end of the picture: the cursor is then below it. (Ctrl-C also
 * resumes a terminal that was stopped.) Other signals do not wait: a terminal may
 * never accept a byte again, and then keeps its colours. */
static int draw(FILE *to, const picture *small, int coloured) {
    sigset_t interrupt, before;
    sigemptyset(&interrupt);
    sigaddset(&interrupt, SIGINT);
    sigprocmask(SIG_BLOCK, &interrupt, &before);
    if (coloured && isatty(fileno(to))) {
        temporary_colours(fileno(to));
    }
    for (unsigned y = 0; y < small->height; y += 2) {
        if (coloured) {
            colour_line(to, small, y);
        } else {
            plain_line(to, small, y);
        }
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
    const int coloured = ink == PICTURE_COLOUR || (ink == PICTURE_AUTO && has_colour(to));
    const int status = draw(to, &small, coloured);
    picture_free(&small);
    return status;
}

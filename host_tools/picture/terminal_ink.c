/* terminal_ink - see terminal_ink.h
 *
 * On Linux's own console backgrounds have eight colours, and the fonts that Debian sets
 * there (console-setup: Lat15, Uni2 and others) have no half block: there only characters
 * and their colours are safe.
 *
 * A VT100, VT220 or VT52 knows no colours, and neither does a terminal whose entry in terminfo
 * ends in "-m" or "-mono".
 *
 * Sources: https://no-color.org, 2017; https://github.com/termstandard/colors (COLORTERM,
 * and that "-direct" in TERM says 24 bits); xterm's 256colres.pl (the cube and the greys);
 * POSIX.1-2017, Base Definitions, section 8.2 (which variable is the locale).
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/terminal_ink.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

static const char *said(const char *name) {
    const char *value = getenv(name);
    return value == NULL ? "" : value;
}

static int ends_in(const char *text, const char *ending) {
    const size_t length = strlen(text), tail = strlen(ending);
    return length >= tail && strcmp(text + length - tail, ending) == 0;
}

/* "de_DE.UTF-8", "C.utf8", "UTF-8". */
static int locale_is_utf8(void) {
    const char *locale = said("LC_ALL");
    if (locale[0] == '\0') {
        locale = said("LC_CTYPE");
    }
    if (locale[0] == '\0') {
        locale = said("LANG");
    }
    const char *dot = strchr(locale, '.');
    const char *charset = dot == NULL ? locale : dot + 1;
    const size_t length = strcspn(charset, "@");
    return (length == 5 && strncasecmp(charset, "UTF-8", 5) == 0) ||
           (length == 4 && strncasecmp(charset, "UTF8", 4) == 0);
}

static int begins_with(const char *text, const char *beginning) {
    return strncmp(text, beginning, strlen(beginning)) == 0;
}

static int is_monochrome(const char *term) {
    return term[0] == '\0' || strcmp(term, "dumb") == 0 || begins_with(term, "vt1") ||
           begins_with(term, "vt2") || strcmp(term, "vt52") == 0 || ends_in(term, "-m") ||
           ends_in(term, "-mono");
}

picture_ink terminal_ink(FILE *to) {
    const char *term = said("TERM"), *colours = said("COLORTERM");
    if (!isatty(fileno(to)) || said("NO_COLOR")[0] != '\0' || is_monochrome(term)) {
        return PICTURE_PLAIN;
    }
    if (strcmp(colours, "truecolor") == 0 || strcmp(colours, "24bit") == 0 ||
        ends_in(term, "-direct")) {
        return locale_is_utf8() ? PICTURE_COLOUR : PICTURE_COLOUR_BLANKS;
    }
    if (strcmp(term, "linux") == 0 || strcmp(term, "ansi") == 0 || ends_in(term, "-16color")) {
        return PICTURE_HUES;
    }
    return locale_is_utf8() ? PICTURE_256 : PICTURE_256_BLANKS;
}

static unsigned distance(const uint8_t *rgb, unsigned r, unsigned g, unsigned b) {
    const int red = rgb[0] - (int)r, green = rgb[1] - (int)g, blue = rgb[2] - (int)b;
    return (unsigned)(red * red + green * green + blue * blue);
}

/* The nearest of 0, 95, 135, 175, 215, 255: 0 to 5. */
static unsigned cube_step(unsigned value) {
    return value < 48 ? 0 : value < 115 ? 1 : (value - 35) / 40;
}

static unsigned cube_level(unsigned step) {
    return step == 0 ? 0 : 55 + 40 * step;
}

/* The greys are 8, 18 ... 238. */
unsigned terminal_nearest_256(const uint8_t *rgb) {
    const unsigned r = cube_step(rgb[0]), g = cube_step(rgb[1]), b = cube_step(rgb[2]);
    const unsigned mean = ((unsigned)rgb[0] + rgb[1] + rgb[2]) / 3;
    const unsigned grey = mean < 8 ? 0 : mean > 238 ? 23 : (mean - 3) / 10;
    const unsigned level = 8 + 10 * grey;
    return distance(rgb, level, level, level) <
                   distance(rgb, cube_level(r), cube_level(g), cube_level(b))
               ? 232 + grey
               : 16 + 36 * r + 6 * g + b;
}

unsigned terminal_hue(const uint8_t *rgb) {
    unsigned least = 255, most = 0;
    for (unsigned i = 0; i < 3; i++) {
        least = rgb[i] < least ? rgb[i] : least;
        most = rgb[i] > most ? rgb[i] : most;
    }
    if (5 * (most - least) < 2 * most) {
        return 7;
    }
    return (2u * rgb[0] >= least + most ? 1 : 0) + (2u * rgb[1] >= least + most ? 2 : 0) +
           (2u * rgb[2] >= least + most ? 4 : 0);
}

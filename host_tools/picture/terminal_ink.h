/* terminal_ink - what a terminal can draw a picture with, by what its environment says
 *
 * SPDX-License-Identifier: MIT */
#ifndef TERMINAL_INK_H
#define TERMINAL_INK_H
#include <stdint.h>
#include <stdio.h>

typedef enum picture_ink {
    PICTURE_AUTO,          /* what terminal_ink says of the file */
    PICTURE_PLAIN,         /* characters from dark to bright, light on a dark ground */
    PICTURE_HUES,          /* the same, each in the nearest of eight hues */
    PICTURE_256,           /* half blocks, two pixels per cell, in the colours of xterm */
    PICTURE_256_BLANKS,    /* blanks instead, a pixel per cell: no UTF-8 */
    PICTURE_COLOUR,        /* half blocks in 24 bits */
    PICTURE_COLOUR_BLANKS, /* blanks in 24 bits */
    PICTURE_INKS           /* how many there are */
} picture_ink;

/* Never PICTURE_AUTO. The first that holds:
 *
 *     `to` is no terminal, NO_COLOR is set and not empty, TERM is not set,
 *     empty, "dumb" or "vt52", begins with "vt1" or "vt2", or ends in
 *     "-m" or "-mono"                                                     PLAIN
 *     COLORTERM is "truecolor" or "24bit", or TERM ends in "-direct"      COLOUR
 *     TERM is "linux" or "ansi", or ends in "-16color"                    HUES
 *     all others, as "xterm-256color" and "screen"                        256
 *
 * The last two kinds of colour are blanks where the locale (the first of LC_ALL,
 * LC_CTYPE, LANG that is set and not empty) does not name UTF-8. */
picture_ink terminal_ink(FILE *to);

/* For the help of a command that draws. */
#define TERMINAL_INK_HELP                                                                          \
    "plain characters if NO_COLOR is set, TERM is monochrome (dumb, vt100 ...) or not set, or "    \
    "the output no terminal; "                                                                     \
    "else half blocks in 24-bit colour if COLORTERM is truecolor or 24bit, characters in eight "   \
    "colours if TERM is linux, or half blocks in 256 colours; blanks for half blocks if the "      \
    "locale is not UTF-8"

/* The number, 16 to 255, of the nearest of xterm's 256 colours: its cube of 6 x 6 x 6 or
 * its greys. (The first 16 differ from terminal to terminal.) */
unsigned terminal_nearest_256(const uint8_t *rgb);

/* The hue, 1 to 7 as in SGR 31 to 37: of the channels that are nearer to the brightest
 * than to the darkest one; white (7) where these differ by less than two fifths. */
unsigned terminal_hue(const uint8_t *rgb);

#endif

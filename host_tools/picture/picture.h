/* picture - 8-bit RGB frames to files and to the terminal
 *
 * SPDX-License-Identifier: MIT */
#ifndef PICTURE_H
#define PICTURE_H
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "host_tools/base/fail.h"
#include "host_tools/base/output.h"

#define PICTURE_SIDE_MAX 32768u

typedef struct picture {
    uint8_t *rgb;           /* 3 bytes per pixel, rows top down, no padding; owned */
    unsigned width, height; /* 1 .. PICTURE_SIDE_MAX */
} picture;

/* A black picture; on failure `p` is all zero, and may be freed. */
int picture_make(picture *p, unsigned width, unsigned height, fail *f);
void picture_free(picture *p);

/* Gives `p`, made before or zero, this size: pixels are kept if it has it already,
 * else black. */
int picture_resize(picture *p, unsigned width, unsigned height, fail *f);

/* Format by the ending: .png .ppm .y4m in any case; "-" leaves `format` as
 * the caller chose it. Y4M holds any number of frames (4:4:4, full range said
 * in the header), PNG and PPM one. A file is one picture_begin, then
 * picture_frame for pictures of just that size; `frames_per_second` is at
 * least 1 for Y4M and else ignored. Memory: PNG needs twice
 * the picture, the others none. */
typedef enum picture_format { PICTURE_PNG, PICTURE_PPM, PICTURE_Y4M } picture_format;
int picture_format_of(const char *path, picture_format *format, fail *f);
int picture_begin(output *o, picture_format format, unsigned width, unsigned height,
                  unsigned frames_per_second, fail *f);
int picture_frame(output *o, picture_format format, const picture *p, fail *f);

/* Draws `p` into at most `columns` x `rows` character cells, keeping its
 * aspect (a cell is twice as tall as wide), made smaller by area averaging,
 * never larger: 24-bit half blocks, or plain characters for light text on
 * dark ground where there is no colour (PICTURE_AUTO with NO_COLOR set,
 * TERM unset or "dumb", or `to` not a terminal). Every line ends in a line
 * feed with all attributes reset; SIGINT waits for the last. 0 columns or rows:
 * picture_terminal_size. Returns 0, or -1 when writing failed (errno says why) or memory is out. */
typedef enum picture_ink { PICTURE_AUTO, PICTURE_COLOUR, PICTURE_PLAIN } picture_ink;
int picture_show(FILE *to, const picture *p, picture_ink ink, unsigned columns, unsigned rows);

/* From the terminal, else COLUMNS and LINES, else 80 x 24; 1 .. 10000 each. */
void picture_terminal_size(FILE *to, unsigned *columns, unsigned *rows);

#endif

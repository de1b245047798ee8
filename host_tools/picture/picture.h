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

typedef struct picture {
    uint8_t *rgb; /* 3 bytes a pixel, rows top down, no padding; owned */
    unsigned width, height;
} picture;

int picture_make(picture *p, unsigned width, unsigned height, fail *f);
void picture_free(picture *p);

/* Format by the ending: .png .ppm .y4m; "-" takes `format` from the
 * caller. Y4M holds any number of frames (4:4:4, full range said in the
 * header), PNG and PPM one. */
typedef enum picture_format { PICTURE_PNG, PICTURE_PPM, PICTURE_Y4M } picture_format;
int picture_format_of(const char *path, picture_format *format, fail *f);
int picture_begin(output *o, picture_format format, unsigned width, unsigned height,
                  unsigned frames_per_second, fail *f);
int picture_frame(output *o, picture_format format, const picture *p, fail *f);

/* Draws `p` into `columns` x `rows` character cells, keeping its aspect:
 * 24-bit half blocks, or plain characters where colour is not to be had
 * (NO_COLOR, TERM=dumb, not a terminal and not forced). */
typedef enum picture_ink { PICTURE_AUTO, PICTURE_COLOUR, PICTURE_PLAIN } picture_ink;
int picture_show(FILE *to, const picture *p, picture_ink ink, unsigned columns, unsigned rows);
void picture_terminal_size(FILE *to, unsigned *columns, unsigned *rows);

#endif

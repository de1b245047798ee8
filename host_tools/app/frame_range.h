/* frame_range - which frames of a sequence: A:B, and the file of each
 *
 * SPDX-License-Identifier: MIT */
#ifndef FRAME_RANGE_H
#define FRAME_RANGE_H

enum { FRAME_RANGE_END = 100000 };

typedef struct frame_range {
    unsigned first, count;
} frame_range;

/* "A:B", A below B. -1: it is not, or too far. */
int frame_range_read(frame_range *r, const char *text);

/* 1: the name has a '{}'. */
int frame_range_is_pattern(const char *name);

/* The name with the number, of three digits or more, for its '{}', if it has one. From malloc;
 * NULL: out of memory. */
char *frame_range_file(const char *name, unsigned number);

#endif

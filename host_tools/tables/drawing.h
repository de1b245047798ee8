/* drawing - a few shapes on a white sheet, as SVG or as pixels
 *
 * Units are those of SVG, (0, 0) top left, y down; a pixel picture has two pixels per unit. The
 * same drawing is the same pixels on every machine: + - * / and square roots alone.
 *
 * SPDX-License-Identifier: MIT */
#ifndef DRAWING_H
#define DRAWING_H
#include <stdint.h>

#include "host_tools/base/fail.h"
#include "host_tools/base/output.h"
#include "host_tools/picture/picture.h"

enum { DRAWING_TEXT = 120, DRAWING_PIXELS = 2 /* per unit */ };
enum { DRAWING_ADVANCE = 6 }; /* units of a letter, in text of scale 1 */

typedef enum drawing_shape { DRAWING_RECTANGLE, DRAWING_LINE, DRAWING_LETTERS } drawing_shape;
typedef enum drawing_anchor { DRAWING_START, DRAWING_MIDDLE, DRAWING_END } drawing_anchor;

typedef struct drawing_item {
    drawing_shape shape;
    drawing_anchor anchor;   /* of letters: what of them is at x; y is their base line */
    double x, y, x2, y2;     /* corners, or ends */
    double width;            /* of a line; of letters 1 or 2, their scale */
    uint32_t colour;         /* 0xRRGGBB */
    char text[DRAWING_TEXT]; /* ASCII */
} drawing_item;

typedef struct drawing {
    unsigned width, height;
    drawing_item *item; /* owned */
    unsigned items, room;
    int wrong; /* memory is out: all that follows does nothing */
} drawing;

void drawing_free(drawing *d);
void drawing_rectangle(drawing *d, double x, double y, double x2, double y2, uint32_t colour);
void drawing_line(drawing *d, double x, double y, double x2, double y2, double width,
                  uint32_t colour);
void drawing_letters(drawing *d, double x, double y, drawing_anchor anchor, unsigned scale,
                     uint32_t colour, const char *text);

int drawing_svg(const drawing *d, output *o, fail *f);
/* `to` is zero or a picture. */
int drawing_paint(const drawing *d, picture *to, fail *f);

#endif

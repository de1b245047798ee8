/* model - a display as seen from the cable: reports in, a panel that can be read
 *
 * Written from the same notes as the drivers, but by other rules: a model
 * parses what comes (a BMP file as such, columns as columns) and counts every
 * breach of the notes, so that agreement is more than one piece of code read
 * twice. It does not show that hardware agrees.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_MODEL_H
#define HID_MODEL_H

#include <stddef.h>
#include <stdint.h>

typedef struct model model;

/* Sizes are in bytes without a report's number; a number of 0 is none. */
typedef struct model_kind {
    const char *name; /* of the driver that is for it */
    uint16_t vendor, id;
    int interface;
    unsigned width, height;
    uint8_t output_number, feature_number, input_number;
    uint16_t output_bytes, feature_bytes, input_bytes;
    int (*open)(model *m); /* may be NULL */
    int lossy; /* squares of 24x24 pixels may be off by so much, mean of squares of 8-bit values */
    int bits;  /* of each colour that its pixels keep; 1: lit or not; 0: all, or as they say */
    void (*output)(model *m, const uint8_t *report, size_t bytes);  /* number first, if any */
    void (*feature)(model *m, const uint8_t *report, size_t bytes); /* likewise; may be NULL */
    size_t (*input)(model *m, uint8_t *report, size_t room);        /* likewise; may be NULL */
    void (*key)(model *m, unsigned key, int is_down);               /* may be NULL: no keys */
} model_kind;

struct model {
    const model_kind *kind;
    unsigned width, height;
    unsigned format;       /* of a Planelet panel: enum wire_format */
    unsigned report_bytes; /* of its output reports */
    unsigned in_bytes;     /* of its input reports */
    int reads;             /* of a Planelet panel: it is memory that can be read */
    int has_keys;          /* of a Planelet panel; without, it is an older firmware's */
    uint8_t *rgb;          /* what the panel shows, 3 bytes per pixel; owned */
    unsigned changes;      /* times the panel was completed or changed */
    unsigned wrong;        /* breaches of the protocol ... */
    char why[120];         /* ... and the first of them */
    int brightness;        /* as it came; -1: never */
    unsigned releases;
    void (*changed)(void *context, model *m); /* after each change; may be NULL */
    void *context;
    void *state; /* the kind's; owned */
};

extern const model_kind model_planelet, model_mini, model_nova, model_nova_elite, model_apex,
    model_apex_2023, model_nexus, model_logitech, model_picolcd, model_original, model_corsair_lcd,
    model_deck, model_deck_xl, model_deck_neo, model_deck_plus;
const model_kind *model_kind_named(const char *name); /* NULL: there is none */

/* The shape is for Planelet panels; 0 means 64x48, RGB565, a panel that cannot
 * be read, reports of 64 bytes in both directions. NULL when memory is out. */
typedef struct model_shape {
    unsigned width, height, format, report_bytes;
    int reads;
    unsigned in_bytes; /* at most 64 */
    int has_keys;
} model_shape;
model *model_make(const model_kind *kind, model_shape shape);
void model_free(model *m);

/* Counts a breach. */
void model_breach(model *m, const char *what);

/* The report descriptor: at most 96 bytes. */
size_t model_descriptor(const model *m, uint8_t *to);

/* Compares the panel with pictures of pattern.h. Returns the first number in
 * from .. from + count - 1 whose picture, seen through the panel's format, is
 * on the panel in every pixel, as exactly as its kind can, or -1. */
int model_shows_pattern(const model *m, unsigned from, unsigned count);

/* Of a Planelet panel over a lossy link: whether each row of each tile of 16 x 16
 * pixels is that of one of these pictures, or dark as at the start. A row may
 * be late, as tiles go to the panel row by row; it must not be wrong. */
int model_rows_are_whole(const model *m, unsigned from, unsigned count);

#endif

/* parameters - a line of key=value items separated by spaces
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_PARAMETERS_H
#define PLT_BOARD_PARAMETERS_H

#include <stddef.h>
#include <stdint.h>

/* A value inside the line it was found in; not ended by a zero. */
typedef struct parameter {
    const char *text;
    unsigned length;
} parameter;

/* The value of the first item with this key: 1, or 0 when there is none. */
int parameter_find(const char *line, const char *key, parameter *value);

/* The first item whose key is neither among `keys` nor among `more` (separated by
 * spaces), or that has no '=': 1 and the item; 0 when there is none. */
int parameter_unknown(const char *line, const char *keys, const char *more, parameter *item);

int parameter_is(const parameter *p, const char *word);

/* Each of these returns -1 when the value is not of the form. */
int parameter_u32(const parameter *p, uint32_t *value);
int parameter_size(const parameter *p, uint32_t *width, uint32_t *height); /* 320x240 */
int parameter_floats(const parameter *p, float *values, unsigned count);   /* 1,2,3 */
int parameter_copy(const parameter *p, char *to, size_t bytes);            /* with a zero */

#endif

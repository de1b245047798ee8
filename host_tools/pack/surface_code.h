/* surface_code - normals and colours of corners as an image has them
 *
 * SPDX-License-Identifier: MIT */
#ifndef SURFACE_CODE_H
#define SURFACE_CODE_H
#include <stdint.h>

/* Of a corner's normal (mesh/corners.h) that code of 16 bits whose normal is nearest. */
uint32_t surface_normal_code(uint32_t normal);

/* Of a corner's colour 24 bits, red in the lowest. One that has none is of clay. */
uint32_t surface_colour(uint32_t colour);

#endif

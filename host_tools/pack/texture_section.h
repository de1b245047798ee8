/* texture_section - the sections of textures and of their tiles (SPEC.md, 4.22)
 *
 * SPDX-License-Identifier: MIT */
#ifndef TEXTURE_SECTION_H
#define TEXTURE_SECTION_H
#include "host_tools/pack/pack.h"
#include "host_tools/picture/picture.h"

/* How a material of the image has its texture. */
typedef struct texture_paint {
    unsigned texture; /* 1 + its number; 0: none */
    int clamp;
    float scale[2], offset[2];
} texture_paint;

typedef struct texture_set {
    const picture *picture; /* sides of at most PLT_TEXTURE_SIDE_MOST; at most 255 */
    uint32_t pictures;
    const texture_paint *paint; /* by material of the image */
    uint32_t paints;
    uint8_t format; /* enum plt_texture_format */
} texture_set;

typedef struct texture_stats {
    uint32_t textures, bytes; /* bytes: of both sections; 0: there are none */
    uint64_t texels;          /* of the pictures */
    double psnr;              /* of all of them, in sRGB, in decibels; 99: nothing is lost */
} texture_stats;

/* Adds them to an image that has none, behind its materials. -1, and the image is as it was or
 * half done: memory is out, or it gets too large. */
int texture_section_add(packed *image, const texture_set *set, const char *name,
                        texture_stats *stats, fail *f);

#endif

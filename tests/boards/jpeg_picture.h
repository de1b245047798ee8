/* jpeg_picture - a picture that needs no file, and a hash, for boards and hosts
 *
 * SPDX-License-Identifier: MIT */
#ifndef JPEG_PICTURE_H
#define JPEG_PICTURE_H
#include "host_tools/picture/picture.h"

enum { JPEG_PICTURE_SIDE = 120, JPEG_PICTURE_QUALITY = 85 };

/* Shades and the edge of a disk, as a key of a display might show them. */
static inline void jpeg_picture_fill(uint8_t *rgb) {
    for (int y = 0; y < JPEG_PICTURE_SIDE; y++) {
        for (int x = 0; x < JPEG_PICTURE_SIDE; x++, rgb += 3) {
            const int dx = x - 50, dy = y - 64, far = dx * dx + dy * dy;
            const int inside = far < 1600;
            rgb[0] = (uint8_t)(inside ? 240 - far / 16 : 40 + x / 2);
            rgb[1] = (uint8_t)(inside ? 170 - far / 20 : 70 + y / 2);
            rgb[2] = (uint8_t)(inside ? 60 + y / 2 : 130 - x / 4);
        }
    }
}

/* FNV-1a. */
static inline uint32_t jpeg_picture_hash(const uint8_t *bytes, size_t count) {
    uint32_t hash = 2166136261u;
    for (size_t i = 0; i < count; i++) {
        hash = (hash ^ bytes[i]) * 16777619u;
    }
    return hash;
}

#endif

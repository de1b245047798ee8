/* picture_read - a picture from a file's bytes
 *
 * SPDX-License-Identifier: MIT */
#ifndef PICTURE_READ_H
#define PICTURE_READ_H
#include "host_tools/picture/picture.h"

/* As png_read (png.h), of PPM and PGM. */
int ppm_read(picture *to, const uint8_t *file, size_t bytes, const char *name, fail *f);

/* PNG or PPM, as the bytes say. */
int picture_read(picture *to, const uint8_t *file, size_t bytes, const char *name, fail *f);

#endif

/* picture_read - see picture_read.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/picture_read.h"

#include <string.h>

#include "host_tools/picture/png.h"

int picture_read(picture *to, const uint8_t *file, size_t bytes, const char *name, fail *f) {
    const int is_png =
        bytes >= PNG_SIGNATURE_BYTES && memcmp(file, png_signature, PNG_SIGNATURE_BYTES) == 0;
    return is_png ? png_read(to, file, bytes, name, f) : ppm_read(to, file, bytes, name, f);
}

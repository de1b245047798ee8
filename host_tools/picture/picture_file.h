/* picture_file - pictures and films into files
 *
 * SPDX-License-Identifier: MIT */
#ifndef PICTURE_FILE_H
#define PICTURE_FILE_H
#include "host_tools/base/output.h"
#include "host_tools/picture/picture.h"

/* Format by the ending: .png .ppm .y4m in any case; "-" leaves `format` as
 * the caller chose it. Y4M holds any number of frames (4:2:0 in limited range, which
 * players want, or by choice 4:4:4 in full range), PNG and PPM one. A file is one picture_begin,
 * then picture_frame for pictures of just that size; `frames_per_second` is at least 1 for Y4M and
 * else ignored. Memory: PNG needs twice the picture, the others none. */
typedef enum picture_format {
    PICTURE_PNG,
    PICTURE_PPM,
    PICTURE_Y4M,
    PICTURE_Y4M_444
} picture_format;
int picture_is_film(picture_format format);
int picture_format_of(const char *path, picture_format *format, fail *f);
int picture_begin(output *o, picture_format format, unsigned width, unsigned height,
                  unsigned frames_per_second, fail *f);
int picture_frame(output *o, picture_format format, const picture *p, fail *f);

#endif

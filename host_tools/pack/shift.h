/* shift - where the scene lies in the coordinates of its meshes
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOST_SHIFT_H
#define HOST_SHIFT_H
#include "engine/planelet.h"

/* Notes in a whole image that `shift` was subtracted from the meshes. */
void shift_write(unsigned char *image, const double shift[3]);

/* 0 in an image whose meshes were not moved; not finite in a hostile one. -1 when the
 * source fails or is too short for a header. */
int shift_read(const plt_source *source, double shift[3]);

#endif

/* ppm - one 8-bit RGB picture as a binary portable pixmap (P6)
 *
 * Source: J. Poskanzer, ppm(5), Netpbm.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/picture/formats.h"

int ppm_frame(output *o, const picture *p, fail *f) {
    if (output_print(o, f, "P6\n%u %u\n255\n", p->width, p->height)) {
        return -1;
    }
    return output_write(o, p->rgb, 3 * (size_t)p->width * p->height, f);
}

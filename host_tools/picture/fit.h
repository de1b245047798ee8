/* fit - a picture of any size on a panel of another
 *
 * SPDX-License-Identifier: MIT */
#ifndef FIT_H
#define FIT_H

#include "host_tools/picture/picture.h"

enum fit_mode {
    FIT_CONTAIN, /* all of the picture, black bars beside it */
    FIT_COVER,   /* all of the panel, the picture cut on two sides */
    FIT_STRETCH, /* all of both; the shape changes */
    FIT_NONE     /* pixel by pixel about the middle, cut or framed */
};

/* Draws `from` over the whole of `panel`: each panel pixel is the average of
 * the part of the picture that lies under it, exact and rounded to nearest.
 * Cost: one visit of every picture pixel under the panel. */
void fit_picture(const picture *from, picture *panel, enum fit_mode mode);

#endif

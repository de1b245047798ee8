/* aim - from which side a camera looks at a scene, and from how far
 *
 * Front is +z when y is up, -y when z is up; right is where +x is then.
 *
 * SPDX-License-Identifier: MIT */
#ifndef AIM_H
#define AIM_H

#include "engine/planelet.h"
#include "host_tools/app/sight.h"

typedef struct aim {
    const plt_info *info;
    const sight *seen; /* NULL, or without an engine: the box is to be seen */
    double aspect;     /* width of the frame over its height */
    int has_side;      /* else in front, somewhat to the right, and above, the higher the flatter
                        * the box is */
    double azimuth, elevation; /* degrees from the front to the right, and up; up to 90 */
    int is_fixed;              /* the point it looks at stays in the middle of the picture */
    int circles;               /* all is to be seen from all around */
} aim;

/* Sets `eye`, and unless it is fixed `look`, of a camera whose `up` and `tan_half_fov` are set, so
 * that the scene just fits, with 3 % of the picture left at both borders. Straight from above or
 * below `up` becomes what is up in the picture: the back, or the front. `look` is the middle of the
 * box, or what the eye is to look at. */
void aim_camera(const aim *a, plt_camera *c);

/* Sets `eye` so that all of the box is seen around `look`, which stays: by the corners of the box
 * alone, in fixed steps. All figures of the documents are of this view. */
void aim_box(const plt_info *info, unsigned width, unsigned height, plt_camera *c);

#endif

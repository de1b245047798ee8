/* view - where the camera stands
 *
 * SPDX-License-Identifier: MIT */
#ifndef VIEW_H
#define VIEW_H

#include "engine/planelet.h"
#include "host_tools/cli/args.h"

#define VIEW_FLAGS                                                                                 \
    {"--eye", "x,y,z", "where the camera stands (default: so that all is seen)"},                  \
        {"--look", "x,y,z", "what it looks at (default: the middle of the scene)"},                \
        {"--up", "x,y,z", "what is up (default 0,1,0)"}, {                                         \
        "--fov", "DEG", "vertical field of view (default 45)"                                      \
    }

/* Fills `camera` from the flags, the rest so that the scene's box fills a
 * frame of this size: seen from the front, somewhat from the right, and from
 * above, the more so the flatter it is. Front is +z when y is up, -y when z
 * is up. */
void view_camera(args *a, const plt_info *info, unsigned width, unsigned height,
                 plt_camera *camera);

/* Turns the eye about the axis through look along up by `turn` of a circle. */
void view_orbit(const plt_camera *from, double turn, plt_camera *to);

#endif

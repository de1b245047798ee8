/* view - where the camera is
 *
 * SPDX-License-Identifier: MIT */
#ifndef VIEW_H
#define VIEW_H

#include "engine/planelet.h"
#include "host_tools/app/args.h"

#define VIEW_FLAGS                                                                                 \
    {"--eye", "x,y,z", "where the camera is (default: where all is seen)"},                        \
        {"--look", "x,y,z", "what it looks at (default: the middle of the scene)"},                \
        {"--up", "x,y,z", "what is up (default 0,1,0)"}, {                                         \
        "--fov", "DEG", "vertical field of view (default 45)"                                      \
    }

/* Fills `camera` from the flags. Without --eye it is where the scene's
 * box fills a frame of this size: in front of it, somewhat to the right, and above,
 * the higher the flatter the box is. Front is +z when y is up, -y when z is up. */
void view_camera(args *a, const plt_info *info, unsigned width, unsigned height,
                 plt_camera *camera);

/* Rotates the eye about the axis through look along up; 1.0 is the whole circle. */
void view_orbit(const plt_camera *from, double circles, plt_camera *to);

/* --shader eyelight|normal|triangle as PLT_SHADE_..., eyelight by default. */
uint8_t view_shader(args *a);

#endif

/* view - where the camera is
 *
 * SPDX-License-Identifier: MIT */
#ifndef VIEW_H
#define VIEW_H

#include "engine/planelet.h"
#include "host_tools/app/args.h"
#include "host_tools/base/fail.h"

#define VIEW_FLAGS                                                                                 \
    {"--eye", "x,y,z", "where the camera is, within 2^40 (default: where all is seen)"},           \
        {"--look", "x,y,z", "what it looks at, within 2^40 (default: the middle of the scene)"},   \
        {"--up", "x,y,z", "what is up, within 2^40 (default 0,1,0)"}, {                            \
        "--fov", "DEG", "vertical field of view, 0.0002 to 179.999 (default 45)"                   \
    }

/* Fills `camera` from the flags; what is out of range sets a->wrong. Without --eye it is where the
 * scene's box fills a frame of this size: in front of it, somewhat to the right, and above, the
 * higher the flatter the box is. Front is +z when y is up, -y when z is up. */
void view_camera(args *a, const plt_info *info, unsigned width, unsigned height,
                 plt_camera *camera);

/* The same without flags. */
void view_of_all(const plt_info *info, unsigned width, unsigned height, plt_camera *camera);

/* -1 when the engine refuses the camera of this frame, or of one of the others of its orbit:
 * `f` says why, and which flag helps; else 0. */
int view_refused(const args *a, const plt_frame *frame, unsigned frames, fail *f);

/* Rotates the eye about the axis through look along up; 1.0 is the whole circle. */
void view_orbit(const plt_camera *from, double circles, plt_camera *to);

/* --shader eyelight|normal|triangle as PLT_SHADE_..., eyelight by default; and of these or
 * depth|heat. */
uint8_t view_shader(args *a);
uint8_t view_any_shader(args *a);

/* --samples 1|4|16|adaptive as PLT_SAMPLES_..., 1 by default. */
uint8_t view_samples(args *a);

#endif

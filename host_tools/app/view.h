/* view - where the camera is
 *
 * SPDX-License-Identifier: MIT */
#ifndef VIEW_H
#define VIEW_H

#include "board/host/host.h"
#include "engine/planelet.h"
#include "host_tools/app/args.h"
#include "host_tools/base/fail.h"

#define VIEW_FLAGS                                                                                 \
    {"--view", "SIDE",                                                                             \
     "from where all is seen as large as it fits: front, back, left, right or side, top, bottom, " \
     "iso, AZIMUTH,ELEVATION in degrees, -360 to 360 from the front to the right and -90 to 90 "   \
     "up, usual (a little from the right and above), or box (usual, but farther away: from there " \
     "all of the scene's box is seen, and all figures are measured)"},                             \
        {"--eye", "x,y,z", "where the camera is, within 2^40, instead of --view"},                 \
        {"--look", "x,y,z", "what it looks at, within 2^40 (default: the middle of the scene)"},   \
        {"--up", "x,y,z", "what is up, within 2^40 (default 0,1,0)"}, {                            \
        "--fov", "DEG", "vertical field of view, 0.0002 to 179.999 (default 45)"                   \
    }

#define VIEW_BACKGROUND_FLAG                                                                       \
    {                                                                                              \
        "--background", "RRGGBB|sky",                                                              \
            "the colour where nothing is hit, six hexadecimal digits (default sky)"                \
    }

/* Fills `camera` from the flags; what is out of range sets a->wrong. Without --eye and --view it is
 * where the scene's box fits a frame of this size in any case: in front of it, somewhat to the
 * right, and above, the higher the flatter the box is; its middle is in the middle of the picture.
 * Front is +z when y is up, -y when z is up. This is the view that measurements are made in (--view
 * box). */
void view_camera(args *a, const plt_info *info, unsigned width, unsigned height,
                 plt_camera *camera);

/* The same without flags. */
void view_of_all(const plt_info *info, unsigned width, unsigned height, plt_camera *camera);

/* What a camera is to see. */
typedef struct view_subject {
    const plt_info *info;
    const host_scene *file; /* NULL: the box is all that is known */
    plt_engine *resident;   /* with all of the scene in memory; NULL: there is none */
    int circles;            /* the camera is to circle around it */
} view_subject;

/* As view_camera, but without --eye and --view box the camera comes as near as what is seen from
 * there lets it (aim.h): without --view, from the usual side. */
void view_fit(args *a, const view_subject *v, unsigned width, unsigned height, plt_camera *camera);

/* -1 when the engine refuses the camera of this frame, or of one of the others of its orbit:
 * `f` says why, and which flag helps; else 0. */
int view_refused(const args *a, const plt_frame *frame, unsigned frames, fail *f);

/* Rotates the eye about the axis through look along up; 1.0 is the whole circle. */
void view_orbit(const plt_camera *from, double circles, plt_camera *to);

/* --background into the frame. */
void view_background(args *a, plt_frame *frame);

/* --shader eyelight|normal|triangle|smooth as PLT_SHADE_..., eyelight by default. */
uint8_t view_shader(args *a);

/* The same without smooth, for scenes whose normals and colours are not opened. */
uint8_t view_shader_of_triangles(args *a);

/* --samples 1|4|16|adaptive as PLT_SAMPLES_..., 1 by default. */
uint8_t view_samples(args *a);

#endif

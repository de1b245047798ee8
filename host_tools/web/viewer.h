/* viewer - a scene that is rendered in steps and turned, as `planelet view` does in a terminal
 *
 * The page calls these. Functions that return a status give an enum plt_status; viewer_why says in
 * a sentence what is wrong. There is one viewer.
 *
 * SPDX-License-Identifier: MIT */
#ifndef WEB_VIEWER_H
#define WEB_VIEWER_H

#include <stdint.h>

#include "engine/planelet.h"
#include "host_tools/app/steer.h"
#include "host_tools/picture/picture.h"
#include "host_tools/web/exports.h"

/* Where an image lies. */
enum view_where {
    VIEW_MAPPED = 0,  /* in memory that is read like flash */
    VIEW_FETCHED = 1, /* it is copied into the arena */
    VIEW_STREAMED = 2 /* with the page; parts come when rays need them */
};

/* A scene of so many bytes comes next. Returns where the page puts the image if it is mapped, and
 * 0 when there is no memory for it. Unless `is_same`, camera and lights begin anew. */
WEB_EXPORT(void *, viewer_begin)(uint32_t bytes, int where, int is_same);

/* Opens it, in an arena of so many bytes, for frames of this enum plt_shader. */
WEB_EXPORT(int, viewer_open)(uint32_t arena_bytes, unsigned shader, unsigned samples);
/* While that gave PLT_MORE. */
WEB_EXPORT(int, viewer_open_step)(void);

/* A first camera instead of the usual one, which `planelet render` has, too; degrees. Before
 * viewer_size. */
WEB_EXPORT(void, viewer_camera)
(float eye_x, float eye_y, float eye_z, float look_x, float look_y, float look_z, float fov);
/* A sun instead of the one behind that camera, and light from above and below. */
WEB_EXPORT(void, viewer_sun)
(float x, float y, float z, float power, float radius, unsigned samples);
WEB_EXPORT(void, viewer_sky)
(float r, float g, float b, float r_below, float g_below, float b_below);

/* Pixels of a frame; of an open scene. */
WEB_EXPORT(int, viewer_size)(unsigned width, unsigned height);

/* Renders until that time (board/web/web.h), a step at least, if there is something to render. */
enum view_news {
    VIEW_NEWS_TILES = 1,   /* pixels have come */
    VIEW_NEWS_COMPLETE = 2 /* the frame has all of them */
};
WEB_EXPORT(int, viewer_work)(double until);

/* Red, green, blue and 255 per pixel of the frame that is rendered, and 0 where none has come. */
WEB_EXPORT(const uint8_t *, viewer_pixels)(void);
/* FNV-1a of red, green and blue of the last frame that was complete: the host's frame_hash. */
WEB_EXPORT(uint64_t, viewer_hash)(void);
WEB_EXPORT(const char *, viewer_why)(void);

/* An enum steer_action, degrees, a factor. */
WEB_EXPORT(void, viewer_steer)(unsigned action);
WEB_EXPORT(void, viewer_turn)(double azimuth, double elevation);
WEB_EXPORT(void, viewer_zoom)(double factor);

/* What there is to say, as numbers; the page has the same list. */
enum viewer_number {
    NUMBER_TRIANGLES,
    NUMBER_IMAGE_BYTES,
    NUMBER_NEED_BYTES, /* of the arena that was too small */
    NUMBER_ARENA_BYTES,
    NUMBER_ARENA_PEAK,
    NUMBER_STACK_USED,
    NUMBER_STACK_BYTES,
    NUMBER_WIDTH, /* of the frame that is rendered, which is coarse while the camera moves */
    NUMBER_HEIGHT,
    NUMBER_LEVEL, /* coarse.h */
    NUMBER_IS_DUE,
    NUMBER_STEPS, /* of the frame, so far */
    NUMBER_LONGEST_MS,
    NUMBER_BUSY_MS,
    NUMBER_RAYS,
    NUMBER_TILES,
    NUMBER_TILES_ALL,
    NUMBER_BYTES_FETCHED, /* of a streamed scene, by this frame */
    NUMBER_HAS_SURFACE,   /* normals or colours */
    NUMBER_HAS_MATERIALS,
    NUMBER_FRAMES, /* of a sequence */
    NUMBER_EYE_X,  /* the camera of the frame */
    NUMBER_EYE_Y,
    NUMBER_EYE_Z,
    NUMBER_LOOK_X,
    NUMBER_LOOK_Y,
    NUMBER_LOOK_Z,
    NUMBERS
};
WEB_EXPORT(double, viewer_number)(unsigned which);

/* For displays: the last frame that was complete, of no pixels until there is one, and whether one
 * has been since the last call. */
const picture *viewer_picture(void);
int viewer_is_new(void);

#endif

/* smooth - hits by the normals and colours of their triangles' corners
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_SMOOTH_H
#define PLT_SHADE_SMOOTH_H

#include "engine/shade/camera.h"
#include "engine/shade/sampling.h"
#include "engine/shade/smooth_paint.h"
#include "engine/trace/traversal.h"

#if PLT_WITH_SURFACE

/* Eye light of a point that is seen along `dir`: its colour, or clay, as bright as its normal faces
 * the eye, on either side. */
void plt_smooth_colour(const plt_surface_point *point, const float dir[3], uint8_t rgb[3]);

/* What frames are shaded with. */
typedef struct plt_smooth {
    plt_traversal *traversal;
#if PLT_WITH_TEXTURE
    const plt_smooth_paint *paint;
#endif
} plt_smooth;

/* The byte colours of a point that is hit along `dir` at `t`: plt_smooth_colour, under the
 * texture of the triangle's material. PLT_OK, or what a fetch failed with. */
static inline int plt_smooth_point(const plt_smooth *s, uint32_t id, const float dir[3], float t,
                                   plt_surface_point *point, uint8_t rgb[3]) {
    int status = PLT_OK;
#if PLT_WITH_TEXTURE
    status = plt_smooth_paint_point(s->paint, id, dir, t, point);
#else
    (void)s;
    (void)id;
    (void)t;
#endif
    if (status == PLT_OK) {
        plt_smooth_colour(point, dir, rgb);
    }
    return status;
}

#if PLT_WITH_GROUPS
/* As plt_shade_pixels, of a packet whose hits have u and v. PLT_OK, or what a fetch failed with. */
int plt_smooth_shade(const plt_smooth *smooth, const plt_packet *packet, const plt_pixels *pixels,
                     const uint8_t *sky, uint8_t *rgb, uint32_t row_bytes);

#if PLT_WITH_SAMPLES
/* As plt_packet_mix, likewise: each sample has the colour of where it hits, along its own ray. */
int plt_smooth_mix(const plt_smooth *smooth, const plt_packet *packet, plt_sampling *s,
                   const plt_pixels *pixels, const uint8_t *sky, uint8_t *rgb, uint32_t row_bytes);
#endif
#endif

#if PLT_WITH_BEAMS
/* As plt_beam_shade; likewise. */
struct plt_beam;
int plt_beam_smooth(const struct plt_beam *b, const plt_smooth *smooth, const uint8_t *sky,
                    uint8_t *rgb, uint32_t row_bytes);

#if PLT_WITH_SAMPLES
/* As plt_beam_mix; likewise. */
int plt_beam_smooth_mix(const struct plt_beam *b, const plt_smooth *smooth, plt_sampling *s,
                        const uint8_t *sky, uint8_t *rgb, uint32_t row_bytes);
#endif
#endif

#endif
#endif

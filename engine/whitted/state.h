/* state - what a packet of pixels with lights, mirrors and glass keeps
 *
 * Each pixel has the ray that is traced, or what it hit, and a stack of rays that wait. Invariant:
 * at most one ray waits per level 1 .. bounces, as of two that a hit sends out one is traced next
 * and their level is one more; so a stack holds as many as there may be bounces, and never runs
 * over.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WHITTED_STATE_H
#define PLT_WHITTED_STATE_H

#include "engine/texture/sample.h"
#include "engine/trace/traversal.h"
#include "engine/whitted/materials.h"

enum plt_lit_state {
    PLT_LIT_DONE, /* no ray, or outside the frame */
    PLT_LIT_RAY,  /* the ray is to be traced */
    PLT_LIT_HIT
};

/* A ray that waits. 40 bytes, with textures 44. */
typedef struct plt_lit_ray {
    float org[3], dir[3]; /* dir: of length 1 */
    float weight[3];      /* what its light counts in the pixel */
    uint16_t inside;      /* 1 + the material of the glass that it runs through; 0: air */
    uint8_t level;        /* bounces before it */
    uint8_t is_sky;       /* 1: the own ray of a pixel, and it hit nothing */
#if PLT_WITH_TEXTURE
    float before; /* how far light has to go from its origin to the eye */
#endif
} plt_lit_ray;

typedef struct plt_lit_pixel {
    float colour[3]; /* light so far, linear */
    plt_lit_ray ray; /* that is traced; of a hit its origin is the point that was hit */
    float normal[3]; /* of a hit, of length 1, against the ray: what it is shaded by */
    float side[3];   /* ... its triangle's */
    uint8_t state;   /* enum plt_lit_state */
    uint8_t material;
    uint8_t is_lit;  /* lights count */
    uint8_t waiting; /* rays */
    uint8_t turn;    /* plt_light_turn */
    uint8_t tint[3]; /* sRGB of its corners; 255: they have none */
} plt_lit_pixel;

/* A ray to a light, where there is glass. 20 bytes. */
typedef struct plt_lit_shadow {
    float through[3];  /* of the light, what has come so far */
    float from;        /* its tmin: behind the surfaces that it has passed */
    uint16_t inside;   /* as plt_lit_ray */
    uint16_t surfaces; /* of glass, that it has passed */
} plt_lit_shadow;

_Static_assert(sizeof(plt_lit_shadow) == 20, "no holes");
_Static_assert(sizeof(plt_lit_ray) == (PLT_WITH_TEXTURE ? 44 : 40) &&
                   sizeof(plt_lit_pixel) == sizeof(plt_lit_ray) + 44,
               "no holes");

typedef struct plt_whitted {
    plt_lighting lighting; /* bounces: at most those that there is room for */
    plt_materials materials;
#if PLT_WITH_TEXTURE
    plt_textures *textures; /* NULL: there are none */
    float angle;            /* side of a pixel, or sample, at a distance of 1 */
    int failed;             /* what a fetch has failed with; PLT_OK: none has */
#endif
    const plt_box *box; /* of all that may be hit */
    float up[3];        /* of length 1 */
    float lift;         /* how far the origins of rays are above what they leave */
    uint32_t pixels;    /* side^2 */
    uint8_t room;       /* bounces that there is room for */
    uint8_t stage;      /* enum of whitted.c */
    uint8_t is_traced;  /* a packet is under way */
    uint8_t is_empty;   /* ... that misses everything, and whose groups may not be set */
    uint8_t light, sample;
    uint8_t is_on_way;      /* rays of the sample go on behind glass */
    uint8_t rays_kind : 2;  /* enum plt_rays: which may go by the wave */
    uint8_t by_wave : 1;    /* those of the packet do */
    uint8_t is_watched : 1; /* ... or do not, and its visits are counted */
    uint32_t rays;          /* of the packet */
    plt_lit_pixel *pixel;   /* [pixels], in Z order */
    plt_lit_ray *waiting;   /* [pixels][room] */
    plt_lit_shadow *shadow; /* [pixels] */
    uint8_t *slot;          /* [rays]: the pixel of each */
} plt_whitted;

#define PLT_WHITTED_ALIGNED(bytes) (((bytes) + 15u) & ~(size_t)15u)

/* Bytes of all that, for packets of side^2 pixels and so many bounces. */
static inline size_t plt_whitted_bytes(unsigned side, unsigned bounces) {
    const size_t pixels = (size_t)side * side;
    return PLT_WHITTED_ALIGNED(sizeof(plt_whitted)) +
           PLT_WHITTED_ALIGNED(pixels * sizeof(plt_lit_pixel)) +
           PLT_WHITTED_ALIGNED(pixels * bounces * sizeof(plt_lit_ray)) +
           PLT_WHITTED_ALIGNED(pixels * sizeof(plt_lit_shadow)) + pixels;
}

/* Rays of less than this in all colours are not followed, but take the sky's light. */
#define PLT_LIT_LEAST 0.001953125f /* 1 / 512 */

static inline int plt_lit_counts(const float weight[3]) {
    return weight[0] >= PLT_LIT_LEAST || weight[1] >= PLT_LIT_LEAST || weight[2] >= PLT_LIT_LEAST;
}

static inline void plt_lit_add(plt_lit_pixel *p, const float weight[3], const float light[3]) {
    for (int c = 0; c < 3; c++) {
        p->colour[c] += weight[c] * light[c];
    }
}

#endif

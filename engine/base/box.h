/* box - axis-aligned boxes (AABBs)
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BASE_BOX_H
#define PLT_BASE_BOX_H

typedef struct plt_box {
    float lo[3], hi[3]; /* lo > hi on every axis: empty */
} plt_box;

/* Beyond any coordinate (PLT_COORD_MAX), so that any point replaces it. */
#define PLT_BOX_FAR 3.0e38f

static inline plt_box plt_box_empty(void) {
    const plt_box b = {{PLT_BOX_FAR, PLT_BOX_FAR, PLT_BOX_FAR},
                       {-PLT_BOX_FAR, -PLT_BOX_FAR, -PLT_BOX_FAR}};
    return b;
}

static inline void plt_box_add_point(plt_box *b, const float p[3]) {
    for (int a = 0; a < 3; a++) {
        b->lo[a] = p[a] < b->lo[a] ? p[a] : b->lo[a];
        b->hi[a] = p[a] > b->hi[a] ? p[a] : b->hi[a];
    }
}

static inline void plt_box_add(plt_box *b, const plt_box *c) {
    for (int a = 0; a < 3; a++) {
        b->lo[a] = c->lo[a] < b->lo[a] ? c->lo[a] : b->lo[a];
        b->hi[a] = c->hi[a] > b->hi[a] ? c->hi[a] : b->hi[a];
    }
}

static inline float plt_box_longest_side(const plt_box *b) {
    const float x = b->hi[0] - b->lo[0], y = b->hi[1] - b->lo[1], z = b->hi[2] - b->lo[2];
    const float xy = x > y ? x : y;
    return xy > z ? xy : z;
}

/* Half the surface; for boxes that are not empty. */
static inline float plt_box_half_area(const plt_box *b) {
    const float x = b->hi[0] - b->lo[0], y = b->hi[1] - b->lo[1], z = b->hi[2] - b->lo[2];
    return x * y + y * z + z * x;
}

#endif

/* camera_packet - the rays of a camera in groups of four, see camera.h
 *
 * Where there are hulls, a square within the frame is set up at a glance, as packet_plain.h does
 * it for rays of a file, from its four corners: rounding is monotone, so each component of a
 * direction is between those of the corners.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/camera.h"
#include "engine/shade/camera_ranges.h"

/* Two by two pixels, in the order of lanes. */
static const float right_of[4] = {0, 1, 0, 1}, below_of[4] = {0, 0, 1, 1};

/* Where four pixels from (x, y) on are; x and y are even. */
static inline f4 columns_at(const plt_view *v, uint32_t x, uint32_t y) {
    const f4 px = f4_add(f4_all((float)x), f4_load(right_of));
#if PLT_WITH_SAMPLES
    const float *aside = &v->aside[y & (v->across - 1)];
    const float by[4] = {aside[0], aside[0], aside[v->across > 1], aside[v->across > 1]};
    return f4_add(px, f4_load(by));
#else
    (void)v;
    (void)y;
    return px;
#endif
}

static inline f4 rows_at(const plt_view *v, uint32_t x, uint32_t y) {
    const f4 py = f4_add(f4_all((float)y), f4_load(below_of));
#if PLT_WITH_SAMPLES
    const float *aside = &v->aside[x & (v->across - 1)];
    const float by[4] = {aside[0], aside[v->across > 1], aside[0], aside[v->across > 1]};
    return f4_sub(py, f4_load(by));
#else
    (void)v;
    (void)x;
    return py;
#endif
}

/* Four pixels from (x, y) on. */
static void set_group(const plt_view *v, plt_packet *p, unsigned index, uint32_t x, uint32_t y,
                      unsigned lanes) {
    const f4 px = columns_at(v, x, y), py = rows_at(v, x, y);
    f4 org[3], dir[3];
    for (int a = 0; a < 3; a++) {
        org[a] = f4_all(v->eye[a]);
        dir[a] = plt_view_directions(v, a, px, py);
    }
    /* Lanes outside the frame get an empty interval. */
    const f4 tmax = f4_select(m4_bits(lanes), f4_all(PLT_VIEW_FAR), f4_all(-1.0f));
    plt_packet_set_group(p, index, org, dir, f4_zero(), tmax, 4);
}

static void set_each(const plt_view *v, plt_packet *p, const plt_pixels *pixels, uint32_t rays) {
    for (uint32_t k = 0; k < rays; k += 4) {
        const uint32_t x = pixels->x + plt_z_order_x(k), y = pixels->y + plt_z_order_y(k);
        const unsigned columns = (x < pixels->x_end ? 5u : 0u) | (x + 1 < pixels->x_end ? 10u : 0u);
        const unsigned rows = (y < pixels->y_end ? 3u : 0u) | (y + 1 < pixels->y_end ? 12u : 0u);
        set_group(v, p, k / 4, x, y, columns & rows);
    }
    plt_packet_finish(p);
}

#if PLT_WITH_HULLS
/* ---- at a glance ------------------------------------------------------------------- */

/* A packet that meets nothing. */
static void share_nothing(plt_packet *p) {
    p->axis = PLT_AXES_DIFFER;
    p->slabs.coherence = PLT_ONE_ORIGIN;
    p->along = 0;
}

/* With 16 samples per pixel every other row of groups is aside of the one above it. */
#define KINDS_OF_ROWS (PLT_WITH_SAMPLES ? 2 : 1)

static inline uint32_t kind_of_row(const plt_view *v, uint32_t i) {
    return KINDS_OF_ROWS == 2 && plt_view_across(v) == 4 ? i & 1u : 0;
}

/* What groups one below the other, or side by side, have in common: those in every row, or in
 * every other one. */
typedef struct grid {
    f4 column[KINDS_OF_ROWS][PLT_PACKET_SIDE_MAX / 2][3];
    f4 row[KINDS_OF_ROWS][PLT_PACKET_SIDE_MAX / 2][3];
} grid;

static void set_kind(grid *g, const plt_view *v, const plt_pixels *pixels, uint32_t kind) {
    f4 px = columns_at(v, pixels->x, pixels->y + 2 * kind);
    f4 py = rows_at(v, pixels->x + 2 * kind, pixels->y);
    for (uint32_t i = 0; i < pixels->side / 2; i++) {
        PLT_UNROLLED for (int a = 0; a < 3; a++) {
            g->column[kind][i][a] = plt_view_along(v, a, px);
            g->row[kind][i][a] = plt_view_below(v, a, py);
        }
        px = f4_add(px, f4_all(2.0f));
        py = f4_add(py, f4_all(2.0f));
    }
}

static void set_grid(grid *g, const plt_view *v, const plt_pixels *pixels) {
    set_kind(g, v, pixels, 0);
    if (KINDS_OF_ROWS == 2 && plt_view_across(v) == 4) {
        set_kind(g, v, pixels, 1);
    }
}

/* As plt_packet_set_group leaves it. */
PLT_INLINED void set_plain(plt_group_slabs *s, plt_group_rays *g, const f4 eye[3],
                           const f4 column[3], const f4 row[3], int z) {
    const int x = z == 2 ? 0 : z + 1, y = z == 0 ? 2 : z - 1;
    f4 dir[3];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        dir[a] = f4_add(column[a], row[a]);
        f4_store(g->org[a], eye[a]);
        f4_store(g->dir[a], dir[a]);
        g->axis_lanes[a] = a == z ? 15 : 0;
    }
    g->valid = 15;
    f4_store(g->slope[0], f4_div(dir[x], dir[z]));
    f4_store(g->slope[1], f4_div(dir[y], dir[z]));
    f4_store(s->tmin, f4_zero());
    f4_store(s->tmax, f4_all(PLT_VIEW_FAR));
    u4_store(g->id, u4_all(PLT_MISS));
}

PLT_INLINED void set_groups(const plt_view *v, plt_packet *p, const grid *of, uint32_t side,
                            int z) {
    static const uint8_t apart[8] = {0, 1, 4, 5, 16, 17, 20, 21}; /* every other bit of Z order */
    const f4 eye[3] = {f4_all(v->eye[0]), f4_all(v->eye[1]), f4_all(v->eye[2])};
    for (uint32_t y = 0; y < side / 2; y++) {
        const uint32_t kind = kind_of_row(v, y);
        plt_group_slabs *s = &p->slabs.group[2u * apart[y]];
        plt_group_rays *g = &p->rays[2u * apart[y]];
        for (uint32_t x = 0; x < side / 2; x++) {
            set_plain(&s[apart[x]], &g[apart[x]], eye, of->column[kind][x],
                      of->row[kind_of_row(v, x)][y], z);
        }
    }
}

static plt_common common_of(const plt_view_ranges *r, uint8_t axis) {
    plt_common c = {0, 1u << axis, {0, 0, 0}, {0.0f, 0.0f, 0.0f}};
    for (int a = 0; a < 3; a++) {
        float sum[4];
        f4_store(sum, r->sum[a]);
        c.forward[a] = sum[0];
        c.other_sign[a] = r->least[a] < 0.0f && r->most[a] >= 0.0f;
    }
    return c;
}

/* 0: the rays differ in their largest component, and nothing was done. */
static int set_all(const plt_view *v, plt_packet *p, const plt_pixels *pixels) {
    plt_view_ranges r;
    grid g;
    plt_view_ranges_set(&r, v, pixels);
    if (plt_view_misses(&r, v, p->scene)) {
        share_nothing(p);
        return 1;
    }
    const uint8_t axis = plt_view_axis(&r);
    if (axis == PLT_AXES_DIFFER) {
        return 0;
    }
    set_grid(&g, v, pixels);
    switch (axis) {
    case 0:
        set_groups(v, p, &g, pixels->side, 0);
        break;
    case 1:
        set_groups(v, p, &g, pixels->side, 1);
        break;
    default:
        set_groups(v, p, &g, pixels->side, 2);
        break;
    }
    const plt_common common = common_of(&r, axis);
    p->unbounded = 1;
    p->active = ~(plt_mask)0 >> (8 * sizeof p->active - p->groups);
    plt_packet_share(p, &common);
    return 1;
}
#endif

void plt_view_packet(const plt_view *v, const plt_box *scene, plt_packet *p,
                     const plt_pixels *pixels) {
    const uint32_t rays = pixels->side * pixels->side;
    plt_packet_begin(p, scene, rays / 4, 0);
    plt_packet_want_normals(p);
#if PLT_WITH_HULLS
    if (pixels->x + pixels->side <= pixels->x_end && pixels->y + pixels->side <= pixels->y_end &&
        set_all(v, p, pixels)) {
        return;
    }
#endif
    set_each(v, p, pixels, rays);
}

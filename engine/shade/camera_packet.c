/* camera_packet - the rays of a camera in groups of four, see camera.h
 *
 * Where there are hulls, a square within the frame is set up at a glance, as packet_plain.h does
 * it for rays of a file, from its four corners: rounding is monotone, so each component of a
 * direction is between those of the corners.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/camera.h"
#include "engine/trace/ray_bounds.h"
#include "engine/trace/triangle_common.h"

/* Two by two pixels, in the order of lanes. */
static const float right_of[4] = {0, 1, 0, 1}, below_of[4] = {0, 0, 1, 1};

/* Directions through pixels in lanes, as plt_view_direction has each. Whole numbers this small
 * are exact. */
static inline f4 along_row(const plt_view *v, int a, f4 px) {
    return f4_add(f4_all(v->corner[a]), f4_mul(px, f4_all(v->right[a])));
}

static inline f4 down_column(const plt_view *v, int a, f4 py) {
    return f4_mul(py, f4_all(v->down[a]));
}

/* Four pixels from (x, y) on. */
static void set_group(const plt_view *v, plt_packet *p, unsigned index, uint32_t x, uint32_t y,
                      unsigned lanes) {
    const f4 px = f4_add(f4_all((float)x), f4_load(right_of));
    const f4 py = f4_add(f4_all((float)y), f4_load(below_of));
    f4 org[3], dir[3];
    for (int a = 0; a < 3; a++) {
        org[a] = f4_all(v->eye[a]);
        dir[a] = f4_add(along_row(v, a, px), down_column(v, a, py));
    }
    /* Lanes outside the frame get an empty interval. */
    const f4 tmax = f4_select(m4_bits(lanes), f4_all(PLT_VIEW_FAR), f4_all(-1.0f));
    plt_packet_set_group(p, index, org, dir, f4_zero(), tmax, 4);
}

static void set_each(const plt_view *v, plt_packet *p, const plt_pixels *pixels) {
    for (uint32_t k = 0; k < pixels->side * pixels->side; k += 4) {
        const uint32_t x = pixels->x + plt_z_order_x(k), y = pixels->y + plt_z_order_y(k);
        const unsigned columns = (x < pixels->x_end ? 5u : 0u) | (x + 1 < pixels->x_end ? 10u : 0u);
        const unsigned rows = (y < pixels->y_end ? 3u : 0u) | (y + 1 < pixels->y_end ? 12u : 0u);
        set_group(v, p, k / 4, x, y, columns & rows);
    }
    plt_packet_finish(p);
}

#if PLT_WITH_HULLS
/* ---- at a glance ------------------------------------------------------------------- */

/* Of each component of the directions, the range, and their sum. */
typedef struct ranges {
    float least[3], most[3];
    f4 sum[3];
} ranges;

static void set_ranges(ranges *r, const plt_view *v, const plt_pixels *pixels) {
    const float last = (float)(pixels->side - 1);
    const f4 px = f4_add(f4_all((float)pixels->x), f4_mul(f4_load(right_of), f4_all(last)));
    const f4 py = f4_add(f4_all((float)pixels->y), f4_mul(f4_load(below_of), f4_all(last)));
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        const f4 corner = f4_add(along_row(v, a, px), down_column(v, a, py));
        r->least[a] = f4_min_lane(corner);
        r->most[a] = -f4_min_lane(f4_neg(corner));
        r->sum[a] = f4_add(corner, f4_turn(f4_turn(corner))); /* lane 0: of two of the four */
    }
}

/* The axis that is the largest of every direction, the first of equals; or PLT_AXES_DIFFER, also
 * where a direction may be none. */
static uint8_t axis_of(const ranges *r) {
    float least[3], most[3]; /* sizes; negative: there are both signs */
    for (int a = 0; a < 3; a++) {
        least[a] = r->least[a] > -r->most[a] ? r->least[a] : -r->most[a];
        most[a] = r->most[a] > -r->least[a] ? r->most[a] : -r->least[a];
    }
    for (uint8_t z = 0; z < 3; z++) {
        const int x = plt_axis_after[z], y = plt_axis_after[x];
        const int beyond_x = x < z ? least[z] > most[x] : least[z] >= most[x];
        const int beyond_y = y < z ? least[z] > most[y] : least[z] >= most[y];
        if (beyond_x && beyond_y && least[z] >= PLT_DIR_LEAST && most[z] <= PLT_DIR_MOST) {
            return z;
        }
    }
    return PLT_AXES_DIFFER;
}

/* What groups one below the other, or side by side, have in common. */
typedef struct grid {
    f4 column[PLT_PACKET_SIDE_MAX / 2][3], row[PLT_PACKET_SIDE_MAX / 2][3];
} grid;

static void set_grid(grid *g, const plt_view *v, const plt_pixels *pixels) {
    f4 px = f4_add(f4_all((float)pixels->x), f4_load(right_of));
    f4 py = f4_add(f4_all((float)pixels->y), f4_load(below_of));
    for (uint32_t i = 0; i < pixels->side / 2; i++) {
        PLT_UNROLLED for (int a = 0; a < 3; a++) {
            g->column[i][a] = along_row(v, a, px);
            g->row[i][a] = down_column(v, a, py);
        }
        px = f4_add(px, f4_all(2.0f));
        py = f4_add(py, f4_all(2.0f));
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
    const f4 eye[3] = {f4_all(v->eye[0]), f4_all(v->eye[1]), f4_all(v->eye[2])};
    for (uint32_t k = 0; k < side * side / 4; k++) {
        const uint32_t x = plt_z_order_x(k), y = plt_z_order_y(k);
        set_plain(&p->slabs.group[k], &p->rays[k], eye, of->column[x], of->row[y], z);
    }
}

static plt_common common_of(const ranges *r, uint8_t axis) {
    plt_common c = {0, 1u << axis, {0, 0, 0}, {r->sum[0], r->sum[1], r->sum[2]}};
    for (int a = 0; a < 3; a++) {
        c.other_sign[a] = r->least[a] < 0.0f && r->most[a] >= 0.0f;
    }
    return c;
}

/* 0: the rays differ in their largest component, and nothing was done. */
static int set_all(const plt_view *v, plt_packet *p, const plt_pixels *pixels) {
    ranges r;
    grid g;
    set_ranges(&r, v, pixels);
    const uint8_t axis = axis_of(&r);
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
    plt_packet_begin(p, scene, pixels->side * pixels->side / 4, 0);
    plt_packet_want_normals(p);
#if PLT_WITH_HULLS
    if (pixels->x + pixels->side <= pixels->x_end && pixels->y + pixels->side <= pixels->y_end &&
        set_all(v, p, pixels)) {
        return;
    }
#endif
    set_each(v, p, pixels);
}

/* aim - see aim.h
 *
 * Computed in double and rounded once: machines whose tangents differ in the last
 * bit still give the engine the same floats, but for rare ties.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/aim.h"

#include <math.h>

#include "host_tools/app/fitting.h"

#define DEGREE 0.017453292519943295

/* Of the scene; unit length, at right angles. */
typedef struct axes {
    double right[3], up[3], front[3];
} axes;

static void make_axes(axes *s, const float up[3]) {
    const double forward[2][3] = {{0.0, 0.0, 1.0}, {0.0, -1.0, 0.0}};
    for (int i = 0; i < 3; i++) {
        s->up[i] = (double)up[i];
    }
    if (!vector_normalise(s->up)) {
        s->up[1] = 1.0; /* the engine refuses this camera later */
    }
    vector_cross(s->up, forward[fabs(s->up[2]) > fabs(s->up[1])], s->right);
    vector_normalise(s->right);
    vector_cross(s->right, s->up, s->front);
}

typedef struct box {
    double lo[3], hi[3], edge[3];
} box;

static void get_box(box *b, const plt_info *info) {
    for (int i = 0; i < 3; i++) {
        b->lo[i] = info->triangles > 0 ? (double)info->lo[i] : 0.0;
        b->hi[i] = info->triangles > 0 ? (double)info->hi[i] : 0.0;
        b->edge[i] = b->hi[i] - b->lo[i];
    }
}

/* How large a box of these edges is along `axis`. */
static double extent(const double edge[3], const double axis[3]) {
    return edge[0] * fabs(axis[0]) + edge[1] * fabs(axis[1]) + edge[2] * fabs(axis[2]);
}

/* From the scene to the eye: 18 degrees up for what is as high as wide, 37
 * for what is flat. */
static void choose_back(const axes *s, const double edge[3], double back[3]) {
    const double wide = fmax(extent(edge, s->right), extent(edge, s->front));
    const double high = fmin(extent(edge, s->up), wide);
    const double rise = wide > 0.0 ? 0.83 - 0.48 * high / wide : 0.35;
    for (int i = 0; i < 3; i++) {
        back[i] = 0.45 * s->right[i] + rise * s->up[i] + s->front[i];
    }
    vector_normalise(back);
}

/* How far back along `back` the eye must stand to see all corners. */
static double distance_to_see(const double lo[3], const double hi[3], const double middle[3],
                              const double back[3], const double up[3], double tan_x,
                              double tan_y) {
    double right[3], above[3], need = 0.0;
    vector_cross(up, back, right);
    vector_normalise(right);
    vector_cross(back, right, above);
    for (int k = 0; k < 8; k++) {
        double q[3];
        for (int i = 0; i < 3; i++) {
            q[i] = (k >> i & 1 ? hi[i] : lo[i]) - middle[i];
        }
        const double near = vector_dot(q, back);
        need = fmax(need, near + fabs(vector_dot(q, right)) / tan_x);
        need = fmax(need, near + fabs(vector_dot(q, above)) / tan_y);
    }
    return need > 0.0 ? 1.03 * need : 1.0;
}

void aim_box(const plt_info *info, unsigned width, unsigned height, plt_camera *c) {
    double middle[3], back[3];
    axes s;
    box b;
    get_box(&b, info);
    for (int i = 0; i < 3; i++) {
        middle[i] = (double)c->look[i];
    }
    make_axes(&s, c->up);
    choose_back(&s, b.edge, back);
    const double tan_y = (double)c->tan_half_fov;
    const double tan_x = tan_y * width / height;
    const double d = distance_to_see(b.lo, b.hi, middle, back, s.up, tan_x, tan_y);
    for (int i = 0; i < 3; i++) {
        c->eye[i] = (float)(middle[i] + d * back[i]);
    }
}

/* ---- what is seen ---------------------------------------------------------------------- */

enum { ALL_AROUND = 16, BOX_ROUNDS = 4, ROUNDS = 3, SIDE_ONCE = 128, SIDE_AROUND = 48 };

/* Of the way from the middle of the picture to its border. */
static const double FILLED = 0.94;
/* The rays of a second round look a little beyond what the first has found. */
static const double WIDER = 1.15;

/* What the steps of an aim share. */
typedef struct aiming {
    const aim *a;
    axes s;
    box b;
    double back[3], up[3], look[3]; /* up: what is up in the picture, or the axis of the circle */
    enum fitting_freedom freedom;
    double most[2]; /* tangents of the angles that there are across and above */
    double tan[2];  /* that the scene is to fill: one of them is all there is */
    double near;    /* how far the box reaches from `look` to the eye, or a little more */
    unsigned around;
    fitting boxed; /* all corners, from all around */
} aiming;

/* Rodrigues: by so many circles around a unit vector. */
static void rotate(const double v[3], const double axis[3], double circles, double to[3]) {
    double side[3];
    vector_cross(axis, v, side);
    const double c = cos(360.0 * DEGREE * circles), s = sin(360.0 * DEGREE * circles);
    const double along = vector_dot(axis, v);
    for (int i = 0; i < 3; i++) {
        to[i] = v[i] * c + side[i] * s + axis[i] * along * (1.0 - c);
    }
}

/* From the scene to the eye; true where that is straight up or down. */
static int choose_side(aiming *g) {
    const aim *a = g->a;
    if (!a->has_side) {
        choose_back(&g->s, g->b.edge, g->back);
        return 0;
    }
    const double azimuth = a->azimuth * DEGREE, elevation = a->elevation * DEGREE;
    for (int i = 0; i < 3; i++) {
        const double level = sin(azimuth) * g->s.right[i] + cos(azimuth) * g->s.front[i];
        g->back[i] = cos(elevation) * level + sin(elevation) * g->s.up[i];
    }
    vector_normalise(g->back);
    return fabs(a->elevation) > 89.9;
}

/* Straight from above what is up in the picture is away from whoever stands at the azimuth. */
static void tilt_up(aiming *g, plt_camera *c) {
    const double azimuth = g->a->azimuth * DEGREE;
    for (int i = 0; i < 3; i++) {
        const double level = sin(azimuth) * g->s.right[i] + cos(azimuth) * g->s.front[i];
        g->up[i] = g->a->elevation > 0.0 ? -level : level;
        c->up[i] = (float)g->up[i];
    }
}

static void begin_fitting(const aiming *g, unsigned k, fitting *f) {
    double back[3];
    rotate(g->back, g->up, (double)k / g->around, back);
    fitting_begin(f, g->look, back, g->up, g->tan[0], g->tan[1]);
}

static void begin_aiming(aiming *g, const aim *a, plt_camera *c) {
    g->a = a;
    g->freedom = a->is_fixed ? FITTING_FIXED : a->circles ? FITTING_CIRCLE : FITTING_ASIDE;
    g->most[1] = FILLED * (double)c->tan_half_fov;
    g->most[0] = g->most[1] * a->aspect;
    g->tan[0] = g->most[0];
    g->tan[1] = g->most[1];
    g->around = a->circles ? ALL_AROUND : 1;
    g->near = 0.0;
    get_box(&g->b, a->info);
    make_axes(&g->s, c->up);
    for (int i = 0; i < 3; i++) {
        g->up[i] = g->s.up[i];
        g->look[i] = (double)c->look[i];
    }
    if (choose_side(g)) {
        tilt_up(g, c);
    }
}

static void fit_box(aiming *g) {
    begin_fitting(g, 0, &g->boxed);
    for (unsigned k = 0; k < g->around; k++) {
        fitting f;
        begin_fitting(g, k, &f);
        fitting_add_box(&f, g->b.lo, g->b.hi);
        g->near = fmax(g->near, 1.03 * fitting_depth(&f, g->b.lo, g->b.hi));
        fitting_join(&g->boxed, &f);
    }
}

/* What is narrower than the picture is to be in its middle: there the farthest points at both sides
 * are to be equally far from the border, and not only from planes that they do not reach. */
static void narrow(aiming *g, const fitting *f) {
    double need[2];
    fitting_need(f, g->freedom, need);
    const double away = fmax(need[0], need[1]);
    double room = HUGE_VAL;
    for (int i = 0; i < 2 && away > 0.0; i++) {
        g->tan[i] = fmax(g->tan[i] * need[i] / away, 0.01 * g->most[i]);
        room = fmin(room, g->most[i] / g->tan[i]);
    }
    for (int i = 0; i < 2 && away > 0.0; i++) {
        g->tan[i] *= room;
    }
}

static void solve(const aiming *g, const fitting *f, plt_camera *c) {
    double eye[3], look[3];
    fitting_solve(f, g->freedom, g->up, g->near, eye, look);
    for (int i = 0; i < 3; i++) {
        c->eye[i] = (float)eye[i];
        c->look[i] = (float)look[i];
    }
}

/* The camera `c`, k steps around. */
static plt_camera step_around(const aiming *g, const plt_camera *c, unsigned k) {
    plt_camera to = *c;
    double arm[3], turned[3];
    for (int i = 0; i < 3; i++) {
        arm[i] = (double)c->eye[i] - (double)c->look[i];
    }
    rotate(arm, g->up, (double)k / g->around, turned);
    for (int i = 0; i < 3; i++) {
        to.eye[i] = (float)((double)c->look[i] + turned[i]);
    }
    return to;
}

/* Adds what is seen from `c`, or from all around. False: nothing is, or nobody can say. */
static int look_around(const aiming *g, const plt_camera *c, fitting *all) {
    const unsigned side = g->a->circles ? SIDE_AROUND : SIDE_ONCE;
    int found = 0;
    begin_fitting(g, 0, all);
    for (unsigned k = 0; k < g->around; k++) {
        const plt_camera from = step_around(g, c, k);
        fitting f;
        begin_fitting(g, k, &f);
        const int more = sight_add(g->a->seen, &from, g->a->aspect, side, &f);
        if (more < 0) {
            return 0;
        }
        found += more;
        fitting_join(all, &f);
    }
    fitting_limit(all, &g->boxed);
    return found > 0;
}

void aim_camera(const aim *a, plt_camera *c) {
    aiming g;
    begin_aiming(&g, a, c);
    for (int i = 0; i < BOX_ROUNDS; i++) {
        fit_box(&g);
        solve(&g, &g.boxed, c);
        narrow(&g, &g.boxed);
    }
    for (int i = 0; i < ROUNDS && a->seen != NULL && a->seen->engine != NULL; i++) {
        plt_camera from = *c;
        fitting f;
        from.tan_half_fov = (float)((double)c->tan_half_fov * WIDER);
        fit_box(&g);
        if (!look_around(&g, &from, &f)) {
            return;
        }
        solve(&g, &f, c);
        narrow(&g, &f);
    }
}

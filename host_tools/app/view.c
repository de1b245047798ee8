/* view - see view.h
 *
 * Computed in double and rounded once: machines whose tangents differ in the last
 * bit still give the engine the same floats, but for rare ties.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/view.h"

#include <math.h>

#include "engine/shade/camera.h"

#define DEGREE 0.017453292519943295

/* The engine takes tangents from 1e-6 to 1e6: these are a little inside. */
static const float FOV_LEAST = 0.0002f, FOV_MOST = 179.999f;

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double to[3]) {
    to[0] = a[1] * b[2] - a[2] * b[1];
    to[1] = a[2] * b[0] - a[0] * b[2];
    to[2] = a[0] * b[1] - a[1] * b[0];
}

static int normalise(double v[3]) {
    const double length = sqrt(dot(v, v));
    for (int i = 0; i < 3 && length > 0.0; i++) {
        v[i] /= length;
    }
    return length > 0.0;
}

/* Axes of the default view; unit length, at right angles. */
typedef struct axes {
    double right[3], up[3], front[3];
} axes;

static void make_axes(axes *s, const float up[3]) {
    const double forward[2][3] = {{0.0, 0.0, 1.0}, {0.0, -1.0, 0.0}};
    for (int i = 0; i < 3; i++) {
        s->up[i] = (double)up[i];
    }
    if (!normalise(s->up)) {
        s->up[1] = 1.0; /* the engine refuses this camera later */
    }
    cross(s->up, forward[fabs(s->up[2]) > fabs(s->up[1])], s->right);
    normalise(s->right);
    cross(s->right, s->up, s->front);
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
    normalise(back);
}

/* How far back along `back` the eye must stand to see all corners. */
static double distance_to_see(const double lo[3], const double hi[3], const double middle[3],
                              const double back[3], const double up[3], double tan_x,
                              double tan_y) {
    double right[3], above[3], need = 0.0;
    cross(up, back, right);
    normalise(right);
    cross(back, right, above);
    for (int k = 0; k < 8; k++) {
        double q[3];
        for (int i = 0; i < 3; i++) {
            q[i] = (k >> i & 1 ? hi[i] : lo[i]) - middle[i];
        }
        const double near = dot(q, back);
        need = fmax(need, near + fabs(dot(q, right)) / tan_x);
        need = fmax(need, near + fabs(dot(q, above)) / tan_y);
    }
    return need > 0.0 ? 1.03 * need : 1.0;
}

static void fit(const plt_info *info, unsigned width, unsigned height, plt_camera *c) {
    double lo[3] = {0, 0, 0}, hi[3] = {0, 0, 0}, edge[3], middle[3], back[3];
    axes s;
    for (int i = 0; i < 3; i++) {
        if (info->triangles > 0) {
            lo[i] = (double)info->lo[i];
            hi[i] = (double)info->hi[i];
        }
        edge[i] = hi[i] - lo[i];
        middle[i] = (double)c->look[i];
    }
    make_axes(&s, c->up);
    choose_back(&s, edge, back);
    const double tan_y = (double)c->tan_half_fov;
    const double d = distance_to_see(lo, hi, middle, back, s.up, tan_y * width / height, tan_y);
    for (int i = 0; i < 3; i++) {
        c->eye[i] = (float)(middle[i] + d * back[i]);
    }
}

/* False for what is no number, too. */
static int is_within(const float v[3]) {
    int within = 1;
    for (int i = 0; i < 3; i++) {
        within &= v[i] >= -PLT_COORD_MAX && v[i] <= PLT_COORD_MAX;
    }
    return within;
}

static void read_point(args *a, const char *flag, float v[3]) {
    if (args_floats(a, flag, v, 3) && !is_within(v)) {
        args_complain(a, "%s takes three numbers from -2^40 to 2^40, not '%s'", flag,
                      args_text(a, flag, ""));
    }
}

static void read_fov(args *a, float *fov) {
    if (args_floats(a, "--fov", fov, 1) && !(*fov >= FOV_LEAST && *fov <= FOV_MOST)) {
        args_complain(a, "--fov takes degrees from 0.0002 to 179.999, not '%s'",
                      args_text(a, "--fov", ""));
        *fov = 45.0f;
    }
}

static void look_at_the_middle(const plt_info *info, plt_camera *c) {
    c->up[0] = c->up[2] = 0.0f;
    c->up[1] = 1.0f;
    for (int i = 0; i < 3; i++) {
        c->look[i] = info->triangles > 0 ? 0.5f * info->lo[i] + 0.5f * info->hi[i] : 0.0f;
    }
}

static void set_fov(plt_camera *c, float degrees) {
    c->tan_half_fov = (float)tan(0.5 * (double)degrees * DEGREE);
}

void view_camera(args *a, const plt_info *info, unsigned width, unsigned height, plt_camera *c) {
    float fov = 45.0f;
    look_at_the_middle(info, c);
    read_point(a, "--up", c->up);
    read_point(a, "--look", c->look);
    read_fov(a, &fov);
    set_fov(c, fov);
    if (args_has(a, "--eye")) {
        read_point(a, "--eye", c->eye);
    } else {
        fit(info, width, height, c);
    }
}

void view_of_all(const plt_info *info, unsigned width, unsigned height, plt_camera *c) {
    look_at_the_middle(info, c);
    set_fov(c, 45.0f);
    fit(info, width, height, c);
}

static int refuse(const args *a, const plt_camera *c, fail *f) {
    if (!is_within(c->eye)) {
        return fail_set(f, "camera", "%s",
                        args_has(a, "--eye")
                            ? "its orbit goes beyond 2^40; move --eye nearer to --look"
                            : "all is seen only from beyond 2^40; choose a nearer --eye, or a "
                              "wider --fov");
    }
    if (c->eye[0] == c->look[0] && c->eye[1] == c->look[1] && c->eye[2] == c->look[2]) {
        return fail_set(f, "camera", "eye and look coincide; change --eye or --look");
    }
    if (c->up[0] == 0.0f && c->up[1] == 0.0f && c->up[2] == 0.0f) {
        return fail_set(f, "camera", "up has no direction; change --up");
    }
    return fail_set(f, "camera", "up runs along the view; change --eye, --look or --up");
}

void view_orbit(const plt_camera *from, double circles, plt_camera *to) {
    double axis[3], arm[3], side[3];
    for (int i = 0; i < 3; i++) {
        axis[i] = (double)from->up[i];
        arm[i] = (double)from->eye[i] - (double)from->look[i];
    }
    normalise(axis);
    cross(axis, arm, side);
    const double c = cos(360.0 * DEGREE * circles), s = sin(360.0 * DEGREE * circles);
    const double along = dot(axis, arm);
    *to = *from;
    for (int i = 0; i < 3; i++) { /* Rodrigues */
        to->eye[i] =
            (float)((double)from->look[i] + arm[i] * c + side[i] * s + axis[i] * along * (1.0 - c));
    }
}

int view_refused(const args *a, const plt_frame *frame, unsigned frames, fail *f) {
    plt_frame now = *frame;
    plt_view view;
    for (unsigned i = 0; i < frames; i++) {
        if (i > 0) {
            view_orbit(&frame->camera, (double)i / frames, &now.camera);
        }
        if (plt_view_set(&view, &now) != PLT_OK) {
            return refuse(a, &now.camera, f);
        }
    }
    return 0;
}

uint8_t view_shader(args *a) {
    static const char *const names[] = {"eyelight", "normal", "triangle", NULL};
    return (uint8_t)args_choice(a, "--shader", names, PLT_SHADE_EYELIGHT);
}

uint8_t view_any_shader(args *a) {
    static const char *const names[] = {"eyelight", "normal", "triangle", "depth", "heat", NULL};
    return (uint8_t)args_choice(a, "--shader", names, PLT_SHADE_EYELIGHT);
}

uint8_t view_samples(args *a) {
    static const char *const names[] = {"1", "4", "16", "adaptive", NULL};
    static const uint8_t samples[] = {PLT_SAMPLES_ONE, PLT_SAMPLES_FOUR, PLT_SAMPLES_SIXTEEN,
                                      PLT_SAMPLES_ADAPTIVE};
    return samples[args_choice(a, "--samples", names, 0)];
}

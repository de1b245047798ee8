/* view - see view.h
 *
 * Double precision, rounded once: the engine gets the same floats wherever
 * the last bit of a tangent does not decide.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/view.h"

#include <math.h>

#define DEGREE 0.017453292519943295

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

/* How far back along `back` the eye must stand to see all corners. */
static double distance_to_see(const double lo[3], const double hi[3], const double middle[3],
                              const double back[3], const double up[3], double tan_x,
                              double tan_y) {
    double right[3], above[3], need = 0.0;
    cross(up, back, right);
    if (!normalise(right)) {
        right[0] = 1.0, right[1] = right[2] = 0.0;
    }
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
    double lo[3] = {0, 0, 0}, hi[3] = {0, 0, 0}, middle[3], back[3] = {0.45, 0.35, 1.0}, up[3];
    for (int i = 0; i < 3; i++) {
        if (info->triangles > 0) {
            lo[i] = (double)info->lo[i];
            hi[i] = (double)info->hi[i];
        }
        middle[i] = (double)c->look[i];
        up[i] = (double)c->up[i];
    }
    if (fabs(up[2]) > fabs(up[1])) { /* z is up: look from the side, not from above */
        back[1] = -1.0, back[2] = 0.35;
    }
    normalise(back);
    const double tan_y = (double)c->tan_half_fov;
    const double d = distance_to_see(lo, hi, middle, back, up, tan_y * width / height, tan_y);
    for (int i = 0; i < 3; i++) {
        c->eye[i] = (float)(middle[i] + d * back[i]);
    }
}

void view_camera(args *a, const plt_info *info, unsigned width, unsigned height,
                 plt_camera *c) {
    float fov = 45.0f;
    c->up[0] = c->up[2] = 0.0f;
    c->up[1] = 1.0f;
    for (int i = 0; i < 3; i++) {
        c->look[i] = info->triangles > 0 ? 0.5f * info->lo[i] + 0.5f * info->hi[i] : 0.0f;
    }
    args_floats(a, "--up", c->up, 3);
    args_floats(a, "--look", c->look, 3);
    if (args_floats(a, "--fov", &fov, 1) && !(fov > 0.0f && fov < 180.0f)) {
        args_complain(a, "--fov takes degrees between 0 and 180");
        fov = 45.0f;
    }
    c->tan_half_fov = (float)tan(0.5 * (double)fov * DEGREE);
    if (!args_floats(a, "--eye", c->eye, 3)) {
        fit(info, width, height, c);
    }
}

void view_orbit(const plt_camera *from, double turn, plt_camera *to) {
    double axis[3], arm[3], side[3];
    for (int i = 0; i < 3; i++) {
        axis[i] = (double)from->up[i];
        arm[i] = (double)from->eye[i] - (double)from->look[i];
    }
    normalise(axis);
    cross(axis, arm, side);
    const double c = cos(360.0 * DEGREE * turn), s = sin(360.0 * DEGREE * turn);
    const double along = dot(axis, arm);
    *to = *from;
    for (int i = 0; i < 3; i++) { /* Rodrigues */
        to->eye[i] = (float)((double)from->look[i] + arm[i] * c + side[i] * s +
                             axis[i] * along * (1.0 - c));
    }
}

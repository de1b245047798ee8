/* fitting - see fitting.h
 *
 * With x, y and z along right, above and back, an eye at (a, b, c) sees (x, y, z) if
 * x - a <= tan_x (c - z), and so for -x, y and -y. So x + tan_x z <= a + tan_x c: the greatest
 * left sides, m0 to m3, are all that counts. a = (m0 - m1) / 2 lets c be least, which is
 * (m0 + m1) / (2 tan_x), or what y asks for if that is more.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/fitting.h"

#include <math.h>

double vector_dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

void vector_cross(const double a[3], const double b[3], double to[3]) {
    to[0] = a[1] * b[2] - a[2] * b[1];
    to[1] = a[2] * b[0] - a[0] * b[2];
    to[2] = a[0] * b[1] - a[1] * b[0];
}

int vector_normalise(double v[3]) {
    const double length = sqrt(vector_dot(v, v));
    for (int i = 0; i < 3 && length > 0.0; i++) {
        v[i] /= length;
    }
    return length > 0.0;
}

void fitting_begin(fitting *f, const double origin[3], const double back[3], const double up[3],
                   double tan_x, double tan_y) {
    for (int i = 0; i < 3; i++) {
        f->origin[i] = origin[i];
        f->back[i] = back[i];
    }
    vector_cross(up, back, f->right);
    vector_normalise(f->right);
    vector_cross(back, f->right, f->above);
    f->tan_x = tan_x;
    f->tan_y = tan_y;
    for (int i = 0; i < 4; i++) {
        f->most[i] = -HUGE_VAL;
    }
}

void fitting_add(fitting *f, const double point[3], double more_x, double more_y) {
    double q[3];
    for (int i = 0; i < 3; i++) {
        q[i] = point[i] - f->origin[i];
    }
    const double x = vector_dot(q, f->right), y = vector_dot(q, f->above);
    const double z = vector_dot(q, f->back);
    const double reach[4] = {x + more_x + f->tan_x * z, more_x - x + f->tan_x * z,
                             y + more_y + f->tan_y * z, more_y - y + f->tan_y * z};
    for (int i = 0; i < 4; i++) {
        f->most[i] = fmax(f->most[i], reach[i]);
    }
}

void fitting_add_box(fitting *f, const double lo[3], const double hi[3]) {
    for (int k = 0; k < 8; k++) {
        double corner[3];
        for (int i = 0; i < 3; i++) {
            corner[i] = k >> i & 1 ? hi[i] : lo[i];
        }
        fitting_add(f, corner, 0.0, 0.0);
    }
}

double fitting_depth(const fitting *f, const double lo[3], const double hi[3]) {
    double depth = 0.0;
    for (int i = 0; i < 3; i++) {
        depth += f->back[i] * ((f->back[i] > 0.0 ? hi[i] : lo[i]) - f->origin[i]);
    }
    return depth;
}

void fitting_join(fitting *f, const fitting *other) {
    for (int i = 0; i < 4; i++) {
        f->most[i] = fmax(f->most[i], other->most[i]);
    }
}

void fitting_limit(fitting *f, const fitting *other) {
    for (int i = 0; i < 4; i++) {
        f->most[i] = fmin(f->most[i], other->most[i]);
    }
}

void fitting_need(const fitting *f, enum fitting_freedom freedom, double need[2]) {
    const double *m = f->most;
    need[0] = freedom == FITTING_ASIDE ? 0.5 * (m[0] + m[1]) : fmax(m[0], m[1]);
    need[1] = freedom == FITTING_FIXED ? fmax(m[2], m[3]) : 0.5 * (m[2] + m[3]);
    need[0] /= f->tan_x;
    need[1] /= f->tan_y;
}

/* Where the eye is along right and above, and how far back. */
static void place(const fitting *f, enum fitting_freedom freedom, double at[3]) {
    const double *m = f->most;
    double need[2];
    fitting_need(f, freedom, need);
    at[0] = freedom == FITTING_ASIDE ? 0.5 * (m[0] - m[1]) : 0.0;
    at[1] = freedom == FITTING_FIXED ? 0.0 : 0.5 * (m[2] - m[3]);
    at[2] = fmax(need[0], need[1]);
}

/* On a circle the point it looks at lies on the axis: the eye's height there is as much along
 * above as is asked for, and some of it is along back. */
void fitting_solve(const fitting *f, enum fitting_freedom freedom, const double up[3], double least,
                   double eye[3], double look[3]) {
    const int circles = freedom == FITTING_CIRCLE;
    const double steep = vector_dot(up, f->above);
    const int is_free = circles && steep > 0.1;
    double at[3];
    place(f, circles && !is_free ? FITTING_FIXED : freedom, at);
    const double rise = is_free ? at[1] / steep : 0.0;
    const double need = fmax(at[2] - rise * vector_dot(up, f->back), least);
    const double away = need > 0.0 ? need : 1.0;
    for (int i = 0; i < 3; i++) {
        look[i] =
            f->origin[i] + (is_free ? rise * up[i] : at[0] * f->right[i] + at[1] * f->above[i]);
        eye[i] = look[i] + away * f->back[i];
    }
}

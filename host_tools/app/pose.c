/* pose - see pose.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/pose.h"

#include <math.h>

#include "host_tools/app/fitting.h"
#include "host_tools/app/view.h"

#define DEGREE 0.017453292519943295

static const double STEEPEST = 89.0, NEAREST = 100.0, FARTHEST = 0.05;

void pose_begin(pose *p, const plt_camera *first) {
    *p = (pose){.first = *first, .nearer = 1.0};
}

static void get_arm(const plt_camera *c, double arm[3], double up[3]) {
    for (int i = 0; i < 3; i++) {
        arm[i] = (double)c->eye[i] - (double)c->look[i];
        up[i] = (double)c->up[i];
    }
    vector_normalise(up);
}

/* How far the first eye is above the plane that up is at right angles to; degrees. */
static double first_elevation(const pose *p) {
    double arm[3], up[3];
    get_arm(&p->first, arm, up);
    return asin(fmax(-1.0, fmin(1.0, vector_dot(arm, up) / sqrt(vector_dot(arm, arm))))) / DEGREE;
}

int pose_turn(pose *p, double azimuth, double elevation) {
    const double before = p->elevation, at = first_elevation(p);
    const double most = fmax(STEEPEST - at, 0.0), least = fmin(-STEEPEST - at, 0.0);
    p->elevation = fmax(least, fmin(most, before + elevation));
    p->azimuth = fmod(p->azimuth + azimuth, 360.0);
    return p->elevation != before || azimuth != 0.0;
}

int pose_zoom(pose *p, double factor) {
    const double before = p->nearer;
    p->nearer = fmax(FARTHEST, fmin(NEAREST, before * factor));
    return p->nearer != before;
}

/* Up in its own plane, then around up. */
plt_camera pose_camera(const pose *p) {
    plt_camera c = p->first, turned;
    double arm[3], up[3];
    get_arm(&p->first, arm, up);
    const double length = sqrt(vector_dot(arm, arm)), high = vector_dot(arm, up);
    const double flat = sqrt(fmax(length * length - high * high, 0.0));
    const double now = (first_elevation(p) + p->elevation) * DEGREE;
    for (int i = 0; i < 3; i++) {
        const double level = flat > 0.0 ? (arm[i] - high * up[i]) / flat : 0.0;
        const double to = length / p->nearer * (cos(now) * level + sin(now) * up[i]);
        c.eye[i] = (float)((double)c.look[i] + to);
    }
    view_orbit(&c, p->azimuth / 360.0, &turned);
    return turned;
}

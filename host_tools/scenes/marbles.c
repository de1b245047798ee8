/* marbles - the mechanics of scene_marbles
 *
 * A step: gravity; friction of the floor, which changes sliding into rolling;
 * rolling resistance; bounces; motion; removal of overlaps. A marble that rolls
 * freely downhill gets 5/7 of the acceleration of one that slides.
 *
 * Source: H. Goldstein, "Classical Mechanics", 3rd ed., 2001, chapters 4 and
 * 5 (rotation of rigid bodies).
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/marbles.h"

#include <math.h>

#include "host_tools/scenes/contacts.h"
#include "host_tools/scenes/cos_sin.h"
#include "host_tools/scenes/noise.h"

#define STEP (1.0 / 500.0)
#define INERTIA_INVERSE 2.5 /* 1 / moment of inertia */
#define FLOOR_FRICTION 0.4  /* of the weight */
#define ROLLING 0.006       /* resistance, of the weight */
#define LEAN 0.07           /* sine of 4 degrees */
#define LEAN_FRAMES 50u     /* until the tray leans in full */
#define PERIOD_X 130u       /* frames for a swing to either side */
#define PERIOD_Z 178u       /* the two together repeat after 11,570 frames */
#define SPREAD 1.30         /* of the first positions, radii */
#define GOLDEN 1640531527u  /* the golden angle, (3 - sqrt(5)) / 2 circles, in units of 2^-32 */
#define FIRST_SPEED 12.0    /* radii per second, at most, along each axis */

static double squared(double x) {
    return x * x;
}

/* At the positions of a sunflower's seeds, rolling in all directions. */
void marbles_start(marbles *m, unsigned count) {
    *m = (marbles){.count = count};
    for (unsigned i = 0; i < count; i++) {
        const cos_sin direction = cos_sin_of((uint64_t)i * GOLDEN, (uint64_t)1 << 32);
        const double out = SPREAD * sqrt(i + 0.5);
        marble *a = &m->marble[i];
        *a = (marble){.x = out * direction.cosine, .z = out * direction.sine, .orientation = {1.0}};
        a->vx = FIRST_SPEED * (2.0 * noise_unit(i, 0, 5) - 1.0);
        a->vz = FIRST_SPEED * (2.0 * noise_unit(i, 1, 5) - 1.0);
        a->spin[0] = a->vz;
        a->spin[2] = -a->vx;
    }
}

/* The lowest point's sliding speed is (vx + spin z, vz - spin x); friction
 * stops it, as far as the weight allows. */
static void grip(marble *a, double most) {
    double x = (a->vx + a->spin[2]) / (1.0 + INERTIA_INVERSE);
    double z = (a->vz - a->spin[0]) / (1.0 + INERTIA_INVERSE);
    const double needed = sqrt(x * x + z * z);
    if (needed > most) {
        x *= most / needed;
        z *= most / needed;
    }
    a->vx -= x;
    a->vz -= z;
    a->spin[2] -= INERTIA_INVERSE * x;
    a->spin[0] += INERTIA_INVERSE * z;
}

static void resist(marble *a, double most) {
    const double speed = sqrt(squared(a->vx) + squared(a->vz) + squared(a->spin[1]));
    const double keep = speed > most ? 1.0 - most / speed : 0.0;
    a->vx *= keep;
    a->vz *= keep;
    for (unsigned i = 0; i < 3; i++) {
        a->spin[i] *= keep;
    }
}

/* orientation += step / 2 * spin * orientation, as quaternions. */
static void rotate(marble *a) {
    const double x = 0.5 * STEP * a->spin[0], y = 0.5 * STEP * a->spin[1];
    const double z = 0.5 * STEP * a->spin[2];
    double *q = a->orientation;
    const double next[4] = {
        q[0] - x * q[1] - y * q[2] - z * q[3], q[1] + x * q[0] + y * q[3] - z * q[2],
        q[2] + y * q[0] + z * q[1] - x * q[3], q[3] + z * q[0] + x * q[2] - y * q[1]};
    const double length =
        sqrt(squared(next[0]) + squared(next[1]) + squared(next[2]) + squared(next[3]));
    for (unsigned i = 0; i < 4; i++) {
        q[i] = next[i] / length;
    }
}

void marbles_step(marbles *m) {
    const double upright = sqrt(1.0 - squared(m->lean_x) - squared(m->lean_z));
    const double weight = STEP * MARBLES_GRAVITY * upright;
    contacts near;
    for (unsigned i = 0; i < m->count; i++) {
        marble *a = &m->marble[i];
        a->vx += STEP * MARBLES_GRAVITY * m->lean_x;
        a->vz += STEP * MARBLES_GRAVITY * m->lean_z;
        grip(a, FLOOR_FRICTION * weight);
        resist(a, ROLLING * weight);
    }
    contacts_find(&near, m);
    contacts_bounce(&near, m, STEP);
    for (unsigned i = 0; i < m->count; i++) {
        marble *a = &m->marble[i];
        a->x += STEP * a->vx;
        a->z += STEP * a->vz;
        rotate(a);
    }
    contacts_part(&near, m);
}

static void lean(marbles *m) {
    const unsigned k = m->frames;
    const double full = k < LEAN_FRAMES ? LEAN * k / LEAN_FRAMES : LEAN;
    m->lean_x = full * cos_sin_of(k, PERIOD_X).sine;
    m->lean_z = full * cos_sin_of(k, PERIOD_Z).cosine;
}

void marbles_frame(marbles *m) {
    m->frames++;
    lean(m);
    for (unsigned i = 0; i < MARBLES_STEPS; i++) {
        marbles_step(m);
    }
}

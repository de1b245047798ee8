/* contacts - marbles against each other and against the walls
 *
 * Sequential impulses: one contact after the other gets the impulse that stops
 * (or reverses) its approach, again and again. Friction acts against the sliding
 * of the surfaces, sideways and, because the marbles rotate, up and down; the
 * floor carries the vertical part. No impulse adds energy: the normal one because
 * restitution is below 1, friction because it is at most what stops the sliding.
 *
 * Source: B. Mirtich, J. Canny, "Impulse-based Simulation of Rigid Bodies",
 * Symposium on Interactive 3D Graphics, 1995.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/contacts.h"

#include <math.h>
#include <stddef.h>

#define RESTITUTION 0.6
#define FRICTION 0.15
#define SLOW 2.0 /* radii per second: gentler meetings do not bounce */
#define BOUNCE_SWEEPS 12u
#define PART_SWEEPS 60u
#define PART_SLACK 0.002 /* overlap that is left alone, of a radius */

/* 1 / (moment of inertia) of a solid ball of mass and radius 1. */
#define INERTIA_INVERSE 2.5

const double marbles_wall[MARBLES_WALLS][2] = {
    {1.0, 0.0},  {0.70710678118654752, 0.70710678118654752},
    {0.0, 1.0},  {-0.70710678118654752, 0.70710678118654752},
    {-1.0, 0.0}, {-0.70710678118654752, -0.70710678118654752},
    {0.0, -1.0}, {0.70710678118654752, -0.70710678118654752},
};

/* The gap now; the normal too for two marbles. */
static void measure(contact *c, const marbles *m) {
    const marble *a = &m->marble[c->first];
    if (c->second == MARBLES) {
        c->gap = MARBLES_REACH - (a->x * c->x + a->z * c->z);
        return;
    }
    const double x = m->marble[c->second].x - a->x, z = m->marble[c->second].z - a->z;
    const double distance = sqrt(x * x + z * z);
    c->gap = distance - 2.0;
    c->x = x / distance;
    c->z = z / distance;
}

static void add_near(contacts *c, contact new, const marbles *m) {
    measure(&new, m);
    if (new.gap < CONTACT_NEAR && c->count < CONTACTS_MAX) {
        c->contact[c->count++] = new;
    }
}

void contacts_find(contacts *c, const marbles *m) {
    c->count = 0;
    for (unsigned i = 0; i < m->count; i++) {
        const marble *a = &m->marble[i];
        for (unsigned j = i + 1; j < m->count; j++) {
            const double x = m->marble[j].x - a->x, z = m->marble[j].z - a->z;
            if (x * x + z * z < (2.0 + CONTACT_NEAR) * (2.0 + CONTACT_NEAR)) {
                add_near(c, (contact){.first = i, .second = j}, m);
            }
        }
        for (unsigned w = 0; w < MARBLES_WALLS; w++) {
            add_near(c,
                     (contact){.first = i,
                               .second = MARBLES,
                               .wall = w,
                               .x = marbles_wall[w][0],
                               .z = marbles_wall[w][1]},
                     m);
        }
    }
}

/* The impulse (along the normal, to its side, up) on the second body, its
 * opposite on the first: both spins change alike. */
static void push(marble *a, marble *b, const contact *c, double normal, double side, double up) {
    const double x = normal * c->x - side * c->z, z = normal * c->z + side * c->x;
    const double spin[3] = {INERTIA_INVERSE * up * c->z, INERTIA_INVERSE * side,
                            -INERTIA_INVERSE * up * c->x};
    a->vx -= x;
    a->vz -= z;
    for (unsigned i = 0; i < 3; i++) {
        a->spin[i] += spin[i];
    }
    if (b) {
        b->vx += x;
        b->vz += z;
        for (unsigned i = 0; i < 3; i++) {
            b->spin[i] += spin[i];
        }
    }
}

/* How fast b's surface slides over a's, to the side and up. */
static void sliding(const marble *a, const marble *b, const contact *c, double *side, double *up) {
    static const marble wall = {0};
    const marble *other = b ? b : &wall;
    const double x = other->vx - a->vx, z = other->vz - a->vz;
    double spin[3];
    for (unsigned i = 0; i < 3; i++) {
        spin[i] = other->spin[i] + a->spin[i];
    }
    *side = z * c->x - x * c->z + spin[1];
    *up = spin[0] * c->z - spin[2] * c->x;
}

static double separation_speed(const marble *a, const marble *b, const contact *c) {
    const double x = (b ? b->vx : 0.0) - a->vx, z = (b ? b->vz : 0.0) - a->vz;
    return x * c->x + z * c->z;
}

static void rub(marble *a, marble *b, const contact *c, double normal) {
    const double bodies = b ? 2.0 : 1.0;
    double side, up;
    sliding(a, b, c, &side, &up);
    side /= -bodies * (1.0 + INERTIA_INVERSE);
    up /= -bodies * INERTIA_INVERSE;
    const double needed = sqrt(side * side + up * up), limit = FRICTION * normal;
    const double share = needed > limit ? limit / needed : 1.0;
    push(a, b, c, 0.0, share * side, share * up);
}

static int bounce(const contact *c, marbles *m, double step) {
    marble *a = &m->marble[c->first];
    marble *b = c->second == MARBLES ? NULL : &m->marble[c->second];
    const double speed = separation_speed(a, b, c);
    const double allowed = c->gap > 0.0 ? -c->gap / step : 0.0;
    if (speed >= allowed) {
        return 0;
    }
    const double wanted = speed < -SLOW ? -RESTITUTION * speed : allowed;
    const double normal = (wanted - speed) / (b ? 2.0 : 1.0);
    push(a, b, c, normal, 0.0, 0.0);
    rub(a, b, c, normal);
    return 1;
}

void contacts_bounce(const contacts *c, marbles *m, double step) {
    int busy = 1;
    for (unsigned sweep = 0; busy && sweep < BOUNCE_SWEEPS; sweep++) {
        busy = 0;
        for (unsigned i = 0; i < c->count; i++) {
            busy |= bounce(&c->contact[i], m, step);
        }
    }
}

static int part(contact c, marbles *m) {
    measure(&c, m);
    if (c.gap >= -PART_SLACK) {
        return 0;
    }
    marble *a = &m->marble[c.first];
    if (c.second == MARBLES) {
        a->x += c.gap * c.x;
        a->z += c.gap * c.z;
        return 1;
    }
    marble *b = &m->marble[c.second];
    a->x += 0.5 * c.gap * c.x;
    a->z += 0.5 * c.gap * c.z;
    b->x -= 0.5 * c.gap * c.x;
    b->z -= 0.5 * c.gap * c.z;
    return 1;
}

void contacts_part(const contacts *c, marbles *m) {
    int busy = 1;
    for (unsigned sweep = 0; busy && sweep < PART_SWEEPS; sweep++) {
        busy = 0;
        for (unsigned i = 0; i < c->count; i++) {
            busy |= part(c->contact[i], m);
        }
    }
}

/* contacts - marbles against each other and against the walls
 *
 * SPDX-License-Identifier: MIT */
#ifndef CONTACTS_H
#define CONTACTS_H
#include "host_tools/scenes/marbles_state.h"

/* At most six neighbours per marble, each pair once, and two walls; those
 * within CONTACT_NEAR may be a few more. */
#define CONTACTS_MAX (8u * MARBLES)
#define CONTACT_NEAR 0.3 /* gap in radii; nothing closes faster in a step */

typedef struct contact {
    unsigned first, second; /* second == MARBLES: the wall below */
    unsigned wall;
    double x, z; /* unit normal, from the first to the second */
    double gap;
} contact;

typedef struct contacts {
    contact contact[CONTACTS_MAX];
    unsigned count;
} contacts;

extern const double marbles_wall[MARBLES_WALLS][2]; /* outward normals, x z */

void contacts_find(contacts *c, const marbles *m);

/* Impulses until no contact closes its gap within `step` seconds, or the
 * sweeps are used up. Never adds kinetic energy. */
void contacts_bounce(const contacts *c, marbles *m, double step);

/* Moves marbles apart until no gap is below -MARBLES_OVERLAP. */
void contacts_part(const contacts *c, marbles *m);

#endif

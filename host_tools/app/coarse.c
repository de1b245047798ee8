/* coarse - see coarse.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/coarse.h"

static const double IN_TIME = 0.06; /* seconds that a picture may take while the camera moves */

void coarse_moved(coarse *c) {
    c->is_due = 1;
    c->level = c->first;
}

unsigned coarse_side(const coarse *c, unsigned side) {
    const unsigned scaled =
        c->level == COARSE_FINEST ? 2 * side : side >> (c->level - COARSE_PLAIN);
    return scaled > 0 ? scaled : 1;
}

static void adapt(coarse *c, double seconds) {
    if (c->level == c->first && seconds > IN_TIME && c->first < COARSE_MOST) {
        c->first++;
    } else if (c->level == c->first && seconds < IN_TIME / 6.0 && c->first > COARSE_PLAIN) {
        c->first--;
    }
}

int coarse_give_up(coarse *c, unsigned level, double seconds) {
    if (level >= c->first && (seconds <= IN_TIME || level >= COARSE_MOST)) {
        return 0;
    }
    if (level >= c->first) {
        c->first = level + 1;
        c->level = c->first;
    }
    return 1;
}

void coarse_complete(coarse *c, double seconds) {
    adapt(c, seconds);
    c->is_due = c->level > COARSE_FINEST;
    c->level -= (unsigned)c->is_due;
}

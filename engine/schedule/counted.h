/* counted - a traversal that takes its visits off those that are left
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SCHEDULE_COUNTED_H
#define PLT_SCHEDULE_COUNTED_H

#include "engine/trace/traversal.h"

/* Goes on with a packet whose entry is on the stack; *visits, which are left, become fewer. PLT_OK:
 * it is done there; PLT_MORE: they are used up; or what a fetch failed with. An entry that turns
 * out to be hidden counts as a visit, so that a call ends. */
static inline int plt_traverse_counted(plt_traversal *t, plt_packet *packet, uint32_t *visits) {
    const uint64_t before = t->stats.node_visits;
    const int status = plt_traverse(t, packet, *visits);
    const uint64_t used = t->stats.node_visits - before + 1;
    if (status < 0) {
        return status;
    }
    if (used >= *visits) {
        return PLT_MORE;
    }
    *visits -= (uint32_t)used;
    return PLT_OK;
}

#endif

/* traverse_format - a format's traversal in every order that is wanted for it
 *
 * Included once by each traverse_NAME.c, behind its format and the orders, with
 *   FORMAT_NAME              as in scene/formats.h
 *   FORMAT_ORDERS(ROW)       ROW(ORDER, order) for each order
 *   FORMAT_ORDER(order)      optional: the order that stands for the one asked for
 *   FORMAT_FETCHES           optional, 1: format_state has a fetcher (memory/fetcher.h)
 * It gives the functions of traverse_formats.h. An order gives
 *   order_entry                            what lies on its stacks
 *   int push_root_order(t, p)              0: there is nothing to hit
 *   int pop_order(t, p, &visits)           works one entry off; adds nodes visited
 * and where packets meet (format_meets.h)
 *   int root_waits_order(t)                waits at the root
 *   int is_open_order(t, p)                the one entry on the stack, an edge, is still met
 *
 * SPDX-License-Identifier: MIT */
#ifdef FORMAT_NAME /* else there is nothing to make */

#include "engine/trace/traverse_formats.h"

#ifndef FORMAT_ORDER
#define FORMAT_ORDER(order) (order)
#endif

/* The row of the order that packets with hulls go in, where there are any. */
#if PLT_WITH_HULLS
#define FORMAT_ORDER_HULLS(ROW) ROW(HULLS, hulls)
#else
#define FORMAT_ORDER_HULLS(ROW)
#endif

/* FORMAT_STACK learns how large entries of the packet's stack are, FORMAT_PAUSE waits for what is
 * on its way when a traversal returns; where packets meet, it is on its way for all of them. */
#if PLT_WITH_PREFETCH && defined(FORMAT_FETCHES)
#define FORMAT_STACK(t, bytes) (t)->entry_bytes = (uint16_t)(bytes)
#define FORMAT_PAUSE(t) pause_alone(t)
static void pause_all(plt_traversal *t) {
    plt_prefetch_end(&((format_state *)t->state)->fetcher);
}

static void pause_alone(plt_traversal *t) {
    if (!plt_meets(t)) {
        pause_all(t);
    }
}
#else
#define FORMAT_STACK(t, bytes)
#define FORMAT_PAUSE(t)
#endif

#define PLT_JOINED_AGAIN(name, what) plt_##name##_##what
#define PLT_JOINED(name, what) PLT_JOINED_AGAIN(name, what)

size_t PLT_JOINED(FORMAT_NAME, entry_bytes)(unsigned order) {
    switch (FORMAT_ORDER(order)) {
#define ENTRY_BYTES(ORDER, order)                                                                  \
    case PLT_ORDER_##ORDER:                                                                        \
        return sizeof(order##_entry);
        FORMAT_ORDERS(ENTRY_BYTES)
#undef ENTRY_BYTES
    default:
        return 0;
    }
}

size_t PLT_JOINED(FORMAT_NAME, state_bytes)(void) {
    return sizeof(format_state);
}

void PLT_JOINED(FORMAT_NAME, state_init)(plt_traversal *t) {
    format_state_init(t);
}

#if FORMAT_MEETS
_Static_assert(sizeof(format_place) <= PLT_TASK_PLACE_BYTES, "places fit queues of tasks");
#define REST_FITS(ORDER, order)                                                                    \
    _Static_assert(offsetof(order##_entry, place) == 0 &&                                          \
                       sizeof(order##_entry) - sizeof(format_place) <= PLT_TASK_REST_BYTES,        \
                   "entries begin with a place, and the rest of them fits a task");
FORMAT_ORDERS(REST_FITS)
#undef REST_FITS

/* At the root, where all packets meet first. */
static int PLT_JOINED(FORMAT_NAME, root_waits)(plt_traversal *t, const plt_packet *p) {
    switch (FORMAT_ORDER(plt_order_for(t, p))) {
#define ROOT_WAITS(ORDER, order)                                                                   \
    case PLT_ORDER_##ORDER:                                                                        \
        return root_waits_##order(t);
        FORMAT_ORDERS(ROOT_WAITS)
#undef ROOT_WAITS
    default:
        return 0;
    }
}

#if PLT_WITH_PREFETCH
int PLT_JOINED(FORMAT_NAME, is_open)(const plt_traversal *t, const plt_packet *p) {
    switch (FORMAT_ORDER(plt_order_for(t, p))) {
#define IS_OPEN(ORDER, order)                                                                      \
    case PLT_ORDER_##ORDER:                                                                        \
        return is_open_##order(t, p);
        FORMAT_ORDERS(IS_OPEN)
#undef IS_OPEN
    default:
        return 0;
    }
}

void PLT_JOINED(FORMAT_NAME, pause)(plt_traversal *t) {
    pause_all(t);
}
#endif
#endif

void PLT_JOINED(FORMAT_NAME, begin)(plt_traversal *t, plt_packet *p) {
    int there = 0;
    switch (FORMAT_ORDER(plt_order_for(t, p))) {
#define PUSH_ROOT(ORDER, order)                                                                    \
    case PLT_ORDER_##ORDER:                                                                        \
        there = push_root_##order(t, p);                                                           \
        FORMAT_STACK(t, sizeof(order##_entry));                                                    \
        break;
        FORMAT_ORDERS(PUSH_ROOT)
#undef PUSH_ROOT
    default:
        break;
    }
    t->waiting = there && p->active != 0;
#if FORMAT_MEETS
    if (t->tasks != NULL && t->waiting > 0) {
        t->waiting = !PLT_JOINED(FORMAT_NAME, root_waits)(t, p);
    }
#endif
}

/* Pops until the visits are used up, nothing waits, every ray of an any-hit packet has
 * hit, or a fetch fails. */
#define TRAVERSE(ORDER, order)                                                                     \
    static int traverse_##order(plt_traversal *t, plt_packet *p, uint32_t visits) {                \
        while (t->waiting > 0 && visits > 0) {                                                     \
            uint32_t used = 1;                                                                     \
            const int status = pop_##order(t, p, &used);                                           \
            if (status != PLT_OK) {                                                                \
                FORMAT_PAUSE(t);                                                                   \
                t->waiting = 0;                                                                    \
                return status;                                                                     \
            }                                                                                      \
            visits -= used < visits ? used : visits;                                               \
            if (p->active == 0) {                                                                  \
                t->waiting = 0;                                                                    \
            }                                                                                      \
        }                                                                                          \
        FORMAT_PAUSE(t);                                                                           \
        return t->waiting > 0 ? PLT_MORE : PLT_OK;                                                 \
    }
FORMAT_ORDERS(TRAVERSE)
#undef TRAVERSE

int PLT_JOINED(FORMAT_NAME, traverse)(plt_traversal *t, plt_packet *p, uint32_t visits) {
    switch (FORMAT_ORDER(plt_order_for(t, p))) {
#define CHOOSE(ORDER, order)                                                                       \
    case PLT_ORDER_##ORDER:                                                                        \
        FORMAT_STACK(t, sizeof(order##_entry)); /* packets of a batch may differ */                \
        return traverse_##order(t, p, visits);
        FORMAT_ORDERS(CHOOSE)
#undef CHOOSE
    default:
        return PLT_OK;
    }
}

#endif

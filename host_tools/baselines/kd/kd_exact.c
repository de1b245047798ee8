/* kd_exact - see kd_exact.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/kd/kd_exact.h"

#include <string.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/kd/kd_sweep.h"

/* Of one cell, along each axis: one block. */
typedef struct events {
    kd_event *of[3];
    uint32_t count; /* along each */
} events;

typedef struct building {
    kd_tree *tree;
    const kd_scene *scene;
} building;

static int begin_events(events *e, uint64_t count) {
    kd_event *block = heap_get(3 * count * sizeof *block + 1);
    for (int a = 0; a < 3; a++) {
        e->of[a] = block + (block != NULL ? a * count : 0);
    }
    e->count = 0;
    return block != NULL ? 0 : -1;
}

static void free_events(events *e) {
    heap_drop(e->of[0]);
    e->of[0] = NULL;
}

static int first_events(events *e, const kd_cell *c) {
    if (begin_events(e, 2 * (uint64_t)c->count) != 0) {
        return -1;
    }
    e->count = 2 * c->count;
    for (int a = 0; a < 3; a++) {
        for (uint32_t i = 0; i < c->count; i++) {
            kd_event_put(&e->of[a][2 * (size_t)i], &c->reference[i], i, a);
        }
        kd_events_sort(e->of[a], e->count);
    }
    return 0;
}

static kd_cut choose(const kd_cell *c, const events *e) {
    kd_cut best = kd_cost_of_leaf(c);
    for (int a = 0; a < 3 && c->levels > 0; a++) {
        kd_sweep(c, a, e->of[a], &best);
    }
    return best;
}

/* ---- events of a part --------------------------------------------------------------- */

/* Of references that were cut. */
static size_t new_events(kd_event *to, const kd_cell *part, int which, int axis,
                         const kd_move *moves, uint32_t count) {
    size_t n = 0;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t at = moves[i].to[which];
        if (!moves[i].is_whole && at != KD_NOWHERE) {
            kd_event_put(&to[n], &part->reference[at], at, axis);
            n += 2;
        }
    }
    kd_events_sort(to, n);
    return n;
}

/* Of those that were not, with their new numbers; `to` has room for all. */
static size_t kept_events(kd_event *to, const events *e, int which, int axis,
                          const kd_move *moves) {
    size_t n = 0;
    for (uint32_t i = 0; i < e->count; i++) {
        const kd_event event = e->of[axis][i];
        const kd_move *m = &moves[event.what >> 1];
        if (m->is_whole && m->to[which] != KD_NOWHERE) {
            to[n++] = (kd_event){event.at, 2 * m->to[which] | (event.what & 1u)};
        }
    }
    return n;
}

/* `spare`: room for as many events as the part has. */
static void fill_axis(events *to, const events *e, const kd_cell *part, int which, int axis,
                      const kd_move *moves, kd_event *spare) {
    const size_t fresh = new_events(spare, part, which, axis, moves, e->count / 2);
    const size_t kept = kept_events(to->of[axis] + fresh, e, which, axis, moves);
    kd_event *out = to->of[axis];
    const kd_event *old = out + fresh, *old_end = old + kept, *young = spare, *end = spare + fresh;
    while (young < end) { /* out never passes `old` */
        *out++ = old < old_end && !kd_event_before(young, old) ? *old++ : *young++;
    }
}

static int part_events(events *to, const events *e, const kd_cell *part, int which,
                       const kd_move *moves) {
    const uint64_t count = 2 * (uint64_t)part->count;
    kd_event *spare = heap_get(count * sizeof *spare + 1);
    if (spare == NULL || begin_events(to, count) != 0) {
        heap_drop(spare);
        to->of[0] = NULL;
        return -1;
    }
    to->count = (uint32_t)count;
    for (int a = 0; a < 3; a++) {
        fill_axis(to, e, part, which, a, moves, spare);
    }
    heap_drop(spare);
    return 0;
}

/* ---- cells ------------------------------------------------------------------------ */

/* The cell's own events are not needed any more. */
static int split(const building *b, const kd_cell *c, const kd_cut *cut, events *e,
                 kd_cell parts[2], events part_event[2]) {
    kd_move *moves = heap_get((uint64_t)c->count * sizeof *moves + 1);
    int status = moves != NULL ? kd_cell_split(c, b->scene, cut, parts, moves) : -1;
    if (status == 0) {
        part_event[0].of[0] = part_event[1].of[0] = NULL;
        for (int i = 0; i < 2 && status == 0; i++) {
            status = part_events(&part_event[i], e, &parts[i], i, moves);
        }
        if (status != 0) {
            for (int i = 0; i < 2; i++) {
                kd_cell_free(&parts[i]);
                free_events(&part_event[i]);
            }
        }
    }
    heap_drop(moves);
    free_events(e);
    return status;
}

/* As deep as kd_cell.levels says. Takes the events. */
static int build_below(const building *b, uint32_t node, events *e) {
    kd_cell c = kd_tree_take(b->tree, node), parts[2];
    events part_event[2];
    const kd_cut cut = choose(&c, e);
    b->tree->work += c.count;
    if (!cut.is_cut) {
        const int status = kd_tree_set_leaf(b->tree, node, &c);
        free_events(e);
        kd_cell_free(&c);
        return status;
    }
    int status = split(b, &c, &cut, e, parts, part_event);
    kd_cell_free(&c);
    if (status != 0) {
        return -1;
    }
    status = kd_tree_set_inner(b->tree, node, &cut, parts);
    for (uint32_t i = 0; i < 2; i++) {
        const uint32_t child = (b->tree->node[node].link >> 2) + i;
        if (status == 0 && b->tree->node[child].link == KD_UNSPLIT) {
            status = build_below(b, child, &part_event[i]);
        } else {
            free_events(&part_event[i]);
        }
    }
    return status;
}

int kd_build_exactly(kd_tree *t, const kd_scene *s, const kd_cell *root) {
    const building b = {t, s};
    events e = {{NULL, NULL, NULL}, 0};
    const int is_sorted = first_events(&e, root) == 0;
    if (kd_tree_begin(t, root) != 0 || !is_sorted) {
        free_events(&e);
        return -1;
    }
    if (t->node[0].link != KD_UNSPLIT) {
        free_events(&e);
        return 0;
    }
    return build_below(&b, 0, &e);
}

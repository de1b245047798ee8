/* kd_cell - see kd_cell.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/kd/kd_cell.h"

#include <string.h>

#include "host_tools/base/heap.h"

/* Levels: 8 + 1.3 log2(triangles), as is usual (Pharr, Humphreys, 2004), by its integer part. */
static uint32_t levels_of(uint32_t triangles) {
    uint32_t log = 0;
    while (triangles >> (log + 1) != 0) {
        log++;
    }
    return 8 + (13 * log + 5) / 10;
}

int kd_cell_begin(kd_cell *c, const kd_scene *s) {
    const uint32_t count = s->triangles->count;
    plt_box box = plt_box_empty();
    *c = (kd_cell){.count = count, .levels = levels_of(count)};
    c->reference = heap_get((uint64_t)count * sizeof *c->reference + 1);
    if (c->reference == NULL) {
        return -1;
    }
    for (uint32_t i = 0; i < count; i++) {
        c->reference[i] = kd_whole(s, i);
        plt_box_add_point(&box, c->reference[i].lo);
        plt_box_add_point(&box, c->reference[i].hi);
    }
    memcpy(c->lo, box.lo, sizeof c->lo);
    memcpy(c->hi, box.hi, sizeof c->hi);
    return 0;
}

void kd_cell_free(kd_cell *c) {
    heap_drop(c->reference);
    heap_drop(c->stray);
    c->reference = NULL;
    c->stray = NULL;
}

uint64_t kd_cell_bytes(const kd_cell *c) {
    return (uint64_t)c->count * sizeof *c->reference + (uint64_t)c->strays * sizeof *c->stray;
}

/* Room for as many as there may be; given back later. */
static int begin_child(kd_cell *to, const kd_cell *c, const kd_scene *s, const kd_cut *cut,
                       int upper) {
    *to = *c;
    to->count = to->strays = 0;
    to->levels = c->levels - 1;
    (upper ? to->lo : to->hi)[cut->axis] = cut->at;
    to->reference = heap_get((uint64_t)c->count * sizeof *to->reference + 1);
    to->stray = s->plane == NULL
                    ? NULL
                    : heap_get(((uint64_t)c->count + c->strays) * sizeof *to->stray + 1);
    return to->reference != NULL && (s->plane == NULL || to->stray != NULL) ? 0 : -1;
}

static void add_stray(kd_cell *to, const kd_scene *s, uint32_t triangle) {
    if (s->plane != NULL && kd_is_stray(s, triangle, to->lo, to->hi)) {
        to->stray[to->strays++] = triangle;
    }
}

/* A reference that reaches into a child; its index there. */
static uint32_t add_part(kd_cell *to, const kd_scene *s, const kd_reference *r) {
    to->reference[to->count] = *r;
    if (!kd_clip(s, &to->reference[to->count], to->lo, to->hi)) {
        add_stray(to, s, r->triangle);
        return KD_NOWHERE;
    }
    return to->count++;
}

static kd_move move_reference(kd_cell to[2], const kd_scene *s, const kd_cut *cut,
                              const kd_reference *r) {
    const int is_low = r->lo[cut->axis]<cut->at, is_high = r->hi[cut->axis]> cut->at;
    kd_move m = {{KD_NOWHERE, KD_NOWHERE}, is_low != is_high};
    if (m.is_whole) {
        to[is_high].reference[to[is_high].count] = *r;
        m.to[is_high] = to[is_high].count++;
        add_stray(&to[!is_high], s, r->triangle);
        return m;
    }
    for (int i = 0; i < 2; i++) {
        m.to[i] = add_part(&to[i], s, r);
    }
    return m;
}

/* Gives back what was not needed; a smaller block cannot fail to be there. */
static void end_child(kd_cell *to) {
    void *block = heap_resize(to->reference, (uint64_t)to->count * sizeof *to->reference + 1);
    to->reference = block != NULL ? block : to->reference;
    if (to->stray != NULL && to->strays == 0) {
        heap_drop(to->stray);
        to->stray = NULL;
    } else if (to->stray != NULL) {
        block = heap_resize(to->stray, (uint64_t)to->strays * sizeof *to->stray);
        to->stray = block != NULL ? block : to->stray;
    }
}

int kd_cell_split(const kd_cell *c, const kd_scene *s, const kd_cut *cut, kd_cell to[2],
                  kd_move *moves) {
    const int is_short = begin_child(&to[0], c, s, cut, 0) != 0;
    if (begin_child(&to[1], c, s, cut, 1) != 0 || is_short) {
        kd_cell_free(&to[0]);
        kd_cell_free(&to[1]);
        return -1;
    }
    for (uint32_t i = 0; i < c->count; i++) {
        const kd_move m = move_reference(to, s, cut, &c->reference[i]);
        if (moves != NULL) {
            moves[i] = m;
        }
    }
    for (uint32_t i = 0; i < c->strays; i++) {
        add_stray(&to[0], s, c->stray[i]);
        add_stray(&to[1], s, c->stray[i]);
    }
    end_child(&to[0]);
    end_child(&to[1]);
    return 0;
}

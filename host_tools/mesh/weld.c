/* weld - finds the vertex that has the same bits
 *
 * Open addressing with linear probing, at most half full.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/weld.h"

#include <stdlib.h>
#include <string.h>

enum { FIRST_SLOTS = 1024 };

/* Multiplies and folds: the upper bits of a product depend on all bits of both factors. */
static size_t hash(const float position[3]) {
    uint32_t bits[3];
    memcpy(bits, position, sizeof bits);
    uint64_t h = 0x9e3779b97f4a7c15u;
    for (int i = 0; i < 3; i++) {
        h = (h ^ bits[i]) * 0xd6e8feb86659fd93u;
        h ^= h >> 32;
    }
    return (size_t)h;
}

static uint32_t *probe(const mesh *m, uint32_t *slot, size_t slots, const float position[3]) {
    size_t at = hash(position) & (slots - 1);
    while (slot[at] && memcmp(m->vertex + 3 * (size_t)(slot[at] - 1), position, 12) != 0) {
        at = (at + 1) & (slots - 1);
    }
    return &slot[at];
}

static int grow(weld *w) {
    const size_t slots = w->slots ? w->slots * 2 : FIRST_SLOTS;
    uint32_t *slot = slots > w->slots ? calloc(slots, sizeof *slot) : NULL;
    if (!slot) {
        return -1;
    }
    for (size_t i = 0; i < w->slots; i++) {
        if (w->slot[i]) {
            *probe(w->m, slot, slots, w->m->vertex + 3 * (size_t)(w->slot[i] - 1)) = w->slot[i];
        }
    }
    free(w->slot);
    w->slot = slot;
    w->slots = slots;
    return 0;
}

uint32_t *weld_find(weld *w, const float position[3]) {
    if (w->used >= w->slots / 2 && grow(w) != 0) {
        return NULL;
    }
    return probe(w->m, w->slot, w->slots, position);
}

void weld_free(weld *w) {
    free(w->slot);
    *w = (weld){0};
}

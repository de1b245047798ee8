/* vertex_table - finds the vertex that has the same bits
 *
 * Open addressing with linear probing, at most half full.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/vertex_table.h"
#include "host_tools/base/heap.h"

#include <string.h>

enum { FIRST_SLOTS = 1024 };

typedef struct key {
    uint64_t bits[3];
} key;

static key key_of(const double position[3]) {
    key k;
    memcpy(k.bits, position, sizeof k.bits);
    return k;
}

static key key_of_vertex(const mesh *m, size_t vertex) {
    return key_of((const double[3]){mesh_wide(m, vertex, 0), mesh_wide(m, vertex, 1),
                                    mesh_wide(m, vertex, 2)});
}

/* Multiplies and folds: the upper bits of a product depend on all bits of both factors. */
static size_t hash(const key *k) {
    uint64_t h = 0x9e3779b97f4a7c15u;
    for (int i = 0; i < 3; i++) {
        h = (h ^ k->bits[i]) * 0xd6e8feb86659fd93u;
        h ^= h >> 32;
    }
    return (size_t)h;
}

static int is_key_of(const key *k, const mesh *m, size_t vertex) {
    const key other = key_of_vertex(m, vertex);
    return memcmp(k, &other, sizeof other) == 0;
}

static uint32_t *probe(const mesh *m, uint32_t *slot, size_t slots, const key *k) {
    size_t at = hash(k) & (slots - 1);
    while (slot[at] && !is_key_of(k, m, (size_t)slot[at] - 1)) {
        at = (at + 1) & (slots - 1);
    }
    return &slot[at];
}

static int grow(vertex_table *t) {
    const size_t slots = t->slots ? t->slots * 2 : FIRST_SLOTS;
    uint32_t *slot = slots > t->slots ? heap_get_zeroed((uint64_t)slots * sizeof *slot) : NULL;
    if (!slot) {
        return -1;
    }
    for (size_t i = 0; i < t->slots; i++) {
        if (t->slot[i]) {
            const key k = key_of_vertex(t->m, (size_t)t->slot[i] - 1);
            *probe(t->m, slot, slots, &k) = t->slot[i];
        }
    }
    heap_drop(t->slot);
    t->slot = slot;
    t->slots = slots;
    return 0;
}

uint32_t *vertex_table_find(vertex_table *t, const real position[3]) {
    if (t->used >= t->slots / 2 && grow(t) != 0) {
        return NULL;
    }
    const key k = key_of((const double[3]){position[0].wide, position[1].wide, position[2].wide});
    return probe(t->m, t->slot, t->slots, &k);
}

void vertex_table_free(vertex_table *t) {
    heap_drop(t->slot);
    *t = (vertex_table){0};
}

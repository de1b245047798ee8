/* position_table - see position_table.h
 *
 * Open addressing with linear probing, at most two thirds full.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/position_table.h"

#include <string.h>

#include "host_tools/base/heap.h"

typedef struct key {
    uint32_t word[3];
} key;

static uint64_t slots_for(uint64_t most) {
    return most + most / 2 + 16;
}

uint64_t position_table_bytes(uint64_t most) {
    return heap_cost(slots_for(most) * sizeof(uint32_t));
}

int position_table_begin(position_table *t, const void *positions, size_t most) {
    *t = (position_table){.positions = positions, .slots = slots_for(most)};
    t->slot = heap_get_zeroed((uint64_t)t->slots * sizeof *t->slot);
    return t->slot == NULL ? -1 : 0;
}

void position_table_free(position_table *t) {
    heap_drop(t->slot);
    *t = (position_table){0};
}

static key key_of(const position_table *t, uint32_t number) {
    key k;
    memcpy(&k, (const unsigned char *)t->positions + sizeof k * (size_t)number, sizeof k);
    for (int a = 0; a < 3; a++) {
        k.word[a] = k.word[a] == 0x80000000u ? 0 : k.word[a]; /* -0 is 0 */
    }
    return k;
}

/* The upper half of the hash, as a fraction of the slots. */
static size_t slot_of(const position_table *t, const key *k) {
    uint64_t h = 0x9e3779b97f4a7c15u;
    for (int a = 0; a < 3; a++) {
        h = (h ^ k->word[a]) * 0xd6e8feb86659fd93u;
        h ^= h >> 32;
    }
    return (size_t)(((h * 0xd6e8feb86659fd93u) >> 32) * t->slots >> 32);
}

uint32_t position_table_first(position_table *t, uint32_t number) {
    const key k = key_of(t, number);
    size_t at = slot_of(t, &k);
    while (t->slot[at] != 0) {
        const uint32_t there = t->slot[at] - 1;
        const key other = key_of(t, there);
        if (memcmp(&k, &other, sizeof k) == 0) {
            return there;
        }
        at = at + 1 < t->slots ? at + 1 : 0;
    }
    t->slot[at] = number + 1;
    return number;
}

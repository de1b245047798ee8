/* unit - see unit.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/unit.h"

/* Bits of the counts: (count - 1) & 1 for K = 2, two strings of a bit a unit for
 * K = 4, none for K = 1. */
static uint32_t count_strings(uint32_t k) {
    return k == 4 ? 2 : k == 2;
}

static uint32_t triangles_before(const plt_geometry *g, uint32_t units, uint32_t unit,
                                 uint32_t pairs) {
    uint32_t count = unit + g->k * pairs;
    for (uint32_t s = 0; s < count_strings(g->k); s++) {
        const uint32_t at = g->counts + s * units;
        count += plt_bits_count(g->bytes, at, at + unit) << s;
    }
    return count;
}

void plt_geometry_open_counts(plt_geometry *g, const plt_block *b, uint32_t k) {
    const uint32_t word0 = plt_get_u32(b->geometry), word1 = plt_get_u32(b->geometry + 4);
    g->bytes = b->geometry;
    g->k = k;
    g->first_triangle = word0 & 0x07FFFFFFu;
    g->vertices = word0 >> 27 | (word1 & 0x3Fu) << 5;
    g->mesh = word1 >> 6 & 0x3FFu;
    g->counts = 8 * PLT_GEOMETRY_HEADER_BYTES;
    g->starts = g->counts + count_strings(k) * b->units; /* triangles_before reads behind it */
    const uint32_t bits = 8 * b->geometry_bytes;
    g->triangles = b->units + k * b->pairs;
    for (uint32_t s = 0; s < count_strings(k) && g->starts <= bits; s++) {
        const uint32_t at = g->counts + s * b->units;
        g->triangles += plt_bits_count(g->bytes, at, at + b->units) << s;
    }
}

void plt_geometry_open(plt_geometry *g, const plt_block *b, const plt_lattice_box *frame,
                       uint32_t k) {
    const uint32_t bits = 8 * b->geometry_bytes;
    plt_geometry_open_counts(g, b, k);
    g->turns = g->starts + g->triangles;
    g->news = g->turns + g->triangles;
    g->slots = g->triangles;
    if (g->turns <= bits) { /* else the block is not sound, and nothing more is read */
        g->slots += 2 * plt_bits_count(g->bytes, g->starts, g->turns);
    }
    g->refs = g->news + g->slots;
    g->ref_bits = g->vertices > 1 ? plt_bits_for(g->vertices - 1) : 0;
    g->positions = g->refs + (g->slots - g->vertices) * g->ref_bits;
    g->vertex_bits = 0;
    for (int a = 0; a < 3; a++) {
        g->base[a] = frame->lo[a];
        g->axis_bits[a] = plt_bits_for(frame->hi[a] - frame->lo[a]);
        g->vertex_bits += g->axis_bits[a];
    }
}

static uint32_t units_of(const plt_geometry *g) {
    return count_strings(g->k) == 0 ? 0 : (g->starts - g->counts) / count_strings(g->k);
}

uint32_t plt_unit_first(const plt_geometry *g, uint32_t unit, uint32_t pairs) {
    return triangles_before(g, units_of(g), unit, pairs);
}

uint32_t plt_unit_count(const plt_geometry *g, uint32_t unit, int pair) {
    uint32_t count = 1 + (pair ? g->k : 0);
    for (uint32_t s = 0; s < count_strings(g->k); s++) {
        count += plt_bits_get(g->bytes, g->counts + s * units_of(g) + unit, 1) << s;
    }
    return count;
}

void plt_unit_vertex(const plt_geometry *g, uint32_t vertex, uint32_t position[3]) {
    uint32_t at = g->positions + vertex * g->vertex_bits;
    if (g->vertex_bits <= 57) { /* one load for all three axes */
        uint64_t word = plt_bits_long(g->bytes, at);
        for (int a = 0; a < 3; a++) {
            position[a] = g->base[a] + ((uint32_t)word & plt_low_bits(g->axis_bits[a]));
            word >>= g->axis_bits[a];
        }
        return;
    }
    for (int a = 0; a < 3; a++) {
        position[a] = g->base[a] + plt_bits_get(g->bytes, at, g->axis_bits[a]);
        at += g->axis_bits[a];
    }
}

/* The vertex of reference slot `slot`; `rank` counts new vertices so far. */
static uint32_t reference(const plt_geometry *g, uint32_t slot, uint32_t *rank) {
    /* No branch: which it is cannot be predicted, and the bits may be looked at
     * either way. */
    const uint32_t is_new = plt_bits_get(g->bytes, g->news + slot, 1);
    const uint32_t old =
        plt_bits_get(g->bytes, g->refs + (slot - *rank) * g->ref_bits, g->ref_bits);
    const uint32_t vertex = ((0u - is_new) & *rank) | ((is_new - 1u) & old);
    *rank += is_new;
    return vertex;
}

void plt_unit_corners(const plt_geometry *g, uint32_t first, uint32_t count,
                      uint32_t corner[][3][3]) {
    uint32_t slot = first + 2 * plt_bits_count(g->bytes, g->starts, g->starts + first);
    uint32_t rank = plt_bits_count(g->bytes, g->news, g->news + slot);
    for (uint32_t i = 0; i < count; i++) {
        uint32_t(*now)[3] = corner[i];
        if (i == 0 || plt_bits_get(g->bytes, g->starts + first + i, 1)) {
            for (int c = 0; c < 3; c++) {
                plt_unit_vertex(g, reference(g, slot++, &rank), now[c]);
            }
            continue;
        }
        /* Turn 0 shares b c of the one before: c b x; turn 1 shares a c: a c x. */
        uint32_t(*before)[3] = corner[i - 1];
        const int turn = (int)plt_bits_get(g->bytes, g->turns + first + i, 1);
        const uint32_t *first_of = before[2 - 2 * turn], *second_of = before[1 + turn];
        for (int a = 0; a < 3; a++) {
            now[0][a] = first_of[a];
            now[1][a] = second_of[a];
        }
        plt_unit_vertex(g, reference(g, slot++, &rank), now[2]);
    }
}

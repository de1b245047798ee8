/* leaf - see leaf.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/tree/compact/leaf.h"

#include <string.h>

#include "engine/lanes/lanes.h"
#include "engine/planelet_config.h"

void plt_geometry_open_counts(plt_geometry *g, const plt_block *b, uint32_t k) {
    const uint32_t word0 = plt_get_u32(b->geometry), word1 = plt_get_u32(b->geometry + 4);
    g->bytes = b->geometry;
    g->k = k;
    g->leaves = b->leaves;
    g->first_triangle = word0 & 0x07FFFFFFu;
    g->vertices = word0 >> 27 | (word1 & 0x3Fu) << 5;
    g->mesh = word1 >> 6 & 0x3FFu;
    g->counts = 8 * PLT_GEOMETRY_HEADER_BYTES;
    g->starts = g->counts + plt_geometry_count_strings(k) * b->leaves;
    const uint32_t bits = 8 * b->geometry_bytes;
    g->triangles = b->leaves + k * b->pairs;
    for (uint32_t s = 0; s < plt_geometry_count_strings(k) && g->starts <= bits; s++) {
        const uint32_t at = g->counts + s * b->leaves;
        g->triangles += plt_bits_count(g->bytes, at, at + b->leaves) << s;
    }
}

/* What follows from the counts of slots and of new vertices. */
static void set_strings(plt_geometry *g, const plt_lattice_box *bounds) {
    g->refs = g->news + g->slots;
    g->ref_bits = plt_geometry_ref_bits(g->vertices);
    g->positions = g->refs + (g->slots - g->vertices) * g->ref_bits;
    g->vertex_bits = g->base[3] = g->axis_mask[3] = 0;
    for (int a = 0; a < 3; a++) {
        g->base[a] = bounds->lo[a];
        g->axis_bits[a] = plt_bits_for(bounds->hi[a] - bounds->lo[a]);
        g->axis_mask[a] = plt_low_bits(g->axis_bits[a]);
        g->vertex_bits += g->axis_bits[a];
    }
}

void plt_geometry_open(plt_geometry *g, const plt_block *b, const plt_lattice_box *bounds,
                       uint32_t k) {
    const uint32_t bits = 8 * b->geometry_bytes;
    plt_geometry_open_counts(g, b, k);
    g->swaps = g->starts + g->triangles;
    g->news = g->swaps + g->triangles;
    g->slots = g->triangles;
    /* Else the block is not valid, and nothing more is read. */
    const int fits = g->swaps <= bits && g->triangles <= PLT_BLOCK_TRIANGLES_MOST;
    if (fits) {
        g->slots += 2 * plt_ranks_open(g->bytes, g->starts, g->swaps, g->starts_before);
    }
    set_strings(g, bounds);
    g->news_ones = 0;
    if (fits && g->refs <= bits) {
        g->news_ones = plt_ranks_open(g->bytes, g->news, g->refs, g->news_before);
    }
}

#if PLT_WITH_WAVE_COMPACT
void plt_geometry_open_leaf(plt_geometry *g, const plt_block *b, const plt_lattice_box *bounds,
                            uint32_t k, const plt_leaf_rank *rank, plt_leaf_place *at) {
    plt_geometry_open_counts(g, b, k);
    at->first = plt_leaf_find(g, rank->leaf, rank->pairs, rank->pair, &at->count);
    g->swaps = g->starts + g->triangles;
    g->news = g->swaps + g->triangles;
    const uint32_t begin = g->starts + at->first;
    const uint32_t before = plt_bits_count(g->bytes, g->starts, begin);
    g->slots = g->triangles + 2 * (before + plt_bits_count(g->bytes, begin, g->swaps));
    set_strings(g, bounds);
    at->slot = at->first + 2 * before;
    at->news = plt_bits_count(g->bytes, g->news, g->news + at->slot);
}
#endif

uint32_t plt_leaf_find(const plt_geometry *g, uint32_t leaf, uint32_t pairs, int pair,
                       uint32_t *count) {
    uint32_t first = leaf + g->k * pairs;
    *count = 1 + (pair ? g->k : 0);
    for (uint32_t s = 0; s < plt_geometry_count_strings(g->k); s++) {
        const uint32_t at = g->counts + s * g->leaves;
        first += plt_bits_count(g->bytes, at, at + leaf) << s;
        *count += plt_bits_short(g->bytes, at + leaf, 1) << s;
    }
    return first;
}

/* Positions of `count` vertices. */
#if UINTPTR_MAX > 0xFFFFFFFFu
static void wide_vertex(const plt_geometry *g, uint32_t at, uint32_t position[3]) {
    for (int a = 0; a < 3; a++) {
        position[a] = g->base[a] + plt_bits_get(g->bytes, at, g->axis_bits[a]);
        at += g->axis_bits[a];
    }
}

/* One load each for all three axes if they fit. */
static void read_vertices(const plt_geometry *g, const uint32_t index[], uint32_t count,
                          plt_vertex *restrict vertex) {
    const u4 mask = u4_load(g->axis_mask), base = u4_load(g->base);
    /* At most 42 in a valid block; another's are not used. */
    const uint32_t y_at = g->axis_bits[0] & 63u, z_at = (y_at + g->axis_bits[1]) & 63u;
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t at = g->positions + index[i] * g->vertex_bits;
        const uint64_t word = plt_bits_long(g->bytes, at);
        const u4 fields =
            u4_three((uint32_t)word, (uint32_t)(word >> y_at), (uint32_t)(word >> z_at));
        u4_store(vertex[i].number, u4_add(base, u4_and(fields, mask)));
        if (g->vertex_bits > PLT_BITS_LONG) {
            wide_vertex(g, at, vertex[i].number);
        }
    }
}

#else
/* A coordinate has at most 21 bits, so a word from the byte that it begins in has all of them:
 * fewer instructions than shifts by 64. */
static inline uint32_t coordinate(const plt_geometry *g, int axis, uint32_t at) {
    return g->base[axis] + (plt_get_u32(g->bytes + (at >> 3)) >> (at & 7) & g->axis_mask[axis]);
}

static void read_vertices(const plt_geometry *g, const uint32_t index[], uint32_t count,
                          plt_vertex *restrict vertex) {
    const uint32_t y_at = g->axis_bits[0], z_at = y_at + g->axis_bits[1];
    for (uint32_t i = 0; i < count; i++) {
        const uint32_t at = g->positions + index[i] * g->vertex_bits;
        vertex[i].number[0] = coordinate(g, 0, at);
        vertex[i].number[1] = coordinate(g, 1, at + y_at);
        vertex[i].number[2] = coordinate(g, 2, at + z_at);
        vertex[i].number[3] = 0;
    }
}
#endif

void plt_leaf_vertex(const plt_geometry *g, uint32_t vertex, uint32_t position[3]) {
    plt_vertex v;
    read_vertices(g, &vertex, 1, &v);
    memcpy(position, v.number, sizeof(uint32_t[3]));
}

/* Indices of the vertices of `slots` slots from `slot` on, with `rank` new vertices before. A new
 * vertex has the running rank. Which slots are new cannot be predicted, so there is no branch; the
 * bits of a reference are read either way. */
static void read_slots(const plt_geometry *g, uint32_t slot, uint32_t rank, uint32_t slots,
                       uint32_t index[]) {
    uint32_t news = plt_bits_short(g->bytes, g->news + slot, slots);
    uint32_t ref_at = g->refs + (slot - rank) * g->ref_bits;
    for (uint32_t i = 0; i < slots; i++, news >>= 1) {
        const uint32_t is_old = (news & 1u) - 1u; /* all ones, or 0 */
        const uint32_t old = plt_bits_short(g->bytes, ref_at, g->ref_bits);
        index[i] = rank ^ ((rank ^ old) & is_old);
        rank += 1 + is_old;
        ref_at += g->ref_bits & is_old;
    }
}

/* Which vertices make each triangle, from the start bits and the swap bits: 0 shares b c
 * of the triangle before, as c b x, 1 shares a c, as a c x. */
static void run_strips(plt_leaf *leaf, uint32_t count, uint32_t starts, uint32_t swaps) {
    uint32_t a = 0, b = 0, c = 0, next = 0;
    for (uint32_t i = 0; i < count; i++, starts >>= 1, swaps >>= 1) {
        const uint32_t is_start = 0u - (starts & 1u), is_swap = 0u - (swaps & 1u);
        const uint32_t old = c ^ ((c ^ a) & is_swap), shared = b ^ ((b ^ c) & is_swap);
        a = old ^ ((old ^ next) & is_start);
        b = shared ^ ((shared ^ (next + 1)) & is_start);
        next += 2 & is_start;
        c = next++;
        leaf->corner[i] = a | b << 8 | c << 16;
    }
}

void plt_leaf_read_at(const plt_geometry *g, const plt_leaf_place *at, plt_leaf *leaf) {
    const uint32_t starts = plt_bits_short(g->bytes, g->starts + at->first, at->count) | 1u;
    const uint32_t swaps = plt_bits_short(g->bytes, g->swaps + at->first, at->count);
    uint32_t index[PLT_LEAF_VERTICES_MOST];
    leaf->vertices = at->count + 2 * plt_count_bits(starts);
    read_slots(g, at->slot, at->news, leaf->vertices, index);
    read_vertices(g, index, leaf->vertices, leaf->vertex);
    run_strips(leaf, at->count, starts, swaps);
}

void plt_leaf_read(const plt_geometry *g, uint32_t first, uint32_t count, plt_leaf *leaf) {
    plt_leaf_place at = {.first = first, .count = count};
    at.slot = first + 2 * plt_ranks_find(g->bytes, g->starts, g->starts_before, first);
    at.news = plt_ranks_find(g->bytes, g->news, g->news_before, at.slot);
    plt_leaf_read_at(g, &at, leaf);
}

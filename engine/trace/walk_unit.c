/* walk_unit - see walk_unit.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/walk_unit.h"

#include <string.h>

#include "engine/trace/frustum.h"
#include "engine/trace/triangle.h"

enum { RIM_FROM = 4 }; /* triangles a list */

/* Vertices from lattice numbers to floats; `key` gets what orders them (record.h):
 * x, y, z. */
static void place(plt_leaf *u, const plt_block_walker *b, uint64_t key[]) {
    for (uint32_t i = 0; i < u->vertices; i++) {
        plt_vertex *v = &u->vertex[i];
        key[i] = (uint64_t)v->number[0] << 42 | (uint64_t)v->number[1] << 21 | v->number[2];
        f4_store(v->scene, plt_block_planes(b, f4_of_u4(u4_load(v->number))));
    }
}

/* Corners in canonical order (record.h): the least first. Which is least cannot be
 * predicted, so there is no branch. */
static void canonical(const plt_leaf *u, const uint64_t key[], uint32_t triangle, float to[3][3]) {
    /* by b < a, c < a and c < b: bits to turn the three places by */
    static const uint8_t turn[8] = {0, 8, 16, 8, 0, 16, 16, 16};
    const uint32_t corner = u->corner[triangle];
    const uint64_t a = key[corner & 0xFFu], b = key[corner >> 8 & 0xFFu], c = key[corner >> 16];
    const unsigned order = (unsigned)(b < a) | (unsigned)(c < a) << 1 | (unsigned)(c < b) << 2;
    const uint64_t turned = ((uint64_t)corner << 24 | corner) >> turn[order];
    PLT_UNROLLED for (unsigned i = 0; i < 3; i++) {
        memcpy(to[i], u->vertex[turned >> 8 * i & 0xFFu].scene, sizeof to[i]);
    }
}

/* Floats of corners were rounded: hence the step more. */
static float longest_side(const plt_lattice *l, const plt_block_entry *e) {
    float longest = 0.0f;
    for (int a = 0; a < 3; a++) {
        const float side = e->hi[a] - e->lo[a];
        longest = side > longest ? side : longest;
    }
    return l->step * (longest + 1.0f);
}

/* Of each vertex which edges of the rim it lies outside of. Strips of two lists share
 * enough of them for this to pay; those of shorter ones do not. */
static void rim_codes(const plt_leaf *u, const plt_packet *p, plt_mask groups, uint8_t code[]) {
    plt_frustum rim;
    if (!plt_frustum_set(&rim, p, groups)) {
        memset(code, 0, u->vertices);
        return;
    }
    for (uint32_t i = 0; i < u->vertices; i++) {
        code[i] = (uint8_t)plt_frustum_outcode(&rim, u->vertex[i].scene);
    }
}

static int is_beside(const plt_leaf *u, const uint8_t code[], uint32_t triangle) {
    return plt_frustum_culls(code[plt_leaf_corner(u, triangle, 0)],
                             code[plt_leaf_corner(u, triangle, 1)],
                             code[plt_leaf_corner(u, triangle, 2)]);
}

/* Triangle i of the `count` is number first + i of the block. */
static void test_lattice(plt_walker *w, const plt_geometry *g, plt_triangle *t, uint32_t first,
                         uint32_t count, plt_mask groups) {
    plt_leaf u;
    uint64_t key[PLT_LEAF_VERTICES_MOST];
    uint8_t code[PLT_LEAF_VERTICES_MOST];
    const int has_rim = g->k >= RIM_FROM;
    plt_leaf_read(g, first, count, &u);
    place(&u, &w->blocks, key);
    if (has_rim) {
        rim_codes(&u, &w->packet, groups, code);
    }
    for (uint32_t i = 0; i < count; i++) {
        if (has_rim && is_beside(&u, code, i)) {
            continue;
        }
        t->number = g->first_triangle + first + i;
        canonical(&u, key, i, t->corner);
        plt_triangle_groups(&w->packet, t, w->packet.any ? groups & w->packet.active : groups);
    }
}

static void test_records(plt_walker *w, const plt_record *record, plt_triangle *t, uint32_t count,
                         plt_mask groups) {
    for (uint32_t i = 0; i < count; i++) {
        plt_record_corners(&record[i], t->corner);
        t->number = plt_get_u32(&record[i].word[9]);
        plt_triangle_groups(&w->packet, t, w->packet.any ? groups & w->packet.active : groups);
    }
}

void plt_walk_leaf_strips(plt_walker *w, const plt_opened_block *o, const plt_block_entry *at) {
    const plt_block_tree *tree = &w->blocks.tree;
    const plt_geometry *g = &o->geometry;
    const uint32_t what = at->child.what, unit = what >> 8 & 0xFFu, pairs = what >> 16 & 0xFFu;
    uint32_t count;
    const uint32_t first = plt_leaf_find(g, unit, pairs, (int)(what >> 24), &count);
    plt_triangle t;
    t.longest = longest_side(&tree->lattice, at);
    t.numbers = tree->ids.bytes == NULL ? NULL : &tree->ids;
    w->stats.triangle_tests += (uint64_t)count * plt_mask_count(at->groups);
    if (tree->records == NULL) {
        test_lattice(w, g, &t, first, count, at->groups);
    } else {
        test_records(w, &tree->records[g->first_triangle + first], &t, count, at->groups);
    }
}

/* leaf_compact - see leaf_compact.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/trace/leaf_compact.h"

#include <string.h>

#include "engine/trace/frustum.h"
#include "engine/trace/leaf_records.h"
#include "engine/trace/triangle.h"

/* Strips of this many triangles per list share enough vertices for frustum culling to
 * pay; those of shorter lists do not. */
enum { CULLING_FROM = 4 };

#if PLT_WITH_WAVE || !PLT_WITH_HULLS
/* Corners in canonical order. */
static void set_corners(const plt_leaf *leaf, const uint64_t key[], uint32_t triangle,
                        float to[3][3]) {
    const uint64_t ordered = plt_leaf_ordered(leaf, key, triangle);
    PLT_UNROLLED for (unsigned i = 0; i < 3; i++) {
        memcpy(to[i], leaf->vertex[ordered >> 8 * i & 0xFFu].scene, sizeof to[i]);
    }
}
#endif

/* Outcodes of all vertices; 0 where the packet has no frustum, so that nothing is
 * culled. */
static void set_outcodes(const plt_leaf *leaf, const plt_packet *p, plt_mask groups,
                         uint8_t code[]) {
    plt_frustum frustum;
    if (!plt_frustum_set(&frustum, p, groups)) {
        memset(code, 0, leaf->vertices);
        return;
    }
    for (uint32_t i = 0; i < leaf->vertices; i++) {
        code[i] = (uint8_t)plt_frustum_outcode(&frustum, leaf->vertex[i].scene);
    }
}

static int is_culled(const plt_leaf *leaf, const uint8_t code[], uint32_t triangle) {
    return plt_frustum_culls(code[plt_leaf_corner(leaf, triangle, 0)],
                             code[plt_leaf_corner(leaf, triangle, 1)],
                             code[plt_leaf_corner(leaf, triangle, 2)]);
}

#if PLT_WITH_WAVE
static void set_strip_triangle(const plt_block_tree *tree, const plt_geometry *g,
                               const plt_leaf_run *run, uint32_t index, plt_triangle *to) {
    plt_leaf leaf;
    uint64_t key[PLT_LEAF_VERTICES_MOST];
    plt_leaf_read(g, run->first, run->count, &leaf);
    plt_leaf_positions(&leaf, &tree->lattice, key);
    set_corners(&leaf, key, index, to->corner);
    to->word = g->first_triangle + run->first + index;
    to->ids = tree->ids.bytes == NULL ? NULL : &tree->ids;
}

void plt_leaf_triangle(const plt_block_tree *tree, const plt_geometry *g, const plt_leaf_run *run,
                       uint32_t index, plt_triangle *to) {
    if (tree->leaf_kind == PLT_LEAF_STRIPS) {
        set_strip_triangle(tree, g, run, index, to);
        return;
    }
    const plt_record *record = &tree->records[g->first_triangle + run->first + index];
    plt_record_corners(record, to->corner);
    to->word = plt_get_u32(&record->word[9]);
    to->ids = NULL;
}
#endif

/* Tests those of a leaf's triangles that are not culled: all at a time where groups are listed. */
#if PLT_WITH_HULLS
_Static_assert((int)PLT_TRIANGLES_MOST >= (int)PLT_LEAF_TRIANGLES_MOST, "all of a leaf at a time");

static void test_triangles(const plt_leaf *leaf, const uint64_t key[], const uint8_t code[],
                           const plt_triangle *common, uint32_t count, plt_packet *p,
                           plt_mask groups) {
    plt_triangle_rows rows[PLT_TRIANGLES_MOST];
    unsigned kept = 0;
    for (uint32_t i = 0; i < count; i++) {
        if (code != NULL && is_culled(leaf, code, i)) {
            continue;
        }
        const uint64_t ordered = plt_leaf_ordered(leaf, key, i);
        PLT_UNROLLED for (unsigned c = 0; c < 3; c++) {
            rows[kept].corner[c] = f4_load(leaf->vertex[ordered >> 8 * c & 0xFFu].scene);
        }
        rows[kept++].word = common->word + i;
    }
    plt_triangles_groups(p, rows, kept, common->ids, common->longest, groups);
}
#else
static void test_triangles(const plt_leaf *leaf, const uint64_t key[], const uint8_t code[],
                           const plt_triangle *common, uint32_t count, plt_packet *p,
                           plt_mask groups) {
    plt_triangle t = *common;
    for (uint32_t i = 0; i < count; i++) {
        if (code != NULL && is_culled(leaf, code, i)) {
            continue;
        }
        t.word = common->word + i;
        set_corners(leaf, key, i, t.corner);
        plt_triangle_groups(p, &t, p->any ? groups & p->active : groups);
    }
}
#endif

static void test_strips(const plt_block_tree *tree, const plt_geometry *g, const plt_leaf_run *run,
                        plt_packet *p, plt_mask groups) {
    plt_leaf leaf;
    uint64_t key[PLT_LEAF_VERTICES_MOST];
    uint8_t code[PLT_LEAF_VERTICES_MOST];
    const int culling = g->k >= CULLING_FROM;
    plt_triangle common; /* but for its corners */
    common.longest = run->longest;
    common.ids = tree->ids.bytes == NULL ? NULL : &tree->ids;
    common.word = g->first_triangle + run->first;
    plt_leaf_read(g, run->first, run->count, &leaf);
    plt_leaf_positions(&leaf, &tree->lattice, key);
    if (culling) {
        set_outcodes(&leaf, p, groups, code);
    }
    test_triangles(&leaf, key, culling ? code : NULL, &common, run->count, p, groups);
}

void plt_leaf_groups(const plt_block_tree *tree, const plt_geometry *g, const plt_leaf_run *run,
                     plt_packet *p, plt_mask groups) {
    if (tree->leaf_kind == PLT_LEAF_STRIPS) {
        test_strips(tree, g, run, p, groups);
        return;
    }
    const plt_record *record = &tree->records[g->first_triangle + run->first];
    for (uint32_t i = 0; i < run->count; i++) {
        plt_record_groups(p, &record[i], run->longest, groups);
    }
}

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

/* Bits of the leaf's triangles that lie outside the packet's frustum; 0 if it has none. */
PLT_APART_ON_SMALL_STACKS static unsigned culled_by_frustum(const plt_leaf *leaf, uint32_t count,
                                                            const plt_packet *p, plt_mask groups) {
    plt_frustum frustum;
    uint8_t code[PLT_LEAF_VERTICES_MOST];
    unsigned culled = 0;
    if (!plt_frustum_set(&frustum, p, groups)) {
        return 0;
    }
    for (uint32_t i = 0; i < leaf->vertices; i++) {
        code[i] = (uint8_t)plt_frustum_outcode(&frustum, leaf->vertex[i].scene);
    }
    for (uint32_t i = 0; i < count; i++) {
        culled |= (unsigned)plt_frustum_culls(code[plt_leaf_corner(leaf, i, 0)],
                                              code[plt_leaf_corner(leaf, i, 1)],
                                              code[plt_leaf_corner(leaf, i, 2)])
                  << i;
    }
    return culled;
}

#if PLT_WITH_WAVE
/* Corners of triangle `index`, in canonical order. */
PLT_APART_ON_SMALL_STACKS static void place_strip_corners(const plt_leaf *leaf, uint32_t index,
                                                          const plt_lattice *l, float to[3][3]) {
    const uint32_t *number[3];
    uint64_t key[3];
    for (unsigned c = 0; c < 3; c++) {
        number[c] = leaf->vertex[plt_leaf_corner(leaf, index, c)].number;
        key[c] = plt_lattice_key(number[c]);
    }
    uint32_t from = plt_canonical_first(key[1] < key[0], key[2] < key[0], key[2] < key[1]);
    for (unsigned c = 0; c < 3; c++) {
        for (int a = 0; a < 3; a++) {
            to[c][a] = plt_lattice_float(l, a, number[from][a]);
        }
        from = from < 2 ? from + 1 : 0;
    }
}

static void set_strip_triangle(const plt_block_tree *tree, const plt_geometry *g,
                               const plt_leaf_run *run, uint32_t index, plt_triangle *to) {
    plt_leaf leaf;
    plt_leaf_read(g, run->first, run->count, &leaf);
    place_strip_corners(&leaf, index, &tree->lattice, to->corner);
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

/* Tests those of a leaf's triangles that are not culled: all at a time where groups are listed.
 * `first`: the index of the first one in the image. */
#if PLT_WITH_HULLS
_Static_assert((int)PLT_TRIANGLES_MOST >= (int)PLT_LEAF_TRIANGLES_MOST, "all of a leaf at a time");

static void test_triangles(const plt_leaf *leaf, unsigned culled, const plt_leaf_run *run,
                           const plt_primitive_ids *ids, uint32_t first, plt_packet *p,
                           plt_mask groups) {
    plt_triangle_rows rows[PLT_TRIANGLES_MOST];
    unsigned kept = 0;
    for (uint32_t i = 0; i < run->count; i++) {
        if (culled >> i & 1u) {
            continue;
        }
        PLT_UNROLLED for (unsigned c = 0; c < 3; c++) {
            rows[kept].corner[c] = f4_load(leaf->vertex[plt_leaf_corner(leaf, i, c)].scene);
        }
        rows[kept++].word = first + i;
    }
    plt_triangles_groups(p, rows, kept, ids, run->longest, groups);
}
#else
/* Corners, which are in canonical order already. */
static inline void set_corners(const plt_leaf *leaf, uint32_t triangle, float to[3][3]) {
    PLT_UNROLLED for (unsigned i = 0; i < 3; i++) {
        memcpy(to[i], leaf->vertex[plt_leaf_corner(leaf, triangle, i)].scene, sizeof to[i]);
    }
}

static void test_triangles(const plt_leaf *leaf, unsigned culled, const plt_leaf_run *run,
                           const plt_primitive_ids *ids, uint32_t first, plt_packet *p,
                           plt_mask groups) {
    plt_triangle t;
    t.longest = run->longest;
    t.ids = ids;
    for (uint32_t i = 0; i < run->count; i++) {
        if (culled >> i & 1u) {
            continue;
        }
        t.word = first + i;
        set_corners(leaf, i, t.corner);
        plt_triangle_groups(p, &t, p->any ? groups & p->active : groups);
    }
}
#endif

PLT_APART_ON_SMALL_STACKS static void test_strips(const plt_block_tree *tree, const plt_geometry *g,
                                                  const plt_leaf_run *run, plt_packet *p,
                                                  plt_mask groups) {
    plt_leaf leaf;
    plt_leaf_read(g, run->first, run->count, &leaf);
    plt_leaf_place_corners(&leaf, run->count, &tree->lattice);
    const unsigned culled =
        g->k >= CULLING_FROM ? culled_by_frustum(&leaf, run->count, p, groups) : 0;
    test_triangles(&leaf, culled, run, tree->ids.bytes == NULL ? NULL : &tree->ids,
                   g->first_triangle + run->first, p, groups);
}

PLT_APART_ON_SMALL_STACKS static void
test_records(const plt_record *record, const plt_leaf_run *run, plt_packet *p, plt_mask groups) {
    for (uint32_t i = 0; i < run->count; i++) {
        plt_record_groups(p, &record[i], run->longest, groups);
    }
}

void plt_leaf_groups(const plt_block_tree *tree, const plt_geometry *g, const plt_leaf_run *run,
                     plt_packet *p, plt_mask groups) {
    if (tree->leaf_kind == PLT_LEAF_STRIPS) {
        test_strips(tree, g, run, p, groups);
    } else {
        test_records(&tree->records[g->first_triangle + run->first], run, p, groups);
    }
}

/* compact_check - see compact_check.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/compact_check.h"

#include "tests/reference/leaf_corners.h"

#include <stdlib.h>
#include <string.h>

typedef struct triangle_key {
    uint32_t q[9]; /* the least rotation of its corners */
} triangle_key;

typedef struct checking {
    const plt_block_tree *tree;
    compact_facts *facts;
    triangle_key *found; /* in the order of the traversal */
    uint32_t room, next; /* next: address where the next block must lie */
} checking;

typedef struct open_block {
    plt_block b;
    plt_geometry g;
    uint32_t inner, edges, leaves, pairs; /* read so far, in the order of slots */
    uint32_t triangles;
} open_block;

static void expect(const checking *c, int good, const char *sentence) {
    if (!good && c->facts->broken++ == 0) {
        c->facts->sentence = sentence;
    }
}

/* The least of the three rotations: also of triangles that have a corner twice. */
static triangle_key key_of(const uint32_t corner[3][3]) {
    triangle_key least;
    for (int rotation = 0; rotation < 3; rotation++) {
        triangle_key k;
        for (int i = 0; i < 9; i++) {
            k.q[i] = corner[(rotation + i / 3) % 3][i % 3];
        }
        int at = 0;
        while (rotation > 0 && at < 8 && k.q[at] == least.q[at]) {
            at++;
        }
        least = rotation == 0 || k.q[at] < least.q[at] ? k : least;
    }
    return least;
}

static int contains(const plt_lattice_box *b, const uint32_t p[3]) {
    int inside = 1;
    for (int a = 0; a < 3; a++) {
        inside &= b->lo[a] <= p[a] && p[a] <= b->hi[a];
    }
    return inside;
}

static void grow(plt_lattice_box *b, const plt_lattice_box *by) {
    for (int a = 0; a < 3; a++) {
        b->lo[a] = by->lo[a] < b->lo[a] ? by->lo[a] : b->lo[a];
        b->hi[a] = by->hi[a] > b->hi[a] ? by->hi[a] : b->hi[a];
    }
}

static int encloses(const plt_lattice_box *outer, const plt_lattice_box *inner) {
    return contains(outer, inner->lo) && contains(outer, inner->hi);
}

static uint32_t bit_at(const unsigned char *bytes, uint32_t at) {
    return bytes[at / 8] >> at % 8 & 1u;
}

/* Box of child `child` of a node with box `box`, from six bytes and five bits. */
static plt_lattice_box child_box(const open_block *o, uint32_t node, const plt_lattice_box *box,
                                 uint32_t child) {
    plt_lattice_box to = *box;
    for (uint32_t a = 0; a < 3; a++) {
        const uint32_t extent = box->hi[a] - box->lo[a];
        const uint32_t step = extent <= 255 ? 1 : (extent + 254) / 255;
        const uint32_t min_owner = a == 0 ? 1 : bit_at(o->b.owners, 5 * node + a - 1);
        const uint32_t max_owner = bit_at(o->b.owners, 5 * node + 2 + a);
        to.lo[a] += min_owner == child ? o->b.planes[6 * node + a] * step : 0;
        to.hi[a] -= max_owner == child ? o->b.planes[6 * node + 3 + a] * step : 0;
    }
    return to;
}

/* Writes down the triangles of a leaf; returns their exact box. */
static plt_lattice_box check_leaf(checking *c, open_block *o, int pair,
                                  const plt_lattice_box *box) {
    uint32_t corner[PLT_LEAF_TRIANGLES_MOST][3][3];
    plt_lattice_box exact = {{~0u, ~0u, ~0u}, {0, 0, 0}};
    const uint32_t k = c->tree->leaf_triangles;
    uint32_t count;
    const uint32_t first = plt_leaf_find(&o->g, o->leaves, o->pairs, pair, &count);
    expect(c, first == o->triangles, "leaves do not follow each other");
    expect(c, pair ? count > k && count <= 2 * k : count >= 1 && count <= k,
           "a leaf's size is not what its pair bit says");
    leaf_corners(&o->g, first, count, corner);
    for (uint32_t i = 0; i < count; i++) {
        if (c->facts->triangles < c->room) {
            c->found[c->facts->triangles] = key_of((const uint32_t(*)[3])corner[i]);
        }
        c->facts->triangles++;
        for (int p = 0; p < 3; p++) {
            plt_lattice_box point;
            memcpy(point.lo, corner[i][p], sizeof point.lo);
            memcpy(point.hi, corner[i][p], sizeof point.hi);
            expect(c, contains(box, corner[i][p]), "a corner lies outside a box above it");
            grow(&exact, &point);
        }
    }
    o->triangles += count;
    o->leaves++;
    o->pairs += (uint32_t)pair;
    c->facts->leaves++;
    c->facts->pairs += (uint32_t)pair;
    c->facts->longest_leaf = count > c->facts->longest_leaf ? count : c->facts->longest_leaf;
    return exact;
}

static plt_lattice_box check_block(checking *c, uint32_t link, const plt_lattice_box *around,
                                   uint32_t depth);

/* Reads the current block slot by slot. Node i's children are slots 2i and 2i + 1, and inner
 * ones are in the order of their numbers, so boxes fit in an array. Edges are followed after
 * the block, as their blocks lie after it. */
typedef struct row {
    plt_lattice_box box[PLT_BLOCK_NODES_MOST], exact[PLT_BLOCK_NODES_MOST];
    plt_lattice_box edge_box[PLT_BLOCK_NODES_MOST + 1];
    uint32_t edge_link[PLT_BLOCK_NODES_MOST + 1], edge_depth[PLT_BLOCK_NODES_MOST + 1];
    uint32_t edge_node[PLT_BLOCK_NODES_MOST + 1];
    uint32_t parent[PLT_BLOCK_NODES_MOST], depth[PLT_BLOCK_NODES_MOST];
} row;

static void check_slot(checking *c, open_block *o, row *r, uint32_t node, uint32_t child) {
    const unsigned char *mask_a = o->b.bytes + 4 + (c->tree->lattice.bits <= 16 ? 12 : 16);
    const unsigned char *mask_b = mask_a + (2 * o->b.nodes + 7) / 8;
    const uint32_t slot = 2 * node + child, a = bit_at(mask_a, slot), b = bit_at(mask_b, slot);
    const plt_lattice_box box = child_box(o, node, &r->box[node], child);
    if (a && !b) {
        const uint32_t number = ++o->inner;
        r->box[number] = box;
        r->parent[number] = node;
        r->depth[number] = r->depth[node] + 1;
    } else if (a) {
        const uint32_t e = o->edges++;
        r->edge_box[e] = box;
        r->edge_link[e] = plt_get_u32(o->b.links + 4 * e);
        r->edge_depth[e] = r->depth[node];
        r->edge_node[e] = node;
    } else {
        const plt_lattice_box exact = check_leaf(c, o, (int)b, &box);
        grow(&r->exact[node], &exact);
    }
}

static void check_edges(checking *c, const open_block *o, row *r) {
    uint32_t done = 0;
    for (uint32_t left = o->edges; left > 0; left--) { /* the lowest address first */
        uint32_t lowest = PLT_LINK_NONE;
        for (uint32_t e = 0; e < o->edges; e++) {
            const uint32_t address = plt_block_address(r->edge_link[e]);
            lowest = address > done && (lowest == PLT_LINK_NONE ||
                                        address < plt_block_address(r->edge_link[lowest]))
                         ? e
                         : lowest;
        }
        if (lowest == PLT_LINK_NONE) {
            expect(c, 0, "two edges lead to one block");
            return;
        }
        done = plt_block_address(r->edge_link[lowest]);
        const plt_lattice_box exact =
            check_block(c, r->edge_link[lowest], &r->edge_box[lowest], r->edge_depth[lowest]);
        grow(&r->exact[r->edge_node[lowest]], &exact);
    }
}

static plt_lattice_box check_block(checking *c, uint32_t link, const plt_lattice_box *around,
                                   uint32_t depth) {
    const uint32_t bits = c->tree->lattice.bits, address = plt_block_address(link);
    const plt_lattice_box none = {{~0u, ~0u, ~0u}, {0, 0, 0}};
    expect(c, address == c->next, "a block does not lie where the one before it ended");
    if (address != c->next || address >= c->tree->used || depth > 2000) {
        return none;
    }
    open_block o = {.inner = 0};
    row *r = calloc(1, sizeof *r);
    plt_block_open(&o.b, c->tree->bytes + address, bits);
    plt_block_bounds(&o.b, bits, &r->box[0]);
    if (o.b.leaves > 0) {
        plt_geometry_open(&o.g, &o.b, &r->box[0], c->tree->leaf_triangles);
        expect(c, o.g.first_triangle == c->facts->triangles, "a block's first triangle is wrong");
    }
    const uint32_t size = (o.b.node_bytes + o.b.geometry_bytes + 7u) & ~7u;
    expect(c, plt_block_node_bytes(link) == o.b.node_bytes, "a link has another size");
    expect(c, encloses(around, &r->box[0]), "a block's bounds leave the box of its edge");
    c->next += size;
    r->depth[0] = depth + 1;
    for (uint32_t i = 0; i < o.b.nodes; i++) {
        r->exact[i] = none;
        c->facts->depth = r->depth[i] > c->facts->depth ? r->depth[i] : c->facts->depth;
        check_slot(c, &o, r, i, 0);
        check_slot(c, &o, r, i, 1);
    }
    expect(c, o.inner + 1 == o.b.nodes, "a block's nodes are no tree");
    if (o.b.leaves > 0) {
        const uint32_t v = o.g.vertices;
        expect(c, o.triangles == o.g.triangles, "a block has triangles in no leaf");
        c->facts->most_vertices = v > c->facts->most_vertices ? v : c->facts->most_vertices;
    }
    c->facts->blocks++;
    c->facts->nodes += o.b.nodes;
    c->facts->largest_block = size > c->facts->largest_block ? size : c->facts->largest_block;
    check_edges(c, &o, r);
    for (uint32_t i = o.b.nodes; i-- > 0;) {
        expect(c, encloses(&r->box[i], &r->exact[i]), "a box does not contain what is below it");
        if (i > 0) {
            grow(&r->exact[r->parent[i]], &r->exact[i]);
        }
    }
    expect(c, memcmp(&r->exact[0], &r->box[0], sizeof r->exact[0]) == 0,
           "a block's bounds are not exact");
    const plt_lattice_box exact = r->exact[0];
    free(r);
    return exact;
}

/* ---- each triangle once ------------------------------------------------------- */

static int compare_keys(const void *a, const void *b) {
    return memcmp(a, b, sizeof(triangle_key));
}

static uint32_t number_at(const snapped *s, uint32_t triangle, uint32_t k) {
    const unsigned char *at = s->corners + (9 * (size_t)triangle + k) * s->width;
    return s->width == 2 ? at[0] | (uint32_t)at[1] << 8 : plt_get_u32(at);
}

static void same_triangles(checking *c, const snapped *s, uint32_t due) {
    triangle_key *wanted = malloc((due + 1u) * sizeof *wanted);
    for (uint32_t i = 0; i < due; i++) {
        uint32_t corner[3][3];
        for (uint32_t k = 0; k < 9; k++) {
            corner[k / 3][k % 3] = number_at(s, i % s->count, k);
        }
        wanted[i] = key_of((const uint32_t(*)[3])corner);
    }
    qsort(wanted, due, sizeof *wanted, compare_keys);
    qsort(c->found, due, sizeof *c->found, compare_keys);
    expect(c, memcmp(wanted, c->found, due * sizeof *wanted) == 0,
           "the triangles are not those of the mesh");
    free(wanted);
}

compact_facts compact_check(const plt_block_tree *tree, const snapped *s) {
    compact_facts facts = {.sentence = "good"};
    const uint32_t due = s == NULL ? 0 : (s->count == 1 ? 2 : s->count);
    checking c = {tree, &facts, malloc((due + 1u) * sizeof(triangle_key)), due, 0};
    if (tree->root != PLT_LINK_NONE) {
        const plt_lattice_box exact = check_block(&c, tree->root, &tree->box, 0);
        expect(&c, memcmp(&exact, &tree->box, sizeof exact) == 0, "the scene's box is not exact");
    }
    expect(&c, c.next == tree->used, "the blocks do not end where they should");
    if (s != NULL) {
        expect(&c, facts.triangles == due, "the number of triangles is not the mesh's");
        if (facts.triangles == due && due > 0) {
            same_triangles(&c, s, due);
        }
    }
    free(c.found);
    return facts;
}

/* treelet_bph - see treelet_bph.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/treelets/treelet_bph.h"

#include <string.h>

#include "engine/image/header.h"
#include "host_tools/base/heap.h"

static void children_of(const void *self, uint32_t slot, const plt_box *box,
                        treelet_child child[2]) {
    const plt_node *node = (const plt_node *)self + slot;
    plt_box boxes[2];
    plt_node_decode(node, box, boxes);
    for (int k = 0; k < 2; k++) {
        child[k] = (treelet_child){boxes[k], plt_node_link(node, k)};
    }
}

static int no_memory(const char *name, fail *f) {
    return fail_set(f, name,
                    "out of memory for treelets; leave out triangles, or choose smaller ones");
}

static int put_nodes(treelet_bph *b, const plt_node *from, uint32_t root,
                     const treelet_bph_options *o) {
    node_tree t;
    treelet_layout l = {.slot = NULL};
    if (node_tree_read(&t, from, root, b->image.info.nodes, &b->nodes.box) != 0) {
        return -1;
    }
    if (treelets_form(&l, &t.tree, &o->wish) == 0) {
        b->node = heap_get_aligned((uint64_t)l.blocks * o->wish.size * sizeof *b->node);
    }
    if (b->node != NULL) {
        node_tree_write(&t, &l, o->wish.size, o->edges, from, b->node);
        b->nodes.root = plt_link_make(l.slot[0], 0);
        b->treelets = l.treelets;
        b->complete = l.complete;
        b->blocks = l.blocks;
        b->unfilled_blocks = l.unfilled_blocks;
    }
    treelets_free(&l);
    node_tree_free(&t);
    return b->node != NULL ? 0 : -1;
}

/* The header says where nodes and records are (SPEC.md, section 2). */
static int read_image(treelet_bph *b, const treelet_bph_options *o) {
    const plt_info *info = &b->image.info;
    plt_header header;
    plt_fault fault;
    if (plt_header_read(&header, b->image.bytes, b->image.size, &fault) != PLT_OK) {
        return -1;
    }
    const unsigned char *bytes = b->image.bytes;
    memcpy(b->nodes.box.lo, info->lo, sizeof info->lo);
    memcpy(b->nodes.box.hi, info->hi, sizeof info->hi);
    b->nodes.record =
        (const plt_record
             *)(const void *)(bytes + plt_header_section(&header, PLT_SECTION_TRIANGLES)->offset);
    b->nodes.root = header.root;
    if (info->nodes == 0) {
        return 0;
    }
    const plt_node *from =
        (const plt_node *)(const void *)(bytes +
                                         plt_header_section(&header, PLT_SECTION_NODES)->offset);
    return put_nodes(b, from, plt_link_index(header.root), o);
}

int treelet_bph_make(treelet_bph *b, const mesh *m, const treelet_bph_options *o, const char *name,
                     fail *f) {
    const pack_options pack = {.splits = o->splits,
                               .build = PLT_BUILD_HOST,
                               .leaf_triangles = o->leaf_triangles,
                               .treelet_nodes = 1};
    if (pack_mesh(&b->image, m, &pack, name, f) != 0) {
        return -1;
    }
    b->size = o->wish.size;
    b->nodes.edges = o->edges;
    b->nodes.children = children_of;
    if (read_image(b, o) != 0) {
        treelet_bph_free(b);
        return no_memory(name, f);
    }
    b->nodes.self = b->node;
    return 0;
}

void treelet_bph_free(treelet_bph *b) {
    heap_drop(b->node);
    pack_free(&b->image);
    memset(b, 0, sizeof *b);
}

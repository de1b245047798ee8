/* measure_nodes - see measure_nodes.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/measure_nodes.h"

#include <stdio.h>
#include <string.h>

#include "engine/image/header.h"
#include "host_tools/pack/node_tree.h"
#include "host_tools/pack/pack.h"

static int refuse(const stage *s, const char *text, fail *f) {
    return fail_set(f, s->name, "there is no measurement '%s'; please report this", text);
}

static int read_packing(const char *text, pack_options *o) {
    char splits[8];
    unsigned leaf, nodes;
    char end;
    if (sscanf(text, "%7[a-z],leaf-%u,treelet-%u%c", splits, &leaf, &nodes, &end) != 3) {
        return -1;
    }
    o->splits = strcmp(splits, "median") == 0 ? PLT_SPLIT_MEDIAN : PLT_SPLIT_SAH;
    o->leaf_triangles = leaf;
    o->treelet_nodes = nodes;
    return 0;
}

static void take_info(const plt_info *info, figures *to) {
    to->of[FIGURE_TRIANGLES] = info->triangles;
    to->of[FIGURE_NODES] = info->nodes;
    to->of[FIGURE_BYTES] = 32.0 * info->nodes;
    to->of[FIGURE_SLOTS] = info->node_slots;
    to->of[FIGURE_LEAVES] = info->leaf_lists;
    to->of[FIGURE_INTERMEDIATES] = info->intermediate_lists;
    to->of[FIGURE_TREELETS] = info->treelets;
}

int measure_packing(stage *s, const char *text, figures *to, fail *f) {
    pack_options options = {.build = PLT_BUILD_HOST};
    packed image = {0};
    if (read_packing(text, &options) != 0) {
        return refuse(s, text, f);
    }
    if (pack_mesh(&image, &s->m, &options, s->name, f) != 0) {
        return -1;
    }
    take_info(&image.info, to);
    pack_free(&image);
    return 0;
}

/* ---- slots ------------------------------------------------------------------ */

static int out_of_memory(const stage *s, fail *f) {
    return fail_set(f, s->name, "out of memory; close other programs");
}

/* Of thesis nodes, which come first in their image. */
static int form(const packed *image, unsigned size, treelet_layout *to) {
    const plt_info *info = &image->info;
    plt_header header;
    plt_fault fault;
    plt_box box;
    node_tree t;
    memcpy(box.lo, info->lo, sizeof box.lo);
    memcpy(box.hi, info->hi, sizeof box.hi);
    if (plt_header_read(&header, image->bytes, image->size, &fault) != PLT_OK) {
        return -1;
    }
    const plt_node *nodes =
        (const plt_node *)(const void *)(image->bytes + header.section[0].offset);
    if (node_tree_read(&t, nodes, plt_link_index(header.root), info->nodes, &box) != 0) {
        return -1;
    }
    const treelet_wish wish = {size, TREELET_FILL_BFS, TREELET_SLOTS_THESIS};
    const int status = treelets_form(to, &t.tree, &wish);
    node_tree_free(&t);
    return status;
}

int measure_slots(stage *s, const char *text, figures *to, fail *f) {
    const pack_options options = {.splits = PLT_SPLIT_MEDIAN,
                                  .build = PLT_BUILD_HOST,
                                  .leaf_triangles = 1,
                                  .treelet_nodes = 1};
    packed image = {0};
    treelet_layout layout;
    unsigned size;
    if (sscanf(text, "%u", &size) != 1) {
        return refuse(s, text, f);
    }
    int status = pack_mesh(&image, &s->m, &options, s->name, f);
    if (status == 0) {
        take_info(&image.info, to);
        to->of[FIGURE_SLOTS] = to->of[FIGURE_TREELETS] = to->of[FIGURE_INCOMPLETE] = 0.0;
    }
    if (status == 0 && image.info.nodes > 0) {
        status = form(&image, size, &layout) == 0 ? 0 : out_of_memory(s, f);
        if (status == 0) {
            to->of[FIGURE_SLOTS] = (double)layout.blocks * size;
            to->of[FIGURE_TREELETS] = layout.treelets;
            to->of[FIGURE_INCOMPLETE] = layout.unfilled_blocks;
            treelets_free(&layout);
        }
    }
    pack_free(&image);
    return status;
}

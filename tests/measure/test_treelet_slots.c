/* test_treelet_slots [MESH...] - what fills and rules for slots cost: Table 5.5 by every one
 *
 * Of each mesh, by spatial median and by SAH, one triangle per list: treelets of less than N nodes
 * (incomplete), how many a random line enters that meets the root's box, and per rule the blocks
 * above as few as could be; in parentheses blocks with free slots, which the thesis counts. The
 * bottom-up variant of section 8.2.2 is counted beside them: a treelet takes what hangs below a
 * node until there are N; where that are more, the larger side is cut off as it is. Its incomplete
 * treelets have edges, so each fills a block of its own (SPEC.md, 4.5). Without a MESH it takes a
 * small one and is one test more.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "host_tools/treelets/forming.h"
#include "tests/measure/meshes.h"
#include "tests/reference/tree_check.h"

static const uint32_t sizes[] = {2, 3, 7, 8, 16, 64, 256, 512, 10000};
#define SIZES (sizeof sizes / sizeof *sizes)

static const char *const fills[] = {"bfs", "area", "full"};
static const char *const rules[] = {"thesis", "newest", "none", "come"};

static int read_tree(node_tree *t, const mesh *m, uint8_t splits) {
    const pack_options o = {
        .splits = splits, .build = PLT_BUILD_HOST, .leaf_triangles = 1, .treelet_nodes = 1};
    packed image;
    plt_box box;
    fail f = {""};
    const int is_packed = pack_mesh(&image, m, &o, "measure", &f) == 0;
    CHECK(is_packed || rig_is_tiny(), "%s", f.text);
    int status = -1;
    if (is_packed && image.info.nodes > 0) {
        const tree_view v = tree_view_of(&image);
        memcpy(box.lo, image.info.lo, sizeof box.lo);
        memcpy(box.hi, image.info.hi, sizeof box.hi);
        status = node_tree_read(t, (const plt_node *)(const void *)v.nodes, v.root >> 5,
                                image.info.nodes, &box);
    }
    pack_free(&image);
    return status;
}

/* Nodes are numbered after their parents. Returns treelets; those of less than N. */
static uint32_t bottom_up(const treelet_tree *t, uint32_t size, uint32_t *incomplete) {
    uint32_t *hangs = calloc(t->nodes, sizeof *hangs), treelets = 1;
    *incomplete = 0;
    for (uint32_t i = t->nodes; i-- > 0;) {
        uint32_t side[2];
        for (int k = 0; k < 2; k++) {
            side[k] = t->child[i][k] == TREELET_NO_NODE ? 0 : hangs[t->child[i][k]];
        }
        for (; side[0] + side[1] + 1 > size; treelets++) {
            const int cut = side[1] > side[0];
            *incomplete += side[cut] < size;
            side[cut] = 0;
        }
        hangs[i] = side[0] + side[1] + 1;
        if (hangs[i] == size && i > 0) {
            hangs[i] = 0;
            treelets++;
        }
    }
    *incomplete += hangs[0] < size;
    free(hangs);
    return treelets;
}

static double entered(const treelet_tree *t, const treelet_layout *l) {
    double sum = 1.0;
    for (uint32_t i = 0; i < t->nodes; i++) {
        for (int k = 0; k < 2; k++) {
            const uint32_t child = t->child[i][k];
            if (child != TREELET_NO_NODE && treelets_leaves(l, i, child)) {
                sum += (double)t->area[child] / (double)t->area[0];
            }
        }
    }
    return sum;
}

static void print_fill(const treelet_tree *t, uint32_t size, uint8_t fill) {
    const uint32_t least = (t->nodes + size - 1) / size;
    for (uint8_t rule = 0; rule < TREELET_SLOT_RULES; rule++) {
        const treelet_wish wish = {size, fill, rule};
        treelet_layout l;
        CHECK(treelets_form(&l, t, &wish) == 0, "N %u", size);
        if (rule == 0) {
            printf("    %5u %-4s %8u %6.2f", size, fills[fill], l.treelets - l.complete,
                   entered(t, &l));
        }
        printf("   %s +%u (%u)", rules[rule], l.blocks - least, l.unfilled_blocks);
        CHECK(fill != TREELET_FILL_FULL || rule != TREELET_SLOTS_THESIS || l.blocks <= least + 1,
              "N %u: %u blocks above", size, l.blocks - least);
        treelets_free(&l);
    }
    printf("\n");
}

static void measure(const mesh *m, const char *name) {
    for (uint8_t splits = 0; splits < 2; splits++) {
        node_tree t = {.slot = NULL};
        if (read_tree(&t, m, splits) != 0) {
            continue;
        }
        printf("    %s, %s, %u nodes\n        N fill incompl entered   blocks above the fewest\n",
               name, splits == PLT_SPLIT_SAH ? "sah" : "median", t.tree.nodes);
        for (size_t n = 0; n < SIZES; n++) {
            uint32_t incomplete;
            const uint32_t treelets = bottom_up(&t.tree, sizes[n], &incomplete);
            for (uint8_t fill = 0; fill < TREELET_FILLS; fill++) {
                print_fill(&t.tree, sizes[n], fill);
            }
            printf("    %5u up   %8u          none +%u\n", sizes[n], incomplete,
                   treelets - (t.tree.nodes + sizes[n] - 1) / sizes[n]);
        }
        node_tree_free(&t);
    }
}

int main(int argc, char **argv) {
    return measure_meshes(
        argc, argv, "filled up, less than two treelets of slots are free, by any splits", measure);
}

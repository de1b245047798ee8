/* kd_build - see kd_build.h
 *
 * A tree that is built whole goes by the same steps as one that is built on demand.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/kd/kd_build.h"

#include "host_tools/baselines/kd/kd_exact.h"
#include "host_tools/baselines/kd/kd_sample.h"
#include "host_tools/baselines/kd/kd_sweep.h"

static kd_cut choose(const kd_cell *c) {
    if (c->levels == 0 || c->count == 0) {
        return kd_cost_of_leaf(c);
    }
    return c->count <= KD_FEW ? kd_sweep_few(c) : kd_sample(c);
}

int kd_build_node(kd_tree *t, const kd_scene *s, uint32_t node) {
    kd_cell c = kd_tree_take(t, node), children[2];
    const kd_cut cut = choose(&c);
    t->work += c.count;
    const int status = !cut.is_cut ? kd_tree_set_leaf(t, node, &c)
                       : kd_cell_split(&c, s, &cut, children, NULL) != 0
                           ? -1
                           : kd_tree_set_inner(t, node, &cut, children);
    kd_cell_free(&c);
    return status;
}

/* Nodes come after those above them, so that one pass would do; but the last ones are split first,
 * and so there are few cells at a time. */
static int build_whole(kd_tree *t, const kd_scene *s) {
    uint32_t stack[64 + 2], entries = 0;
    stack[entries++] = 0;
    while (entries > 0) {
        const uint32_t node = stack[--entries];
        if (t->node[node].link == KD_UNSPLIT && kd_build_node(t, s, node) != 0) {
            return -1;
        }
        if ((t->node[node].link & 3u) != KD_LEAF) {
            stack[entries++] = (t->node[node].link >> 2) + 1;
            stack[entries++] = t->node[node].link >> 2;
        }
    }
    return 0;
}

int kd_build(kd_tree *t, const kd_scene *s, const kd_way *way) {
    kd_cell root;
    if (kd_cell_begin(&root, s) != 0) {
        return -1;
    }
    if (way->is_exact) {
        return kd_build_exactly(t, s, &root);
    }
    if (kd_tree_begin(t, &root) != 0) {
        return -1;
    }
    return way->is_lazy ? 0 : build_whole(t, s);
}

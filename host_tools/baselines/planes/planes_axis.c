/* planes_axis - see planes_axis.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/planes/planes_axis.h"

#include "host_tools/base/heap.h"

/* Children stand behind their parents. */
int planes_source_begin(planes_source *s, binary_tree *tree, int outer) {
    *s = (planes_source){.tree = tree, .outer = outer};
    s->weight = heap_get((uint64_t)tree->nodes * sizeof *s->weight + 1);
    if (s->weight == NULL) {
        return -1;
    }
    for (uint32_t i = tree->nodes; i-- > 0;) {
        const binary_node *n = &tree->node[i];
        s->weight[i] =
            binary_is_leaf(n) ? (float)n->count : s->weight[n->first] + s->weight[n->first + 1];
    }
    return 0;
}

void planes_source_end(planes_source *s) {
    heap_drop(s->weight);
    s->weight = NULL;
}

/* Whether the first of two children has its centre beyond the other's. */
static int is_swapped(const binary_node of[2], int axis) {
    return of[0].box.lo[axis] + of[0].box.hi[axis] > of[1].box.lo[axis] + of[1].box.hi[axis];
}

/* What is left of `in` for the lower (0) or the upper child, whose own box is `own`. */
static plt_box left_of(const planes_source *s, const plt_box *in, const plt_box *own, int axis,
                       int which) {
    plt_box b = *in;
    b.lo[axis] = which == 1 || s->outer ? own->lo[axis] : b.lo[axis];
    b.hi[axis] = which == 0 || s->outer ? own->hi[axis] : b.hi[axis];
    return b;
}

static float cost(const planes_source *s, const binary_node *n, int axis) {
    const binary_node *of = &s->tree->node[n->first];
    const int swap = is_swapped(of, axis);
    float sum = 0.0f;
    for (int c = 0; c < 2; c++) {
        const plt_box left = left_of(s, &n->box, &of[c].box, axis, c ^ swap);
        sum += plt_box_half_area(&left) * s->weight[n->first + (uint32_t)c];
    }
    return sum;
}

/* The first of equals. */
static int axis_of(const planes_source *s, const binary_node *n) {
    int best = 0;
    float least = cost(s, n, 0);
    for (int a = 1; a < 3; a++) {
        const float this = cost(s, n, a);
        if (this < least) {
            least = this;
            best = a;
        }
    }
    return best;
}

static void swap_children(planes_source *s, uint32_t first) {
    const binary_node n = s->tree->node[first];
    const float weight = s->weight[first];
    s->tree->node[first] = s->tree->node[first + 1];
    s->tree->node[first + 1] = n;
    s->weight[first] = s->weight[first + 1];
    s->weight[first + 1] = weight;
}

planes_cut planes_source_cut(planes_source *s, uint32_t node) {
    const binary_node *n = &s->tree->node[node];
    binary_node *of = &s->tree->node[n->first];
    const int axis = axis_of(s, n);
    planes_cut cut = {.axis = (uint32_t)axis};
    if (is_swapped(of, axis)) {
        swap_children(s, n->first);
    }
    for (int c = 0; c < 2; c++) {
        cut.lo[c] = of[c].box.lo[axis];
        cut.hi[c] = of[c].box.hi[axis];
        of[c].box = left_of(s, &n->box, &of[c].box, axis, c);
    }
    return cut;
}

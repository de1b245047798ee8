/* test_treelets_slots - which block takes a treelet, and what a choice of nodes costs, by hand
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/treelets/full.h"
#include "host_tools/treelets/slots.h"
#include "tests/reference/treelet_trees.h"
#include "tests/test.h"

enum { SIZE = 9, TREELETS = 400 };

/* Blocks as a list, the last of which was filled last. */
typedef struct listed {
    uint32_t block[TREELETS], used[TREELETS], count;
} listed;

/* The newest block with room; or, by the thesis's rule, of those with the least left that is just
 * enough, else of those with most, the one that was filled last. UINT32_MAX: none. */
static uint32_t due_block(const listed *l, uint8_t rule, uint32_t nodes) {
    uint32_t best = UINT32_MAX, most = nodes;
    if (rule == TREELET_SLOTS_NEWEST) {
        for (uint32_t i = 0; i < l->count; i++) {
            const uint32_t block = l->block[i];
            const int is_newer = best == UINT32_MAX || block > best;
            best = SIZE - l->used[block] >= nodes && is_newer ? block : best;
        }
        return best;
    }
    for (uint32_t i = l->count; i-- > 0;) {
        if (SIZE - l->used[l->block[i]] == nodes) {
            return l->block[i];
        }
    }
    for (uint32_t i = l->count; i-- > 0;) {
        const uint32_t left = SIZE - l->used[l->block[i]];
        best = left > most ? l->block[i] : best;
        most = left > most ? left : most;
    }
    return best;
}

/* It becomes the last. */
static void fill(listed *l, uint32_t block, uint32_t nodes) {
    uint32_t to = 0;
    for (uint32_t i = 0; i < l->count; i++) {
        if (l->block[i] != block) {
            l->block[to++] = l->block[i];
        }
    }
    l->block[to] = block;
    l->count = to + 1;
    l->used[block] += nodes;
}

static void check_rule(uint8_t rule) {
    random_state r = {rule + 5u};
    treelet_blocks b;
    listed l = {.count = 0};
    uint32_t shared = 0;
    CHECK(treelet_blocks_make(&b, SIZE, rule, TREELETS) == 0, "no memory");
    for (uint32_t t = 0; t < TREELETS; t++) {
        const uint32_t nodes = 1 + random_below(&r, SIZE), due = due_block(&l, rule, nodes);
        const uint32_t block = treelet_blocks_find(&b, nodes);
        CHECK(block == (due != UINT32_MAX ? due : l.count), "treelet %u: block %u, not %u", t,
              block, due);
        CHECK(b.used[block] == l.used[block], "block %u", block);
        shared += due != UINT32_MAX;
        treelet_blocks_fill(&b, block, nodes);
        fill(&l, block, nodes);
    }
    CHECK(shared > TREELETS / 5, "%u find room", shared);
    treelet_blocks_free(&b);
}

/* Of a leaf of the tree. */
static const uint32_t no_child[2] = {TREELET_NO_NODE, TREELET_NO_NODE};

static void check_price(void) {
    const uint32_t order[1] = {0}, child[1][2] = {{no_child[0], no_child[1]}};
    const treelet_tree tree = {.child = child, .nodes = 1};
    const treelet_prices prices = {.per_size = 2.0f, .above_half = 10.0f};
    treelet_costs c;
    for (uint32_t size = 1; size <= 3; size++) {
        const float due = size == 1 ? 0.0f : size == 2 ? 2.0f : 1.0f + 2.0f / 3.0f;
        CHECK(treelet_costs_make(&c, &tree, size, order, &prices) == 0, "no memory");
        CHECK(c.cost[0] == due && c.cost[1] == 0.0f, "N %u: %g, %g", size, (double)c.cost[0],
              (double)c.cost[1]);
        treelet_costs_free(&c);
    }
}

static uint32_t left_of(const float *left, const float *right) {
    const uint32_t child[3][2] = {{1, 2}, {no_child[0], no_child[1]}, {no_child[0], no_child[1]}};
    const treelet_tree tree = {.child = child, .nodes = 3};
    uint32_t below[3] = {5, 2, 2};
    size_t at[3] = {0, 0, 3};
    float cost[6];
    memcpy(cost, left, 3 * sizeof *left);
    memcpy(cost + 3, right, 3 * sizeof *right);
    const treelet_costs c = {.tree = &tree, .size = 3, .below = below, .at = at, .cost = cost};
    return treelet_costs_left(&c, 0, 3);
}

static void check_left(void) {
    const float alike[3] = {0, 0, 0}, ends[3] = {0, 5, 0}, more[3] = {4, 2, 0};
    test("a treelet takes the cheapest nodes, of equals as the tree has them, then from the right");
    CHECK(left_of(alike, alike) == 1, "%u", left_of(alike, alike));
    CHECK(left_of(ends, alike) == 0, "%u", left_of(ends, alike));
    CHECK(left_of(more, alike) == 2, "%u", left_of(more, alike));
    CHECK(left_of(alike, more) == 0, "%u", left_of(alike, more));
}

/* Without areas all nodes are as large: the first to come is the next. */
static void check_no_areas(void) {
    random_state r = {3};
    treelet_tree_made t = treelet_tree_make(700, TREELETS_AS_BUILT, &r);
    t.tree.area = NULL;
    for (uint32_t size = 2; size <= 64; size *= 2) {
        const treelet_wish area = {size, TREELET_FILL_AREA, TREELET_SLOTS_THESIS};
        const treelet_wish bfs = {size, TREELET_FILL_BFS, TREELET_SLOTS_THESIS};
        treelet_layout a, b;
        CHECK(treelets_form(&a, &t.tree, &area) == 0 && treelets_form(&b, &t.tree, &bfs) == 0,
              "no memory");
        CHECK(memcmp(a.slot, b.slot, t.tree.nodes * sizeof *a.slot) == 0, "N %u", size);
        treelets_free(&a);
        treelets_free(&b);
    }
    treelet_tree_drop(&t);
}

int main(void) {
    test("the thesis's rule: a block that is just filled, else the emptiest, the last of equals");
    check_rule(TREELET_SLOTS_THESIS);
    check_rule(TREELET_SLOTS_COME);
    test("the newest block with room");
    check_rule(TREELET_SLOTS_NEWEST);
    test("what an incomplete treelet costs grows with its nodes, and above half of N");
    check_price();
    check_left();
    test("filled by area without areas, treelets are breadth first");
    check_no_areas();
    return test_done();
}

/* polygon_tree - see polygon_tree.h
 *
 * Source of the order: G. M. Morton, "A Computer Oriented Geodetic Data Base and a
 * New Technique in File Sequencing", 1966. It is sorted by radix, so ties stand
 * in the order of the points on every machine.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/polygon_tree.h"
#include "host_tools/base/heap.h"

#include <math.h>
#include <string.h>

enum {
    LEAF_POINTS = 8,
    SORTED_FROM = 65, /* fewer points are left in the caller's order, an outline's */
};

static size_t leaves_for(size_t points) {
    size_t leaves = 1;
    while (leaves * LEAF_POINTS < points) {
        leaves *= 2;
    }
    return leaves;
}

static int grow(polygon_tree *t, size_t n) {
    if (n <= t->room) {
        return 0;
    }
    polygon_tree_free(t);
    const size_t leaves = leaves_for(n);
    if (n > SIZE_MAX / (2 * sizeof *t->key) || leaves > SIZE_MAX / (2 * sizeof *t->box)) {
        return -1;
    }
    t->key = heap_get(2 * (uint64_t)n * sizeof *t->key);
    t->place = heap_get((uint64_t)n * sizeof *t->place);
    t->box = heap_get(2 * (uint64_t)leaves * sizeof *t->box);
    t->marked = heap_get(2 * (uint64_t)leaves * sizeof *t->marked);
    if (!t->key || !t->place || !t->box || !t->marked) {
        polygon_tree_free(t);
        return -1;
    }
    t->room = n;
    return 0;
}

void polygon_tree_free(polygon_tree *t) {
    heap_drop(t->key);
    heap_drop(t->place);
    heap_drop(t->box);
    heap_drop(t->marked);
    *t = (polygon_tree){0};
}

static const tree_box NOTHING = {{INFINITY, INFINITY}, {-INFINITY, -INFINITY}};

static void extend(tree_box *box, const double lo[2], const double hi[2]) {
    for (int a = 0; a < 2; a++) {
        box->lo[a] = lo[a] < box->lo[a] ? lo[a] : box->lo[a];
        box->hi[a] = hi[a] > box->hi[a] ? hi[a] : box->hi[a];
    }
}

/* Puts a 0 before every bit. */
static uint64_t spread(uint64_t x) {
    x = (x | x << 16) & 0x0000FFFF0000FFFFu;
    x = (x | x << 8) & 0x00FF00FF00FF00FFu;
    x = (x | x << 4) & 0x0F0F0F0F0F0F0F0Fu;
    x = (x | x << 2) & 0x3333333333333333u;
    return (x | x << 1) & 0x5555555555555555u;
}

static void find_keys(polygon_tree *t, uint32_t n) {
    tree_box all = NOTHING;
    for (uint32_t i = 0; i < n; i++) {
        extend(&all, t->point[i], t->point[i]);
    }
    const double size = fmax(all.hi[0] - all.lo[0], all.hi[1] - all.lo[1]);
    const double scale = size > 0 ? 4294967295.0 / size : 0;
    for (uint32_t i = 0; i < n; i++) {
        const uint64_t x = (uint64_t)((t->point[i][0] - all.lo[0]) * scale);
        const uint64_t y = (uint64_t)((t->point[i][1] - all.lo[1]) * scale);
        t->key[i] = (tree_key){spread(x) | spread(y) << 1, i};
    }
}

/* Eight passes, so that the keys end where they began. */
static void sort_keys(tree_key *key, uint32_t n) {
    tree_key *from = key, *to = key + n;
    for (int shift = 0; shift < 64; shift += 8) {
        size_t start[257] = {0};
        for (uint32_t i = 0; i < n; i++) {
            start[(from[i].key >> shift & 255) + 1]++;
        }
        for (int d = 0; d < 256; d++) {
            start[d + 1] += start[d];
        }
        for (uint32_t i = 0; i < n; i++) {
            to[start[from[i].key >> shift & 255]++] = from[i];
        }
        tree_key *swapped = from;
        from = to;
        to = swapped;
    }
}

static void find_boxes(polygon_tree *t, uint32_t n) {
    for (uint32_t leaf = 0; leaf < t->leaves; leaf++) {
        tree_box *box = &t->box[t->leaves + leaf];
        *box = NOTHING;
        for (uint32_t k = 0; k < LEAF_POINTS && leaf * LEAF_POINTS + k < n; k++) {
            const double *p = t->point[t->key[leaf * LEAF_POINTS + k].point];
            extend(box, p, p);
        }
    }
    for (uint32_t i = t->leaves - 1; i > 0; i--) {
        t->box[i] = t->box[2 * i];
        extend(&t->box[i], t->box[2 * i + 1].lo, t->box[2 * i + 1].hi);
    }
}

int polygon_tree_build(polygon_tree *t, const double (*point)[2], uint32_t n) {
    if (grow(t, n) != 0) {
        return -1;
    }
    t->point = point;
    t->leaves = (uint32_t)leaves_for(n);
    find_keys(t, n);
    if (n >= SORTED_FROM) {
        sort_keys(t->key, n);
    }
    for (uint32_t i = 0; i < n; i++) {
        t->place[t->key[i].point] = i;
    }
    find_boxes(t, n);
    memset(t->marked, 0, 2 * (size_t)t->leaves * sizeof *t->marked);
    return 0;
}

int polygon_tree_is_marked(const polygon_tree *t, uint32_t point) {
    const uint32_t place = t->place[point];
    return t->marked[t->leaves + place / LEAF_POINTS] >> place % LEAF_POINTS & 1;
}

void polygon_tree_mark(polygon_tree *t, uint32_t point, int on) {
    if (polygon_tree_is_marked(t, point) == on) {
        return;
    }
    const uint32_t place = t->place[point];
    uint32_t node = t->leaves + place / LEAF_POINTS;
    t->marked[node] ^= 1u << place % LEAF_POINTS;
    for (node /= 2; node > 0; node /= 2) {
        t->marked[node] += on ? 1u : UINT32_MAX;
    }
}

tree_search polygon_tree_search(const polygon_tree *t, const double a[2], const double b[2],
                                const double c[2], double slack) {
    tree_search s = {.t = t, .box = NOTHING, .slack = slack, .waits = 1};
    const double *corner[3] = {a, b, c};
    for (int k = 0; k < 3; k++) {
        memcpy(s.corner[k], corner[k], sizeof s.corner[k]);
        extend(&s.box, corner[k], corner[k]);
    }
    s.waiting[0] = 1;
    return s;
}

/* Whether the box lies to the right of p q; some boxes that only just do are missed. */
static int is_right_of(const tree_box *box, const double p[2], const double q[2], double slack) {
    const double dx = q[0] - p[0], dy = q[1] - p[1];
    const double x = (dy < 0 ? box->hi[0] : box->lo[0]) - p[0];
    const double y = (dx < 0 ? box->lo[1] : box->hi[1]) - p[1];
    const double size = fabs(dx) + fabs(dy) + fabs(x) + fabs(y);
    return dx * y - dy * x < -(0x1p-49 * size + slack) * size;
}

static int may_meet(const tree_search *s, const tree_box *box) {
    for (int a = 0; a < 2; a++) {
        if (box->lo[a] > s->box.hi[a] + s->slack || box->hi[a] < s->box.lo[a] - s->slack) {
            return 0;
        }
    }
    for (int k = 0; k < 3; k++) {
        if (is_right_of(box, s->corner[k], s->corner[(k + 1) % 3], s->slack)) {
            return 0;
        }
    }
    return 1;
}

static uint32_t lowest_bit(uint32_t bits) {
    uint32_t at = 0;
    while (!(bits >> at & 1)) {
        at++;
    }
    return at;
}

/* Fills `bits` from the next leaf, if there is one. */
static void find_leaf(tree_search *s) {
    const polygon_tree *t = s->t;
    while (!s->bits && s->waits) {
        const uint32_t node = s->waiting[--s->waits];
        s->visits++;
        if (!t->marked[node] || !may_meet(s, &t->box[node])) {
            continue;
        }
        if (node >= t->leaves) {
            s->leaf = node - t->leaves;
            s->bits = t->marked[node];
        } else {
            s->waiting[s->waits++] = 2 * node + 1;
            s->waiting[s->waits++] = 2 * node;
        }
    }
}

uint32_t polygon_tree_next(tree_search *s) {
    for (find_leaf(s); s->bits; find_leaf(s)) {
        const uint32_t place = s->leaf * LEAF_POINTS + lowest_bit(s->bits);
        const uint32_t point = s->t->key[place].point;
        const double *p = s->t->point[point];
        const tree_box box = {{p[0], p[1]}, {p[0], p[1]}};
        s->bits &= s->bits - 1;
        s->visits++;
        if (may_meet(s, &box)) {
            return point;
        }
    }
    return POLYGON_NONE;
}

/* strips - few strips over the triangles of a leaf
 *
 * Every triangle in each of its three rotations is tried as the first; a strip goes
 * on with the first triangle that shares the right edge in the right direction,
 * and a new one starts where none does. With at most 8 triangles that is
 * close to the best.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/builder/blocks_state.h"

typedef struct strip_try {
    plt_strip_step step[PLT_LEAF_TRIANGLES_MOST];
    uint32_t starts;
} strip_try;

static int same_point(const uint32_t a[3], const uint32_t b[3]) {
    return a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
}

/* Corner `c` of a triangle rotated by `rotation` corners. */
static const uint32_t *rotated_corner(const uint32_t corner[3][3], uint32_t rotation, uint32_t c) {
    return corner[(rotation + c) % 3];
}

/* A triangle not yet used that has the edge from `p` to `q`; 0: none. */
static int find_edge(const uint32_t corner[][3][3], uint32_t count, uint32_t used,
                     const uint32_t *p, const uint32_t *q, plt_strip_step *found) {
    for (uint32_t t = 0; t < count; t++) {
        for (uint32_t r = 0; r < 3 && !(used >> t & 1u); r++) {
            if (same_point(corner[t][r], p) && same_point(corner[t][(r + 1) % 3], q)) {
                found->triangle = (uint8_t)t;
                found->rotation = (uint8_t)r;
                return 1;
            }
        }
    }
    return 0;
}

static int go_on(const uint32_t corner[][3][3], uint32_t count, uint32_t used,
                 const plt_strip_step *last, plt_strip_step *next) {
    const uint32_t(*c)[3] = corner[last->triangle];
    const uint32_t *p0 = rotated_corner(c, last->rotation, 0),
                   *p1 = rotated_corner(c, last->rotation, 1),
                   *p2 = rotated_corner(c, last->rotation, 2);
    next->start = 0;
    next->swap = 0;
    if (find_edge(corner, count, used, p2, p1, next)) {
        return 1;
    }
    next->swap = 1;
    return find_edge(corner, count, used, p0, p2, next);
}

/* The first triangle left, rotated so that a strip can go on from it. */
static void start_anew(const uint32_t corner[][3][3], uint32_t count, uint32_t used,
                       plt_strip_step *next) {
    uint32_t t = 0;
    while (used >> t & 1u) {
        t++;
    }
    for (uint32_t r = 0; r < 3; r++) {
        plt_strip_step ahead;
        const plt_strip_step step = {(uint8_t)t, (uint8_t)r, 1, 0};
        *next = step;
        if (go_on(corner, count, used | 1u << t, next, &ahead)) {
            return;
        }
    }
}

static void try_from(const uint32_t corner[][3][3], uint32_t count, uint32_t triangle,
                     uint32_t rotation, strip_try *now) {
    const plt_strip_step first = {(uint8_t)triangle, (uint8_t)rotation, 1, 0};
    uint32_t used = 1u << triangle;
    now->step[0] = first;
    now->starts = 1;
    for (uint32_t i = 1; i < count; i++) {
        if (!go_on(corner, count, used, &now->step[i - 1], &now->step[i])) {
            start_anew(corner, count, used, &now->step[i]);
            now->starts++;
        }
        used |= 1u << now->step[i].triangle;
    }
}

void plt_strips_find(const uint32_t corner[][3][3], uint32_t count, plt_strip_step *step) {
    strip_try best = {{{0, 0, 0, 0}}, PLT_LEAF_TRIANGLES_MOST + 1}, now;
    for (uint32_t i = 0; i < 3 * count && best.starts > 1; i++) {
        try_from(corner, count, i / 3, i % 3, &now);
        if (now.starts < best.starts) {
            best = now;
        }
    }
    for (uint32_t i = 0; i < count; i++) {
        step[i] = best.step[i];
    }
}

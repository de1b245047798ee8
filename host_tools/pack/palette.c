/* palette - see palette.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/palette.h"

#include <stdlib.h>
#include <string.h>

#include "host_tools/base/heap.h"

typedef struct shade {
    uint32_t colour; /* 24 bits */
    uint32_t at;     /* among those that rise */
    uint64_t count;
} shade;

/* Shades begin .. end - 1, and how far they reach. */
typedef struct box {
    size_t begin, end;
    int axis, extent; /* the longest side */
} box;

static int part(uint32_t colour, int axis) {
    return (int)(colour >> 8 * axis & 0xFFu);
}

static int by_colour(const void *a, const void *b) {
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

#define BY_PART(name, axis)                                                                        \
    static int name(const void *a, const void *b) {                                                \
        const shade *x = a, *y = b;                                                                \
        const int difference = part(x->colour, axis) - part(y->colour, axis);                      \
        return difference != 0 ? difference : (x->at > y->at) - (x->at < y->at);                   \
    }
BY_PART(by_red, 0)
BY_PART(by_green, 1)
BY_PART(by_blue, 2)

static box box_of(const shade *s, size_t begin, size_t end) {
    box b = {begin, end, 0, -1};
    for (int axis = 0; axis < 3; axis++) {
        int low = 255, high = 0;
        for (size_t i = begin; i < end; i++) {
            const int x = part(s[i].colour, axis);
            low = x < low ? x : low;
            high = x > high ? x : high;
        }
        if (high - low > b.extent) {
            b.extent = high - low;
            b.axis = axis;
        }
    }
    return b;
}

/* Where half of the colours are on either side, with one shade at least. */
static size_t middle_of(const shade *s, const box *b) {
    uint64_t all = 0, before = 0;
    for (size_t i = b->begin; i < b->end; i++) {
        all += s[i].count;
    }
    size_t at = b->begin;
    while (at + 2 < b->end && before + s[at].count <= all / 2) {
        before += s[at++].count;
    }
    return at + 1;
}

/* Until there are `most`, or none reaches further than `extent`. */
static uint32_t split(shade *s, size_t shades, box *boxes, uint32_t most, int extent) {
    static int (*const by[3])(const void *, const void *) = {by_red, by_green, by_blue};
    uint32_t count = 1;
    boxes[0] = box_of(s, 0, shades);
    while (count < most) {
        uint32_t widest = 0;
        for (uint32_t i = 1; i < count; i++) {
            widest = boxes[i].extent > boxes[widest].extent ? i : widest;
        }
        box *b = &boxes[widest];
        if (b->extent <= extent) {
            break;
        }
        qsort(s + b->begin, b->end - b->begin, sizeof *s, by[b->axis]);
        const size_t middle = middle_of(s, b), end = b->end;
        boxes[widest] = box_of(s, b->begin, middle);
        boxes[count++] = box_of(s, middle, end);
    }
    return count;
}

/* The mean of a box's colours. */
static void settle(palette *p, uint32_t index, const shade *s, const box *b) {
    for (int axis = 0; axis < 3; axis++) {
        uint64_t sum = 0, all = 0;
        for (size_t i = b->begin; i < b->end; i++) {
            sum += s[i].count * (uint64_t)part(s[i].colour, axis);
            all += s[i].count;
        }
        p->colour[index][axis] = (uint8_t)((sum + all / 2) / all);
    }
    for (size_t i = b->begin; i < b->end; i++) {
        p->to[s[i].at] = (uint16_t)index;
    }
}

/* How far colours are from what stands for them. */
static void judge(palette *p, const shade *s) {
    uint64_t sum = 0, all = 0;
    p->furthest = 0;
    for (uint32_t i = 0; i < p->distinct; i++) {
        for (int axis = 0; axis < 3; axis++) {
            const int due = part(s[i].colour, axis);
            const uint32_t off = (uint32_t)abs(due - p->colour[p->to[s[i].at]][axis]);
            p->furthest = off > p->furthest ? off : p->furthest;
            sum += off * s[i].count;
        }
        all += 3 * s[i].count;
    }
    p->mean = all > 0 ? (double)sum / (double)all : 0;
}

/* The distinct ones, rising, and how often each is there. */
static size_t count_shades(shade *s, uint32_t *colour, size_t count) {
    size_t shades = 0;
    qsort(colour, count, sizeof *colour, by_colour);
    for (size_t i = 0; i < count; i++) {
        if (i == 0 || colour[i] != colour[i - 1]) {
            s[shades] = (shade){colour[i], (uint32_t)shades, 0};
            shades++;
        }
        s[shades - 1].count++;
    }
    return shades;
}

/* ---- the nearest of many ------------------------------------------------------------------- */

/* A colour of the palette; the sum of its three parts tells where to look. */
typedef struct mark {
    int32_t sum, index, part[3];
} mark;

static int by_sum(const void *a, const void *b) {
    const mark *x = a, *y = b;
    return x->sum != y->sum ? x->sum - y->sum : x->index - y->index;
}

static void sort_marks(const palette *p, mark *m) {
    for (uint32_t i = 0; i < p->count; i++) {
        const uint8_t *c = p->colour[i];
        m[i] = (mark){c[0] + c[1] + c[2], (int32_t)i, {c[0], c[1], c[2]}};
    }
    qsort(m, p->count, sizeof *m, by_sum);
}

typedef struct nearest {
    int32_t squared, index;
} nearest;

/* Whether marks from here on may be nearer: where sums differ by d, squares differ by d d / 3. */
static int may_be_nearer(const mark *m, int32_t sum, const nearest *best) {
    const int32_t d = m->sum - sum;
    return d * d <= 3 * best->squared;
}

static void try_mark(const mark *m, uint32_t colour, nearest *best) {
    int32_t squared = 0;
    for (int axis = 0; axis < 3; axis++) {
        const int32_t d = m->part[axis] - part(colour, axis);
        squared += d * d;
    }
    if (squared < best->squared || (squared == best->squared && m->index < best->index)) {
        *best = (nearest){squared, m->index};
    }
}

/* The lowest of those that are equally near. */
static uint16_t nearest_of(const mark *m, uint32_t count, uint32_t colour) {
    const int32_t sum = part(colour, 0) + part(colour, 1) + part(colour, 2);
    nearest best = {3 * 256 * 256, 0};
    uint32_t low = 0, high = count;
    while (low < high) {
        const uint32_t middle = low + (high - low) / 2;
        low = m[middle].sum < sum ? middle + 1 : low;
        high = m[middle].sum < sum ? high : middle;
    }
    for (uint32_t i = low; i < count && may_be_nearer(&m[i], sum, &best); i++) {
        try_mark(&m[i], colour, &best);
    }
    for (uint32_t i = low; i-- > 0 && may_be_nearer(&m[i], sum, &best);) {
        try_mark(&m[i], colour, &best);
    }
    return (uint16_t)best.index;
}

/* What colours stand for, and how many there are. */
typedef struct total {
    uint64_t part[3], all;
} total;

/* Each colour of the palette becomes the mean of those that it stands for, if any. */
static void move_all(palette *p, const shade *s, total *t) {
    memset(t, 0, p->count * sizeof *t);
    for (uint32_t i = 0; i < p->distinct; i++) {
        total *to = &t[p->to[s[i].at]];
        for (int axis = 0; axis < 3; axis++) {
            to->part[axis] += s[i].count * (uint64_t)part(s[i].colour, axis);
        }
        to->all += s[i].count;
    }
    for (uint32_t i = 0; i < p->count; i++) {
        for (int axis = 0; axis < 3 && t[i].all > 0; axis++) {
            p->colour[i][axis] = (uint8_t)((t[i].part[axis] + t[i].all / 2) / t[i].all);
        }
    }
}

/* Whether any has another nearest now. */
static int choose_all(palette *p, const shade *s, mark *m) {
    int changed = 0;
    sort_marks(p, m);
    for (uint32_t i = 0; i < p->distinct; i++) {
        const uint16_t index = nearest_of(m, p->count, s[i].colour);
        changed |= index != p->to[s[i].at];
        p->to[s[i].at] = index;
    }
    return changed;
}

/* From what stands for colours now: to the nearest, and to the means of those, by turns. -1: memory
 * is out. */
static int settle_all(palette *p, const shade *s) {
    enum { TURNS = 24, LOOKS = 1 << 23 };
    const uint32_t turns = LOOKS / p->distinct < TURNS ? LOOKS / p->distinct + 1 : TURNS;
    mark *m = heap_get((uint64_t)p->count * sizeof *m);
    total *t = heap_get((uint64_t)p->count * sizeof *t);
    const int status = m == NULL || t == NULL ? -1 : 0;
    for (uint32_t i = 0; i < turns && status == 0 && choose_all(p, s, m); i++) {
        move_all(p, s, t);
    }
    if (status == 0) {
        choose_all(p, s, m);
    }
    heap_drop(m);
    heap_drop(t);
    return status;
}

/* Of `most` boxes. */
static void cut(palette *p, shade *s, box *boxes, uint32_t most, int extent) {
    p->count = split(s, p->distinct, boxes, most, extent);
    for (uint32_t i = 0; i < p->count; i++) {
        settle(p, i, s, &boxes[i]);
    }
    judge(p, s);
}

static int make(palette *p, shade *s, box *boxes, uint32_t *sorted, size_t count, uint32_t near) {
    enum { EXTENT = 3 }; /* means of less than that are within 2 of all, mostly */
    p->distinct = (uint32_t)count_shades(s, sorted, count);
    for (uint32_t i = 0; i < p->distinct; i++) {
        p->from[i] = s[i].colour;
    }
    cut(p, s, boxes, PALETTE_FEW, 0);
    if (p->furthest <= near) {
        return 0;
    }
    cut(p, s, boxes, PALETTE_MANY, p->distinct > PALETTE_MANY ? EXTENT : 0);
    const int status = p->furthest > 0 ? settle_all(p, s) : 0;
    judge(p, s);
    return status;
}

int palette_make(palette *p, const uint32_t *colour, size_t count, uint32_t near) {
    *p = (palette){.count = 1};
    uint32_t *sorted = heap_get(4 * (uint64_t)(count + 1));
    shade *s = heap_get((uint64_t)(count + 1) * sizeof *s);
    box *boxes = heap_get(PALETTE_MANY * sizeof *boxes);
    p->colour = heap_get_zeroed(PALETTE_MANY * sizeof *p->colour);
    p->from = heap_get(4 * (uint64_t)(count + 1));
    p->to = heap_get_zeroed(2 * (uint64_t)(count + 1));
    int status = sorted == NULL || s == NULL || boxes == NULL || p->colour == NULL ||
                         p->from == NULL || p->to == NULL
                     ? -1
                     : 0;
    if (status == 0 && count > 0) {
        memcpy(sorted, colour, 4 * count);
        status = make(p, s, boxes, sorted, count, near);
    }
    heap_drop(sorted);
    heap_drop(s);
    heap_drop(boxes);
    return status;
}

uint32_t palette_index(const palette *p, uint32_t colour) {
    uint32_t low = 0, high = p->distinct;
    while (high - low > 1) {
        const uint32_t middle = low + (high - low) / 2;
        low = p->from[middle] <= colour ? middle : low;
        high = p->from[middle] <= colour ? high : middle;
    }
    return p->to[low];
}

void palette_free(palette *p) {
    heap_drop(p->colour);
    heap_drop(p->from);
    heap_drop(p->to);
    *p = (palette){.count = 0};
}

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

static uint32_t split(shade *s, size_t shades, box *boxes, uint32_t most) {
    static int (*const by[3])(const void *, const void *) = {by_red, by_green, by_blue};
    uint32_t count = 1;
    boxes[0] = box_of(s, 0, shades);
    while (count < most) {
        uint32_t widest = 0;
        for (uint32_t i = 1; i < count; i++) {
            widest = boxes[i].extent > boxes[widest].extent ? i : widest;
        }
        box *b = &boxes[widest];
        if (b->extent == 0) {
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
    uint64_t all = 0;
    for (int axis = 0; axis < 3; axis++) {
        uint64_t sum = 0;
        all = 0;
        for (size_t i = b->begin; i < b->end; i++) {
            sum += s[i].count * (uint64_t)part(s[i].colour, axis);
            all += s[i].count;
        }
        p->colour[index][axis] = (uint8_t)((sum + all / 2) / all);
    }
    for (size_t i = b->begin; i < b->end; i++) {
        p->to[s[i].at] = (uint8_t)index;
        for (int axis = 0; axis < 3; axis++) {
            const int off = abs(part(s[i].colour, axis) - p->colour[index][axis]);
            p->furthest = (uint32_t)off > p->furthest ? (uint32_t)off : p->furthest;
        }
    }
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

int palette_make(palette *p, const uint32_t *colour, size_t count, uint32_t most) {
    box boxes[255];
    *p = (palette){.count = 1};
    uint32_t *sorted = heap_get(4 * (uint64_t)(count + 1));
    shade *s = heap_get((uint64_t)(count + 1) * sizeof *s);
    p->from = heap_get(4 * (uint64_t)(count + 1));
    p->to = heap_get_zeroed((uint64_t)count + 1);
    const int status = sorted == NULL || s == NULL || p->from == NULL || p->to == NULL ? -1 : 0;
    if (status == 0 && count > 0) {
        memcpy(sorted, colour, 4 * count);
        p->distinct = (uint32_t)count_shades(s, sorted, count);
        for (uint32_t i = 0; i < p->distinct; i++) {
            p->from[i] = s[i].colour;
        }
        p->count = split(s, p->distinct, boxes, most < 255 ? most : 255);
        for (uint32_t i = 0; i < p->count; i++) {
            settle(p, i, s, &boxes[i]);
        }
    }
    heap_drop(sorted);
    heap_drop(s);
    return status;
}

uint8_t palette_index(const palette *p, uint32_t colour) {
    uint32_t low = 0, high = p->distinct;
    while (high - low > 1) {
        const uint32_t middle = low + (high - low) / 2;
        low = p->from[middle] <= colour ? middle : low;
        high = p->from[middle] <= colour ? high : middle;
    }
    return p->to[low];
}

void palette_free(palette *p) {
    heap_drop(p->from);
    heap_drop(p->to);
    *p = (palette){.count = 0};
}

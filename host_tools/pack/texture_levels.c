/* texture_levels - see texture_levels.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/texture_levels.h"

#include "engine/base/linear.h"
#include "engine/texture/directory.h"
#include "host_tools/base/heap.h"

static int make(texture_level *l, uint32_t width, uint32_t height) {
    l->light = heap_get(6 * (uint64_t)width * height);
    l->width = l->light != NULL ? width : 0;
    l->height = l->light != NULL ? height : 0;
    return l->light != NULL ? 0 : -1;
}

void texture_level_free(texture_level *l) {
    heap_drop(l->light);
    *l = (texture_level){0, 0, NULL};
}

int texture_level_first(texture_level *l, const picture *p) {
    if (make(l, p->width, p->height) != 0) {
        return -1;
    }
    for (uint64_t i = 0; i < 3 * (uint64_t)p->width * p->height; i++) {
        l->light[i] = plt_linear[p->rgb[i]];
    }
    return 0;
}

/* Texels of a row of `from` that texel i of one of `to` covers, and how much of each: a texel of
 * `from` is `to` wide, one of `to` is `from` wide. */
typedef struct span {
    uint32_t first, end;
    uint64_t at, from, to;
} span;

static span span_of(uint32_t i, uint32_t from, uint32_t to) {
    const uint64_t begin = (uint64_t)i * from, end = begin + from;
    return (span){(uint32_t)(begin / to), (uint32_t)((end + to - 1) / to), begin, from, to};
}

static uint64_t share(const span *s, uint32_t j) {
    const uint64_t begin = j * s->to, end = begin + s->to;
    const uint64_t from = begin > s->at ? begin : s->at;
    const uint64_t to = end < s->at + s->from ? end : s->at + s->from;
    return to - from;
}

/* Sums stay below 2^15 * 2^15 * 2^16. */
static void mean(const texture_level *l, const span *x, const span *y, uint16_t to[3]) {
    uint64_t sum[3] = {0, 0, 0};
    const uint64_t all = x->from * y->from;
    for (uint32_t j = y->first; j < y->end; j++) {
        for (uint32_t i = x->first; i < x->end; i++) {
            const uint16_t *light = &l->light[3 * ((uint64_t)j * l->width + i)];
            const uint64_t weight = share(x, i) * share(y, j);
            for (int c = 0; c < 3; c++) {
                sum[c] += weight * light[c];
            }
        }
    }
    for (int c = 0; c < 3; c++) {
        to[c] = (uint16_t)((sum[c] + all / 2) / all);
    }
}

int texture_level_next(texture_level *l, const texture_level *before) {
    if (make(l, plt_texture_halved(before->width), plt_texture_halved(before->height)) != 0) {
        return -1;
    }
    for (uint32_t y = 0; y < l->height; y++) {
        const span rows = span_of(y, before->height, l->height);
        for (uint32_t x = 0; x < l->width; x++) {
            const span columns = span_of(x, before->width, l->width);
            mean(before, &columns, &rows, &l->light[3 * ((uint64_t)y * l->width + x)]);
        }
    }
    return 0;
}

/* By halving; of two that are as near the lower. */
static uint8_t byte_of(uint16_t light) {
    unsigned low = 0, high = 255;
    while (low < high) {
        const unsigned middle = (low + high) / 2;
        if (2u * light <= (unsigned)plt_linear[middle] + plt_linear[middle + 1]) {
            high = middle;
        } else {
            low = middle + 1;
        }
    }
    return (uint8_t)low;
}

void texture_level_bytes(const texture_level *l, uint32_t x, uint32_t y, uint8_t rgb[3]) {
    const uint32_t column = x < l->width ? x : l->width - 1;
    const uint32_t row = y < l->height ? y : l->height - 1;
    const uint16_t *light = &l->light[3 * ((uint64_t)row * l->width + column)];
    for (int c = 0; c < 3; c++) {
        rgb[c] = byte_of(light[c]);
    }
}

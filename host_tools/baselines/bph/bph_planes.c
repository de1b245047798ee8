/* bph_planes - see bph_planes.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/bph/bph_planes.h"

static void add(bph_planes *b, int axis, int is_max, float at) {
    b->plane[b->count++] = (bph_plane){at, (uint8_t)axis, (uint8_t)is_max};
}

bph_planes bph_planes_of_box(const plt_box *box) {
    bph_planes b = {.count = 0};
    for (int a = 0; a < 3; a++) {
        add(&b, a, 0, box->lo[a]);
        add(&b, a, 1, box->hi[a]);
    }
    return b;
}

bph_planes bph_planes_owned(const plt_node *node, int child) {
    bph_planes b = {.count = 0};
    for (int a = 0; a < 3; a++) {
        for (int is_max = 0; is_max < 2; is_max++) {
            const int is_right = (plt_node_link(node, is_max) & plt_owner_bit(a)) != 0;
            if (is_right == child) {
                add(&b, a, is_max, plt_get_float(&node->word[3 * is_max + a]));
            }
        }
    }
    return b;
}

int bph_planes_cut(const bph_planes *b, const bph_packet *p, uint32_t ray, float *from, float *to) {
    for (uint32_t k = 0; k < b->count; k++) {
        const unsigned a = b->plane[k].axis;
        const int is_near = b->plane[k].is_max == p->negative[a][ray];
        const float org = is_near ? p->early[a][ray] : p->late[a][ray];
        const float t = (b->plane[k].at - org) * p->rdir[a][ray];
        *from = is_near && t > *from ? t : *from;
        *to = !is_near && t < *to ? t : *to;
    }
    return *from <= *to;
}

/* A plane that all rays come to from the same side. */
static void cut_near(float at, const float *early, const float *rdir, uint32_t first, uint32_t last,
                     float *from) {
    for (uint32_t i = first; i <= last; i++) {
        const float t = (at - early[i]) * rdir[i];
        from[i] = t > from[i] ? t : from[i];
    }
}

static void cut_far(float at, const float *late, const float *rdir, uint32_t first, uint32_t last,
                    float *to) {
    for (uint32_t i = first; i <= last; i++) {
        const float t = (at - late[i]) * rdir[i];
        to[i] = t < to[i] ? t : to[i];
    }
}

void bph_planes_cut_all(const bph_planes *b, const bph_packet *p, uint32_t first, uint32_t last,
                        int is_mixed, const bph_intervals *in, bph_intervals *out) {
    if (out != in) {
        const size_t bytes = (last - first + 1) * sizeof(float);
        memcpy(out->from + first, in->from + first, bytes);
        memcpy(out->to + first, in->to + first, bytes);
    }
    for (uint32_t i = first; is_mixed && i <= last; i++) {
        bph_planes_cut(b, p, i, &out->from[i], &out->to[i]);
    }
    for (uint32_t k = 0; !is_mixed && k < b->count; k++) {
        const unsigned a = b->plane[k].axis;
        if (b->plane[k].is_max == p->negative[a][0]) {
            cut_near(b->plane[k].at, p->early[a], p->rdir[a], first, last, out->from);
        } else {
            cut_far(b->plane[k].at, p->late[a], p->rdir[a], first, last, out->to);
        }
    }
}

bph_set bph_intervals_left(const bph_intervals *of, const bph_set *rays) {
    bph_set left = {{0}};
    for (uint32_t w = 0; w < BPH_WORDS; w++) {
        for (uint64_t rest = rays->word[w]; rest != 0; rest &= rest - 1) {
            const uint32_t i = 64 * w + (uint32_t)__builtin_ctzll(rest);
            left.word[w] |= (uint64_t)(of->from[i] <= of->to[i]) << i % 64;
        }
    }
    return left;
}

/* The least and the greatest product of two intervals. */
static void multiply(float bounds[2], const float x[2], const float y[2]) {
    bounds[0] = bounds[1] = x[0] * y[0];
    for (int i = 1; i < 4; i++) {
        const float xy = x[i & 1] * y[i >> 1];
        bounds[0] = xy < bounds[0] ? xy : bounds[0];
        bounds[1] = xy > bounds[1] ? xy : bounds[1];
    }
}

/* Rounding is monotone, so no ray's distance is outside of the bounds. */
int bph_planes_miss(const bph_planes *b, const bph_packet *p) {
    float from = p->tmin_least, to = p->limit_most;
    for (uint32_t k = 0; k < b->count; k++) {
        const unsigned a = b->plane[k].axis;
        const int is_near = b->plane[k].is_max == p->negative[a][0];
        const bph_hull_axis *h = &p->hull[a];
        const float *org = is_near ? h->early : h->late;
        const float way[2] = {b->plane[k].at - org[1], b->plane[k].at - org[0]};
        float t[2];
        multiply(t, way, h->rdir);
        from = is_near && t[0] > from ? t[0] : from;
        to = !is_near && t[1] < to ? t[1] : to;
    }
    return from > to;
}

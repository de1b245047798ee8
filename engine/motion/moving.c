/* moving - see moving.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/motion/moving.h"

/* Rounded once: a 64-bit conversion would be a function of the compiler's. */
static float float_of(uint64_t x) {
    return (float)(uint32_t)(x >> 32) * 4294967296.0f + (float)(uint32_t)x;
}

static float change_of(uint64_t now, uint64_t built) {
    const uint64_t change = now >= built ? now - built : built - now;
    const float size = built == 0 ? 0.0f : float_of(change) / float_of(built);
    return now >= built ? size : -size;
}

float plt_degradation(const plt_moving *m) {
    return change_of(m->areas.ratios, m->areas_built.ratios);
}

float plt_growth(const plt_moving *m) {
    return change_of(m->areas.sum, m->areas_built.sum);
}

#if PLT_WITH_REBUILD
#if PLT_WITH_SUBTREES
float plt_subtree_degradation(const plt_subtree *p) {
    return change_of(p->ratios, p->ratios_built);
}

/* As of a whole tree: of all areas that rays meet, those that it would not have, built anew. */
uint64_t plt_subtree_excess(const plt_moving *m, const plt_subtree *p, uint64_t work) {
    if (p->sum <= p->sum_built) {
        return p->excess;
    }
    const float worse = 0.01f * (float)PLT_GROWTH_WORK * float_of(p->sum - p->sum_built);
    const float share = worse / float_of(m->areas.sum);
    const float most = share < 1.0f ? share : 1.0f;
    return p->excess + ((work * (uint32_t)(int32_t)(most * 65536.0f)) >> 16);
}

static float growth_per_triangle(const plt_subtree *p) {
    return (float_of(p->sum) - float_of(p->sum_built)) / (float)(int32_t)p->count;
}

plt_subtree *plt_moving_worst(const plt_moving *m, uint64_t work) {
    const plt_subtrees *s = &m->subtrees;
    plt_subtree *worst = NULL;
    float most = 0.0f;
    for (plt_subtree *p = s->at; p < s->at + s->count; p++) {
        const float excess = float_of(plt_subtree_excess(m, p, work)) / (float)(int32_t)p->count;
        if (worst == NULL || excess > most ||
            (excess == most && growth_per_triangle(p) > growth_per_triangle(worst))) {
            worst = p;
            most = excess;
        }
    }
    return worst;
}

static void count_in_subtrees(plt_moving *m, uint64_t work) {
    for (plt_subtree *p = m->subtrees.at; p < m->subtrees.at + m->subtrees.count; p++) {
        p->excess = plt_subtree_excess(m, p, work);
    }
}
#else
static void count_in_subtrees(plt_moving *m, uint64_t work) {
    (void)m;
    (void)work;
}
#endif

/* Excess is a share of the work that was done, in 1/65,536. */
void plt_moving_count(plt_moving *m, uint64_t work) {
    count_in_subtrees(m, work);
    const float worse = 0.01f * (float)PLT_GROWTH_WORK * plt_growth(m);
    if (worse > 0.0f) {
        const float share = worse / (1.0f + worse);
        m->excess += (work * (uint32_t)(int32_t)(share * 65536.0f)) >> 16;
    }
}
#endif

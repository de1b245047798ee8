/* kd_sample - see kd_sample.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/baselines/kd/kd_sample.h"

#include <math.h>

enum { EVEN = 8, MORE = 8, PLACES = EVEN + MORE + 2 + 2 }; /* + 2: whole registers */

/* The cost along an axis at some places in order, the first and the last being the cell's sides. */
typedef struct samples {
    kd_areas areas;
    float at[PLACES];
    uint32_t begun[PLACES], ended[PLACES]; /* boxes that begin, or end, after place i - 1 and up to
                                            * place i */
    float low[PLACES], high[PLACES];       /* boxes that reach below, or above, place i */
    float least, most;                     /* where the first box begins, and the last ends */
    int count;
} samples;

/* The first place that is not below x. As many compares for every x, without a jump. */
static inline int place_of(const samples *s, float x) {
    int below = 0;
    for (int i = 0; i < PLACES; i++) {
        below += s->at[i] < x;
    }
    return below;
}

static void count_boxes(samples *s, const kd_cell *c, int axis) {
    s->least = s->areas.hi;
    s->most = s->areas.lo;
    for (int i = 0; i < s->count; i++) {
        s->begun[i] = s->ended[i] = 0;
    }
    for (uint32_t i = 0; i < c->count; i++) {
        const float lo = c->reference[i].lo[axis], hi = c->reference[i].hi[axis];
        s->least = fminf(s->least, lo);
        s->most = fmaxf(s->most, hi);
        s->begun[place_of(s, lo)]++;
        s->ended[place_of(s, hi)]++;
    }
    uint32_t low = 0, high = c->count;
    for (int i = 0; i < s->count; i++) {
        low += s->begun[i];
        s->low[i] = (float)low;
        high -= s->ended[i];
        s->high[i] = (float)high;
    }
}

/* Those that are not there are below nothing, and nor is the last. */
static void end_places(samples *s) {
    s->at[s->count - 1] = s->areas.hi;
    for (int i = s->count; i < PLACES; i++) {
        s->at[i] = INFINITY;
    }
}

static void even_places(samples *s) {
    s->count = EVEN + 2;
    for (int i = 0; i < s->count; i++) {
        const float share = (float)i / (float)(s->count - 1);
        s->at[i] = s->areas.lo + share * (s->areas.hi - s->areas.lo);
    }
    end_places(s);
}

/* How many boxes begin or end up to place i. */
static float changes_before(const samples *s, int i, uint32_t count) {
    return s->low[i] + ((float)count - s->high[i]);
}

/* Between places that are there, so that as many boxes begin and end from one to the next. */
static void more_places(samples *s, uint32_t count) {
    float at[PLACES];
    int places = 0, next = 1;
    const float first = changes_before(s, 0, count);
    const float each = (changes_before(s, s->count - 1, count) - first) / (MORE + 1);
    for (int i = 1; i < s->count; i++) {
        const float from = changes_before(s, i - 1, count), to = changes_before(s, i, count);
        at[places++] = s->at[i - 1];
        for (; next <= MORE && first + (float)next * each < to; next++) {
            const float share = fmaxf(0.0f, (first + (float)next * each - from) / (to - from));
            const float x = s->at[i - 1] + share * (s->at[i] - s->at[i - 1]);
            if (x > at[places - 1] && x < s->at[i]) {
                at[places++] = x;
            }
        }
    }
    at[places++] = s->areas.hi;
    for (int i = 0; i < places; i++) {
        s->at[i] = at[i];
    }
    s->count = places;
    end_places(s);
}

/* Between place i - 1 and i counts are linear and areas, too. Takes the place of the least cost. */
static void take_between(const samples *s, int i, int axis, kd_cut *best) {
    const kd_areas *a = &s->areas;
    const float from = s->at[i - 1], width = s->at[i] - from;
    const float low = s->low[i - 1], more = s->low[i] - low;
    const float high = s->high[i - 1], fewer = s->high[i] - high;
    const float below = a->face + (from - a->lo) * a->around;
    const float above = a->face + (a->hi - from) * a->around;
    /* cost * whole = .. + x linear + x x square, x being 0 to 1 */
    const float grows = width * a->around;
    const float square = grows * (more - fewer);
    const float linear = below * more + grows * low + above * fewer - grows * high;
    if (square > 0.0f) {
        const float x = -0.5f * linear / square;
        if (x > 0.0f && x < 1.0f) {
            kd_cut_take(best, a, axis, from + x * width, low + x * more, high + x * fewer);
        }
    }
    kd_cut_take(best, a, axis, s->at[i], s->low[i], s->high[i]);
}

static void sample_axis(const kd_cell *c, int axis, kd_cut *best) {
    samples s = {.areas = kd_areas_of(c, axis)};
    if (!(s.areas.hi > s.areas.lo)) {
        return;
    }
    even_places(&s);
    count_boxes(&s, c, axis);
    more_places(&s, c->count);
    count_boxes(&s, c, axis);
    for (int i = 1; i < s.count; i++) {
        take_between(&s, i, axis, best);
    }
    kd_cut_take(best, &s.areas, axis, s.least, 0.0f, (float)c->count); /* empty space is exact */
    kd_cut_take(best, &s.areas, axis, s.most, (float)c->count, 0.0f);
}

/* What the cut really costs. */
static kd_cut counted(const kd_cell *c, const kd_cut *cut) {
    const kd_areas areas = kd_areas_of(c, cut->axis);
    kd_cut best = kd_cost_of_leaf(c);
    uint32_t low = 0, high = 0;
    for (uint32_t i = 0; i < c->count; i++) {
        low += c->reference[i].lo[cut->axis] < cut->at;
        high += c->reference[i].hi[cut->axis] > cut->at;
    }
    kd_cut_take(&best, &areas, cut->axis, cut->at, (float)low, (float)high);
    return best;
}

kd_cut kd_sample(const kd_cell *c) {
    kd_cut best = kd_cost_of_leaf(c);
    for (int a = 0; a < 3; a++) {
        sample_axis(c, a, &best);
    }
    return best.is_cut ? counted(c, &best) : best;
}

/* footprint - the pixels of a square that a triangle may cover
 *
 * Of one that is projected. Inline for those who project triangles: footprint_corners.h has float
 * corners, beam_strips.c the strips of compact blocks.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_SHADE_FOOTPRINT_H
#define PLT_SHADE_FOOTPRINT_H

#include "engine/shade/footprint_edges.h"
#if PLT_WITH_SAMPLES
#include "engine/shade/footprint_samples.h"
#endif

/* One that may cover a single pixel. */
static inline int is_single(const projected *p) {
    return p->columns.last - p->columns.before == 1 && p->rows.last - p->rows.before == 1;
}

/* One that covers whole pixels of samples. */
static inline int is_large(const plt_beam *b, const projected *p) {
#if PLT_WITH_SAMPLES
    const uint32_t across = b->view->across;
    return across > 1 && p->size > PLT_LARGE_SIZE * (float)(int32_t)across;
#else
    (void)b;
    (void)p;
    return 0;
#endif
}

PLT_INLINED void test_single(plt_beam *b, candidate *c, projected *p) {
    const uint32_t x = (uint32_t)(p->columns.last - PLT_LINE_NUMBER);
    const uint32_t y = (uint32_t)(p->rows.last - PLT_LINE_NUMBER);
    footprint f;
    set_at_pixel(&f, p, b, x, y);
    set_edges(&f, p, &b->margins);
    if (!is_outside(&f, f.at)) {
        test_inside(b, c, p, &f, f.at, x, y);
    }
}

PLT_INLINED rectangle rectangle_of(const plt_beam *b, const projected *p) {
    const rectangle r = {plt_lines_first(p->columns), plt_lines_last(p->columns, b->end_x),
                         plt_lines_first(p->rows), plt_lines_last(p->rows, b->end_y)};
    return r;
}

PLT_INLINED void test_rectangle(plt_beam *b, candidate *c, projected *p, const rectangle *r) {
    footprint f;
    steps s;
    set_at_pixel(&f, p, b, r->left, r->top);
    set_edges(&f, p, &b->margins);
    set_steps(&s, b, p);
    test_all(b, c, p, r, &s, &f);
}

/* The pixels of a triangle that is projected. `apart`: one that may cover a single pixel goes a way
 * of its own, for 560 bytes. */
PLT_INLINED void test_footprint(plt_beam *b, candidate *c, projected *p, int apart) {
    if (apart && is_single(p)) {
        test_single(b, c, p);
        return;
    }
    const rectangle r = rectangle_of(b, p);
#if PLT_WITH_SAMPLES
    if (is_large(b, p)) {
        if (!test_pixels(b, c, p, &r)) {
            plt_beam_test_samples(b, record_of(b, c), &r);
        }
        return;
    }
#endif
    test_rectangle(b, c, p, &r);
}

#endif

/* beam_sight - boxes that a pixel of a square may see
 *
 * A box is projected as a triangle is (footprint.h): all triangles in it lie between its corners,
 * and so do their pixels. Margins: DESIGN.md, section 7.7.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/footprint.h"

/* To look at a box costs a third of what is saved if it is hidden. So a look is worth it where one
 * in three is; where fewer are, it is tried again after some that were not looked at. */
enum { DOUBT_GAIN = 2, DOUBT_MOST = 6, DOUBT_PAUSE = 12 };

/* The least and the greatest that a row of the projection gives in a box: at two of its corners, as
 * rounding is monotone, in the products and in their sum. */
static range along_box(const float lo[3], const float hi[3], const float row[3]) {
    float near[3], far[3];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        near[a] = row[a] > 0.0f ? lo[a] : hi[a];
        far[a] = row[a] > 0.0f ? hi[a] : lo[a];
    }
    const range r = {plt_along(near, row), plt_along(far, row)};
    return r;
}

/* From w x and w, which is positive, to the lines at x. */
static inline plt_lines divided(range wx, float nearest, float farthest, float margin) {
    const float least = wx.least > 0.0f ? wx.least * farthest : wx.least * nearest;
    const float most = wx.most > 0.0f ? wx.most * nearest : wx.most * farthest;
    return plt_lines_between(least + (PLT_LINE_FIRST - margin), most + (PLT_LINE_FIRST + margin),
                             1);
}

/* Columns and rows that a box may reach. 0: some of it is not deep in front. */
static int project_box(const plt_beam *b, const plt_box *box, plt_lines *x, plt_lines *y) {
    const float margin = plt_margins_reach(&b->margins);
    float lo[3], hi[3];
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        lo[a] = box->lo[a] - b->origin.org[a];
        hi[a] = box->hi[a] - b->origin.org[a];
    }
    const range w = along_box(lo, hi, b->margins.row_w);
    if (!(w.least >= b->margins.depth)) {
        return 0;
    }
    const float nearest = 1.0f / w.least, farthest = 1.0f / w.most;
    *x = divided(along_box(lo, hi, b->box_x), nearest, farthest, margin);
    *y = divided(along_box(lo, hi, b->box_y), nearest, farthest, margin);
    return 1;
}

/* A beam of one ray: may the pixel have a hit in the box? */
static int pixel_meets(const plt_beam *b, uint32_t x, uint32_t y, const plt_box *box, float t) {
    plt_beam_entry in = {0.0f, -PLT_VIEW_FAR, 0};
    plt_beam_plane plane[6];
    plt_beam_range r[3];
    float dir[3];
    plt_view_direction(b->view, b->square.x + x, b->square.y + y, dir);
    for (int a = 0; a < 3; a++) {
        r[a].least = r[a].most = dir[a];
    }
    if (!plt_beam_planes(plane, &b->origin, r)) {
        return 0;
    }
    for (int a = 0; a < 3; a++) {
        plt_beam_bound(&in, &plane[a], box->lo[a]);
        plt_beam_bound(&in, &plane[3 + a], box->hi[a]);
    }
    return in.enter <= -in.minus_leave && in.enter <= t;
}

/* Does a pixel of a rectangle, both ends included, meet the box, which begins at `enter`? */
static int some_meets(const plt_beam *b, const uint32_t column[2], const uint32_t row[2],
                      const plt_box *box, float enter) {
    for (uint32_t y = row[0]; y <= row[1]; y++) {
        const plt_pixel *p = &b->pixel[y * b->square.side];
        for (uint32_t x = column[0]; x <= column[1]; x++) {
            if (p[x].t >= enter && pixel_meets(b, x, y, box, p[x].t)) {
                return 1;
            }
        }
    }
    return 0;
}

int plt_beam_sees(const plt_beam *b, const plt_beam_block_entry *e) {
    uint32_t column[2] = {0, b->columns - 1}, row[2] = {0, b->rows - 1};
    plt_box box;
    plt_lines x, y;
    PLT_UNROLLED for (int a = 0; a < 3; a++) {
        box.lo[a] = plt_lattice_float(&b->tree->lattice, a, e->lo[a]);
        box.hi[a] = plt_lattice_float(&b->tree->lattice, a, e->hi[a]);
    }
    if (b->margins.project && project_box(b, &box, &x, &y)) {
        if (!plt_lines_any(x, b->end_x) || !plt_lines_any(y, b->end_y)) {
            return 0;
        }
        column[0] = plt_lines_first(x);
        column[1] = plt_lines_last(x, b->end_x);
        row[0] = plt_lines_first(y);
        row[1] = plt_lines_last(y, b->end_y);
        if (column[1] - column[0] == b->columns - 1 && row[1] - row[0] == b->rows - 1) {
            return 1; /* what lies in it may be hidden, hardly the box */
        }
    }
    return some_meets(b, column, row, &box, e->enter);
}

int plt_beam_hides(const plt_beam *b, int8_t *doubt, const plt_beam_block_entry *e) {
    if (*doubt < 0) {
        ++*doubt;
        return 0;
    }
    if (plt_beam_sees(b, e)) {
        *doubt = (int8_t)(*doubt > 0 ? *doubt - 1 : -DOUBT_PAUSE);
        return 0;
    }
    *doubt = (int8_t)(*doubt < DOUBT_MOST ? *doubt + DOUBT_GAIN : DOUBT_MOST);
    return 1;
}

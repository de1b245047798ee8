/* beam - see beam.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/shade/beam.h"

#include "engine/shade/lines.h"
#include "engine/trace/triangle_common.h"

static void set_records(plt_beam *b, const plt_scene *scene, uint32_t side) {
#if PLT_BEAMS_STORE
    if (plt_has_store(scene->format)) {
        b->store = (plt_record *)(void *)(b->pixel + (size_t)side * side);
        b->records = plt_has_blocks(scene->format) && scene->compact.leaf_kind != PLT_LEAF_STRIPS
                         ? scene->compact.records
                         : b->store;
        return;
    }
#endif
    (void)side;
#if PLT_WITH_GRID
    if (scene->format == PLT_FORMAT_GRID) {
        b->records = scene->gridded.records;
        return;
    }
#endif
    b->records = scene->format == PLT_FORMAT_LIST ? scene->list.records : scene->thesis.records;
}

void plt_beam_init(plt_beam *b, const plt_view *view, const plt_frame *frame,
                   const plt_scene *scene, uint32_t side) {
    b->view = view;
    b->pixel = (plt_pixel *)(void *)(b + 1);
    b->node_doubt = b->leaf_doubt = 0;
    set_records(b, scene, side);
    plt_ray_origin_set(&b->origin, &scene->box, view->eye);
    plt_margins_set(&b->margins, view, frame, side, &scene->box, b->origin.reach);
}

static void widen(plt_beam_range *r, float x) {
    r->least = x < r->least ? x : r->least;
    r->most = x > r->most ? x : r->most;
}

/* The box of all directions: rounding is monotone, so its corners are directions of the
 * pixels at the square's corners. */
static void set_ranges(const plt_beam *b, plt_beam_range r[3]) {
    const plt_view *v = b->view;
    const uint32_t x_last = b->square.x + b->columns - 1, y_last = b->square.y + b->rows - 1;
    for (int a = 0; a < 3; a++) {
        const float left = v->corner[a] + plt_view_least(v, (float)b->square.x) * v->right[a];
        const float right = v->corner[a] + plt_view_most(v, (float)x_last) * v->right[a];
        const float top = plt_view_least(v, (float)b->square.y) * v->down[a];
        const float bottom = plt_view_most(v, (float)y_last) * v->down[a];
        r[a].least = r[a].most = left + top;
        widen(&r[a], left + bottom);
        widen(&r[a], right + top);
        widen(&r[a], right + bottom);
    }
}

static int set_beam(plt_beam *b) {
    plt_beam_range r[3];
    set_ranges(b, r);
    b->is_mixed = 0;
    for (int a = 0; a < 3; a++) {
        b->is_mixed |= r[a].least < 0.0f && r[a].most >= 0.0f;
    }
    return plt_beam_planes(b->plane, &b->origin, r);
}

static void set_rows(plt_beam *b) {
    const plt_view *v = b->view;
    const float scale = 1.0f / b->margins.det;
    plt_view_point(v, (float)b->square.x, (float)b->square.y, b->first);
    plt_cross(v->down, b->first, b->row_x);
    plt_cross(b->first, v->right, b->row_y);
    for (int a = 0; a < 3; a++) {
        const float w = b->margins.bias * b->margins.row_w[a];
        b->row_x[a] *= scale;
        b->row_y[a] *= scale;
#if PLT_WITH_COMPACT
        b->box_x[a] = b->row_x[a];
        b->box_y[a] = b->row_y[a];
#endif
        b->row_x[a] += w;
        b->row_y[a] += w;
    }
}

static uint32_t least(uint32_t a, uint32_t b) {
    return a < b ? a : b;
}

static void open_pixels(plt_beam *b) {
    static const plt_pixel open = {PLT_VIEW_FAR, PLT_MISS};
    plt_pixel *end = b->pixel + b->square.side * b->rows;
    for (plt_pixel *p = b->pixel; p < end; p += 2) {
        p[0] = open;
        p[1] = open;
    }
}

void plt_beam_begin(plt_beam *b, const plt_pixels *square, plt_traversal *t, uint32_t rays) {
    b->square = *square;
    b->columns = least(square->side, square->x_end - square->x);
    b->rows = least(square->side, square->y_end - square->y);
    b->end_x = (int32_t)(b->columns - 1) + PLT_LINE_NUMBER;
    b->end_y = (int32_t)(b->rows - 1) + PLT_LINE_NUMBER;
    b->far = PLT_VIEW_FAR;
    b->open = b->columns * b->rows;
    b->is_stored = 0;
#if PLT_BEAMS_STORE
    b->next = 0;
#endif
#if PLT_BEAMS_STORE && PLT_WITH_PAGES
    b->index =
        t->scene->surface.is_paged && b->records == b->store ? (uint32_t *)(void *)t->kept : NULL;
#endif
    t->waiting = 0;
    if (set_beam(b)) {
        plt_beam_push_root(b, t);
    }
    if (t->waiting > 0) {
        set_rows(b);
        open_pixels(b);
    }
    t->stats.rays += rays;
    t->stats.packets++;
    t->stats.mixed_packets += b->is_mixed;
}

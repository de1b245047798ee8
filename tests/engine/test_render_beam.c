/* test_render_beam - pixels traced as beams have the hits of plt_trace
 *
 * Of every pixel t, bit for bit once it is settled, and the triangle, so that ties count; and
 * before that t is no less, and hardly more: for cameras anywhere, of any field of view and size,
 * in every size of square, also where it is cropped. Random cameras hardly find a margin that is
 * missing (DESIGN.md, section 7.7); views straight down on grids do, whose corners and edges lie
 * on pixels. Scenes are of thesis nodes, and the same of compact blocks. Broken on purpose, so many
 * frames differ of 646 cameras, 384 views on grids, 384 by bounds and 320 of sheets that cross
 * (PLANELET_COUNT=1 prints it):
 *
 *   margins.pixels and edge = 0      0    159    156      0
 *   margins.pixels * 0.03            0      0      0      0
 *   margins.edge = 0                 0    174    175      1
 *   margins.edge * 0.1               0      0      0      0
 *   margins.lines = 1                0     49     50      1
 *   slack_of returns 0             314    334    364    249
 *   slack_of * 0.05                  0      0      0      0
 *   margins.plane = 0                0      9      1      0
 *   taken at 0, not at the error     0      0     24      0
 *   taken without slack            301      0    332    225
 *   NEARER = 1                      28    148      0     33
 *   far: the last pixel's t         17      0      0      5
 *   ties are always won             58    384    328      0
 *   corners turned, depths not     231      0      0    121
 *   and of compact blocks alone
 *   margins.pixels and edge = 0      1    161    151      1
 *   slack_of returns 0             315    350    373    248
 *   records given out while in use  32     76     59     36
 *   corners not in canonical order 262      0      0    145
 *
 * What no frame shows is in test_lines.c.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/engine.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/random.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { SIDE_MOST = 72 };

typedef struct tracer {
    rig r;
    struct {
        plt_beam beam;
        plt_pixel pixels[PLT_PACKET_SIDE_MAX * PLT_PACKET_SIDE_MAX];
        plt_record store[PLT_PACKET_SIDE_MAX * PLT_PACKET_SIDE_MAX * 3 / 2]; /* of strips */
    } memory;
    plt_beam *beam;
    plt_view view;
    plt_ray rays[PLT_PACKET_SIDE_MAX * PLT_PACKET_SIDE_MAX];
    plt_hit hits[PLT_PACKET_SIDE_MAX * PLT_PACKET_SIDE_MAX];
} tracer;

static uint32_t frames_seen, frames_wrong;
static uint64_t pixels_hit, pixels_bound; /* bound: taken without the exact test */

/* What scenes are of. */
static enum { NODES, STRIPS, BLOCKS_OF_RECORDS, STREAMED, GRIDS } kind;

/* Boxes are looked at wherever that may be, and not only where it pays. */
static int looks;

static int compact_opened(rig *r, const mesh *m, uint32_t leaf) {
    compact_config config = compact_config_of(leaf, 21, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    config.pack.floats = kind == BLOCKS_OF_RECORDS;
    config.run.residency = kind == STREAMED ? PLT_RESIDENCY_STREAMED : PLT_RESIDENCY_WHOLE;
    return compact_open(r, m, &config);
}

/* Bytes per triangle that an arena has beside a grid's need: cells are fewer or more. */
static size_t spare;

static int grid_opened(rig *r, const mesh *m, uint32_t leaf, uint8_t build) {
    rig_config config = rig_config_of(leaf, 16, build, PLT_SPLIT_SAH);
    config.run.structure = PLT_STRUCTURE_GRID;
    const int status = rig_open_spare(r, m, &config, 1000 + spare * m->triangles);
    spare = spare == 100 ? 4 : spare == 4 ? 16 : 100;
    return status;
}

static void opened(tracer *t, const mesh *m, uint32_t leaf, uint8_t build) {
    if (kind == GRIDS) {
        const int status = grid_opened(&t->r, m, leaf, build);
        CHECK(status == PLT_OK || status == PLT_ERR_LIMIT, "%s", t->r.fault.message);
        return;
    }
    if (kind != NODES && build == PLT_BUILD_HOST) {
        const int status = compact_opened(&t->r, m, leaf);
        CHECK(status == PLT_OK || status == PLT_ERR_LIMIT, "%s", t->r.fault.message);
        return;
    }
    const rig_config config = rig_config_of(leaf, 16, build, PLT_SPLIT_SAH);
    const int status = rig_open(&t->r, m, &config);
    CHECK(status == PLT_OK || (status == PLT_ERR_LIMIT && rig_is_tiny()), "%s", t->r.fault.message);
}

static void set_rays(tracer *t, const plt_pixels *s, uint32_t columns, uint32_t rows) {
    for (uint32_t i = 0; i < columns * rows; i++) {
        plt_ray *ray = &t->rays[i];
        memcpy(ray->org, t->view.eye, sizeof ray->org);
        plt_view_direction(&t->view, s->x + i % columns, s->y + i / columns, ray->dir);
        ray->tmin = 0.0f;
        ray->tmax = PLT_VIEW_FAR;
    }
}

/* Makes t exact, and says whether it was no less, and not more than it may be. */
static int settled(tracer *t, uint32_t x, uint32_t y) {
    const plt_pixel *pixel = &t->beam->pixel[y * t->beam->square.side + x];
    const plt_pixel before = *pixel;
    plt_beam_settle(t->beam, x, y);
    pixels_bound += before.record != pixel->record;
    return before.record == pixel->record
               ? before.t == pixel->t
               : before.t >= pixel->t && pixel->t >= (1.0f - PLT_PIXEL_SLACK) * before.t;
}

/* Pixels of the square that differ. */
static uint32_t compare(tracer *t, uint32_t columns, uint32_t rows) {
    uint32_t wrong = 0;
    for (uint32_t i = 0; i < columns * rows; i++) {
        const plt_pixel *pixel = &t->beam->pixel[i / columns * t->beam->square.side + i % columns];
        const plt_hit *hit = &t->hits[i];
        uint32_t id = plt_beam_is_empty(t->beam) ? PLT_MISS : pixel->record;
        int is_settled = 1;
        if (id != PLT_MISS) {
            is_settled = settled(t, i % columns, i / columns);
            id = plt_primitive_id(plt_get_u32(&t->beam->records[pixel->record].word[9]));
            pixels_hit++;
        }
        wrong += id != hit->triangle || !is_settled ||
                 (id != PLT_MISS && memcmp(&pixel->t, &hit->t, sizeof hit->t) != 0);
    }
    return wrong;
}

static uint32_t one_square(tracer *t, const plt_pixels *s) {
    const uint32_t columns = s->x_end - s->x < s->side ? s->x_end - s->x : s->side;
    const uint32_t rows = s->y_end - s->y < s->side ? s->y_end - s->y : s->side;
    plt_beam_begin(t->beam, s, &t->r.engine->traversal, columns * rows);
    do {
        t->beam->node_doubt = looks ? 1 : t->beam->node_doubt;
        t->beam->leaf_doubt = looks ? 1 : t->beam->leaf_doubt;
    } while (plt_beam_trace(t->beam, &t->r.engine->traversal, looks ? 1 : 3) == PLT_MORE);
    set_rays(t, s, columns, rows);
    plt_trace(t->r.engine, t->rays, t->hits, columns * rows, 0);
    return compare(t, columns, rows);
}

/* Two frames of three are of samples: 4 per pixel of a small frame, or 16. */
static uint32_t refined(tracer *t, const plt_frame *f, uint32_t side) {
#if PLT_WITH_SAMPLES
    const uint32_t across = 1u << frames_seen % 3;
    if (across <= side && (uint32_t)f->width * f->height <= SIDE_MOST * SIDE_MOST) {
        plt_view_refine(&t->view, across);
    }
#else
    (void)f;
    (void)side;
#endif
    return plt_view_across(&t->view);
}

/* `what`: for messages. */
static void one_frame(tracer *t, const plt_frame *f, uint32_t side, const char *what) {
    if (t->r.engine == NULL || plt_view_set(&t->view, f) != PLT_OK) {
        return;
    }
    uint32_t wrong = 0;
    const uint32_t across = refined(t, f, side), width = across * f->width;
    const uint32_t height = across * f->height;
    t->beam = &t->memory.beam;
    plt_beam_init(t->beam, &t->view, f, &t->r.engine->scene, side);
    for (uint32_t y = 0; y < height; y += side) {
        for (uint32_t x = 0; x < width; x += side) {
            const plt_pixels square = {side, x, y, width, height};
            wrong += one_square(t, &square);
        }
    }
    frames_seen++;
    frames_wrong += wrong > 0;
    CHECK(wrong == 0, "%s: %u pixels of %u x %u, squares of %u, %u across", what, wrong, width,
          height, side, across);
}

static uint32_t any_side(random_state *r) {
    const uint32_t side = 2u << random_below(r, 4);
    return side < PLT_PACKET_SIDE_MAX ? side : PLT_PACKET_SIDE_MAX;
}

/* ---- cameras anywhere ------------------------------------------------------------ */

static plt_frame any_frame(random_state *r, float scale, const float middle[3]) {
    plt_frame f = {.width = (uint16_t)(1 + random_below(r, SIDE_MOST)),
                   .height = (uint16_t)(1 + random_below(r, SIDE_MOST))};
    const float away = random_below(r, 3) ? 3.0f : 0.9f; /* outside, or inside */
    for (int a = 0; a < 3; a++) {
        f.camera.eye[a] = middle[a] + scale * away * random_float(r, -1.0f, 1.0f);
        f.camera.look[a] = middle[a] + scale * random_float(r, -0.5f, 0.5f);
    }
    f.camera.up[random_below(r, 3)] = 1.0f;
    if (random_below(r, 4) == 0) { /* along an axis */
        const unsigned axis = random_below(r, 3);
        for (unsigned a = 0; a < 3; a++) {
            f.camera.look[a] = a == axis ? f.camera.look[a] : f.camera.eye[a];
            f.camera.up[a] = a == (axis + 1) % 3;
        }
    }
    f.camera.tan_half_fov = tanf(random_float(r, 0.09f, 1.05f)); /* 10 to 120 degrees */
    return f;
}

/* Some of the eyes over a grid are where planes of cells are, on one axis or all. */
static void move_to_planes(const tracer *t, plt_frame *f, random_state *r) {
    const unsigned axes = random_below(r, 8);
    if (kind != GRIDS || t->r.engine == NULL) {
        return;
    }
    const plt_grid_level *top = &t->r.engine->scene.gridded.grid->top;
    for (unsigned a = 0; a < 3; a++) {
        if ((axes >> a & 1u) != 0) {
            const uint32_t plane = random_below(r, top->cells[a] + 1);
            const float to = top->lo[a] + (float)plane * top->size[a];
            f->camera.look[a] += to - f->camera.eye[a];
            f->camera.eye[a] = to;
        }
    }
}

static void cameras(const mesh *m, uint32_t frames, float scale, const float middle[3],
                    const char *what) {
    random_state r = {frames};
    static tracer t;
    for (uint32_t leaf = 1; leaf <= 4; leaf *= 4) {
        opened(&t, m, leaf, PLT_BUILD_HOST);
        for (uint32_t i = 0; i < frames; i++) {
            plt_frame f = any_frame(&r, scale, middle);
            move_to_planes(&t, &f, &r);
            one_frame(&t, &f, any_side(&r), what);
        }
        rig_close(&t.r);
    }
}

static void anywhere(void) {
    static const float middle[3] = {0, 0, 0}, far[3] = {1000, -500, 300};
    mesh m = {0};
    shape_soup(&m, rig_triangles(300, 1), 0.4f, 1);
    cameras(&m, 40, 1.0f, middle, "large triangles");
    mesh_free(&m);
    shape_soup(&m, rig_triangles(4000, 1), 0.04f, 2);
    cameras(&m, 40, 1.0f, middle, "small triangles");
    shape_transform(&m, 0x1p35f, 0, 0, 0);
    cameras(&m, 20, 0x1p35f, middle, "triangles of 2^30");
    mesh_free(&m);
    shape_soup(&m, rig_triangles(12, 1), 0.3f, 3); /* few: integers decide all of them */
    shape_transform(&m, 0x1p-70f, 0, 0, 0);
    cameras(&m, 3, 0x1p-70f, middle, "triangles of 2^-72");
    mesh_free(&m);
    shape_cube(&m);
    cameras(&m, 60, 1.0f, middle, "a room");
    shape_transform(&m, 1.0f, far[0], far[1], far[2]);
    cameras(&m, 40, 1.0f, far, "a room far from the origin");
    mesh_free(&m);
    shape_icosphere(&m, rig_is_tiny() ? 1 : 3);
    cameras(&m, 40, 1.0f, middle, "a sphere");
    mesh_free(&m);
    shape_needles(&m, rig_triangles(200, 1) / 4);
    cameras(&m, 40, 1.0f, middle, "slivers");
    mesh_free(&m);
    shape_coincident(&m, 5);
    shape_degenerate(&m);
    shape_exponential(&m, rig_triangles(40, 1));
    cameras(&m, 40, 1.0f, middle, "odd triangles");
    mesh_free(&m);
}

/* A soup in a hall: one cell has nearly all triangles, and a level of its own. */
static void crowds(void) {
    static const float middle[3] = {0.3f, 0.0f, -0.2f};
    static tracer t;
    random_state r = {11};
    mesh m = {0};
    shape_soup(&m, rig_triangles(2000, 1), 0.2f, 4);
    shape_transform(&m, 0.01f, 0.3f, 0.01f, -0.2f);
    shape_sheet(&m, rig_is_tiny() ? 2 : 8, 1);
    spare = 100;
    opened(&t, &m, 4, PLT_BUILD_HOST);
    CHECK(rig_is_tiny() || t.r.engine->scene.gridded.grid->crowded_count > 0, "no crowded cell");
    for (unsigned i = 0; i < 120; i++) {
        plt_frame f = any_frame(&r, i % 2 ? 0.02f : 1.0f, middle);
        if (i % 4 == 3) { /* from above: the floor is behind all of it */
            f.camera.eye[1] = fabsf(f.camera.eye[1]) + 0.03f;
            f.camera.look[1] = 0.01f;
            f.camera.tan_half_fov = 0.1f;
        }
        move_to_planes(&t, &f, &r);
        one_frame(&t, &f, any_side(&r), "a crowd");
    }
    rig_close(&t.r);
    mesh_free(&m);
}

/* ---- straight down on grids ----------------------------------------------------------- */

/* Sheets of squares above each other, `apart` (0: the same twice), the upper one moved. */
static void doubled(mesh *m, uint32_t side, float apart, float moved) {
    shape_sheet(m, side, 1);
    shape_transform(m, 1.0f, moved, apart, moved);
    shape_sheet(m, side, 1);
}

static plt_frame down_on(float x, float height, float z, float tan_half, uint16_t pixels) {
    const plt_frame f = {.width = pixels,
                         .height = pixels,
                         .camera = {.eye = {x, height, z},
                                    .look = {x, 0.0f, z},
                                    .up = {0, 0, 1},
                                    .tan_half_fov = tan_half}};
    return f;
}

/* Every second triangle of a sheet: behind its edges, on which pixels lie, there is nothing. */
static void halved(mesh *m, uint32_t side) {
    shape_sheet(m, side, 1);
    for (size_t i = 1; i < m->triangles / 2; i++) {
        memcpy(&m->triangle[3 * i], &m->triangle[6 * i], 3 * sizeof *m->triangle);
    }
    m->triangles /= 2;
}

/* Down on such sheets, or, with `apart` NAN, on half of one. */
static void down_on_sheets(float apart, uint32_t side, float moved, random_state *r) {
    static const float height[4] = {1.0f, 2.0f, 1.37f, -3.0f};
    static const uint16_t pixels[4] = {32, 33, 47, 64};
    static tracer t;
    mesh m = {0};
    if (isnan(apart)) {
        halved(&m, side);
    } else {
        doubled(&m, side, apart, moved);
    }
    opened(&t, &m, 4, PLT_BUILD_HOST);
    for (unsigned k = 0; k < 4 * 4 * 2; k++) {
        const float h = height[k % 4], wide = fabsf(h);
        const float at = k < 16 ? 0.0f : random_float(r, -0.3f, 0.3f);
        const plt_frame f = down_on(at, h, at, 1.0f / wide, pixels[k / 4 % 4]);
        one_frame(&t, &f, any_side(r), "straight down");
    }
    rig_close(&t.r);
    mesh_free(&m);
}

static void straight_down(void) {
    static const float apart[6] = {0.0f, 0x1p-24f, 0x1p-22f, 0x1p-18f, 0x1p-14f, -0x1p-23f};
    random_state r = {4};
    for (unsigned i = 0; i < 6 * 2; i++) {
        const uint32_t side = rig_is_tiny() ? 2 : (i % 2 ? 8 : 11);
        down_on_sheets(apart[i / 2], side, i % 4 < 2 ? 0.0f : 0x1p-20f, &r);
    }
}

/* Squares of a sheet are cells of the grid over it, and pixels lie on all of their edges. */
static void on_planes(void) {
    static const float height[6] = {1.0f, 2.0f, 1.37f, -3.0f, 0.7f, 5.3f};
    static tracer t;
    random_state r = {12};
    for (unsigned i = 0; i < 12; i++) {
        const uint32_t side = rig_is_tiny() ? 2 : 4u << (i % 3);
        const float x = i < 6 ? 0.0f : random_float(&r, -900.0f, 900.0f);
        mesh m = {0};
        shape_sheet(&m, side, 1);
        shape_transform(&m, 1.0f, x, 0.0f, -x);
        spare = 100;
        opened(&t, &m, 4, PLT_BUILD_HOST);
        for (unsigned k = 0; k < 6 * 4; k++) {
            const float h = height[k % 6];
            const uint16_t pixels = (uint16_t)(16u << (k / 6 % 2) << (k / 12));
            plt_frame f = down_on(x + 1.0f / pixels, h, 1.0f / pixels - x, 1.0f / fabsf(h), pixels);
            one_frame(&t, &f, any_side(&r), "on planes of cells");
        }
        rig_close(&t.r);
        mesh_free(&m);
    }
}

/* A fine sheet just in front of a coarse one, at a slant: what is behind is met first. */
static void slanted(void) {
    static const float before[4] = {0.001f, 0.004f, 0.01f, 0.04f};
    static tracer t;
    random_state r = {13};
    for (unsigned i = 0; i < 8; i++) {
        mesh m = {0};
        shape_sheet(&m, rig_is_tiny() ? 2 : 32, 1);
        shape_transform(&m, 1.0f, 0.0f, before[i % 4], 0.0f);
        shape_sheet(&m, 1, 1);
        for (size_t v = 0; v < m.vertices; v++) {
            float *p = &m.vertex[3 * v];
            p[1] += 0.7f * p[0] + (i < 4 ? 0.0f : 0.4f * p[2]);
        }
        spare = 100;
        opened(&t, &m, 4, PLT_BUILD_HOST);
        for (unsigned k = 0; k < 12; k++) {
            const float x = random_float(&r, -0.2f, 0.2f), z = random_float(&r, -0.2f, 0.2f);
            const plt_frame f = down_on(x, 2.0f, z, 0.2f, 32);
            one_frame(&t, &f, any_side(&r), "slanted");
        }
        rig_close(&t.r);
        mesh_free(&m);
    }
}

/* So far apart that bounds of t tell which is nearer, or just do not. */
static void straight_down_by_bounds(void) {
    static const float apart[6] = {NAN, 0x1p-11f, 0x1p-9f, -0x1p-7f, 0x1p-5f, 0x1p-3f};
    random_state r = {6};
    for (unsigned i = 0; i < 6 * 2; i++) {
        const uint32_t side = rig_is_tiny() ? 2 : (i % 2 ? 8 : 11);
        down_on_sheets(apart[i / 2], side, i % 4 < 2 ? 0.0f : 0x1p-20f, &r);
    }
}

/* Sheets that cross each other at small angles, from all sides: from line to line the distance
 * between them grows from nothing. */
static void crossing(void) {
    static const float middle[3] = {0, 0, 0};
    static tracer t;
    random_state r = {7};
    for (unsigned i = 0; i < 8; i++) {
        const uint32_t side = rig_is_tiny() ? 2 : 2 + 3 * (i % 4);
        mesh m = {0};
        shape_sheet(&m, side, 1);
        shape_sheet(&m, side, 1);
        for (size_t v = 0; v < m.vertices; v++) {
            float *p = &m.vertex[3 * v];
            p[1] = (v < m.vertices / 2 ? 0x1p-2f : 0x1p-4f) * (p[0] + p[2] * (float)(i / 4));
        }
        opened(&t, &m, 4, PLT_BUILD_HOST);
        for (unsigned k = 0; k < 40; k++) {
            const plt_frame f = any_frame(&r, 1.0f, middle);
            one_frame(&t, &f, any_side(&r), "crossing sheets");
        }
        rig_close(&t.r);
        mesh_free(&m);
    }
}

/* ---- limits --------------------------------------------------------------------------------- */

static void limits(void) {
    static const float tan_half[8] = {1e-6f, 1e-5f, 1e-3f, 0.01f, 20.0f, 1e3f, 1e5f, 1e6f};
    static const uint16_t size[5][2] = {{1, 1}, {65535, 1}, {1, 4099}, {20, 3}, {8, 40}};
    static tracer t;
    random_state r = {5};
    mesh m = {0};
    shape_soup(&m, rig_triangles(24, 1), 0.4f, 3);
    opened(&t, &m, 2, PLT_BUILD_HOST);
    for (unsigned i = 0; i < 8 * 5; i++) {
        const float eye[3] = {0.3f, 0.1f, 2.0f};
        plt_frame f = {.width = size[i % 5][0], .height = size[i % 5][1]};
        memcpy(f.camera.eye, eye, sizeof eye);
        f.camera.up[1] = 1.0f;
        f.camera.tan_half_fov = tan_half[i / 5];
        f.width = i / 5 % 3 > 0 && f.width > 999 ? 999 : f.width; /* wide ones take long */
        one_frame(&t, &f, any_side(&r), "at a limit");
    }
    rig_close(&t.r);
    opened(&t, &m, 1, PLT_BUILD_NONE);
    const float middle[3] = {0, 0, 0};
    for (unsigned i = 0; i < 10; i++) {
        const plt_frame f = any_frame(&r, 1.0f, middle);
        one_frame(&t, &f, any_side(&r), "a list");
    }
    rig_close(&t.r);
    mesh_free(&m);
}

static void add_triangle(mesh *m, const float corner[3][3]) {
    fail f = {""};
    const uint32_t first = (uint32_t)m->vertices;
    for (int c = 0; c < 3; c++) {
        CHECK(mesh_add_vertex(m, corner[c][0], corner[c][1], corner[c][2], &f) == 0, "%s", f.text);
    }
    CHECK(mesh_add_triangle(m, first, first + 1, first + 2, &f) == 0, "%s", f.text);
}

/* A triangle that all but touches the eye, in front of others whose t is 0 or next to it. */
static void at_the_eye(void) {
    static const float depth[3] = {0.0f, 1e-37f, 1e-30f};
    static tracer t;
    for (unsigned i = 0; i < 3; i++) {
        const float front[3][3] = {{-1, -1, 2}, {0, 0, 1e-20f}, {1, -1, 2}};
        const float plane[3][3] = {{-1, -1, depth[i]}, {1, -1, depth[i]}, {0, 1, depth[i]}};
        mesh m = {0};
        add_triangle(&m, front);
        for (unsigned k = 0; k < 5; k++) {
            add_triangle(&m, plane);
        }
        opened(&t, &m, 4, PLT_BUILD_HOST);
        plt_frame f = {.width = 32, .height = 32};
        f.camera.look[2] = f.camera.up[1] = f.camera.tan_half_fov = 1.0f;
        one_frame(&t, &f, PLT_PACKET_SIDE_MAX, "at the eye");
        rig_close(&t.r);
        mesh_free(&m);
    }
}

static void report(void) {
    CHECK(pixels_hit > frames_seen, "%llu pixels hit something", (unsigned long long)pixels_hit);
    if (getenv("PLANELET_COUNT") != NULL) {
        printf("    %u of %u frames differ; %llu of %llu hits were taken by a bound\n",
               frames_wrong, frames_seen, (unsigned long long)pixels_bound,
               (unsigned long long)pixels_hit);
    }
    frames_seen = frames_wrong = 0;
    pixels_hit = pixels_bound = 0;
}

/* The same properties of each kind of scenes. */
static void begin(const char *what, const char *of) {
    char sentence[160];
    snprintf(sentence, sizeof sentence, "%s: %s", of, what);
    test(sentence);
}

static void all_of(const char *scenes) {
    looks = kind == STRIPS;
    begin("cameras anywhere: pixels of beams have the hits of plt_trace", scenes);
    anywhere();
    report();
    begin("straight down on doubled grids: the same", scenes);
    straight_down();
    report();
    begin("... on half a grid, and on grids far enough apart for bounds of t: the same", scenes);
    straight_down_by_bounds();
    report();
    begin("sheets that cross at small angles: the same", scenes);
    crossing();
    report();
    begin("hits at a t of 0 hide nothing: the same", scenes);
    at_the_eye();
    report();
    begin("fields of 1e-6 to 1e6, frames of up to 65535 pixels, lists: the same", scenes);
    limits();
    report();
}

int main(void) {
    kind = NODES;
    all_of("thesis nodes");
    kind = STRIPS;
    all_of("compact blocks");
    kind = BLOCKS_OF_RECORDS;
    all_of("compact blocks over float records");
    kind = STREAMED;
    all_of("compact blocks that are streamed");
    kind = GRIDS;
    all_of("grids");
    begin("a crowded cell, seen from near and far: the same", "grids");
    crowds();
    report();
    begin("pixels on the planes of cells: the same", "grids");
    on_planes();
    report();
    begin("a fine sheet before a coarse one, at a slant: the same", "grids");
    slanted();
    report();
    return test_done();
}

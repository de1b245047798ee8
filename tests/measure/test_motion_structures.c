/* test_motion_structures [FILE:FRAMES[:EVERY]...] - what builds and rays of moving scenes take
 *
 * FILE is as in animation.h. Frame by frame, every structure of host_tools/baselines does what it
 * does before a frame, and traces it: a view, and as incoherent rays as there are, from points of
 * triangles in all directions. Their hits are the same, bit for bit. Times are the processor's, and
 * only their ratios within a run say something; counts are the same every time. Without a FILE it
 * takes a few frames of marbles and is one test more.
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <stdlib.h>

#include "host_tools/base/clock.h"
#include "host_tools/baselines/structure.h"
#include "tests/measure/animation.h"

enum { FRAMES_MOST = 1000, SIDE = 256, PIXELS = SIDE * SIDE, APART = 16384, KINDS_MOST = 32 };

/* Of one structure, over all frames but the first, which is built when it is opened. */
typedef struct row {
    built_structure *s;
    const char *name;
    double open_seconds, build_seconds, view_seconds, apart_seconds;
    structure_statistics view, apart; /* counts of rays, summed */
    uint64_t work_before;
    double nodes, unsplit, work, references, strays, bytes; /* after tracing, summed */
    double view_work;                                       /* built for the view alone */
} row;

typedef struct bench {
    row rows[KINDS_MOST];
    unsigned kinds, frames;
    uint32_t triangles;
    float lo[3], hi[3];
    plt_ray *rays;       /* PIXELS, then APART */
    plt_hit *due, *hits; /* likewise */
} bench;

/* ---- rays ------------------------------------------------------------------------- */

/* Across the view: x of the frame's right side, y of its top are 1. */
static plt_ray ray_of_pixel(const plt_camera *c, float x, float y) {
    float to[3], right[3], up[3], length = 0.0f, across = 0.0f;
    for (int a = 0; a < 3; a++) {
        to[a] = c->look[a] - c->eye[a];
        length += to[a] * to[a];
    }
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3, d = (a + 2) % 3;
        to[a] /= sqrtf(length);
        right[a] = (c->look[b] - c->eye[b]) * c->up[d] - (c->look[d] - c->eye[d]) * c->up[b];
        across += right[a] * right[a];
    }
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3, d = (a + 2) % 3;
        up[a] = (right[b] * to[d] - right[d] * to[b]) / sqrtf(across);
    }
    float dir[3];
    for (int a = 0; a < 3; a++) {
        dir[a] = to[a] + c->tan_half_fov * (x * right[a] / sqrtf(across) + y * up[a]);
    }
    return ray_make(c->eye, dir, 0.0f, RAYS_FAR);
}

/* In packets of 8 x 8, each in Z order. */
static void make_rays(bench *b, const mesh *m, unsigned frame) {
    const plt_frame f = animation_view(b->lo, b->hi, 0.0, 0, frame % 2, SIDE);
    random_state r = {frame + 1};
    for (unsigned i = 0; i < PIXELS; i++) {
        unsigned x = i / 64 % (SIDE / 8) * 8, y = i / 64 / (SIDE / 8) * 8;
        for (unsigned bit = 0; bit < 3; bit++) {
            x += (i >> (2 * bit) & 1u) << bit;
            y += (i >> (2 * bit + 1) & 1u) << bit;
        }
        b->rays[i] = ray_of_pixel(&f.camera, 2.0f * ((float)x + 0.5f) / SIDE - 1.0f,
                                  1.0f - 2.0f * ((float)y + 0.5f) / SIDE);
    }
    for (unsigned i = 0; i < APART; i++) {
        b->rays[PIXELS + i] = animation_ray(m, &r);
    }
}

/* ---- a frame ---------------------------------------------------------------------- */

static void add(structure_statistics *to, const structure_statistics *s) {
    to->rays += s->rays;
    to->node_visits += s->node_visits;
    to->box_tests += s->box_tests;
    to->triangle_tests += s->triangle_tests;
    to->sieved += s->sieved;
}

static double trace(bench *b, row *r, unsigned first, unsigned count, structure_statistics *to) {
    fail f = {""};
    structure_forget(r->s);
    const double began = clock_processor_seconds();
    CHECK(structure_trace(r->s, b->rays + first, b->hits + first, count, 0, &f) == 0, "%s", f.text);
    const double took = clock_processor_seconds() - began;
    const structure_statistics s = structure_count(r->s);
    add(to, &s);
    return took;
}

static void follow(bench *b, row *r, const mesh *m, unsigned frame) {
    fail f = {""};
    const double began = clock_processor_seconds();
    CHECK(structure_move(r->s, m, &f) == 0, "%s", f.text);
    r->build_seconds += clock_processor_seconds() - began;
    r->view_seconds += trace(b, r, 0, PIXELS, &r->view);
    r->view_work += (double)(structure_count(r->s).build_work - r->work_before);
    r->apart_seconds += trace(b, r, PIXELS, APART, &r->apart);
    const structure_statistics s = structure_count(r->s);
    r->work += (double)(s.build_work - r->work_before);
    r->work_before = s.build_work;
    r->nodes += s.nodes;
    r->unsplit += s.unsplit;
    r->references += s.references;
    r->strays += s.strays;
    r->bytes += (double)s.bytes;
    if (r == b->rows) {
        memcpy(b->due, b->hits, (PIXELS + APART) * sizeof *b->due);
    }
    CHECK(memcmp(b->due, b->hits, (PIXELS + APART) * sizeof *b->due) == 0, "%s, frame %u: hits",
          r->name, frame);
}

/* ---- figures ---------------------------------------------------------------------- */

static void print_row(const bench *b, const row *r, const row *first) {
    const double n = b->frames - 1, triangles = n * b->triangles;
    const double all = r->build_seconds + r->view_seconds;
    const double due = first->build_seconds + first->view_seconds;
    printf(
        "    %-11s frame %7.2f + %7.2f ms (%5.2f of the tree's), incoherent %5.2f us per ray; "
        "built: "
        "%6.2f triangles looked at per triangle (view alone %6.2f), %5.2f nodes, %5.2f references, "
        "%5.2f strays, %6.1f bytes per triangle; view: %6.2f visits, %6.2f boxes, %6.2f tests, "
        "%5.2f sieved per ray; incoherent: %6.2f visits, %6.2f tests\n",
        r->name, 1e3 * r->build_seconds / n, 1e3 * r->view_seconds / n, all / due,
        1e6 * r->apart_seconds / n / APART, r->work / triangles, r->view_work / triangles,
        r->nodes / triangles, r->references / triangles, r->strays / triangles,
        r->bytes / triangles, (double)r->view.node_visits / n / PIXELS,
        (double)r->view.box_tests / n / PIXELS, (double)r->view.triangle_tests / n / PIXELS,
        (double)r->view.sieved / n / PIXELS, (double)r->apart.node_visits / n / APART,
        (double)r->apart.triangle_tests / n / APART);
}

static const row *row_of(const bench *b, const char *name) {
    const row *found = b->rows;
    for (unsigned i = 0; i < b->kinds; i++) {
        found = strcmp(b->rows[i].name, name) == 0 ? &b->rows[i] : found;
    }
    return found;
}

static void print(const bench *b, const animation *a) {
    const row *lazy = row_of(b, "kd-lazy"), *fast = row_of(b, "kd-fast");
    printf("  %s, %u frames, %u triangles\n", a->file, b->frames, b->triangles);
    for (unsigned i = 0; i < b->kinds; i++) {
        print_row(b, &b->rows[i], b->rows);
    }
    printf(
        "    built on demand: %.1f %% of the nodes for both kinds of rays, %.1f %% of the work, "
        "for "
        "the view alone %.1f %%\n",
        100.0 * lazy->nodes / fast->nodes, 100.0 * lazy->work / fast->work,
        100.0 * lazy->view_work / fast->work);
}

/* ---- an animation ----------------------------------------------------------------- */

static void open_all(bench *b, const mesh *m) {
    static const structure_options options = {.packet_side = 0};
    for (const structure_kind *const *kind = structure_kinds(); *kind != NULL; kind++) {
        row *r = &b->rows[b->kinds];
        fail f = {""};
        CHECK(b->kinds < KINDS_MOST, "more kinds than rows");
        if (b->kinds == KINDS_MOST) {
            return;
        }
        const double began = clock_processor_seconds();
        r->s = structure_open(*kind, m, &options, "it", &f);
        r->open_seconds = clock_processor_seconds() - began;
        r->name = structure_name(*kind);
        CHECK(r->s != NULL, "%s", f.text);
        b->kinds += r->s != NULL;
    }
}

static void run(const animation *a) {
    bench *b = calloc(1, sizeof *b);
    mesh m = {0};
    b->frames = a->frames;
    b->rays = calloc(PIXELS + APART, sizeof *b->rays);
    b->due = calloc(PIXELS + APART, sizeof *b->due);
    b->hits = calloc(PIXELS + APART, sizeof *b->hits);
    int status = animation_frame(&m, a, 0);
    b->triangles = (uint32_t)m.triangles;
    if (status == 0) {
        animation_box(&m, b->lo, b->hi);
        open_all(b, &m);
    }
    for (unsigned i = 0; i < b->kinds; i++) {
        b->rows[i].work_before = structure_count(b->rows[i].s).build_work;
    }
    for (unsigned frame = 1; frame < a->frames && status == 0; frame++) {
        mesh_free(&m);
        m = (mesh){0};
        status = animation_frame(&m, a, frame);
        make_rays(b, &m, frame);
        for (unsigned i = 0; i < b->kinds && status == 0; i++) {
            follow(b, &b->rows[i], &m, frame);
        }
    }
    if (status == 0) {
        print(b, a);
    }
    for (unsigned i = 0; i < b->kinds; i++) {
        structure_close(b->rows[i].s);
    }
    mesh_free(&m);
    free(b->rays);
    free(b->due);
    free(b->hits);
    free(b);
}

int main(int argc, char **argv) {
    return animations_run(argc, argv, "structures of scenes in motion have the same hits",
                          FRAMES_MOST, run);
}

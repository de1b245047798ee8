/* test_compact_topology - what the bytes of compact nodes cost in visits and tests
 *
 * Compared with thesis nodes of the same topology and positions (compact_thesis.h): the hits
 * are the same bit for bit, with at most +1.5 % node visits and +2.5 % triangle tests, on
 * camera rays and their bounces.
 *
 * test_compact_topology IMAGE RAYS [SIDE [THESIS]] compares on a packed image and a ray file
 * and prints both in per cent; THESIS is a file for the image with thesis nodes, to be timed
 * (used by compact.sh).
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "engine/base/bytes.h"
#include "host_tools/base/input.h"
#include "host_tools/base/output.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/compact_rig.h"
#include "tests/reference/compact_thesis.h"
#include "tests/reference/rays.h"
#include "tests/reference/room.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

typedef struct pair_of {
    packed image;
    rig compact, thesis;
} pair_of;

typedef struct excess {
    double visits, tests; /* of compact nodes, as a share */
    uint32_t differ;      /* hits */
} excess;

static int open_image(rig *r, const packed *image, uint8_t side) {
    const plt_options options = {.packet_side = side, .count_touched = 1};
    const plt_source source = rig_source(image);
    plt_info info;
    int status = plt_image_info(&source, &info, &r->fault);
    if (status == PLT_OK) {
        r->arena_bytes = plt_arena_need(&info, 1, &options);
        r->arena = room_get(r->arena_bytes);
        status = plt_open(&r->engine, r->arena, r->arena_bytes, &source, &options, &r->fault);
    }
    return status;
}

/* The thesis tree of an image with compact nodes; 0 when both are open. */
static int open_pair(pair_of *p, const packed *image, uint8_t side) {
    memset(p, 0, sizeof *p);
    int status = open_image(&p->compact, image, side);
    if (status == PLT_OK) {
        p->thesis.image =
            compact_as_thesis(compact_tree(&p->compact), plt_engine_info(p->compact.engine));
        status = open_image(&p->thesis, &p->thesis.image, side);
        p->compact.fault = status == PLT_OK ? p->compact.fault : p->thesis.fault;
    }
    return status;
}

static void close_pair(pair_of *p) {
    rig_close(&p->compact);
    rig_close(&p->thesis);
}

static plt_stats trace(const rig *r, const plt_ray *rays, plt_hit *hits, uint32_t count) {
    plt_stats s;
    plt_stats_reset(r->engine);
    plt_trace(r->engine, rays, hits, count, 0);
    plt_stats_get(r->engine, &s);
    return s;
}

/* `hits` are those of the compact nodes afterwards. */
static excess compare(const pair_of *p, const plt_ray *rays, plt_hit *hits, uint32_t count) {
    plt_hit *other = malloc(count * sizeof *other);
    const plt_stats a = trace(&p->compact, rays, hits, count);
    const plt_stats b = trace(&p->thesis, rays, other, count);
    excess e = {(double)a.node_visits / (double)b.node_visits - 1.0,
                (double)a.triangle_tests / (double)b.triangle_tests - 1.0, 0};
    for (uint32_t i = 0; i < count; i++) {
        e.differ += memcmp(&hits[i], &other[i], sizeof hits[i]) != 0;
    }
    free(other);
    return e;
}

/* ---- scenes of our own ----------------------------------------------------------- */

/* From each hit a little back along the ray, then in a random direction. */
static uint32_t bounce(plt_ray *rays, const plt_hit *hits, uint32_t count, random_state *r) {
    static const float lo[3] = {-1, -1, -1}, hi[3] = {1, 1, 1};
    uint32_t made = 0;
    for (uint32_t i = 0; i < count; i++) {
        if (hits[i].triangle != PLT_MISS) {
            plt_ray ray = rays[i];
            for (int a = 0; a < 3; a++) {
                ray.org[a] += 0.9999f * hits[i].t * ray.dir[a];
            }
            random_point(r, lo, hi, ray.dir);
            ray.tmin = 0.0f;
            ray.tmax = RAYS_FAR;
            rays[made++] = ray;
        }
    }
    return made;
}

static void scene(const mesh *m, const char *name, uint32_t k, uint8_t bits) {
    enum { RAYS = 40000 };
    compact_config config = compact_config_of(k, bits, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    plt_ray *rays = malloc(RAYS * sizeof *rays);
    plt_hit *hits = malloc(RAYS * sizeof *hits);
    random_state r = {k};
    pair_of p;
    rig one;
    CHECK(compact_open(&one, m, &config) == PLT_OK, "%s: %s", name, one.fault.message);
    CHECK(open_pair(&p, &one.image, 2) == PLT_OK, "%s: %s", name, p.compact.fault.message);
    if (p.thesis.engine != NULL) {
        uint32_t count = RAYS;
        rays_camera(rays, count, m, &r);
        for (int bounced = 0; bounced < 2; bounced++) {
            const excess e = compare(&p, rays, hits, count);
            CHECK(count >= RAYS / 8, "%s: only %u rays", name, count);
            CHECK(e.differ == 0, "%s: %u hits differ", name, e.differ);
            CHECK(e.visits <= 0.015 && e.tests <= 0.025,
                  "%s, K %u, %u bits, %s: visits %+.2f %%, tests %+.2f %%", name, k, bits,
                  bounced ? "bounce" : "camera", 100.0 * e.visits, 100.0 * e.tests);
            printf("    %s, K %u, %u bits, %s: visits %+.2f %%, tests %+.2f %%\n", name, k, bits,
                   bounced ? "bounce" : "camera", 100.0 * e.visits, 100.0 * e.tests);
            count = bounce(rays, hits, count, &r);
        }
    }
    close_pair(&p);
    rig_close(&one);
    free(rays);
    free(hits);
}

static int scenes(void) {
    fail f = {""};
    test("hits of the same topology are the same, visits and tests within their limits");
    for (uint32_t k = 2; k <= 4; k *= 2) {
        mesh knot = {0}, terrain = {0};
        CHECK(scene_knot(&knot, compact_triangles(20000, k), &f) == 0, "%s", f.text);
        CHECK(scene_terrain(&terrain, compact_triangles(20000, k), &f) == 0, "%s", f.text);
        scene(&knot, "knot", k, 14);
        scene(&knot, "knot", k, 21);
        scene(&terrain, "terrain", k, 14);
        mesh_free(&knot);
        mesh_free(&terrain);
    }
    return test_done();
}

/* ---- files ------------------------------------------------------------------------- */

/* 0: written, or not asked for. */
static int write_thesis(const pair_of *p, const char *name) {
    fail f = {""};
    output *o = name == NULL ? NULL : output_open(name, &f);
    if (o != NULL) {
        output_write(o, p->thesis.image.bytes, p->thesis.image.size, &f);
    }
    if (name != NULL && (o == NULL || output_commit(o, &f) != 0)) {
        fprintf(stderr, "%s\n", f.text);
        return 1;
    }
    return 0;
}

static int files(const char *scene_name, const char *rays_name, uint8_t side,
                 const char *thesis_name) {
    input image_file, ray_file;
    fail f = {""};
    pair_of p;
    if (input_read(&image_file, scene_name, &f) != 0 || input_read(&ray_file, rays_name, &f) != 0) {
        fprintf(stderr, "%s\n", f.text);
        return 1;
    }
    packed image = {.bytes = aligned_alloc(64, (image_file.size + 63) / 64 * 64),
                    .size = (uint32_t)image_file.size};
    memcpy(image.bytes, image_file.bytes, image_file.size);
    const uint32_t count = (uint32_t)(ray_file.size / sizeof(plt_ray));
    plt_ray *rays = malloc(ray_file.size);
    plt_hit *hits = malloc(count * sizeof *hits);
    for (uint32_t i = 0; i < count; i++) {
        plt_get_floats(rays[i].org, ray_file.bytes + 32 * (size_t)i, 8);
    }
    int status = open_pair(&p, &image, side);
    if (status == PLT_OK) {
        const excess e = compare(&p, rays, hits, count);
        printf("%+.2f %+.2f %u\n", 100.0 * e.visits, 100.0 * e.tests, e.differ);
        status = write_thesis(&p, thesis_name);
    } else {
        fprintf(stderr, "%s: %s\n", scene_name, p.compact.fault.message);
    }
    close_pair(&p);
    pack_free(&image);
    free(rays);
    free(hits);
    input_free(&image_file);
    input_free(&ray_file);
    return status != PLT_OK;
}

int main(int count, char **argument) {
    if (count < 3) {
        return scenes();
    }
    return files(argument[1], argument[2], (uint8_t)(count > 3 ? atoi(argument[3]) : 2),
                 count > 4 ? argument[4] : NULL);
}

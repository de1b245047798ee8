/* test_surface - normals and colours of hits: beside the mesh's own in double precision
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>

#include "tests/hostile/surface.h"
#include "tests/reference/frame_rays.h"
#include "tests/reference/frames.h"
#include "tests/reference/surface_rig.h"

enum { SIDE = 32, RAYS = SIDE * SIDE };

static const double STEP = 0.0115; /* radians: two neighbouring codes are nearer than twice that */

static const plt_options plain = {.packet_side = 2, .surface = 1};

typedef struct scene {
    mesh m;
    mesh_corners c;
    rig r;
} scene;

static void close_scene(scene *s) {
    rig_close(&s->r);
    corners_free(&s->c);
    mesh_free(&s->m);
}

/* The mesh of `s`, with normals by that crease. */
static void open_scene(scene *s, double degrees, const plt_options *options) {
    const rig_config config =
        rig_config_of(2, 8, rig_is_tiny() ? PLT_BUILD_NONE : PLT_BUILD_HOST, PLT_SPLIT_SAH);
    CHECK(mesh_smooth(&s->m, degrees, &s->c) == 0, "no memory");
    const packed image = surface_rig_image(&s->m, &s->c, &config.pack);
    const plt_source source = rig_source(&image);
    const int status = surface_rig_open(&s->r, image, &source, options);
    CHECK(status == PLT_OK, "%s", s->r.fault.message);
}

static double angle_between(const double a[3], const float b[3]) {
    double along = 0, lengths[2] = {0, 0};
    for (int i = 0; i < 3; i++) {
        along += a[i] * (double)b[i];
        lengths[0] += a[i] * a[i];
        lengths[1] += (double)b[i] * (double)b[i];
    }
    return acos(fmin(1.0, along / sqrt(lengths[0] * lengths[1])));
}

/* What the corners have, weighted in double precision. */
static void expect(const scene *s, const plt_hit *h, double normal[3], double colour[3]) {
    const double weight[3] = {1.0 - (double)h->u - (double)h->v, (double)h->u, (double)h->v};
    for (int a = 0; a < 3; a++) {
        normal[a] = colour[a] = 0;
    }
    for (size_t j = 0; j < 3; j++) {
        const size_t at = 3 * (size_t)h->triangle + j;
        double n[3];
        corner_direction(s->c.normal[at], n);
        for (int a = 0; a < 3; a++) {
            normal[a] += weight[j] * n[a];
            colour[a] += s->c.colour == NULL
                             ? weight[j]
                             : weight[j] * (double)(s->c.colour[at] >> 8 * a & 0xFFu) / 255.0;
        }
    }
}

static void check_hit(const scene *s, const plt_hit *h, double bound) {
    double normal[3], colour[3];
    plt_surface_point p;
    expect(s, h, normal, colour);
    CHECK(plt_surface_at(s->r.engine, h, &p) == PLT_OK, "triangle %u", h->triangle);
    CHECK(angle_between(normal, p.normal) < bound, "triangle %u: %g", h->triangle,
          angle_between(normal, p.normal));
    CHECK(hostile_is_unit(p.normal) && hostile_is_unit(p.flat), "not of length 1");
    CHECK(p.has_normal && p.has_colour == (s->c.colour != NULL), "nothing is there");
    for (int a = 0; a < 3; a++) {
        CHECK(fabs(colour[a] - (double)p.colour[a]) < 1e-5, "triangle %u, colour %d: %g for %g",
              h->triangle, a, (double)p.colour[a], colour[a]);
    }
}

static uint32_t check_hits(const scene *s, double bound) {
    plt_ray *rays = frame_rays(&s->m, SIDE, 2);
    plt_hit *hits = malloc(RAYS * sizeof *hits);
    uint32_t met = 0;
    plt_trace(s->r.engine, rays, hits, RAYS, 0);
    for (uint32_t i = 0; i < RAYS; i++) {
        if (hits[i].triangle != PLT_MISS) {
            check_hit(s, &hits[i], bound);
            met++;
        }
    }
    free(rays);
    free(hits);
    return met;
}

static void smooth_normals(void) {
    for (unsigned levels = 0; levels < 4; levels++) {
        scene s = {.m = {0}};
        shape_icosphere(&s.m, levels);
        surface_rig_colour(&s.m, &s.c, 1 + levels);
        open_scene(&s, 180, &plain);
        CHECK(check_hits(&s, STEP) > RAYS / 8, "few hits");
        close_scene(&s);
    }
}

static void creased_normals(void) {
    for (unsigned painted = 0; painted < 2; painted++) {
        scene s = {.m = {0}};
        shape_cube(&s.m);
        shape_icosphere(&s.m, 2);
        if (painted) {
            surface_rig_paint(&s.m, &s.c);
        }
        open_scene(&s, 30, &plain);
        CHECK(check_hits(&s, STEP) > RAYS / 8, "few hits");
        plt_surface_point p;
        for (uint32_t i = 0; i < 12; i++) { /* of the cube */
            const plt_hit h = {1.0f, 0.25f, 0.5f, i};
            CHECK(plt_surface_at(s.r.engine, &h, &p) == PLT_OK, "triangle %u", i);
            CHECK(memcmp(p.normal, p.flat, sizeof p.normal) == 0, "a side of the cube is not flat");
        }
        close_scene(&s);
    }
}

static void without(void) {
    scene s = {.m = {0}};
    shape_icosphere(&s.m, 1);
    const rig_config config = rig_config_of(2, 8, PLT_BUILD_NONE, PLT_SPLIT_SAH);
    fail f = {""};
    packed image;
    CHECK(pack_mesh(&image, &s.m, &config.pack, "test", &f) == 0, "%s", f.text);
    const plt_source source = rig_source(&image);
    CHECK(surface_rig_open(&s.r, image, &source, &plain) == PLT_OK, "%s", s.r.fault.message);
    for (uint32_t i = 0; i < s.m.triangles; i++) {
        const plt_hit h = {1.0f, 0.25f, 0.5f, i};
        plt_surface_point p;
        CHECK(plt_surface_at(s.r.engine, &h, &p) == PLT_OK, "triangle %u", i);
        CHECK(!p.has_normal && !p.has_colour && p.colour[0] == 1 &&
                  memcmp(p.normal, p.flat, sizeof p.normal) == 0 && hostile_is_unit(p.flat),
              "triangle %u has something", i);
    }
    close_scene(&s);
}

/* Odd u and v, and triangles that are not there. */
static void odd_hits(void) {
    static const float odd[] = {0.0f, -1.0f, 3e38f, -3e38f, INFINITY, NAN, 1e-40f};
    scene s = {.m = {0}};
    shape_icosphere(&s.m, 1);
    surface_rig_colour(&s.m, &s.c, 3);
    open_scene(&s, 180, &plain);
    for (unsigned i = 0; i < 49; i++) {
        const plt_hit h = {1.0f, odd[i / 7], odd[i % 7], 5};
        const char *sentence = hostile_point(s.r.engine, &h);
        CHECK(sentence == NULL, "u %g, v %g: %s", (double)h.u, (double)h.v, sentence);
    }
    const plt_surface_point before = {.flat = {7, 8, 9}};
    plt_surface_point p = before;
    const plt_hit beyond = {1, 0, 0, (uint32_t)s.m.triangles}, miss = {0, 0, 0, PLT_MISS};
    CHECK(plt_surface_at(s.r.engine, &beyond, &p) == PLT_ERR_ARGUMENT, "a triangle beyond");
    CHECK(plt_surface_at(s.r.engine, &miss, &p) == PLT_ERR_ARGUMENT, "a miss");
    CHECK(memcmp(&p, &before, sizeof p) == 0, "it was written");
    close_scene(&s);
}

/* Of a lattice, where hits are not just those of the mesh, and of float records. */
static void compact_blocks(void) {
    for (uint8_t floats = 0; floats < 2 && !rig_is_tiny(); floats++) {
        for (unsigned levels = 0; levels < 4; levels++) {
            scene s = {.m = {0}};
            shape_cube(&s.m);
            shape_icosphere(&s.m, levels);
            surface_rig_paint(&s.m, &s.c);
            CHECK(mesh_smooth(&s.m, 50, &s.c) == 0, "no memory");
            const packed image = surface_rig_compact(&s.m, &s.c, floats);
            const plt_source source = rig_source(&image);
            CHECK(surface_rig_open(&s.r, image, &source, &plain) == PLT_OK, "%s",
                  s.r.fault.message);
            CHECK(check_hits(&s, STEP) > RAYS / 8, "few hits");
            for (uint32_t i = 0; i < s.m.triangles; i++) { /* in blocks each is found by itself */
                const plt_hit h = {1.0f, 0.2f, 0.3f, i};
                check_hit(&s, &h, STEP);
            }
            close_scene(&s);
        }
    }
    CHECK(1, "a tiny build refuses some of these trees");
}

/* ---- frames ------------------------------------------------------------------------------ */

static plt_frame smooth_frame(void) {
    static const float eye[3] = {2, 1.5f, 3}, look[3] = {0, 0, 0};
    return frame_of(eye, look, 48, 48, PLT_SHADE_SMOOTH);
}

static uint64_t hash_of(const packed *image, const plt_options *options, int streamed) {
    const plt_frame frame = smooth_frame();
    hostile_stream stream = {image->bytes, image->size, 0};
    const plt_source mapped = rig_source(image),
                     fetched = {NULL, image->size, &stream, hostile_start, hostile_wait};
    const packed none = {.bytes = NULL, .info = image->info};
    rig r;
    const int status = surface_rig_open(&r, none, streamed ? &fetched : &mapped, options);
    CHECK(status == PLT_OK || (status == PLT_ERR_LIMIT && rig_is_tiny()), "%s", r.fault.message);
    CHECK(plt_render_begin(r.engine, &frame) == PLT_OK, "a smooth frame is refused");
    plt_frame four = frame;
    four.samples = PLT_SAMPLES_FOUR;
    CHECK(plt_render_begin(r.engine, &four) == PLT_ERR_ARGUMENT, "smooth and four samples");
    const uint64_t hash = frame_hash(r.engine, &frame, 1000);
    r.image.bytes = NULL;
    free(r.arena);
    return hash;
}

/* Of every build, packet, order, structure and source; GOLDEN is of every machine. */
static void same_frame(void) {
    static const uint64_t GOLDEN = UINT64_C(0x9bf2fa38d0468564);
    mesh m = {0};
    mesh_corners c = {0};
    unsigned compared = 0;
    shape_icosphere(&m, 2);
    shape_cube(&m);
    CHECK(mesh_smooth(&m, 40, &c) == 0, "no memory");
    surface_rig_colour(&m, &c, 4);
    for (unsigned i = 0; i < 3 * 4 * 2 * 2 * 2; i++) {
        const uint8_t build = rig_is_tiny() ? PLT_BUILD_NONE : (uint8_t)(i % 3);
        const rig_config config = rig_config_of(1 + i % 2, 8, build, PLT_SPLIT_SAH);
        plt_options options = plain;
        options.packet_side = (uint8_t)(2u << i / 3 % 4);
        options.order = (uint8_t)(i / 12 % 2);
        options.structure = (uint8_t)(i / 24 % 2);
        if (options.packet_side > PLT_PACKET_SIDE_MAX ||
            (options.structure == PLT_STRUCTURE_GRID && options.order != 0)) {
            continue;
        }
        packed image = surface_rig_image(&m, &c, &config.pack);
        const uint64_t hash = hash_of(&image, &options, (int)(i / 48));
        CHECK(hash == GOLDEN, "%s: %016" PRIx64, rig_name(&config), hash);
        compared++;
        pack_free(&image);
    }
    for (int fetched = 0; fetched < 2 && !rig_is_tiny(); fetched++) {
        packed image = surface_rig_compact(&m, &c, 1);
        plt_options options = plain;
        options.packet_side = fetched && PLT_PACKET_SIDE_MAX >= 8 ? 8 : 2;
        const uint64_t hash = hash_of(&image, &options, fetched);
        CHECK(hash == GOLDEN, "compact, float records: %016" PRIx64, hash);
        pack_free(&image);
    }
    CHECK(compared >= (rig_is_tiny() ? 18u : 72u), "%u frames", compared);
    corners_free(&c);
    mesh_free(&m);
}

/* The frame's hits have that colour: eye light by the normal. */
static void frame_of_hits(void) {
    scene s = {.m = {0}};
    shape_icosphere(&s.m, 2);
    surface_rig_colour(&s.m, &s.c, 4);
    open_scene(&s, 180, &plain);
    plt_frame frame = smooth_frame();
    frame.camera.eye[0] = frame.camera.eye[1] = 0;
    frame.camera.eye[2] = 4;
    const float half = frame.camera.tan_half_fov;
    frame_result result = frame_render(s.r.engine, &frame, 1000);
    unsigned met = 0;
    for (int i = 0; i < 48 * 48; i++) {
        const float x = (float)(2 * (i % 48) + 1) / 48.0f - 1.0f;
        const float y = 1.0f - (float)(2 * (i / 48) + 1) / 48.0f;
        const plt_ray ray = {{0, 0, 4}, 0, {x * half, y * half, -1}, 3e38f};
        plt_hit hit;
        plt_surface_point p;
        plt_trace(s.r.engine, &ray, &hit, 1, 0);
        if (hit.triangle == PLT_MISS) {
            continue;
        }
        met++;
        plt_surface_at(s.r.engine, &hit, &p);
        double along = 0, squared = 0;
        for (int a = 0; a < 3; a++) {
            along += (double)(p.normal[a] * ray.dir[a]);
            squared += (double)(ray.dir[a] * ray.dir[a]);
        }
        for (int a = 0; a < 3; a++) {
            const double due = fabs(along) / sqrt(squared) * (double)p.colour[a] * 255;
            CHECK(fabs(due - (double)result.rgb[3 * i + a]) < 1.6, "pixel %d: %u for %g", i,
                  result.rgb[3 * i + a], due);
        }
    }
    CHECK(met > 300 && result.wrong == 0, "%u hits", met);
    free(result.rgb);
    close_scene(&s);
}

/* ---- refusals ---------------------------------------------------------------------------- */

static void options_refused(void) {
    scene s = {.m = {0}};
    shape_icosphere(&s.m, 1);
    const plt_options without_surface = {.packet_side = 2};
    open_scene(&s, 180, &without_surface);
    const plt_frame frame = smooth_frame();
    const plt_hit hit = {1, 0, 0, 0};
    plt_surface_point p;
    CHECK(plt_render_begin(s.r.engine, &frame) == PLT_ERR_ARGUMENT, "a smooth frame");
    CHECK(plt_surface_at(s.r.engine, &hit, &p) == PLT_ERR_ARGUMENT, "a surface");
    const plt_source source = rig_source(&s.r.image);
    plt_options o[3] = {plain, plain, plain};
    o[0].movable = 1;
    o[1].residency = PLT_RESIDENCY_STREAMED;
    o[2].surface = 2;
    for (int i = 0; i < 3; i++) {
        plt_engine *e;
        plt_fault fault;
        static unsigned char arena[4096] __attribute__((aligned(PLT_ALIGN)));
        CHECK(plt_arena_need(&s.r.image.info, 1, &o[i]) == 0, "options %d have a need", i);
        CHECK(plt_open(&e, arena, sizeof arena, &source, &o[i], &fault) == PLT_ERR_ARGUMENT,
              "options %d: %s", i, fault.message);
    }
    close_scene(&s);
}

/* Sections that are not asked for are not looked at, but the table is. */
static packed forged;

static hostile_result with_word(uint32_t at, uint32_t value) {
    const hostile_config config = {0, 0, 2, 0};
    unsigned char *bytes = hostile_copy(forged.bytes, forged.size);
    plt_put_u32(bytes + at, value);
    hostile_seal_surface(bytes, forged.size);
    const hostile_result r = hostile_try_surface(bytes, forged.size, config);
    free(bytes);
    return r;
}

static void refused(uint32_t at, uint32_t value, unsigned rule, uint32_t offset) {
    const hostile_result r = with_word(at, value);
    CHECK(r.status == PLT_ERR_IMAGE && r.fault.kind == 'R' && r.fault.rule == rule &&
              r.fault.offset == offset && r.sentence == NULL,
          "byte %u = %x: status %d, rule %u at %u, not %u at %u", at, value, r.status, r.fault.rule,
          r.fault.offset, rule, offset);
}

static void rules(void) {
    mesh m = {0};
    mesh_corners c = {0};
    const rig_config config = rig_config_of(2, 8, PLT_BUILD_NONE, PLT_SPLIT_SAH);
    shape_icosphere(&m, 1);
    CHECK(mesh_smooth(&m, 180, &c) == 0, "no memory");
    surface_rig_colour(&m, &c, 2);
    forged = surface_rig_image(&m, &c, &config.pack);
    const uint32_t table = hostile_further_at(forged.bytes), normals = table + 64;
    const uint32_t colours = normals + forged.info.normal_bytes;
    CHECK(colours + forged.info.colour_bytes == forged.size, "%u bytes", forged.size);
    refused(HOSTILE_AT_FURTHER, 8, 17, HOSTILE_AT_FURTHER);
    refused(HOSTILE_AT_FURTHER, 1, 17, table);      /* an entry too many */
    refused(HOSTILE_AT_FURTHER, 3, 17, table + 48); /* one too few */
    refused(HOSTILE_AT_FURTHER, 0, 11, 16);
    refused(table + 4, 1, 17, table);
    refused(table + 12, 1, 17, table);
    refused(table + 48, 14, 17, table);      /* behind the last entry */
    refused(table + 16, 13, 17, table + 32); /* both of colours */
    refused(table + 16, 11, 17, table + 16);
    refused(table + 32, 99, 17, table + 32); /* none that there is */
    refused(table + 20, normals + 64, 17, table + 16);
    refused(table + 24, 0, 17, table + 16);
    refused(table + 24, forged.info.normal_bytes + 1, 17, table + 16);
    refused(table + 24, forged.info.normal_bytes - 64, 17, table + 32);
    refused(table + 40, forged.info.colour_bytes - 64, 17, 16);
    const uint32_t third = plt_get_u32(forged.bytes + normals + 4);
    refused(normals + 4, third + 12, 18, normals);
    refused(normals + 4, third - 12, 18, normals);
    refused(normals + 4, 0xFFFFFFFF, 18, normals);
    refused(normals + 12, 0x80000000u, 18, normals);
    refused(normals + 12, 0xAAAAAAABu, 18, normals); /* times six it is 2 of 2^32 */
    refused(colours + 4, 0x55555556u, 18, colours);
    refused(colours + 16, 0, 18, colours);
    refused(colours + 16, 256, 18, colours);
    refused(colours + 20, 1, 18, colours);
    refused(colours + 28, 1, 18, colours);
    unsigned char *bytes = hostile_copy(forged.bytes, forged.size);
    bytes[colours + 40] ^= 1;
    const hostile_config config_of = {1, 0, 2, 0};
    const hostile_result r = hostile_try_surface(bytes, forged.size, config_of);
    CHECK(r.status == PLT_ERR_IMAGE && r.fault.rule == 13 && r.fault.offset == colours,
          "rule %u at %u", r.fault.rule, r.fault.offset);
    const hostile_result unasked = hostile_try(bytes, forged.size, config_of);
    CHECK(unasked.status == PLT_OK, "it was looked at: %s", unasked.fault.message);
    bytes[table + 17] ^= 1;
    const hostile_result damaged = hostile_try(bytes, forged.size, config_of);
    CHECK(damaged.status == PLT_ERR_IMAGE && damaged.fault.rule == 17 &&
              damaged.fault.offset == table,
          "rule %u at %u", damaged.fault.rule, damaged.fault.offset);
    free(bytes);
    pack_free(&forged);
    corners_free(&c);
    mesh_free(&m);
}

/* Any seed, and any entries: normals of length 1, and colours. */
static void forged_tables(void) {
    mesh m = {0};
    mesh_corners c = {0};
    random_state state = {7};
    const hostile_config config = {0, 0, 2, 0};
    const rig_config plain_config = rig_config_of(2, 8, PLT_BUILD_NONE, PLT_SPLIT_SAH);
    shape_icosphere(&m, 1);
    CHECK(mesh_smooth(&m, 180, &c) == 0, "no memory");
    surface_rig_colour(&m, &c, 2);
    forged = surface_rig_image(&m, &c, &plain_config.pack);
    const uint32_t normals = hostile_further_at(forged.bytes) + 64;
    const uint32_t colours = normals + forged.info.normal_bytes;
    for (unsigned i = 0; i < 200; i++) {
        unsigned char *bytes = hostile_copy(forged.bytes, forged.size);
        for (uint32_t k = normals + 16; k < forged.size; k++) {
            const int is_head = k >= colours && k < colours + 32;
            bytes[k] = is_head ? bytes[k] : (unsigned char)random_bits(&state);
        }
        bytes[normals] = bytes[colours] = (unsigned char)random_bits(&state);
        hostile_seal_surface(bytes, forged.size);
        const hostile_result r = hostile_try_surface(bytes, forged.size, config);
        CHECK(r.status == PLT_OK && r.sentence == NULL, "%s", r.sentence);
        free(bytes);
    }
    pack_free(&forged);
    corners_free(&c);
    mesh_free(&m);
}

int main(void) {
    test("hits have the normals and colours of their corners, weighted by u and v");
    smooth_normals();
    test("where triangles that meet differ, each has its own: the sides of a cube are flat");
    creased_normals();
    test("... and of compact blocks");
    compact_blocks();
    test("without normals and colours surfaces are flat and white");
    without();
    test(
        "whatever u and v are, the normal has the length 1; triangles that are not there have "
        "none");
    odd_hits();
    test("the smooth frame is the same for every build, packet, order, structure and source");
    same_frame();
    test("its pixels are eye light by the normals of their hits, times their colours");
    frame_of_hits();
    test("without the option, and of scenes that move or are streamed, there are no surfaces");
    options_refused();
    test("tables and heads of further sections that are wrong are refused, with rule and place");
    rules();
    test("whatever tables hold, hits have normals of length 1, and colours");
    forged_tables();
    return test_done();
}

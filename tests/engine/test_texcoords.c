/* test_texcoords - texture coordinates of hits, beside the mesh's own in double precision; and
 * colours of large palettes
 *
 * SPDX-License-Identifier: MIT */
#include "tests/hostile/surface.h"
#include "tests/reference/surface_rig.h"

#include "engine/surface/texcoords.h"

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

static packed image_of(const scene *s) {
    const rig_config config =
        rig_config_of(2, 8, rig_is_tiny() ? PLT_BUILD_NONE : PLT_BUILD_HOST, PLT_SPLIT_SAH);
    return surface_rig_image(&s->m, &s->c, &config.pack);
}

static void open_image(scene *s, packed image) {
    const plt_source source = rig_source(&image);
    const int status = surface_rig_open(&s->r, image, &source, &plain);
    CHECK(status == PLT_OK, "%s", s->r.fault.message);
}

static plt_surface_point point_at(const scene *s, uint32_t triangle, float u, float v) {
    const plt_hit hit = {1.0f, u, v, triangle};
    plt_surface_point p;
    CHECK(plt_surface_at(s->r.engine, &hit, &p) == PLT_OK, "triangle %u", triangle);
    return p;
}

/* Corner by corner within `off` of the mesh's, and between them what single precision gives in its
 * one order, bit for bit. */
static void check_triangle(const scene *s, uint32_t triangle, double off) {
    static const float weights[][2] = {{0, 0}, {1, 0}, {0, 1}, {0.25f, 0.5f}, {0.1f, 0.7f}};
    plt_surface_point p[5];
    for (int i = 0; i < 5; i++) {
        p[i] = point_at(s, triangle, weights[i][0], weights[i][1]);
        CHECK(p[i].has_texcoord, "triangle %u has none", triangle);
        CHECK(p[i].texcoord_scale == p[0].texcoord_scale, "the scale is not the triangle's");
        for (int a = 0; a < 2; a++) {
            const float u = weights[i][0], v = weights[i][1], w = (1.0f - u) - v;
            const float due = (w * p[0].texcoord[a] + u * p[1].texcoord[a]) + v * p[2].texcoord[a];
            CHECK(p[i].texcoord[a] == due, "triangle %u: %.9g for %.9g", triangle,
                  (double)p[i].texcoord[a], (double)due);
        }
    }
    for (size_t j = 0; j < 3; j++) {
        for (int a = 0; a < 2; a++) {
            const double due = (double)plt_float_of(s->c.texcoord[a][3 * (size_t)triangle + j]);
            const double is = (double)p[j].texcoord[a];
            CHECK(fabs(is - due) <= off, "triangle %u, corner %zu, axis %d: %g for %g", triangle, j,
                  a, is, due);
        }
    }
}

/* The square root of what the mesh says in double precision. */
static double scale_of(const scene *s, uint32_t triangle) {
    double edge[2][3], across[2][2], squared = 0;
    for (size_t e = 0; e < 2; e++) {
        const size_t from = 3 * (size_t)triangle, to = from + e + 1;
        for (size_t a = 0; a < 3; a++) {
            edge[e][a] = (double)s->m.vertex[3 * (size_t)s->m.triangle[to] + a] -
                         (double)s->m.vertex[3 * (size_t)s->m.triangle[from] + a];
        }
        for (int a = 0; a < 2; a++) {
            across[e][a] = (double)plt_float_of(s->c.texcoord[a][to]) -
                           (double)plt_float_of(s->c.texcoord[a][from]);
        }
    }
    for (int a = 0; a < 3; a++) {
        const int b = (a + 1) % 3, c = (a + 2) % 3;
        const double x = edge[0][b] * edge[1][c] - edge[0][c] * edge[1][b];
        squared += x * x;
    }
    return sqrt(fabs(across[0][0] * across[1][1] - across[0][1] * across[1][0]) / sqrt(squared));
}

static void by_position(void) {
    static const float REPEATS[] = {1.0f, 0.01f, 40.0f, -7.0f, 4000.0f};
    for (size_t i = 0; i < sizeof REPEATS / sizeof REPEATS[0]; i++) {
        for (int fine = 0; fine < 2; fine++) {
            scene s = {.m = {0}};
            shape_icosphere(&s.m, 2);
            surface_rig_unwrap(&s.m, &s.c, REPEATS[i]);
            s.c.has_fine_texcoords = fine;
            open_image(&s, image_of(&s));
            const double off = fabs((double)REPEATS[i]) * (fine ? 0.501 / 65534 : 0.501 / 4094);
            for (uint32_t t = 0; t < s.m.triangles; t++) {
                check_triangle(&s, t, off);
                const double due = scale_of(&s, t),
                             is = (double)point_at(&s, t, 0, 0).texcoord_scale;
                CHECK(fabs(is * is - due * due) < 0.02 * (double)(REPEATS[i] * REPEATS[i]),
                      "triangle %u: the scale is %g, not %g", t, is, due);
            }
            close_scene(&s);
        }
    }
}

static void by_triangle(void) {
    scene s = {.m = {0}};
    shape_cube(&s.m);
    shape_icosphere(&s.m, 1);
    surface_rig_tile(&s.m, &s.c);
    open_image(&s, image_of(&s));
    for (uint32_t t = 0; t < s.m.triangles; t++) {
        if (t % 9 == 8) {
            const plt_surface_point p = point_at(&s, t, 0.25f, 0.25f);
            CHECK(!p.has_texcoord && p.texcoord[0] == 0 && p.texcoord[1] == 0 &&
                      p.texcoord_scale == 0,
                  "triangle %u has a corner without, and some", t);
        } else {
            check_triangle(&s, t, 0.501 * 7 / 4094);
            const double due = scale_of(&s, t), is = (double)point_at(&s, t, 0, 0).texcoord_scale;
            CHECK(fabs(is - due) < 0.01 * due, "triangle %u: the scale is %g, not %g", t, is, due);
        }
    }
    close_scene(&s);
}

/* Sides of a cube on which u stays the same cover nothing, and a triangle without area is covered
 * by nothing. */
static void scales_vanish(void) {
    scene s = {.m = {0}};
    fail f = {""};
    unsigned none = 0;
    shape_cube(&s.m);
    mesh_add_triangle(&s.m, 0, 0, 1, &f);
    surface_rig_unwrap(&s.m, &s.c, 1);
    open_image(&s, image_of(&s));
    for (uint32_t t = 0; t < s.m.triangles; t++) {
        none += point_at(&s, t, 0.5f, 0.25f).texcoord_scale == 0;
    }
    CHECK(none == 8 + 1, "%u of 13", none);
    close_scene(&s);
    for (int i = -100; i <= 60; i += 20) { /* from where areas vanish, to where squares overflow */
        const float x = ldexpf(1.0f, i);
        const float corner[3][3] = {{0, 0, 0}, {x, 0, 0}, {0, x, 0}};
        static const float texcoord[3][2] = {{0, 0}, {1, 0}, {0, 1}};
        const float is = plt_texcoord_scale(corner, texcoord);
        CHECK(is == (i > -60 ? 1.0f / x : 0.0f), "2^%d: %g", i, (double)is);
    }
}

static void of_blocks(void) {
    for (uint8_t floats = 0; floats < 2 && !rig_is_tiny(); floats++) {
        for (int tiled = 0; tiled < 2; tiled++) {
            scene s = {.m = {0}};
            shape_icosphere(&s.m, 3);
            if (tiled) {
                surface_rig_tile(&s.m, &s.c);
            } else {
                surface_rig_unwrap(&s.m, &s.c, 1);
            }
            CHECK(mesh_smooth(&s.m, 50, &s.c) == 0, "no memory");
            open_image(&s, surface_rig_compact(&s.m, &s.c, floats));
            for (uint32_t t = 0; t < s.m.triangles; t++) {
                if (!tiled || t % 9 != 8) {
                    check_triangle(&s, t, tiled ? 0.501 * 7 / 4094 : 0.501 / 4094);
                }
            }
            close_scene(&s);
        }
    }
    CHECK(1, "a tiny build refuses some of these trees");
}

/* Of an image that is copied, too. */
static void of_sources(void) {
    scene s = {.m = {0}}, other;
    shape_icosphere(&s.m, 2);
    surface_rig_unwrap(&s.m, &s.c, 3);
    surface_rig_colour(&s.m, &s.c, 5);
    open_image(&s, image_of(&s));
    other = s;
    const packed none = {.info = s.r.image.info};
    hostile_stream stream = {s.r.image.bytes, s.r.image.size, 0};
    const plt_source fetched = {NULL, s.r.image.size, &stream, hostile_start, hostile_wait};
    CHECK(surface_rig_open(&other.r, none, &fetched, &plain) == PLT_OK, "%s",
          other.r.fault.message);
    for (uint32_t t = 0; t < s.m.triangles; t++) {
        const plt_surface_point a = point_at(&s, t, 0.3f, 0.4f),
                                b = point_at(&other, t, 0.3f, 0.4f);
        CHECK(memcmp(a.texcoord, b.texcoord, sizeof a.texcoord) == 0 &&
                  memcmp(a.colour, b.colour, sizeof a.colour) == 0 &&
                  a.texcoord_scale == b.texcoord_scale && b.has_texcoord && b.has_colour,
              "triangle %u", t);
    }
    free(other.r.arena);
    close_scene(&s);
}

static void odd_weights(void) {
    static const float odd[] = {0.0f, -1.0f, 3e38f, -3e38f, INFINITY, NAN, 1e-40f};
    scene s = {.m = {0}};
    shape_icosphere(&s.m, 1);
    surface_rig_unwrap(&s.m, &s.c, 60000);
    open_image(&s, image_of(&s));
    for (unsigned i = 0; i < 49; i++) {
        const plt_hit h = {1.0f, odd[i / 7], odd[i % 7], 5};
        const char *sentence = hostile_point(s.r.engine, &h);
        CHECK(sentence == NULL, "u %g, v %g: %s", (double)h.u, (double)h.v, sentence);
    }
    close_scene(&s);
}

/* ---- many colours ------------------------------------------------------------------------ */

/* 642 positions, in as many colours; by position, by triangle, and by both. */
static void many_colours(void) {
    for (int painted = 0; painted < 3; painted++) {
        for (int compact = 0; compact < (rig_is_tiny() ? 1 : 2); compact++) {
            scene s = {.m = {0}};
            shape_icosphere(&s.m, 3);
            CHECK(corners_want_colours(&s.c, s.m.triangles) == 0, "no memory");
            for (size_t i = 0; i < 3 * s.m.triangles; i++) {
                const int by_triangle = painted == 1 || (painted == 2 && i < 12);
                const uint32_t k = by_triangle ? (uint32_t)i / 3 : s.m.triangle[i];
                s.c.colour[i] = corner_colour(k * 97 & 255, k * 31 >> 2 & 255, k * 7 & 255);
            }
            open_image(&s, compact ? surface_rig_compact(&s.m, &s.c, 1) : image_of(&s));
            for (uint32_t t = 0; t < s.m.triangles; t++) {
                const plt_surface_point p = point_at(&s, t, 0, 0);
                for (int a = 0; a < 3; a++) {
                    const float due = (float)(s.c.colour[3 * (size_t)t] >> 8 * a & 255u) / 255.0f;
                    CHECK(p.colour[a] == due, "triangle %u, colour %d: %g for %g", t, a,
                          (double)p.colour[a], (double)due);
                }
            }
            close_scene(&s);
        }
    }
}

/* ---- refusals ---------------------------------------------------------------------------- */

static packed forged;
static uint32_t texcoords, colours;

static void forge(void) {
    scene s = {.m = {0}};
    shape_icosphere(&s.m, 1);
    surface_rig_unwrap(&s.m, &s.c, 1);
    surface_rig_colour(&s.m, &s.c, 3);
    forged = image_of(&s);
    texcoords = forged.size - forged.info.texcoord_bytes;
    colours = texcoords - forged.info.colour_bytes;
    corners_free(&s.c);
    mesh_free(&s.m);
}

static hostile_result with_word(uint32_t at, uint32_t value) {
    const hostile_config config = {0, 0, 2, 0};
    unsigned char *bytes = hostile_copy(forged.bytes, forged.size);
    plt_put_u32(bytes + at, value);
    hostile_seal_surface(bytes, forged.size);
    const hostile_result r = hostile_try_surface(bytes, forged.size, config);
    free(bytes);
    return r;
}

static void refused(uint32_t at, uint32_t value) {
    const hostile_result r = with_word(at, value);
    CHECK(r.status == PLT_ERR_IMAGE && r.fault.kind == 'R' && r.fault.rule == 18 &&
              r.fault.offset == (at < texcoords ? colours : texcoords) && r.sentence == NULL,
          "byte %u = %x: status %d, rule %u at %u", at, value, r.status, r.fault.rule,
          r.fault.offset);
}

static void taken(uint32_t at, uint32_t value) {
    const hostile_result r = with_word(at, value);
    CHECK(r.status == PLT_OK && r.sentence == NULL, "byte %u = %x: status %d, %s", at, value,
          r.status, r.sentence != NULL ? r.sentence : r.fault.message);
}

static void rules(void) {
    static const uint32_t WRONG[] = {0x7FC00000u, 0x7F800000u, 0xFF800000u, 0x7F7FFFFFu,
                                     0x49800001u /* 2^20 and a little */};
    forge();
    const uint32_t third = plt_get_u32(forged.bytes + texcoords + 4);
    refused(texcoords + 4, third + 12);
    refused(texcoords + 4, third - 12);
    refused(texcoords + 4, 0xFFFFFFFFu);
    refused(texcoords + 12, 0x80000000u);
    for (uint32_t a = 0; a < 8; a += 4) {
        refused(texcoords + 16 + a, 0);
        refused(texcoords + 16 + a, 1);
        refused(texcoords + 16 + a, 17);
        refused(texcoords + 16 + a, 0xFFFFFFFFu);
        refused(texcoords + 16 + a, 16); /* entries of 28 bits: more than there are */
        for (size_t i = 0; i < sizeof WRONG / sizeof WRONG[0]; i++) {
            refused(texcoords + 24 + a, WRONG[i]);
            refused(texcoords + 32 + a, WRONG[i]);
        }
        refused(texcoords + 32 + a, 0x80000001u); /* a little below 0 */
        refused(texcoords + 32 + a, 0x43800CCDu); /* 4095 steps of 256.1 */
        taken(texcoords + 32 + a, 0x43800000u);   /* ... of 256 */
        taken(texcoords + 32 + a, 0);
        taken(texcoords + 24 + a, 0xC9800000u); /* from -2^20 */
    }
    for (uint32_t b = 1; b < 24; b++) { /* of 24 bits, as many as there are */
        plt_put_u32(forged.bytes + texcoords + 20, 24 - b);
        if (b < 8 || b > 16) {
            refused(texcoords + 16, b);
        } else {
            taken(texcoords + 16, b);
        }
    }
    plt_put_u32(forged.bytes + texcoords + 20, 12);
    for (uint32_t at = 40; at < 64; at += 4) {
        refused(texcoords + at, 0x01000000u);
    }
    refused(colours + 16, 256); /* entries of 11 bits: more than there are */
    refused(colours + 16, 2048);
    pack_free(&forged);
}

static void forged_tables(void) {
    random_state state = {7};
    const hostile_config config = {0, 0, 2, 0};
    forge();
    const unsigned char *head = forged.bytes + texcoords;
    const uint32_t bits = plt_get_u32(head + 16) + plt_get_u32(head + 20);
    const uint64_t end = texcoords + plt_texcoords_bytes(head, bits); /* behind that are zeros */
    for (unsigned i = 0; i < 200; i++) {
        unsigned char *bytes = hostile_copy(forged.bytes, forged.size);
        for (uint32_t k = texcoords + 64; k < end; k++) {
            bytes[k] = (unsigned char)random_bits(&state);
        }
        bytes[texcoords] = (unsigned char)random_bits(&state);
        hostile_seal_surface(bytes, forged.size);
        const hostile_result r = hostile_try_surface(bytes, forged.size, config);
        CHECK(r.status == PLT_OK && r.sentence == NULL, "%s", r.sentence);
        free(bytes);
    }
    pack_free(&forged);
}

int main(void) {
    test("hits have the texture coordinates of their corners, within half a step, and the scale");
    by_position();
    test("where triangles that meet differ, each has its own; one with a corner without has none");
    by_triangle();
    test("... and of compact blocks");
    of_blocks();
    test("the scale is 0 where nothing is covered, or areas vanish");
    scales_vanish();
    test("an image that is fetched has the same as one that is mapped");
    of_sources();
    test("whatever u and v are, coordinates are within 2^20");
    odd_weights();
    test("hundreds of colours are what they are in the mesh");
    many_colours();
    test("heads that are wrong are refused; at their bounds they are not");
    rules();
    test("whatever tables hold, coordinates are within 2^20");
    forged_tables();
    return test_done();
}

/* test_pack_lattice - which lattice a mesh gets, what counts in that, and what is said of it
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "host_tools/pack/lattice_boxes.h"
#include "host_tools/pack/lattice_snap.h"
#include "host_tools/pack/pack.h"
#include "tests/reference/random.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

static uint32_t add_vertex(mesh *m, float x, float y, float z) {
    fail f = {""};
    CHECK(mesh_add_vertex(m, x, y, z, &f) == 0, "%s", f.text);
    return (uint32_t)m->vertices - 1;
}

static void add_triangle(mesh *m, uint32_t a, uint32_t b, uint32_t c) {
    fail f = {""};
    CHECK(mesh_add_triangle(m, a, b, c, &f) == 0, "%s", f.text);
}

/* Triangles whose corners are multiples of `grain`, 0 .. `extent` of them from lo on. */
static mesh grained(float grain, uint32_t extent, const float lo[3]) {
    random_state r = {extent};
    mesh m = {0};
    for (uint32_t i = 0; i < 300; i++) {
        float p[3];
        for (int a = 0; a < 3; a++) {
            const uint32_t q = i < 2 ? i * extent : random_below(&r, extent + 1);
            p[a] = lo[a] + grain * (float)(i == 2 ? a == 0 : q);
        }
        add_vertex(&m, p[0], p[1], p[2]);
    }
    for (uint32_t i = 0; i < m.vertices; i += 3) {
        add_triangle(&m, i, i + 1, i + 2);
    }
    return m;
}

static snapped snap(const mesh *m, uint32_t bits, int power) {
    const lattice_wish wish = {.bits = bits, .power = power};
    snapped s;
    fail f = {""};
    CHECK(lattice_snap_as(&s, m, &wish, "test", &f) == 0, "%s", f.text);
    return s;
}

/* The position of a corner as the engine computes it. */
static void position(const snapped *s, uint32_t triangle, uint32_t corner, float p[3]) {
    const unsigned char *at = s->corners + ((size_t)9 * triangle + 3 * corner) * s->width;
    for (int a = 0; a < 3; a++, at += s->width) {
        uint32_t q = 0;
        for (uint32_t k = 0; k < s->width; k++) {
            q |= (uint32_t)at[k] << 8 * k;
        }
        p[a] = plt_lattice_float(&s->lattice, a, q);
    }
}

static size_t count_equal(const snapped *s, const mesh *m) {
    size_t equal = 0;
    for (uint32_t i = 0; i < s->count; i++) {
        for (uint32_t k = 0; k < 3; k++) {
            const float *was = shape_corner(m, s->source[i], k);
            float p[3];
            position(s, i, k, p);
            equal += p[0] == was[0] && p[1] == was[1] && p[2] == was[2];
        }
    }
    return equal;
}

static int is_power(float step) {
    int exponent;
    return frexpf(step, &exponent) == 0.5f;
}

static int origin_fits(const plt_lattice *l) {
    int fits = 1;
    for (int a = 0; a < 3; a++) {
        fits &= fmodf(l->origin[a], l->step) == 0.0f;
    }
    return fits;
}

/* ---- corners that stay where they are ---------------------------------------------------- */

static void check_exact(float grain, uint32_t extent, const float lo[3], uint32_t bits) {
    mesh m = grained(grain, extent, lo);
    for (int power = 0; power < 2; power++) {
        snapped s = snap(&m, bits, power);
        CHECK(s.lattice.step == grain && origin_fits(&s.lattice), "%u bits: step %g, not %g", bits,
              (double)s.lattice.step, (double)grain);
        CHECK(s.count == m.triangles && count_equal(&s, &m) == 3 * m.triangles,
              "%u bits: %zu of %zu corners are equal", bits, count_equal(&s, &m), 3 * m.triangles);
        CHECK(s.loss.largest_move == 0.0 && s.loss.unmoved == m.vertices &&
                  s.loss.vertices == m.vertices,
              "moved by %g", s.loss.largest_move);
        snapped_free(&s);
    }
    mesh_free(&m);
}

static void exact(void) {
    for (uint32_t bits = 12; bits <= 21; bits++) {
        const uint32_t most = (1u << bits) - 1;
        check_exact(1.0f, most, (const float[3]){0, 0, 0}, bits);
        check_exact(1.0f, most - 77, (const float[3]){-5, 1000, -2000}, bits);
        check_exact(0.5f, 1000, (const float[3]){0.5f, -7.5f, 3}, bits);
        check_exact(1.0f / 64, 4000, (const float[3]){1, 2, -3}, bits);
        check_exact(8192.0f, 300, (const float[3]){0, -8192, 8192}, bits);
        /* floats are a step apart there: 2^23 .. 2^24 */
        check_exact(1.0f, 4000, (const float[3]){16773000, 8388608, -16000000}, bits);
    }
}

/* The bits do not suffice: the step is that of any other mesh. */
static void not_exact(void) {
    for (uint32_t bits = 12; bits <= 20; bits++) {
        const uint32_t most = (1u << bits) - 1;
        mesh m = grained(1.0f, most + 1, (const float[3]){0, 0, 0});
        snapped s = snap(&m, bits, 0);
        CHECK(!is_power(s.lattice.step) && s.lattice.step > 1.0f && s.lattice.step < 1.2f,
              "%u bits: step %g", bits, (double)s.lattice.step);
        snapped_free(&s);
        s = snap(&m, bits, 1);
        CHECK(s.lattice.step == 2.0f && origin_fits(&s.lattice), "%u bits: step %g", bits,
              (double)s.lattice.step);
        snapped_free(&s);
        mesh_free(&m);
    }
}

/* A part of round coordinates, and one of any. */
static void partly_exact(void) {
    for (uint32_t bits = 12; bits <= 21; bits++) {
        mesh m = grained(0.25f, 100, (const float[3]){-3.25f, 7, 1});
        const size_t round = m.vertices;
        random_state r = {bits};
        for (uint32_t i = 0; i < 30; i++) {
            add_vertex(&m, random_float(&r, -3.25f, 20), random_float(&r, 7, 30),
                       random_float(&r, 1, 25));
            if (i % 3 == 2) {
                add_triangle(&m, (uint32_t)m.vertices - 3, (uint32_t)m.vertices - 2,
                             (uint32_t)m.vertices - 1);
            }
        }
        snapped ordinary = snap(&m, bits, 0), s = snap(&m, bits, 1);
        CHECK(!is_power(ordinary.lattice.step), "step %g", (double)ordinary.lattice.step);
        CHECK(is_power(s.lattice.step) && origin_fits(&s.lattice) &&
                  s.lattice.step <= 2.0f * ordinary.lattice.step,
              "step %g", (double)s.lattice.step);
        CHECK(s.loss.unmoved >= round && s.loss.vertices == m.vertices, "%llu of %llu stayed",
              (unsigned long long)s.loss.unmoved, (unsigned long long)s.loss.vertices);
        CHECK(ordinary.loss.unmoved < round / 2, "%llu stayed",
              (unsigned long long)ordinary.loss.unmoved);
        CHECK(s.loss.largest_move > 0.0 &&
                  s.loss.largest_move * 25.0 <= 0.87 * (double)s.lattice.step,
              "moved by %g", s.loss.largest_move);
        snapped_free(&ordinary);
        snapped_free(&s);
        mesh_free(&m);
    }
}

/* ---- what counts --------------------------------------------------------------------------- */

static int same_lattice(const snapped *a, const snapped *b) {
    return memcmp(&a->lattice, &b->lattice, sizeof a->lattice) == 0 && a->count == b->count &&
           memcmp(&a->box, &b->box, sizeof a->box) == 0 &&
           memcmp(a->corners, b->corners, (size_t)9 * a->width * a->count) == 0;
}

/* What has no area and lies far away changes nothing but a count. */
static void stray(int power) {
    mesh m = {0};
    shape_icosphere(&m, 2);
    snapped before = snap(&m, 14, power);
    const uint32_t far = add_vertex(&m, 1.0e9f, 0, 0);
    add_vertex(&m, -1.0e9f, 0.3f, 0);
    add_vertex(&m, 3.0e9f, 0, 0);
    add_triangle(&m, far, far + 1, far + 1);
    add_triangle(&m, 0, 0, far);
    add_triangle(&m, add_vertex(&m, 2.0e9f, 0, 0), far, far + 2);
    snapped after = snap(&m, 14, power);
    CHECK(same_lattice(&before, &after), "step %g, was %g", (double)after.lattice.step,
          (double)before.lattice.step);
    CHECK(after.loss.flat_before == 3 && after.loss.flat_now == 0 && after.loss.t_junctions == 0,
          "%llu had no area", (unsigned long long)after.loss.flat_before);
    CHECK(after.loss.vertices == before.loss.vertices, "they count");
    CHECK(after.loss.largest_move == before.loss.largest_move, "moved by %g",
          after.loss.largest_move);
    snapped_free(&before);
    snapped_free(&after);
    mesh_free(&m);
}

/* One without area within the others' box closes on the lattice what it closed before; a
 * far one with an area counts, though it loses it. */
static void what_counts(void) {
    mesh m = {0};
    shape_icosphere(&m, 2);
    snapped before = snap(&m, 12, 0);
    const uint32_t a = add_vertex(&m, 0.1f, 0.1f, 0.1f), b = add_vertex(&m, 0.3f, 0.3f, 0.3f),
                   c = add_vertex(&m, 0.7f, 0.7f, 0.7f);
    add_triangle(&m, a, b, c);
    snapped within = snap(&m, 12, 0);
    CHECK(within.loss.vertices == before.loss.vertices + 3, "it does not count");
    CHECK(within.lattice.step == before.lattice.step, "step %g", (double)within.lattice.step);
    const uint32_t far = add_vertex(&m, 1000, 0, 0);
    add_triangle(&m, far, add_vertex(&m, 1000, 0.01f, 0), add_vertex(&m, 1000, 0, 0.01f));
    snapped wide = snap(&m, 12, 0);
    CHECK(wide.lattice.step > 100.0f * before.lattice.step, "step %g", (double)wide.lattice.step);
    CHECK(wide.loss.flat_now > 0, "it has kept its area");
    snapped_free(&before);
    snapped_free(&within);
    snapped_free(&wide);
    mesh_free(&m);
}

/* Records that stay floats count, whatever they are. */
static void boxes(void) {
    const lattice_wish wish = {.bits = 16, .boxes = 1};
    mesh m = {0};
    fail f = {""};
    snapped s;
    shape_cube(&m);
    add_triangle(&m, 0, 0, add_vertex(&m, 100, 0, 0));
    CHECK(lattice_boxes(&s, &m, &wish, "test", &f) == 0, "%s", f.text);
    CHECK(s.mesh_box.hi[0] == 100.0f && s.count == m.triangles, "up to %g",
          (double)s.mesh_box.hi[0]);
    CHECK(s.lattice.step == 1.0f, "step %g", (double)s.lattice.step);
    snapped_free(&s);
    mesh_free(&m);
}

/* ---- how far vertices moved ------------------------------------------------------------------ */

/* Of the mesh's longest side, whatever is left on the lattice. */
static void longest_side(void) {
    mesh m = {0};
    const uint32_t a = add_vertex(&m, 0, 0, 0), b = add_vertex(&m, 1, 0, 0);
    add_triangle(&m, a, b, add_vertex(&m, 0.5001f, 1.0e-9f, 0));
    snapped s = snap(&m, 12, 0);
    CHECK(s.count == 0 && s.loss.flat_now == 1, "%u triangles", s.count);
    CHECK(s.loss.largest_move > 0.9e-4 && s.loss.largest_move < 2.12e-4, "moved by %g",
          s.loss.largest_move);
    snapped_free(&s);
    const uint32_t c = add_vertex(&m, 0.9f, 0.9f, 0.01f);
    add_triangle(&m, c, add_vertex(&m, 0.91f, 0.9f, 0.01f), add_vertex(&m, 0.9f, 0.91f, 0.01f));
    s = snap(&m, 12, 0);
    CHECK(s.count == 1 && s.loss.flat_now == 1, "%u triangles", s.count);
    CHECK(s.loss.largest_move > 0.9e-4 && s.loss.largest_move < 2.12e-4, "moved by %g",
          s.loss.largest_move);
    snapped_free(&s);
    mesh_free(&m);
}

static packed pack(const mesh *m, const compact_options *o, lattice_loss *loss) {
    packed image;
    fail f = {""};
    CHECK(pack_compact(&image, m, o, "test", loss, &f) == 0, "%s", f.text);
    return image;
}

/* Kept with steps of a power of two, and far from the origin, where floats round as
 * coarsely as the lattice; kept by few bits where nothing moves. */
static void tolerance(void) {
    for (int i = 0; i < 12; i++) {
        const double keep = ldexp(3.0e-4, -i / 4);
        mesh m = {0};
        shape_icosphere(&m, 1);
        shape_transform(&m, 1.0f, i % 2 == 0 ? 0.0f : 300.0f, 0, 0);
        const compact_options o = {.lattice_bits = (uint8_t)lattice_bits_for(keep),
                                   .power = i % 3 == 0,
                                   .tolerance = keep,
                                   .leaf_triangles = 2};
        lattice_loss loss;
        packed image = pack(&m, &o, &loss);
        CHECK(loss.largest_move <= keep && loss.largest_move > 0.2 * keep,
              "%g: moved by %g, %u bits", keep, loss.largest_move, image.info.lattice_bits);
        pack_free(&image);
        mesh_free(&m);
    }
    mesh cube = {0};
    shape_cube(&cube);
    const compact_options o = {.lattice_bits = 20, .tolerance = 1.0e-6, .leaf_triangles = 2};
    lattice_loss loss;
    packed image = pack(&cube, &o, &loss);
    CHECK(image.info.lattice_bits == 12 && loss.bits == 12 && loss.largest_move == 0.0, "%u bits",
          image.info.lattice_bits);
    pack_free(&image);
    mesh_free(&cube);
}

/* ---- what is refused ---------------------------------------------------------------------------
 */

/* A remedy with a number of bits works, and one bit more does not; without one, 12 bits do
 * not work either. */
static void too_far(float distance, int power, int fewer) {
    mesh m = {0};
    shape_icosphere(&m, 2);
    shape_transform(&m, 1.0f, distance, 0.1f, 0.2f);
    lattice_wish wish = {.bits = 21, .power = power};
    fail f = {""}, ignored = {""};
    snapped s;
    CHECK(lattice_snap_as(&s, &m, &wish, "far.ply", &f) != 0, "packed at %g", (double)distance);
    CHECK(strncmp(f.text, "far.ply: a lattice of 21 bits is finer than floats are that far", 63) ==
              0,
          "%s", f.text);
    CHECK(strstr(f.text, "--centre") != NULL && strstr(f.text, "--nodes thesis") != NULL, "%s",
          f.text);
    const char *bits = strstr(f.text, "lattice:");
    CHECK((bits != NULL) == fewer && (bits != NULL) == (strstr(f.text, "fewer bits") != NULL), "%s",
          f.text);
    wish.bits = bits != NULL ? (uint32_t)strtoul(bits + 8, NULL, 10) : 11;
    if (bits != NULL) {
        CHECK(lattice_snap_as(&s, &m, &wish, "far.ply", &ignored) == 0, "%s", ignored.text);
        snapped_free(&s);
    }
    wish.bits++;
    CHECK(lattice_snap_as(&s, &m, &wish, "far.ply", &ignored) != 0, "%u bits would do", wish.bits);
    mesh_free(&m);
}

/* Boxes alone take the bits that they can get. */
static void boxes_far(void) {
    const compact_options o = {.lattice_bits = 16, .floats = 1, .leaf_triangles = 2};
    mesh m = {0};
    lattice_loss loss;
    shape_icosphere(&m, 1);
    shape_transform(&m, 1.0f, 3000, 0.1f, 0.2f);
    packed image = pack(&m, &o, &loss);
    CHECK(image.info.lattice_bits >= 12 && image.info.lattice_bits < 16, "%u bits",
          image.info.lattice_bits);
    pack_free(&image);
    mesh_free(&m);
}

int main(void) {
    test("corners that are multiples of a power of two stay exact where the bits suffice");
    exact();
    test("... and where they do not, the lattice is as for any mesh");
    not_exact();
    test("steps of a power of two keep the corners that are multiples of them, for one bit");
    partly_exact();
    test("vertices that no triangle uses and triangles without area do not widen the lattice");
    stray(0);
    stray(1);
    test("... triangles without area within it stay on it, and any with an area count");
    what_counts();
    test("... under float records all of them count");
    boxes();
    test("how far vertices moved is told of the mesh's longest side, whatever is lost");
    longest_side();
    test("a tolerance is kept with any step, far from the origin, and by few bits if they do");
    tolerance();
    test("a lattice finer than floats is refused with the bits that would do, if any would");
    too_far(3000, 0, 1);
    too_far(3000, 1, 1);
    too_far(1000000, 0, 0);
    too_far(1000000, 1, 0);
    test("... but boxes alone take fewer bits");
    boxes_far();
    return test_done();
}

/* test_beam_planes - margins of samples by planes, which pictures cannot show
 *
 * They are for the worst of many roundings at once, so frames with less of them come out right, too
 * (test_beam_samples). What DESIGN.md, section 7.7, says that they have to be is compared here with
 * sums in double, and planes and volumes with exact ones.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "engine/lanes/unroll.h"
#include "tests/reference/random.h"
#include "tests/test.h"

#define plt_beam_test_samples tested_samples
#include "engine/shade/beam_samples.c"

#if PLT_WITH_BEAMS && PLT_WITH_SAMPLES

#define U 0x1p-24

/* A view through samples, and a square of it. */
typedef struct scene {
    plt_view view;
    plt_beam beam;
    double term; /* M of 7.7 */
} scene;

static int any_scene(random_state *r, uint32_t across, scene *s) {
    static const plt_box box = {{-1, -1, -1}, {1, 1, 1}};
    const float tangent = ldexpf(random_float(r, 1.0f, 2.0f), (int)random_below(r, 12) - 8);
    plt_frame f = {.width = (uint16_t)(16 + random_below(r, 1000)),
                   .height = (uint16_t)(16 + random_below(r, 1000)),
                   .camera = {.up = {0, 1, 0}, .tan_half_fov = tangent}};
    memset(&s->beam, 0, sizeof s->beam);
    for (int a = 0; a < 3; a++) {
        f.camera.look[a] = random_float(r, -1.0f, 1.0f);
    }
    if (plt_view_set(&s->view, &f) != PLT_OK) {
        return 0;
    }
    plt_view_refine(&s->view, across);
    plt_margins_set(&s->beam.margins, &s->view, &f, PLT_PACKET_SIDE_MAX, &box, 5.0f);
    s->beam.view = &s->view;
    s->beam.square.x = across * random_below(r, f.width - 15u);
    s->beam.square.y = across * random_below(r, f.height - 15u);
    plt_view_point(&s->view, (float)s->beam.square.x, (float)s->beam.square.y, s->beam.first);
    s->term = 0.0;
    for (int a = 0; a < 3; a++) {
        const double term = fabs((double)s->view.corner[a]) +
                            across * f.width * fabs((double)s->view.right[a]) +
                            across * f.height * fabs((double)s->view.down[a]);
        s->term = fmax(s->term, term);
    }
    return 1;
}

/* Of any sizes: long ones and slivers, too. */
static void any_record(random_state *r, plt_record *record, double q[3][3]) {
    for (int c = 0; c < 3; c++) {
        const float size = ldexpf(1.0f, (int)random_below(r, 10) - 5);
        for (int a = 0; a < 3; a++) {
            const float at = size * random_float(r, -1.0f, 1.0f);
            uint32_t bits;
            memcpy(&bits, &at, sizeof bits);
            plt_put_u32(&record->word[3 * c + a], bits);
            q[c][a] = (double)at;
        }
    }
}

static double largest_of(const double q[3]) {
    return fmax(fmax(fabs(q[0]), fabs(q[1])), fabs(q[2]));
}

static void crossed(const double a[3], const double b[3], double to[3]) {
    for (int i = 0; i < 3; i++) {
        const int y = (i + 1) % 3, z = (i + 2) % 3;
        to[i] = a[y] * b[z] - a[z] * b[y];
    }
}

static double along(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* What is allowed is at least what 7.7 adds up to, and no more than half above it. */
static int is_due(double allowed, double due) {
    return allowed >= due && allowed <= 1.5 * due;
}

/* A sample's planes are off by the margin at most, and beside those in the middle by no more. */
static void check_sample(const scene *s, const planes *p, const double q[3][3], uint32_t column,
                         uint32_t row) {
    const uint32_t across = s->view.across;
    float at[3], dir[3];
    samples of;
    planes_at(p, column / across, row / across, of.at);
    planes_in(&s->view, p, &of, column, row, at);
    plt_view_direction(&s->view, s->beam.square.x + column, s->beam.square.y + row, dir);
    const double d[3] = {(double)dir[0], (double)dir[1], (double)dir[2]};
    double of_exact[3];
    for (int c = 0; c < 3; c++) {
        crossed(q[(c + 1) % 3], q[(c + 2) % 3], of_exact);
        const double exact = along(of_exact, d), margin = (double)p->margin[c];
        CHECK(fabs((double)at[c] - exact) <= margin, "a plane of %g, not %g, margin %g",
              (double)at[c], exact, margin);
        CHECK(fabs((double)of.at[c] - exact) <= (double)p->beside[c],
              "a plane of %g in the middle, %g in a sample, %g beside", (double)of.at[c], exact,
              (double)p->beside[c]);
    }
}

static void check_planes(const planes *p, const scene *s, const double q[3][3]) {
    const double size[3] = {largest_of(q[0]), largest_of(q[1]), largest_of(q[2])};
    const double largest = fmax(fmax(size[0], size[1]), size[2]);
    double normal[3];
    for (int c = 0; c < 3; c++) {
        const double due = 149.0 * U * s->term * size[(c + 1) % 3] * size[(c + 2) % 3];
        CHECK(is_due((double)p->margin[c], due), "a margin of %g, not %g", (double)p->margin[c],
              due);
    }
    crossed(q[1], q[2], normal);
    const double volume = fabs(along(q[0], normal)), off = (double)p->volume_error;
    CHECK(fabs(fabs((double)p->volume) - volume) <= off, "a volume of %g, not %g",
          (double)p->volume, volume);
    CHECK(is_due(off, 46.0 * U * size[0] * size[1] * size[2]), "a volume's error of %g", off);
    CHECK(is_due((double)p->error * fabs((double)p->volume), 437.0 * U * pow(largest, 3)),
          "a share of %g of shape", (double)p->error);
    CHECK(is_due((double)p->near, 3.5 * U * largest), "%g of nearness", (double)p->near);
}

static void triangles(void) {
    random_state r = {1};
    uint32_t seen = 0;
    for (uint32_t i = 0; i < 3000; i++) {
        plt_record record;
        double q[3][3];
        planes p;
        scene s;
        if (!any_scene(&r, i % 2 ? 2 : 4, &s)) {
            continue;
        }
        seen++;
        memset(&record, 0, sizeof record);
        any_record(&r, &record, q);
        set_planes(&p, &s.beam, &record);
        check_planes(&p, &s, (const double(*)[3])q);
        for (int k = 0; k < 8; k++) {
            check_sample(&s, &p, (const double(*)[3])q, random_below(&r, PLT_PACKET_SIDE_MAX),
                         random_below(&r, PLT_PACKET_SIDE_MAX));
        }
    }
    CHECK(seen > 1000, "%u scenes", (unsigned)seen);
}

/* Of planes that are sure t is the quotient, give or take what the exact test is off by. */
static void bounds_of_t(void) {
    random_state r = {2};
    uint32_t known = 0, open = 0;
    for (uint32_t i = 0; i < 20000; i++) {
        const float sum = random_float(&r, 0.5f, 4.0f),
                    at[3] = {0.5f * sum, 0.25f * sum, 0.25f * sum};
        const float wide = ldexpf(sum, -8 - (int)random_below(&r, 16));
        const float beside[3] = {0.5f * wide, 0.25f * wide, 0.25f * wide};
        planes p = {.volume = random_float(&r, 0.5f, 4.0f)};
        p.volume_error = ldexpf(p.volume, -9 - (int)random_below(&r, 16));
        p.error = ldexpf(1.0f, -7 - (int)random_below(&r, 20));
        p.near = ldexpf(1.0f, -8 - (int)random_below(&r, 20));
        const bounds t = bounds_of(&p, at, beside);
        const double least =
            ((double)p.volume - (double)p.volume_error) / ((double)sum + (double)wide);
        const double most =
            ((double)p.volume + (double)p.volume_error) / ((double)sum - (double)wide);
        const double off = (double)p.error + (double)p.near / least;
        known += (uint32_t)t.is_known;
        open += !t.is_known;
        CHECK(!t.is_known || off <= 0x1p-8, "bounds that are off by %g", off);
        CHECK(!t.is_known || ((double)t.least <= least * (1.0 - off) &&
                              (double)t.least >= least * (1.0 - off - 14.0 * U)),
              "from %g, not %g", (double)t.least, least * (1.0 - off));
        CHECK(!t.is_known || ((double)t.most >= most * (1.0 + off) &&
                              (double)t.most <= most * (1.0 + off + 14.0 * U)),
              "to %g, not %g", (double)t.most, most * (1.0 + off));
    }
    CHECK(known > 1000 && open > 1000, "%u bounds, %u open ones", known, open);
}

/* Where nothing else is off, the roundings of a bound are 5 u of it. */
static void roundings(void) {
    static const float beside[3] = {0, 0, 0};
    random_state r = {3};
    for (uint32_t i = 0; i < 1000; i++) {
        const float at[3] = {random_float(&r, 0.5f, 4.0f), 0, 0};
        const planes p = {.volume = random_float(&r, 0.5f, 4.0f)};
        const double t = (double)(p.volume / at[0]);
        const bounds of = bounds_of(&p, at, beside);
        CHECK(of.is_known && is_due((double)of.most - t, 6.0 * U * t) &&
                  is_due(t - (double)of.least, 6.0 * U * t),
              "from %g to %g, not %g", (double)of.least, (double)of.most, t);
    }
}

/* One plane within its margin: nothing is sure. */
static void sides(void) {
    static const float beside[3] = {1, 2, 4};
    for (int c = 0; c < 3; c++) {
        for (int sign = -1; sign <= 1; sign += 2) {
            float at[3] = {9, 9, 9};
            at[c] = 0.99f * (float)sign * beside[c];
            CHECK((sides_of(at, beside) & 7u) == 5u, "plane %d at %g: %u", c, (double)at[c],
                  sides_of(at, beside));
            at[c] = -1.01f * beside[c];
            CHECK((sides_of(at, beside) & 3u) == 3u, "plane %d at %g is not outside", c,
                  (double)at[c]);
            at[c] = 1.01f * beside[c];
            CHECK(sides_of(at, beside) == 1u, "plane %d at %g is not inside", c, (double)at[c]);
        }
    }
}

int main(void) {
    test("planes and volumes are off by their margins at most, which are what they have to be");
    triangles();
    test("bounds of t are as wide as they have to be, and no wider");
    bounds_of_t();
    roundings();
    test("what is within a margin is on neither side");
    sides();
    return test_done();
}

#else

int main(void) {
    return test_done();
}

#endif

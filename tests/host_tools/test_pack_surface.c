/* test_pack_surface - tables of normals and colours, and what they take
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "engine/surface/octahedral.h"
#include "engine/surface/retrieval.h"
#include "host_tools/pack/palette.h"
#include "host_tools/pack/retrieval_build.h"
#include "host_tools/pack/surface_code.h"
#include "host_tools/pack/texcoord_code.h"
#include "tests/reference/random.h"
#include "tests/reference/surface_rig.h"

static uint32_t value_of(const retrieval_table *t, const uint32_t key[3]) {
    uint32_t place[3];
    plt_retrieval_places(t->third, t->seed, key, place);
    CHECK(place[0] < t->third && place[1] >= t->third && place[1] < 2 * t->third &&
              place[2] >= 2 * t->third && place[2] < 3 * t->third,
          "a place is not in its third");
    return t->entry[place[0]] ^ t->entry[place[1]] ^ t->entry[place[2]];
}

static void gives_values(void) {
    static const size_t COUNTS[] = {1, 2, 3, 7, 100, 1000, 50000};
    test("a table gives each of its keys its value, for 1.23 entries per key and a dozen more");
    for (size_t k = 0; k < sizeof COUNTS / sizeof COUNTS[0]; k++) {
        const size_t n = COUNTS[k];
        random_state r = {k + 1};
        retrieval_pair *pair = calloc(n, sizeof *pair);
        retrieval_table t;
        for (size_t i = 0; i < n; i++) { /* alike, as coordinates on a lattice are */
            pair[i] = (retrieval_pair){{(uint32_t)i % 37, (uint32_t)(i / 37) << 8, 0x3F800000u},
                                       random_bits(&r) & 0xFFFFu};
        }
        CHECK(retrieval_build(&t, pair, n) == 0, "%zu keys: there is none", n);
        CHECK(3.0 * t.third < 1.32 * (double)n + 16, "%zu keys: %u entries", n, 3 * t.third);
        for (size_t i = 0; i < n; i++) {
            CHECK(value_of(&t, pair[i].key) == pair[i].value, "key %zu of %zu", i, n);
        }
        retrieval_free(&t);
        free(pair);
    }
    retrieval_table none;
    CHECK(retrieval_build(&none, NULL, 0) == 0 && none.third == 0, "no key has entries");
}

static void is_near(void) {
    double worst = 0;
    test("a normal of 16 bits is off by less than 0.0115, 0.66 degrees; axes are exact");
    random_state r = {3};
    for (int i = 0; i < 100000; i++) {
        double n[3], length = 0, along = 0;
        float coded[3];
        for (int a = 0; a < 3; a++) {
            n[a] = (double)random_float(&r, -1.0f, 1.0f);
            length += n[a] * n[a];
        }
        const uint32_t code = surface_normal_code(corner_normal(n));
        CHECK(code != PLT_NORMAL_NONE && code != PLT_NORMAL_SPLIT, "it has another meaning");
        plt_octahedral_normal(code, coded);
        for (int a = 0; a < 3; a++) {
            along += n[a] * (double)coded[a];
        }
        worst = fmax(worst, acos(fmin(1.0, along / sqrt(length))));
    }
    CHECK(worst < 0.0115, "%g", worst);
    for (int a = 0; a < 6; a++) {
        const double n[3] = {a / 2 == 0 ? 1 - 2 * (a % 2) : 0, a / 2 == 1 ? 1 - 2 * (a % 2) : 0,
                             a / 2 == 2 ? 1 - 2 * (a % 2) : 0};
        float coded[3];
        plt_octahedral_normal(surface_normal_code(corner_normal(n)), coded);
        for (int k = 0; k < 3; k++) {
            CHECK((double)coded[k] == n[k], "axis %d", a);
        }
    }
    CHECK(surface_normal_code(CORNER_NO_NORMAL) == PLT_NORMAL_NONE, "none is some");
}

static void every_code(void) {
    test("every one of the 65536 codes is a normal of length 1");
    for (uint32_t code = 0; code < 65536; code++) {
        float n[3];
        plt_octahedral_normal(code, n);
        const float squared = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
        CHECK(squared > 0.99999f && squared < 1.00001f, "%04x: %g", code, (double)squared);
    }
}

static uint32_t colour_of(const palette *p, uint32_t colour) {
    const uint8_t *c = p->colour[palette_index(p, colour)];
    return c[0] | (uint32_t)c[1] << 8 | (uint32_t)c[2] << 16;
}

/* The palette's own word on how far off it is, and nothing nearer than what it takes. */
static void check_palette(const palette *p, const uint32_t *colour, size_t count, int is_nearest) {
    uint32_t furthest = 0;
    uint64_t sum = 0;
    for (size_t i = 0; i < count; i++) {
        const uint32_t is = colour_of(p, colour[i]);
        int least = 1 << 30, squared = 0;
        for (int a = 0; a < 24; a += 8) {
            const int off = abs((int)(colour[i] >> a & 255) - (int)(is >> a & 255));
            furthest = (uint32_t)off > furthest ? (uint32_t)off : furthest;
            sum += (uint64_t)off;
            squared += off * off;
        }
        for (uint32_t k = 0; k < p->count && is_nearest; k++) {
            int other = 0;
            for (int a = 0; a < 3; a++) {
                const int off = (int)(colour[i] >> 8 * a & 255) - p->colour[k][a];
                other += off * off;
            }
            least = other < least ? other : least;
        }
        CHECK(!is_nearest || least == squared, "colour %06x: %d, not %d", colour[i], squared,
              least);
    }
    CHECK(furthest == p->furthest, "%u, not %u", p->furthest, furthest);
    CHECK(fabs(p->mean - (double)sum / (3.0 * (double)count)) < 1e-9, "%g on average", p->mean);
}

static void keeps_few(void) {
    test("colours that are few stay what they are");
    uint32_t many[4096];
    palette p;
    for (uint32_t i = 0; i < 4096; i++) {
        many[i] = (i & 15) * 17 | (i >> 4 & 15) * 17 << 8 | (i >> 8) * 17 << 16;
    }
    CHECK(palette_make(&p, many, 255, 2) == 0 && p.count == 255 && p.furthest == 0, "%u, %u",
          p.count, p.furthest);
    for (uint32_t i = 0; i < 255; i++) {
        CHECK(colour_of(&p, many[i]) == many[i], "colour %u", i);
    }
    palette_free(&p);
    CHECK(palette_make(&p, many, 2047, 2) == 0 && p.count == 2047 && p.furthest == 0, "%u, %u",
          p.count, p.furthest);
    check_palette(&p, many, 2047, 1);
    palette_free(&p);
    CHECK(palette_make(&p, many, 0, 2) == 0 && p.count == 1, "%u of none", p.count);
    palette_free(&p);
}

static void keeps_many(void) {
    test("of many none is far from what stands for it, which is the nearest that there is");
    uint32_t many[4096];
    palette p;
    for (uint32_t i = 0; i < 4096; i++) {
        many[i] = (i & 15) * 17 | (i >> 4 & 15) * 17 << 8 | (i >> 8) * 17 << 16;
    }
    CHECK(palette_make(&p, many, 4096, 34) == 0 && p.count == 255 && p.distinct == 4096, "%u of %u",
          p.count, p.distinct);
    CHECK(p.furthest <= 34, "%u of 255", p.furthest);
    check_palette(&p, many, 4096, 0);
    palette_free(&p);
    random_state r = {11};
    for (uint32_t i = 0; i < 4096; i++) {
        many[i] = random_bits(&r) & 0x7FFFFF;
    }
    CHECK(palette_make(&p, many, 4096, 2) == 0 && p.count == 2047, "%u", p.count);
    CHECK(p.furthest <= 20 && p.mean < 3, "%u, %g", p.furthest, p.mean);
    check_palette(&p, many, 4096, 1);
    palette_free(&p);
    for (uint32_t i = 0; i < 4096; i++) { /* a thousand pairs that are next to each other */
        many[i] = ((i >> 1 & 15) * 8 + (i & 1)) | (i >> 6) * 3 << 8;
    }
    CHECK(palette_make(&p, many, 4096, 2) == 0 && p.count < 2047 && p.furthest <= 2,
          "%u, off by %u", p.count, p.furthest);
    palette_free(&p);
}

static void codes_steps(void) {
    test("texture coordinates are off by half a step at most; bits go where steps are large");
    static const struct {
        double low[2], high[2];
        uint32_t bits, share;
    } CASES[] = {{{0, 0}, {1, 1}, 24, 12},        {{-3, 2}, {29, 4}, 24, 14},
                 {{0, 0}, {0.001, 60000}, 24, 8}, {{0, 0}, {1, 1}, 32, 16},
                 {{5, 5}, {5, 5}, 24, 12},        {{-65536, 0}, {65536, 1}, 32, 16}};
    random_state r = {5};
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        texcoord_code t = texcoord_code_begin();
        texcoord_code_add(&t, CORNER_NO_TEXCOORD, CORNER_NO_TEXCOORD);
        texcoord_code_add(&t, corner_texcoord(CASES[i].low[0]), corner_texcoord(CASES[i].high[1]));
        texcoord_code_add(&t, corner_texcoord(CASES[i].high[0]), corner_texcoord(CASES[i].low[1]));
        texcoord_code_end(&t, CASES[i].bits);
        CHECK(t.steps.bits[0] == CASES[i].share &&
                  t.steps.bits[0] + t.steps.bits[1] == CASES[i].bits,
              "case %zu: %u and %u bits", i, t.steps.bits[0], t.steps.bits[1]);
        for (int k = 0; k < 2000; k++) {
            uint32_t at[2];
            float is[2];
            for (int a = 0; a < 2; a++) {
                const double share = k < 4 ? k >> a & 1 : (double)random_float(&r, 0.0f, 1.0f);
                at[a] =
                    corner_texcoord(CASES[i].low[a] + share * (CASES[i].high[a] - CASES[i].low[a]));
            }
            const uint32_t value = texcoord_code_value(&t, at[0], at[1]);
            plt_texcoord_decode(&t.steps, value, is);
            CHECK((value & plt_texcoord_split(&t.steps)) != plt_texcoord_split(&t.steps),
                  "it has another meaning");
            for (int a = 0; a < 2; a++) {
                const double due = (double)plt_float_of(at[a]), step = (double)t.steps.step[a];
                const double off = fabs((double)is[a] - due);
                CHECK(off <= 0.5001 * step + 1e-6 * fabs(due), "case %zu, axis %d: %g for %g", i, a,
                      (double)is[a], due);
                CHECK(off <= t.off, "%g is more than it says, %g", off, t.off);
            }
        }
        const uint32_t none = texcoord_code_value(&t, CORNER_NO_TEXCOORD, CORNER_NO_TEXCOORD);
        CHECK((none & plt_texcoord_split(&t.steps)) == plt_texcoord_split(&t.steps) &&
                  none != plt_texcoord_split(&t.steps),
              "%x", none);
    }
}

static surface_stats stats_of(const mesh *m, const mesh_corners *c, packed *image) {
    const rig_config config = rig_config_of(2, 8, PLT_BUILD_NONE, PLT_SPLIT_SAH);
    surface_stats stats;
    fail f = {""};
    CHECK(pack_mesh(image, m, &config.pack, "test", &f) == 0, "%s", f.text);
    const packed before = *image;
    unsigned char *bytes = malloc(before.size);
    memcpy(bytes, before.bytes, before.size);
    CHECK(surface_add(image, c, "test", &stats, &f) == 0, "%s", f.text);
    const uint32_t first = 24, last = before.size; /* sizes and checks are behind the magic */
    CHECK(memcmp(image->bytes + first, bytes + first, 228 - first) == 0 &&
              memcmp(image->bytes + 232, bytes + 232, last - 232) == 0,
          "tree and triangles have changed");
    free(bytes);
    return stats;
}

static void takes_little(void) {
    test("a smooth mesh takes at most 1.5, 1 and 2 bytes per triangle; tree and triangles stay");
    mesh m = {0};
    mesh_corners c = {0};
    packed image;
    shape_icosphere(&m, 4);
    CHECK(mesh_smooth(&m, 180, &c) == 0, "no memory");
    surface_rig_colour(&m, &c, 8);
    surface_rig_unwrap(&m, &c, 2);
    const surface_stats s = stats_of(&m, &c, &image);
    const double n = (double)m.triangles;
    CHECK(s.normals.bytes / n <= 1.5 && s.colours.bytes / n <= 1.0 && s.texcoords.bytes / n <= 2.0,
          "%g, %g and %g", s.normals.bytes / n, s.colours.bytes / n, s.texcoords.bytes / n);
    CHECK(s.texcoords.split == 0 && s.texcoords_off < 2 * 0.5 / 2047, "%g", s.texcoords_off);
    CHECK(s.normals.split == 0 && s.normals.positions == m.triangles / 2 + 2, "%llu, %llu",
          (unsigned long long)s.normals.positions, (unsigned long long)s.normals.split);
    CHECK(image.info.normal_bytes == s.normals.bytes &&
              image.info.colour_bytes == s.colours.bytes &&
              image.info.texcoord_bytes == s.texcoords.bytes,
          "the info has others");
    pack_free(&image);
    corners_free(&c);
    mesh_free(&m);
}

static void splits(void) {
    test("where all corners differ they are found by triangle alone; where few do, by both");
    mesh m = {0};
    mesh_corners c = {0};
    packed image;
    shape_cube(&m);
    CHECK(mesh_smooth(&m, 30, &c) == 0, "no memory");
    surface_stats s = stats_of(&m, &c, &image);
    CHECK(s.normals.positions == 0 && s.normals.split == 36, "%llu and %llu",
          (unsigned long long)s.normals.positions, (unsigned long long)s.normals.split);
    pack_free(&image);
    shape_icosphere(&m, 3);
    corners_free(&c);
    CHECK(mesh_smooth(&m, 30, &c) == 0, "no memory");
    s = stats_of(&m, &c, &image);
    CHECK(s.normals.positions == 8 + 642 && s.normals.split == 36, "%llu and %llu",
          (unsigned long long)s.normals.positions, (unsigned long long)s.normals.split);
    pack_free(&image);
    corners_free(&c);
    mesh_free(&m);
}

int main(void) {
    gives_values();
    is_near();
    every_code();
    keeps_few();
    keeps_many();
    codes_steps();
    takes_little();
    splits();
    return test_done();
}

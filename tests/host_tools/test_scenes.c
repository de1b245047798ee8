/* test_scenes - the built-in meshes: counts, shape, and the same bits everywhere
 *
 * Golden values: FNV-1a, 64 bits (board/hash.h), over the vertices as
 * little-endian IEEE single precision and then the indices as little-endian
 * 32-bit words.
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>

#include "board/hash.h"
#include "host_tools/scenes/cos_sin.h"
#include "host_tools/scenes/noise.h"
#include "host_tools/scenes/scenes.h"
#include "tests/test.h"

#if defined(__SANITIZE_ADDRESS__)
#define SANITIZED 1 /* which takes terabytes of address space */
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SANITIZED 1
#endif
#endif
#ifndef SANITIZED
#define SANITIZED 0
#endif

static int make(mesh *m, char scene, uint64_t number, fail *f) {
    switch (scene) {
    case 'g':
        return scene_ground(m, f);
    case 'm':
        return scene_marbles(m, SCENE_MARBLES_MOST, (unsigned)number, f);
    case 'c':
        return scene_city(m, (unsigned)number, f);
    case 't':
        return scene_terrain(m, number, f);
    case 'r':
        return scene_room(m, number, 0, f);
    case 's': /* another room */
        return scene_room(m, number, 7, f);
    default:
        return scene_knot(m, number, f);
    }
}

static mesh made(char scene, uint64_t number) {
    mesh m = {0};
    fail f = {""};
    CHECK(make(&m, scene, number, &f) == 0, "%c %" PRIu64 ": %s", scene, number, f.text);
    return m;
}

static uint64_t hash_word(uint64_t hash, uint32_t word) {
    const uint8_t bytes[4] = {(uint8_t)word, (uint8_t)(word >> 8), (uint8_t)(word >> 16),
                              (uint8_t)(word >> 24)};
    return hash_update(hash, bytes, sizeof bytes);
}

static uint64_t mesh_hash(const mesh *m) {
    uint64_t hash = HASH_BASIS;
    for (size_t i = 0; i < 3 * m->vertices; i++) {
        uint32_t word;
        memcpy(&word, &m->vertex[i], 4);
        hash = hash_word(hash, word);
    }
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        hash = hash_word(hash, m->triangle[i]);
    }
    return hash;
}

static void test_golden(void) {
    static const struct {
        char scene;
        uint64_t number;
        size_t vertices, triangles;
        uint64_t hash;
    } golden[] = {
        {'g', 0, 8, 12, 0xB12832159B096EF5},
        {'c', 0, 25064, 44844, 0x8BE9851F423BCF55},
        {'c', 60, 25064, 44844, 0x1EA6B752658FCACD},
        {'c', 99999, 25064, 44844, 0x92A3080AD738060D},
        {'m', 0, 4620, 8800, 0x044575C989F444A2},
        {'m', 1, 4620, 8800, 0x99D8933F892E72DA},
        {'m', 100, 4620, 8800, 0x12C9545C240F3E35},
        {'m', 500, 4620, 8800, 0x5F416089B5A9B8E0},
        {'t', 2, 4, 2, 0x5C5A3862F0CF47DF},
        {'t', 1000, 529, 968, 0xFDCCEFACFB435170},
        {'t', 100000, 50400, 99904, 0x56479161E207E2C2},
        {'k', 24, 12, 24, 0xEBDD8A992A1F4468},
        {'k', 1000, 497, 994, 0x330E0B7527CDB241},
        {'k', 100000, 49980, 99960, 0x90DDD7F92F7AF280},
        {'r', 24000, 13559, 22614, 0xA3D2FE0ED78A7F0F},
        {'r', 100000, 52214, 99924, 0xAC3D2943982E5D68},
        {'s', 100000, 51760, 98748, 0xDBE8037DD92761A3},
    };
    test("scenes: vertices, triangles and every bit of them are the golden ones");
    for (size_t i = 0; i < sizeof golden / sizeof golden[0]; i++) {
        mesh m = made(golden[i].scene, golden[i].number);
        CHECK(m.vertices == golden[i].vertices && m.triangles == golden[i].triangles,
              "%c %" PRIu64 ": %zu vertices, %zu triangles", golden[i].scene, golden[i].number,
              m.vertices, m.triangles);
        CHECK(mesh_hash(&m) == golden[i].hash, "{'%c', %" PRIu64 ", %zu, %zu, 0x%016" PRIX64 "},",
              golden[i].scene, golden[i].number, m.vertices, m.triangles, mesh_hash(&m));
        mesh_free(&m);
    }
}

static void test_counts(void) {
    static const uint64_t asked[] = {24, 25, 26, 31, 100, 999, 1000, 4711, 12345, 100000, 1234567};
    test("counts: never more than asked for, fewer by less than 2 columns or 2 sides");
    for (unsigned i = 0; i < sizeof asked / sizeof asked[0]; i++) {
        mesh t = made('t', asked[i]), k = made('k', asked[i]);
        const uint64_t columns = (uint64_t)sqrt((double)(asked[i] / 2));
        const uint64_t root = (uint64_t)sqrt((double)(asked[i] / 20)), sides = root < 3 ? 3 : root;
        CHECK(t.triangles <= asked[i] && t.triangles + 2 * columns > asked[i] - 1,
              "terrain %" PRIu64 ": %zu", asked[i], t.triangles);
        CHECK(t.triangles == 2 * columns * (asked[i] / 2 / columns), "terrain: not by the rule");
        CHECK(t.vertices == (columns + 1) * (t.triangles / 2 / columns + 1), "not shared");
        CHECK(k.triangles == 2 * sides * (asked[i] / 2 / sides), "knot %" PRIu64 ": %zu", asked[i],
              k.triangles);
        CHECK(2 * k.vertices == k.triangles, "knot: %zu vertices", k.vertices);
        mesh_free(&t);
        mesh_free(&k);
    }
}

static void test_room_counts(void) {
    static const uint64_t asked[] = {24000, 30000, 52000, 100000, 1000000, 10000000};
    test("room: never more triangles than asked for, fewer by less than a third, for any seed");
    for (unsigned i = 0; i < sizeof asked / sizeof asked[0]; i++) {
        for (uint32_t seed = 0; seed < (asked[i] > 100000 ? 1 : 40); seed++) {
            const uint32_t which = seed == 39 ? 701611 : seed; /* the most of all seeds */
            mesh m = {0};
            fail f = {""};
            CHECK(scene_room(&m, asked[i], which, &f) == 0, "%s", f.text);
            CHECK(m.triangles <= asked[i] && 3 * m.triangles > 2 * asked[i],
                  "%zu triangles of %" PRIu64 ", seed %u", m.triangles, asked[i], (unsigned)which);
            mesh_free(&m);
        }
    }
}

static int by_value(const void *left, const void *right) {
    const uint64_t a = *(const uint64_t *)left, b = *(const uint64_t *)right;
    return (a > b) - (a < b);
}

/* Directed edges that occur twice, and those without their opposite. */
static void count_edges(const mesh *m, size_t *twice, size_t *alone) {
    const size_t count = 3 * m->triangles;
    uint64_t *edge = malloc(count * sizeof *edge);
    *twice = *alone = 0;
    for (size_t i = 0; i < count; i++) {
        const uint64_t from = m->triangle[i];
        const uint64_t to = m->triangle[i % 3 == 2 ? i - 2 : i + 1];
        edge[i] = from << 32 | to;
    }
    qsort(edge, count, sizeof *edge, by_value);
    for (size_t i = 0; i < count; i++) {
        const uint64_t opposite = edge[i] << 32 | edge[i] >> 32;
        *twice += i > 0 && edge[i] == edge[i - 1];
        *alone += !bsearch(&opposite, edge, count, sizeof *edge, by_value);
    }
    free(edge);
}

static double volume(const mesh *m) {
    double sum = 0.0;
    for (size_t i = 0; i < m->triangles; i++) {
        const float *a = m->vertex + 3 * (size_t)m->triangle[3 * i];
        const float *b = m->vertex + 3 * (size_t)m->triangle[3 * i + 1];
        const float *c = m->vertex + 3 * (size_t)m->triangle[3 * i + 2];
        for (unsigned k = 0; k < 3; k++) {
            const unsigned p = (k + 1) % 3, q = (k + 2) % 3;
            sum += (double)a[k] * ((double)b[p] * (double)c[q] - (double)b[q] * (double)c[p]);
        }
    }
    return sum / 6.0;
}

/* `euler`: vertices - edges + triangles. */
static void check_closed(char scene, uint64_t number, long euler, double least, double most) {
    mesh m = made(scene, number);
    size_t twice, alone;
    count_edges(&m, &twice, &alone);
    CHECK(twice == 0 && alone == 0, "%c %" PRIu64 ": %zu edges twice, %zu alone", scene, number,
          twice, alone);
    CHECK((long)m.vertices - (long)(3 * m.triangles / 2) + (long)m.triangles == euler, "%c: V-E+F",
          scene);
    const double v = volume(&m);
    CHECK(v > least && v < most, "%c %" PRIu64 ": volume %g", scene, number, v);
    mesh_free(&m);
}

static uint32_t root_of(uint32_t *parent, uint32_t i) {
    while (parent[i] != i) {
        i = parent[i] = parent[parent[i]];
    }
    return i;
}

/* Six times the volume of every surface, at the first vertex that its root is. */
static double *surface_volumes(const mesh *m, uint32_t *parent) {
    double *volumes = calloc(m->vertices, sizeof *volumes);
    for (uint32_t i = 0; i < m->vertices; i++) {
        parent[i] = i;
    }
    for (size_t i = 0; i < 3 * m->triangles; i++) {
        const uint32_t a = root_of(parent, m->triangle[i]);
        parent[a] = root_of(parent, m->triangle[i % 3 == 2 ? i - 2 : i + 1]);
    }
    for (size_t i = 0; i < m->triangles; i++) {
        mesh one = *m;
        one.triangle += 3 * i;
        one.triangles = 1;
        volumes[root_of(parent, m->triangle[3 * i])] += 6.0 * volume(&one);
    }
    return volumes;
}

/* Every surface is closed and a ball in topology, and its outside is out. */
static void check_room(char scene, uint64_t number) {
    mesh m = made(scene, number);
    uint32_t *parent = calloc(m.vertices, sizeof *parent);
    double *volumes = surface_volumes(&m, parent);
    long surfaces = 0, cavities = 0;
    for (uint32_t i = 0; i < m.vertices; i++) {
        surfaces += parent[i] == i;
        cavities += parent[i] == i && volumes[i] < 0.0;
        CHECK(parent[i] != i || fabs(volumes[i]) > 1e-9, "a surface without volume at %u",
              (unsigned)i);
    }
    CHECK(cavities == 1, "%ld cavities", cavities);
    CHECK(surfaces > 500, "%ld surfaces", surfaces);
    free(volumes);
    free(parent);
    mesh_free(&m);
    check_closed(scene, number, 2 * surfaces, 10.0, 30.0);
}

static void test_manifolds(void) {
    test(
        "knot: closed, every edge has two triangles, one in each direction; one handle; outside is "
        "out");
    check_closed('k', 24, 0, -99, 99); /* too coarse to have an inside */
    check_closed('k', 1000, 0, 15, 25);
    check_closed('k', 123456, 0, 23, 25);
    test("ground: closed, 20 x 0.5 x 20, outside is out");
    check_closed('g', 0, 2, 199.99, 200.01);
    test("marbles: 110 closed surfaces, outside is out");
    check_closed('m', 0, 220, 1100, 1600);
    check_closed('m', 77, 220, 1100, 1600);

    test("room: closed surfaces, the cavity alone is within out");
    check_room('r', 24000);
    check_room('r', 200000);
    check_room('s', 50000);

    test("city: 1,321 closed surfaces, outside is out");
    check_closed('c', 0, 2 * 1321, 790000, 810000);
    check_closed('c', 140, 2 * 1321, 790000, 810000);

    test("terrain: one sheet whose edges are shared but for its border");
    mesh m = made('t', 20000);
    size_t twice, alone;
    count_edges(&m, &twice, &alone);
    CHECK(twice == 0 && alone == 400, "%zu edges twice, %zu alone", twice, alone);
    mesh_free(&m);
}

/* 4 area^2 over the longest edge to the fourth; 0 for a degenerate one. */
static double fatness(const mesh *m, size_t triangle) {
    const float *p[3];
    double longest = 0.0, edge[3][3], area = 0.0;
    for (unsigned i = 0; i < 3; i++) {
        p[i] = m->vertex + 3 * (size_t)m->triangle[3 * triangle + i];
    }
    for (unsigned i = 0; i < 3; i++) {
        double length = 0.0;
        for (unsigned k = 0; k < 3; k++) {
            edge[i][k] = (double)p[(i + 1) % 3][k] - (double)p[i][k];
            length += edge[i][k] * edge[i][k];
        }
        longest = length > longest ? length : longest;
    }
    for (unsigned k = 0; k < 3; k++) {
        const unsigned a = (k + 1) % 3, b = (k + 2) % 3;
        const double part = edge[0][a] * edge[1][b] - edge[0][b] * edge[1][a];
        area += part * part;
    }
    return longest > 0.0 ? area / (longest * longest) : 0.0;
}

static void test_degenerate(void) {
    static const struct {
        char scene;
        uint64_t number;
    } all[] = {{'g', 0},        {'m', 0},     {'m', 333},      {'c', 0},
               {'c', 70},       {'t', 2},     {'t', 3000},     {'t', 300000},
               {'t', 10000000}, {'k', 24},    {'k', 300},      {'k', 300000},
               {'k', 10000000}, {'r', 24000}, {'r', 10000000}, {'s', 300000}};
    test("scenes: no degenerate triangle, every index in range, every vertex finite and used");
    for (size_t i = 0; i < sizeof all / sizeof all[0]; i++) {
        mesh m = made(all[i].scene, all[i].number);
        double least = 1.0;
        size_t wild = 0, used = 0;
        uint8_t *seen = calloc(1, m.vertices + 1);
        for (size_t k = 0; k < 3 * m.triangles; k++) {
            const int bad = m.triangle[k] >= m.vertices;
            wild += bad;
            used += !bad && !seen[m.triangle[k]]++;
            seen[bad ? m.vertices : m.triangle[k]] = 1;
        }
        for (size_t k = 0; k < 3 * m.vertices; k++) {
            wild += !(m.vertex[k] > -140.0f && m.vertex[k] < 140.0f);
        }
        CHECK(wild == 0, "%c %" PRIu64 ": %zu wild", all[i].scene, all[i].number, wild);
        CHECK(used == m.vertices, "%zu of %zu vertices used", used, m.vertices);
        for (size_t k = 0; wild == 0 && k < m.triangles; k++) {
            const double fat = fatness(&m, k);
            least = fat < least ? fat : least;
        }
        /* Boards and rounded edges of a room are long. */
        const double thin = all[i].scene == 'r' || all[i].scene == 's' ? 1e-9 : 1e-4;
        CHECK(least > thin, "%c %" PRIu64 ": thinnest %g", all[i].scene, all[i].number, least);
        free(seen);
        mesh_free(&m);
    }
}

/* From and to which x, y and z people are. */
static void extent_of_people(unsigned frame, float lo[3], float hi[3]) {
    mesh m = made('c', frame);
    for (unsigned a = 0; a < 3; a++) {
        lo[a] = 1e9f;
        hi[a] = -1e9f;
        for (size_t i = 3 * (m.triangles - SCENE_CITY_MOVING); i < 3 * m.triangles; i++) {
            const float x = m.vertex[3 * (size_t)m.triangle[i] + a];
            lo[a] = x < lo[a] ? x : lo[a];
            hi[a] = x > hi[a] ? x : hi[a];
        }
    }
    mesh_free(&m);
}

static void test_city(void) {
    static const unsigned frames[] = {0, 25, 140};
    float lo[3][3], hi[3][3];
    test(
        "city: people on a lift, on the ground, all over the city; then they stay; no house moves");
    for (unsigned i = 0; i < 3; i++) {
        extent_of_people(frames[i], lo[i], hi[i]);
    }
    CHECK(lo[0][1] > 70.0f && hi[0][0] - lo[0][0] < 16.0f && hi[0][2] - lo[0][2] < 16.0f, "0");
    CHECK(lo[1][1] > -0.1f && hi[1][1] < 2.0f && hi[1][0] - lo[1][0] < 16.0f, "25");
    CHECK(lo[2][0] < -100.0f && hi[2][0] > 100.0f && lo[2][2] < -100.0f && hi[2][2] > 100.0f &&
              lo[2][1] < -5.0f && hi[2][1] > 30.0f,
          "140");
    mesh last = made('c', 140), later = made('c', 5000), first = made('c', 0);
    const size_t still = 3 * (last.triangles - SCENE_CITY_MOVING);
    CHECK(last.triangles == SCENE_CITY_TRIANGLES && mesh_hash(&last) == mesh_hash(&later), "stay");
    for (size_t i = 0; i < 3 * first.triangles; i++) {
        const size_t v = 3 * (size_t)first.triangle[i];
        CHECK(first.triangle[i] == last.triangle[i] &&
                  (i >= still || memcmp(&first.vertex[v], &last.vertex[v], 12) == 0),
              "corner %zu", i);
    }
    mesh_free(&first);
    mesh_free(&last);
    mesh_free(&later);
}

static void test_refusals(void) {
    static const struct {
        char scene;
        uint64_t number;
    } bad[] = {{'t', 0}, {'t', 1},     {'t', 10000001}, {'t', UINT64_MAX},
               {'k', 0}, {'k', 23},    {'k', 10000001}, {'k', UINT64_MAX},
               {'r', 0}, {'r', 23999}, {'r', 10000001}, {'r', UINT64_MAX}};
    test("scenes: a count out of range is refused with the range, the mesh is left alone");
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        mesh m = {0};
        fail f = {""};
        CHECK(make(&m, bad[i].scene, bad[i].number, &f) == -1, "made");
        CHECK(strstr(f.text, "10000000") && !strchr(f.text, '\n'), "\"%s\"", f.text);
        CHECK(m.vertices == 0 && m.triangles == 0, "something was left");
        mesh_free(&m);
    }
    test("scenes: a second scene is appended, with its own vertex indices");
    mesh m = made('g', 0);
    fail f = {""};
    CHECK(make(&m, 'k', 24, &f) == 0 && make(&m, 'm', 0, &f) == 0, "%s", f.text);
    CHECK(m.vertices == 8 + 12 + 4620 && m.triangles == 12 + 24 + 8800, "%zu %zu", m.vertices,
          m.triangles);
    size_t twice, alone;
    count_edges(&m, &twice, &alone);
    CHECK(twice == 0 && alone == 0, "%zu edges twice, %zu alone", twice, alone);
    const size_t vertices = m.vertices;
    m.vertices = UINT32_MAX - 10;
    CHECK(make(&m, 't', 2, &f) == -1 && f.text[0], "vertex numbers ran over");
    m.vertices = vertices;
    mesh_free(&m);
}

static void test_memory(void) {
    struct rlimit before, less;
    if (SANITIZED) {
        printf("    out of memory is not tried: the sanitizer needs all address space\n");
        return;
    }
    test("scenes: out of memory is one line, and the mesh is as it was before");
    CHECK(getrlimit(RLIMIT_AS, &before) == 0, "no limit");
    for (unsigned i = 0; i < 3; i++) {
        mesh m = made('g', 0);
        fail f = {""};
        less = before;
        less.rlim_cur = 100u << 20;
        CHECK(setrlimit(RLIMIT_AS, &less) == 0, "no limit");
        CHECK(make(&m, "tkr"[i], 10000000, &f) == -1, "240 MB fitted into 100");
        CHECK(setrlimit(RLIMIT_AS, &before) == 0, "the limit stays");
        CHECK(f.text[0] && !strchr(f.text, '\n'), "\"%s\"", f.text);
        CHECK(m.vertices == 8 && m.triangles == 12, "%zu %zu", m.vertices, m.triangles);
        mesh_free(&m);
    }
}

static void test_cos_sin(void) {
    test("cos_sin: sine and cosine agree with libm to 1e-15, quarters of the circle are exact");
    for (uint64_t i = 0; i <= 20000; i++) {
        const double angle = 2.0 * 3.14159265358979323846 * (double)i / 20000.0;
        const cos_sin t = cos_sin_of(i, 20000);
        CHECK(fabs(t.sine - sin(angle)) < 2e-15 && fabs(t.cosine - cos(angle)) < 2e-15,
              "%" PRIu64 ": %g %g", i, t.sine - sin(angle), t.cosine - cos(angle));
    }
    for (uint64_t i = 0; i < 8; i++) {
        static const double exact[4] = {0.0, 1.0, 0.0, -1.0};
        const cos_sin t = cos_sin_of(i, 4);
        CHECK(t.sine == exact[i % 4] && t.cosine == exact[(i + 1) % 4], "quarter %" PRIu64, i);
    }
}

static void test_noise(void) {
    double lowest = 0.0, highest = 0.0, steepest = 0.0, last = noise_gradient(-40.0, 5.3, 9);
    test("noise: 0 at whole numbers, within -1 .. 1, without a jump, both signs");
    for (int i = -400; i < 400; i++) {
        CHECK(noise_gradient(i, i / 3, 9) == 0.0, "not 0 at %d", i);
    }
    for (unsigned i = 1; i < 100000; i++) {
        const double n = noise_gradient(-40.0 + 1e-3 * i, 5.3, 9), step = fabs(n - last);
        lowest = n < lowest ? n : lowest;
        highest = n > highest ? n : highest;
        steepest = step > steepest ? step : steepest;
        last = n;
    }
    CHECK(lowest >= -1.0 && lowest < -0.3 && highest <= 1.0 && highest > 0.3, "%g .. %g", lowest,
          highest);
    CHECK(steepest < 4e-3, "a step of %g in 1/1000", steepest);

    test("terrain: valleys near 0 and mountains above 2, nothing below 0 or above 9");
    mesh m = made('t', 200000);
    size_t valley = 0, mountain = 0;
    for (size_t i = 0; i < m.vertices; i++) {
        const float y = m.vertex[3 * i + 1];
        CHECK(y >= 0.0f && y < 9.0f, "height %g", (double)y);
        valley += y < 0.3f;
        mountain += y > 2.0f;
    }
    CHECK(valley > m.vertices / 20, "%zu of %zu", valley, m.vertices);
    CHECK(mountain > m.vertices / 200, "%zu of %zu", mountain, m.vertices);
    mesh_free(&m);
}

int main(void) {
    test_golden();
    test_counts();
    test_room_counts();
    test_manifolds();
    test_degenerate();
    test_city();
    test_refusals();
    test_memory();
    test_cos_sin();
    test_noise();
    return test_done();
}

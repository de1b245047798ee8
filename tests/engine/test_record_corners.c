/* test_record_corners - records rewritten from vertices or corners, against a plain loop
 *
 * Coordinates are few, so that most triangles have equal ones, zeros of both signs and corners that
 * are one point.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/motion/corners.h"
#include "engine/motion/vertices.h"
#include "tests/test.h"

enum { VERTICES = 31, MOST = 403 };

static uint32_t state = 1;

static uint32_t random_below(uint32_t count) {
    state = state * 1664525u + 1013904223u;
    return (uint32_t)((uint64_t)(state >> 8) * count >> 24);
}

/* A mesh whose triangles are in another order in its records. */
typedef struct bed {
    plt_frame_vertex vertex[VERTICES + 1];
    float position[VERTICES][3];
    uint32_t index[MOST][3];
    unsigned char topology[12 * MOST + PLT_BITS_BEHIND];
    plt_vertices v;
    plt_record *records, *expected; /* `count` each, and nothing behind them */
    uint32_t count;
} bed;

/* ---- what is expected ---------------------------------------------------------------------- */

/* By x, y and z, in turn. */
static int is_below(const double *a, const double *b) {
    for (int axis = 0; axis < 3; axis++) {
        if (a[axis] != b[axis]) {
            return a[axis] < b[axis];
        }
    }
    return 0;
}

/* Compared as they are in the frame: on a lattice, coordinates. */
static unsigned first_of(const bed *b, const uint32_t index[3]) {
    unsigned first = 0;
    double at[3][3];
    for (unsigned k = 0; k < 3; k++) {
        for (int axis = 0; axis < 3; axis++) {
            at[k][axis] = b->v.lattice.bits == 0 ? (double)b->position[index[k]][axis]
                                                 : (double)b->vertex[index[k]].word[axis];
        }
        first = is_below(at[k], at[first]) ? k : first;
    }
    return first;
}

static void expect(bed *b) {
    for (uint32_t i = 0; i < b->count; i++) {
        const uint32_t word = plt_get_u32(&b->records[i].word[9]);
        const uint32_t *index = b->index[plt_primitive_id(word)];
        const unsigned first = first_of(b, index);
        for (unsigned k = 0; k < 3; k++) {
            const float *from = b->position[index[(first + k) % 3]];
            plt_put_floats((unsigned char *)&b->expected[i].word[3 * k], from, 3);
        }
        plt_put_u32(&b->expected[i].word[9], (word & ~(3u << PLT_PRIMITIVE_ROTATION_SHIFT)) |
                                                 (3 - first) % 3 << PLT_PRIMITIVE_ROTATION_SHIFT);
    }
}

static void compare(const bed *b, const char *from) {
    CHECK(b->count == 0 || memcmp(b->records, b->expected, b->count * sizeof *b->records) == 0,
          "%u records of %s, lattice bits %u, numbers of %u bits", (unsigned)b->count, from,
          (unsigned)b->v.lattice.bits, (unsigned)b->v.index_bits);
}

/* ---- what is made -------------------------------------------------------------------------- */

static void put_vertices(bed *b) {
    static const float few[5] = {-1.5f, -0.0f, 0.0f, 1.5f, 2.0f};
    const plt_lattice *l = &b->v.lattice;
    for (uint32_t i = 0; i < VERTICES; i++) {
        for (int a = 0; a < 3; a++) {
            if (l->bits == 0) {
                b->position[i][a] = few[random_below(5)];
                memcpy(&b->vertex[i].word[a], &b->position[i][a], 4);
            } else { /* the last ones round to one float */
                b->vertex[i].word[a] = random_below(2) * ((1u << l->bits) - 3) + random_below(3);
                b->position[i][a] = plt_lattice_float(l, a, b->vertex[i].word[a]);
            }
        }
    }
}

static void put_triangles(bed *b) {
    for (uint32_t i = 0; i < b->count; i++) {
        const uint32_t id = b->count - 1 - i;
        for (uint32_t k = 0; k < 3; k++) {
            b->index[id][k] = random_below(VERTICES);
            plt_bits_put(b->topology, (3 * id + k) * b->v.index_bits, b->v.index_bits,
                         b->index[id][k]);
        }
        memset(&b->records[i], 0xA5, sizeof b->records[i]);
        plt_put_u32(&b->records[i].word[9],
                    id | random_below(4) << PLT_PRIMITIVE_ROTATION_SHIFT | random_below(2) << 31);
    }
}

static void begin(bed *b, uint32_t count, uint32_t index_bits, uint32_t lattice_bits) {
    memset(b, 0, sizeof *b);
    b->count = count;
    b->records = malloc(count * sizeof *b->records + 1);
    b->expected = malloc(count * sizeof *b->expected + 1);
    b->v.vertex = b->vertex;
    b->v.topology = b->topology;
    b->v.index_bits = index_bits;
    b->v.lattice.bits = lattice_bits;
    b->v.lattice.step = 0.25f;
    b->v.lattice.origin[0] = -3.0f;
    b->v.lattice.origin[2] = 1048576.0f; /* where a step is less than a float's last bit */
    put_vertices(b);
    put_triangles(b);
    expect(b);
}

static void end(bed *b) {
    free(b->records);
    free(b->expected);
}

static const uint32_t counts[] = {0, 1, 2, 3, 4, 5, 7, 8, 25, 28, 29, MOST};

static void from_vertices(void) {
    static const uint32_t bits[] = {5, 16, 19, 20, 27, 32};
    test("records of vertices are those of a plain loop");
    for (unsigned n = 0; n < sizeof counts / sizeof *counts; n++) {
        for (unsigned w = 0; w < sizeof bits / sizeof *bits; w++) {
            for (uint32_t lattice_bits = 0; lattice_bits <= 21; lattice_bits += 7) {
                static bed b;
                begin(&b, counts[n], bits[w], lattice_bits);
                plt_vertices_put(b.records, b.count, &b.v);
                compare(&b, "vertices");
                end(&b);
            }
        }
    }
}

/* Of as many floats as there are, so that a reader behind the last is found. */
static void from_corners(void) {
    test("records of corners are those of a plain loop");
    for (unsigned n = 0; n < sizeof counts / sizeof *counts; n++) {
        static bed b;
        begin(&b, counts[n], 16, 0);
        float(*corners)[9] = malloc(counts[n] * sizeof *corners + 1);
        for (uint32_t id = 0; id < b.count; id++) {
            for (unsigned k = 0; k < 3; k++) {
                memcpy(&corners[id][3 * k], b.position[b.index[id][k]], 3 * sizeof(float));
            }
        }
        plt_corners_put(b.records, b.count, (const float(*)[9])corners);
        compare(&b, "corners");
        free(corners);
        end(&b);
    }
}

int main(void) {
    from_vertices();
    from_corners();
    return test_done();
}

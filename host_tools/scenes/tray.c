/* tray - the mesh of scene_marbles: up to 109 balls in an eight-sided tray
 *
 * Both have 42 vertices and 80 triangles. A ball is an icosahedron with
 * each face cut in four, its corners on the sphere; the tray is five
 * octagons, one above or within the other, closed by two fans.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <string.h>

#include "host_tools/scenes/counts.h"
#include "host_tools/scenes/marbles.h"
#include "host_tools/scenes/scenes.h"

#define BALL_VERTICES 42u
#define BALL_TRIANGLES 80u
#define RINGS 5u
#define CORNERS 8u

typedef struct ball {
    double vertex[BALL_VERTICES][3];
    uint8_t triangle[BALL_TRIANGLES][3];
    unsigned vertices, triangles;
    uint8_t middle[12][12]; /* vertex halfway between two corners; 0: not yet */
} ball;

typedef double rotation[3][3];

/* Height and distance from the axis of each octagon's sides, from below the
 * tray over its edge to the floor. */
static const double rings[RINGS][2] = {
    {-1.0, 16.0}, {1.2, 16.9}, {1.7, 16.5}, {1.7, MARBLES_REACH + 1.0}, {0.0, MARBLES_REACH + 1.0}};

static const uint8_t faces[20][3] = {{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                     {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                     {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                     {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};

static uint8_t ball_vertex(ball *b, double x, double y, double z) {
    const double length = sqrt(x * x + y * y + z * z);
    double *v = b->vertex[b->vertices];
    v[0] = x / length;
    v[1] = y / length;
    v[2] = z / length;
    return (uint8_t)b->vertices++;
}

static uint8_t ball_middle(ball *b, uint8_t i, uint8_t j) {
    const uint8_t low = i < j ? i : j, high = i < j ? j : i;
    uint8_t *known = &b->middle[low][high];
    if (!*known) {
        const double *p = b->vertex[low], *q = b->vertex[high];
        *known = ball_vertex(b, p[0] + q[0], p[1] + q[1], p[2] + q[2]);
    }
    return *known;
}

static void ball_triangle(ball *b, uint8_t i, uint8_t j, uint8_t k) {
    uint8_t *t = b->triangle[b->triangles++];
    t[0] = i;
    t[1] = j;
    t[2] = k;
}

static void ball_make(ball *b) {
    const double golden = 0.5 * (1.0 + sqrt(5.0));
    memset(b, 0, sizeof *b);
    for (unsigned i = 0; i < 12; i++) {
        const double one = i & 1 ? 1.0 : -1.0, long_side = i & 2 ? -golden : golden;
        const double c[3] = {one, long_side, 0.0};
        const unsigned k = 3 - i / 4; /* three golden rectangles, axes changed cyclically */
        ball_vertex(b, c[k % 3], c[(k + 1) % 3], c[(k + 2) % 3]);
    }
    for (unsigned i = 0; i < 20; i++) {
        const uint8_t *c = faces[i];
        const uint8_t p = ball_middle(b, c[0], c[1]), q = ball_middle(b, c[1], c[2]);
        const uint8_t r = ball_middle(b, c[2], c[0]);
        ball_triangle(b, c[0], p, r);
        ball_triangle(b, c[1], q, p);
        ball_triangle(b, c[2], r, q);
        ball_triangle(b, p, q, r);
    }
}

/* The smallest rotation that brings (0, 1, 0) to the tray's normal. */
static void lean_rotation(const marbles *m, rotation r) {
    const double a = m->lean_x, b = m->lean_z, up = sqrt(1.0 - a * a - b * b);
    const double k = 1.0 / (1.0 + up);
    const rotation made = {
        {1.0 - k * a * a, a, -k * a * b}, {-a, up, -b}, {-k * a * b, b, 1.0 - k * b * b}};
    memcpy(r, made, sizeof made);
}

static void orientation_rotation(const double *q, rotation r) {
    const double w = q[0], x = q[1], y = q[2], z = q[3];
    const rotation made = {
        {1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)},
        {2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)},
        {2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)}};
    memcpy(r, made, sizeof made);
}

static void rotated(const rotation r, const double *p, double *out) {
    for (unsigned i = 0; i < 3; i++) {
        out[i] = r[i][0] * p[0] + r[i][1] * p[1] + r[i][2] * p[2];
    }
}

static int add_vertex(mesh *out, const rotation lean, double x, double y, double z, fail *f) {
    const double local[3] = {x, y, z};
    double p[3];
    rotated(lean, local, p);
    return mesh_add_vertex(out, (float)p[0], (float)p[1], (float)p[2], f);
}

static int add_tray_vertices(mesh *out, const rotation lean, fail *f) {
    const double slope = sqrt(2.0) - 1.0; /* tangent of 1/16 of a circle */
    for (unsigned i = 0; i < RINGS; i++) {
        for (unsigned c = 0; c < CORNERS; c++) {
            /* Corners 2 .. 7 are the first two, rotated by quarters of the circle. */
            double x = rings[i][1] * (c & 1 ? slope : 1.0);
            double z = rings[i][1] * (c & 1 ? 1.0 : slope);
            for (unsigned quarter = 0; quarter < c / 2; quarter++) {
                const double was = x;
                x = -z;
                z = was;
            }
            if (add_vertex(out, lean, x, rings[i][0], z, f)) {
                return -1;
            }
        }
    }
    return add_vertex(out, lean, 0.0, rings[0][0], 0.0, f) ||
                   add_vertex(out, lean, 0.0, rings[RINGS - 1][0], 0.0, f)
               ? -1
               : 0;
}

static int add_tray(mesh *out, const rotation lean, fail *f) {
    const uint32_t first = (uint32_t)out->vertices, last = first + (RINGS - 1) * CORNERS;
    const uint32_t below = first + RINGS * CORNERS, middle = below + 1;
    int wrong = add_tray_vertices(out, lean, f);
    for (uint32_t c = 0; c < CORNERS && !wrong; c++) {
        const uint32_t d = (c + 1) % CORNERS;
        wrong = mesh_add_triangle(out, below, first + c, first + d, f) ||
                mesh_add_triangle(out, middle, last + d, last + c, f);
        for (uint32_t i = 0; i + 1 < RINGS && !wrong; i++) {
            const uint32_t at = first + i * CORNERS, up = at + CORNERS;
            wrong = mesh_add_triangle(out, at + c, up + d, at + d, f) ||
                    mesh_add_triangle(out, at + c, up + c, up + d, f);
        }
    }
    return wrong ? -1 : 0;
}

static int add_ball(mesh *out, const ball *b, const marble *a, const rotation lean, fail *f) {
    const uint32_t first = (uint32_t)out->vertices;
    rotation own;
    int wrong = 0;
    orientation_rotation(a->orientation, own);
    for (unsigned i = 0; i < BALL_VERTICES && !wrong; i++) {
        double p[3];
        rotated(own, b->vertex[i], p);
        wrong = add_vertex(out, lean, a->x + p[0], 1.0 + p[1], a->z + p[2], f);
    }
    for (unsigned i = 0; i < BALL_TRIANGLES && !wrong; i++) {
        const uint8_t *t = b->triangle[i];
        wrong = mesh_add_triangle(out, first + t[0], first + t[1], first + t[2], f);
    }
    return wrong ? -1 : 0;
}

static int add(mesh *out, const marbles *m, fail *f) {
    rotation lean;
    ball b;
    lean_rotation(m, lean);
    ball_make(&b);
    int wrong = add_tray(out, lean, f);
    for (unsigned i = 0; i < m->count && !wrong; i++) {
        wrong = add_ball(out, &b, &m->marble[i], lean, f);
    }
    return wrong;
}

/* That frame of so many marbles beside the tray. */
static const marbles *world_at(uint64_t triangles, unsigned frame) {
    static marbles world; /* of no marbles until it has begun */
    const unsigned count = (unsigned)(triangles / BALL_TRIANGLES) - 1;
    if (world.count != count || frame < world.frames) {
        marbles_start(&world, count);
    }
    while (world.frames < frame) {
        marbles_frame(&world);
    }
    return &world;
}

static const rotation as_it_is = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};

int scene_marbles_tray(mesh *m, fail *f) {
    return add_tray(m, as_it_is, f);
}

int scene_marbles_ball(mesh *m, fail *f) {
    ball b;
    int wrong = 0;
    ball_make(&b);
    for (unsigned i = 0; i < BALL_VERTICES && !wrong; i++) {
        wrong = add_vertex(m, as_it_is, b.vertex[i][0], b.vertex[i][1], b.vertex[i][2], f);
    }
    for (unsigned i = 0; i < BALL_TRIANGLES && !wrong; i++) {
        wrong = mesh_add_triangle(m, b.triangle[i][0], b.triangle[i][1], b.triangle[i][2], f);
    }
    return wrong ? -1 : 0;
}

/* The product of two rotations, and the place of what they rotate about. */
static void set_matrix(double to[12], const rotation lean, const rotation own, const double at[3]) {
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 3; j++) {
            to[4 * i + j] =
                lean[i][0] * own[0][j] + lean[i][1] * own[1][j] + lean[i][2] * own[2][j];
        }
        to[4 * i + 3] = lean[i][0] * at[0] + lean[i][1] * at[1] + lean[i][2] * at[2];
    }
}

unsigned scene_marbles_matrices(uint64_t triangles, unsigned frame,
                                double matrix[SCENE_MARBLES_INSTANCES][12]) {
    static const double nowhere[3] = {0.0, 0.0, 0.0};
    const marbles *world = world_at(triangles, frame);
    rotation lean, own;
    lean_rotation(world, lean);
    set_matrix(matrix[0], lean, as_it_is, nowhere);
    for (unsigned i = 0; i < world->count; i++) {
        const marble *a = &world->marble[i];
        const double at[3] = {a->x, 1.0, a->z};
        orientation_rotation(a->orientation, own);
        set_matrix(matrix[i + 1], lean, own, at);
    }
    return world->count + 1;
}

int scene_marbles(mesh *m, uint64_t triangles, unsigned frame, fail *f) {
    const size_t had_vertices = m->vertices, had_triangles = m->triangles;
    if (count_check(m, "tray of marbles", triangles, SCENE_MARBLES_LEAST, SCENE_MARBLES_MOST, f)) {
        return -1;
    }
    if (add(m, world_at(triangles, frame), f) == 0) {
        return 0;
    }
    m->vertices = had_vertices;
    m->triangles = had_triangles;
    return -1;
}

/* test_baselines_strays - kd-trees that cut triangles hold them wherever their hits may be reported
 *
 * kd_stray.h says how far from a triangle that is. The engine's bound is far above what rounding
 * does, so that hits beyond 16 h are hard to find: here h is made a thousandth, as far as
 * references go, and then strays are what finds them.
 *
 * SPDX-License-Identifier: MIT */
#include <math.h>
#include <stdlib.h>

#include "host_tools/base/heap.h"
#include "host_tools/baselines/kd/kd_trace.h"
#include "tests/reference/grid_scenes.h"
#include "tests/reference/rays.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { RAYS = 200 };

typedef struct subject {
    triangle_set triangles;
    kd_scene scene;
    kd_tree tree;
} subject;

static void open_subject(subject *s, const mesh *m, float share) {
    static const kd_way way = {.is_exact = 1, .is_clipped = 1};
    memset(s, 0, sizeof *s);
    CHECK(triangle_set_fill(&s->triangles, m) == 0 &&
              kd_scene_set(&s->scene, &s->triangles, 1) == 0,
          "memory");
    for (uint32_t i = 0; i < s->triangles.count; i++) {
        s->scene.plane[i].off *= share;
    }
    CHECK(kd_build(&s->tree, &s->scene, &way) == 0, "memory");
}

static void close_subject(subject *s) {
    triangle_set_free(&s->triangles);
    kd_scene_free(&s->scene);
    kd_tree_free(&s->tree);
}

/* ---- points ------------------------------------------------------------------------ */

static int lists(const uint32_t *item, uint32_t count, uint32_t triangle) {
    for (uint32_t i = 0; i < count; i++) {
        if (item[i] == triangle) {
            return 1;
        }
    }
    return 0;
}

/* In the leaf of a point the triangle is a reference (2), a stray (1), or neither. */
static int found_at(const kd_tree *t, const float point[3], uint32_t triangle) {
    const kd_node *n = t->node;
    while ((n->link & 3u) != KD_LEAF) {
        n = &t->node[(n->link >> 2) + (point[n->link & 3u] > n->at.plane)];
    }
    const uint32_t count = n->link >> 2, *item = t->item + n->at.first;
    return lists(item, count, triangle) ? 2 : lists(item + count + 1, item[count], triangle);
}

/* A point of the plane, inside the triangle's box; 0: none was found. */
static int point_of_plane(const subject *s, uint32_t triangle, random_state *r, float point[3]) {
    const kd_plane *p = &s->scene.plane[triangle];
    const plt_box b = plt_record_box(&s->triangles.record[triangle]);
    int axis = 0;
    for (int a = 1; a < 3; a++) {
        axis = fabsf(p->normal[a]) > fabsf(p->normal[axis]) ? a : axis;
    }
    for (int tries = 0; tries < 8; tries++) {
        double along = 0.0;
        random_point(r, b.lo, b.hi, point);
        for (int a = 0; a < 3; a++) {
            const double apart =
                (double)plt_record_float(&s->triangles.record[triangle], 0, a) - (double)point[a];
            along += (double)p->normal[a] * apart;
        }
        const double off = (double)p->off * (double)random_float(r, -0.99f, 0.99f);
        point[axis] += (float)((along + off) / (double)p->normal[axis]);
        if (point[axis] >= b.lo[axis] && point[axis] <= b.hi[axis]) {
            return 1;
        }
    }
    return 0;
}

/* A point within 16 h of the triangle. */
static void point_near(const subject *s, uint32_t triangle, random_state *r, float point[3]) {
    const plt_record *t = &s->triangles.record[triangle];
    const float off = fmaxf(s->scene.plane[triangle].off, 0.0f);
    const float u = random_float(r, 0.0f, 1.0f), v = random_float(r, 0.0f, 1.0f - u);
    for (int a = 0; a < 3; a++) {
        const float p = plt_record_float(t, 0, a), q = plt_record_float(t, 1, a),
                    w = plt_record_float(t, 2, a);
        const plt_box b = plt_record_box(t);
        const float near = p + u * (q - p) + v * (w - p) + off * random_float(r, -15.9f, 15.9f);
        point[a] = fminf(fmaxf(near, b.lo[a]), b.hi[a]);
    }
}

static void points(int is_soak) {
    random_state r = {41};
    unsigned strays = 0, references = 0;
    test("a leaf has the triangles whose hits may be reported in it: all rays', or grazing ones'");
    for (unsigned i = 0; i < (is_soak ? 2000 : 60); i++) {
        mesh m = {0};
        subject s;
        grid_scene_make(&m, &r);
        open_subject(&s, &m, 1.0f);
        for (unsigned k = 0; k < 500; k++) {
            const uint32_t triangle = random_below(&r, s.triangles.count);
            float point[3];
            point_near(&s, triangle, &r, point);
            CHECK(found_at(&s.tree, point, triangle) == 2, "scene %u: no reference", i);
            if (s.scene.plane[triangle].off >= 0.0f && point_of_plane(&s, triangle, &r, point)) {
                const int how = found_at(&s.tree, point, triangle);
                CHECK(how > 0, "scene %u: neither reference nor stray", i);
                strays += how == 1;
                references += how == 2;
            }
        }
        close_subject(&s);
        mesh_free(&m);
    }
    CHECK(strays > 200 && references > 1000, "%u strays, %u references", strays, references);
}

/* ---- directions -------------------------------------------------------------------- */

static void directions(void) {
    random_state r = {43};
    unsigned grazing = 0;
    test(
        "a ray at less than 1 / 16 to a plane grazes it, however long, and one at 1 / 15 does not");
    for (unsigned i = 0; i < 200000; i++) {
        static const float lo[3] = {-1.0f, -1.0f, -1.0f}, hi[3] = {1.0f, 1.0f, 1.0f};
        kd_plane p;
        float dir[3], size = 0.0f, length = 0.0f, cosine = 0.0f;
        random_point(&r, lo, hi, p.normal);
        random_point(&r, lo, hi, dir);
        for (int a = 0; a < 3; a++) {
            size += p.normal[a] * p.normal[a];
        }
        for (int a = 0; a < 3; a++) {
            p.normal[a] /= sqrtf(size);
            length += dir[a] * dir[a];
            cosine += p.normal[a] * dir[a];
        }
        cosine = fabsf(cosine) / sqrtf(length);
        const float scale = ldexpf(1.0f, (int)random_below(&r, 120) - 60);
        for (int a = 0; a < 3; a++) {
            dir[a] *= scale;
        }
        const int is_grazing = kd_is_grazing(&p, dir);
        CHECK(is_grazing || cosine > 0.0625f, "cosine %g", (double)cosine);
        CHECK(!is_grazing || cosine < 0.0667f, "cosine %g", (double)cosine);
        grazing += is_grazing != 0;
    }
    CHECK(grazing > 1000, "%u", grazing);
}

/* ---- rays ---------------------------------------------------------------------------- */

static void unit(float v[3]) {
    const float length = sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int a = 0; a < 3; a++) {
        v[a] /= length;
    }
}

static void cross(const float a[3], const float b[3], float to[3]) {
    for (int i = 0; i < 3; i++) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        to[i] = a[j] * b[k] - a[k] * b[j];
    }
}

/* A large triangle of equal sides, and small ones about its middle, along a line that nearly lies
 * in it, most of them beside the line, where they make small cells: the engine's t of the large one
 * is off by several of those. */
static void graze(mesh *m, random_state *r, float at[3], float along[3], float apart) {
    static const float lo[3] = {-1.0f, -1.0f, -1.0f}, hi[3] = {1.0f, 1.0f, 1.0f};
    static const float corner[3][2] = {{1.0f, 0.0f}, {-0.5f, 0.8660254f}, {-0.5f, -0.8660254f}};
    float normal[3], across[3], first[3];
    fail f = {""};
    random_point(r, lo, hi, at);
    random_point(r, lo, hi, along);
    random_point(r, lo, hi, across);
    unit(along);
    cross(along, across, normal);
    unit(normal);
    cross(normal, along, across);
    memcpy(first, along, sizeof first);
    for (uint32_t c = 0; c < 3; c++) {
        float v[3];
        for (int a = 0; a < 3; a++) {
            v[a] = at[a] + corner[c][0] * along[a] + corner[c][1] * across[a];
        }
        mesh_add_vertex(m, v[0], v[1], v[2], &f);
    }
    mesh_add_triangle(m, 0, 1, 2, &f);
    const float u = random_float(r, 0.4f, 1.0f), w = random_float(r, -1.0f, 1.0f);
    for (int a = 0; a < 3; a++) {
        along[a] = u * along[a] + w * across[a];
    }
    unit(along);
    const float slope = ldexpf(random_float(r, 1.0f, 2.0f), -12 - (int)random_below(r, 4));
    for (int a = 0; a < 3; a++) {
        along[a] += normal[a] * slope;
    }
    for (int a = 0; a < 3; a++) { /* just inside the edge across from corner 0 */
        at[a] += 0.2f * apart * along[a] - 0.5f * first[a];
    }
    for (uint32_t i = 0, many = rig_triangles(300, 1) - 1; i < many; i++) {
        const float off = random_float(r, -apart, apart);
        float beside[3];
        for (int a = 0; a < 3; a++) {
            beside[a] = i < 16 ? 0.0f : 0.1f * apart * random_float(r, -1.0f, 1.0f);
        }
        for (uint32_t c = 0; c < 3; c++) {
            float v[3];
            for (int a = 0; a < 3; a++) {
                v[a] = at[a] + off * along[a] + beside[a] +
                       (i < 16 ? 0.05f : 0.01f) * apart * random_float(r, -1.0f, 1.0f);
            }
            mesh_add_vertex(m, v[0], v[1], v[2], &f);
        }
        mesh_add_triangle(m, 3 * i + 3, 3 * i + 4, 3 * i + 5, &f);
    }
    CHECK(f.text[0] == 0, "%s", f.text);
}

/* How many of the rays have other hits than a list gives them. */
static unsigned differ(subject *s, const mesh *m, const plt_ray *rays) {
    const rig_config list = rig_config_of(2, 64, PLT_BUILD_NONE, PLT_SPLIT_SAH);
    plt_hit due[RAYS], got;
    rig x;
    unsigned others = 0;
    CHECK(rig_open(&x, m, &list) == PLT_OK && plt_trace(x.engine, rays, due, RAYS, 0) == PLT_OK,
          "%s", x.fault.message);
    kd_tracing k = {.tree = &s->tree, .scene = &s->scene};
    k.mailbox = calloc(s->triangles.count, sizeof *k.mailbox);
    for (uint32_t i = 0; i < RAYS; i++) {
        lone_ray r;
        k.number = i + 1;
        CHECK(lone_ray_set(&r, &s->triangles.box, &rays[i]) && kd_trace(&k, &r) == 0, "traced");
        lone_ray_store(&r, &got, 0);
        others += memcmp(&got, &due[i], sizeof got) != 0;
    }
    free(k.mailbox);
    rig_close(&x);
    return others;
}

static void without_strays(kd_tree *t) {
    for (uint32_t i = 0; i < t->nodes; i++) {
        if ((t->node[i].link & 3u) == KD_LEAF) {
            t->item[t->node[i].at.first + (t->node[i].link >> 2)] = 0;
        }
    }
}

/* From one to two times `back` before the point, which is far if that is far above 3. */
static void aim(plt_ray *rays, const float at[3], const float along[3], float apart, float back,
                random_state *r) {
    for (uint32_t k = 0; k < RAYS; k++) {
        const float away = back * random_float(r, 1.0f, 2.0f);
        float from[3];
        for (int a = 0; a < 3; a++) {
            from[a] = at[a] - away * along[a] + 1e-5f * apart * random_float(r, -1.0f, 1.0f);
        }
        rays[k] = ray_make(from, along, 0.0f, RAYS_FAR);
    }
}

static void grazing_rays(int is_soak) {
    random_state r = {12};
    unsigned others = 0;
    test("triangles that rays graze are hit as in a list, with strays, and not without");
    for (unsigned i = 0; i < (is_soak ? 2000 : 60) && !rig_is_tiny(); i++) {
        plt_ray rays[RAYS];
        mesh m = {0};
        subject s;
        float at[3], along[3];
        const float apart = ldexpf(1.0f, -7 - (int)random_below(&r, 4));
        graze(&m, &r, at, along, apart);
        aim(rays, at, along, apart, 2.0f, &r);
        open_subject(&s, &m, 0.001f);
        const unsigned wrong = differ(&s, &m, rays);
        CHECK(wrong == 0, "scene %u: %u hits", i, wrong);
        aim(rays, at, along, apart, 32.0f, &r);
        const unsigned far = differ(&s, &m, rays);
        CHECK(far == 0, "scene %u, from far: %u hits", i, far);
        without_strays(&s.tree);
        aim(rays, at, along, apart, 2.0f, &r);
        others += differ(&s, &m, rays);
        close_subject(&s);
        mesh_free(&m);
    }
    CHECK(others > 0 || rig_is_tiny(), "strays found nothing");
    printf("    without strays %u hits are others\n", others);
}

int main(int argc, char **argv) {
    const int is_soak = argc > 1 && strcmp(argv[1], "soak") == 0;
    points(is_soak);
    directions();
    grazing_rays(is_soak);
    return test_done();
}

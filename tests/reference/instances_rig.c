/* instances_rig - see instances_rig.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/instances_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/reference/guarded.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

/* ---- matrices --------------------------------------------------------------------- */

/* A rotation by a random unit quaternion. */
static void turn(float m[PLT_MATRIX_FLOATS], random_state *r) {
    float q[4], sum = 0.0f;
    for (int i = 0; i < 4; i++) {
        q[i] = random_float(r, -1.0f, 1.0f);
        sum += q[i] * q[i];
    }
    const float s = 2.0f / (sum + 1.0e-6f), w = q[0], x = q[1], y = q[2], z = q[3];
    const float rows[12] = {
        1 - s * (y * y + z * z), s * (x * y - w * z),     s * (x * z + w * y),     0,
        s * (x * y + w * z),     1 - s * (x * x + z * z), s * (y * z - w * x),     0,
        s * (x * z - w * y),     s * (y * z + w * x),     1 - s * (x * x + y * y), 0};
    memcpy(m, rows, sizeof rows);
}

void instances_rig_matrix(float m[PLT_MATRIX_FLOATS], enum instances_kind kind, float apart,
                          random_state *r) {
    turn(m, r);
    for (int i = 0; i < PLT_MATRIX_FLOATS; i++) {
        const float scale =
            i % 4 == 0 || kind == INSTANCES_SKEWED ? random_float(r, -2.5f, 2.5f) : 1.0f;
        if (i % 4 == 3) {
            m[i] = random_float(r, -apart, apart);
        } else if (kind == INSTANCES_SKEWED) {
            m[i] += scale;
        }
    }
    const float scale = kind == INSTANCES_SCALED ? random_float(r, 0.05f, 3.0f) : 1.0f;
    const int mirrors = kind == INSTANCES_SCALED && random_below(r, 3) == 0;
    for (int i = 0; i < PLT_MATRIX_FLOATS; i++) {
        m[i] *= i % 4 == 3 ? 1.0f : i % 4 == 0 && mirrors ? -scale : scale;
    }
}

/* Some skewed ones are too flat for the engine. */
static void valid_matrix(const packed *body, float m[PLT_MATRIX_FLOATS], const instances_config *c,
                         random_state *r) {
    plt_box box;
    do {
        instances_rig_matrix(m, c->kind, c->apart, r);
    } while (!instances_place(body, m, &box));
}

/* ---- packing and opening ---------------------------------------------------------- */

static void make_bodies(instances_rig *r, const instances_config *c) {
    rig_config list = c->scene;
    list.pack.build = PLT_BUILD_NONE;
    list.pack.checks = 0;
    list.run = (plt_options){.packet_side = 2};
    shape_icosphere(&r->body[0], 1);
    shape_soup(
        &r->body[1],
        rig_triangles(rig_is_tiny() ? 30 : INSTANCES_RIG_TRIANGLES, c->scene.pack.leaf_triangles),
        0.4f, c->seed + 7);
    shape_coincident(&r->body[2], 1); /* a list, without nodes */
    for (int i = 0; i < INSTANCES_RIG_BODIES; i++) {
        pack_options plain = c->scene.pack;
        fail f = {""};
        plain.checks = 0;
        CHECK(pack_mesh(&r->packed[i], &r->body[i], &plain, "test", &f) == 0, "%s", f.text);
        CHECK(rig_open(&r->alone[i], &r->body[i], &list) == PLT_OK, "%s",
              r->alone[i].fault.message);
    }
}

void instances_rig_pack(instances_rig *r, const instances_config *c) {
    random_state random = {c->seed};
    fail f = {""};
    memset(r, 0, sizeof *r);
    make_bodies(r, c);
    r->all = (instance_set){.body = r->packed,
                            .bodies = INSTANCES_RIG_BODIES,
                            .body_of = r->body_of,
                            .instances = c->instances,
                            .frames = INSTANCES_RIG_FRAMES,
                            .frame_rate = 25};
    for (uint32_t i = 0; i < c->instances; i++) {
        r->body_of[i] = random_below(&random, INSTANCES_RIG_BODIES);
    }
    const int status = instances_begin(&r->image, &r->all, "test", &f);
    CHECK(status == 0, "%s", f.text);
    for (uint32_t k = 0; k < INSTANCES_RIG_FRAMES && status == 0; k++) {
        for (uint32_t i = 0; i < c->instances; i++) {
            valid_matrix(&r->packed[r->body_of[i]], r->matrix[k][i], c, &random);
            if (i % 5 == 4) { /* two in the same place */
                r->body_of[i] = r->body_of[i - 1];
                memcpy(r->matrix[k][i], r->matrix[k][i - 1], sizeof r->matrix[k][i]);
            }
        }
        if (k == 0) { /* bodies have changed */
            pack_free(&r->image);
            CHECK(instances_begin(&r->image, &r->all, "test", &f) == 0, "%s", f.text);
        }
        instances_frame(&r->image, &r->all, k, (const float(*)[PLT_MATRIX_FLOATS])r->matrix[k]);
    }
    instances_finish(&r->image);
}

packed instances_rig_image(const instances_config *c) {
    instances_rig r;
    instances_rig_pack(&r, c);
    const packed image = r.image;
    r.image.bytes = NULL;
    instances_rig_close(&r);
    return image;
}

int instances_rig_open(instances_rig *r, const instances_config *c, size_t short_by) {
    const plt_options o = c->scene.run;
    const plt_source source = guarded_source(&r->link, &r->image, c->is_mapped);
    r->arena_bytes = plt_arena_need(&r->image.info, c->is_mapped, &o) - short_by;
    free(r->arena);
    r->arena = guarded_arena(&r->link, r->arena_bytes);
    return plt_open(&r->engine, r->arena, r->arena_bytes, &source, &o, &r->fault);
}

int instances_rig_start(instances_rig *r, const instances_config *c) {
    instances_rig_pack(r, c);
    const int status = instances_rig_open(r, c, 0);
    CHECK(status == PLT_OK, "%s: %s", rig_name(&c->scene), r->fault.message);
    return status;
}

int instances_rig_close(instances_rig *r) {
    const int good = guarded_whole(r->arena, r->arena_bytes);
    for (int i = 0; i < INSTANCES_RIG_BODIES; i++) {
        mesh_free(&r->body[i]);
        pack_free(&r->packed[i]);
        rig_close(&r->alone[i]);
    }
    free(r->arena);
    pack_free(&r->image);
    return good && r->link.broken == 0 && fake_unfinished(&r->link) == 0;
}

/* ---- the reference ---------------------------------------------------------------- */

void instances_rig_flatten(const instances_rig *r, const float (*matrix)[PLT_MATRIX_FLOATS],
                           mesh *to) {
    fail f = {""};
    for (uint32_t i = 0; i < r->all.instances; i++) {
        const mesh *body = &r->body[r->body_of[i]];
        const float *m = matrix[i];
        const uint32_t first = (uint32_t)to->vertices;
        for (size_t v = 0; v < body->vertices; v++) {
            const float *p = body->vertex + 3 * v;
            double at[3];
            for (int a = 0; a < 3; a++) {
                at[a] = (double)m[4 * a] * (double)p[0] + (double)m[4 * a + 1] * (double)p[1] +
                        (double)m[4 * a + 2] * (double)p[2] + (double)m[4 * a + 3];
            }
            mesh_add_vertex(to, (float)at[0], (float)at[1], (float)at[2], &f);
        }
        for (size_t t = 0; t < body->triangles; t++) {
            const uint32_t *v = body->triangle + 3 * t;
            mesh_add_triangle(to, first + v[0], first + v[1], first + v[2], &f);
        }
    }
}

/* The order of operations that the engine promises. */
static plt_ray seen_from(const plt_placed *p, const plt_ray *ray) {
    plt_ray to = *ray;
    for (int a = 0; a < 3; a++) {
        const float *row = &p->to_body[4 * a];
        const float *o = ray->org, *d = ray->dir;
        to.org[a] = ((row[0] * o[0] + row[1] * o[1]) + row[2] * o[2]) + row[3];
        to.dir[a] = (row[0] * d[0] + row[1] * d[1]) + row[2] * d[2];
    }
    return to;
}

plt_hit instances_rig_hit(const instances_rig *r, const float (*matrix)[PLT_MATRIX_FLOATS],
                          const plt_ray *ray, int any) {
    plt_hit nearest = {0, 0, 0, any ? 0 : PLT_MISS};
    uint32_t first = 0;
    for (uint32_t i = 0; i < r->all.instances; i++) {
        const rig *alone = &r->alone[r->body_of[i]];
        const plt_info *info = plt_engine_info(alone->engine);
        plt_placed p;
        plt_box box;
        plt_hit hit;
        float spread = 0.0f;
        memcpy(box.lo, info->lo, sizeof box.lo);
        memcpy(box.hi, info->hi, sizeof box.hi);
        CHECK(plt_placed_set(&p, matrix[i], &box, &spread), "instance %u", i);
        const plt_ray there = seen_from(&p, ray);
        plt_trace(alone->engine, &there, &hit, 1, any);
        if (any) {
            nearest.triangle |= hit.triangle;
        } else if (hit.triangle != PLT_MISS &&
                   (nearest.triangle == PLT_MISS || hit.t < nearest.t)) {
            nearest = hit;
            nearest.triangle += first;
        }
        first += info->triangles;
    }
    return nearest;
}

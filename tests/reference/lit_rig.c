/* lit_rig - see lit_rig.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/lit_rig.h"

#include <stdlib.h>
#include <string.h>

#include "host_tools/pack/material_section.h"
#include "tests/reference/shapes.h"

static const material_values values[LIT_MATERIALS] = {
    {{0.5f, 0.5f, 0.4f}, {0}, {0}, {0}, 1, 0, 0, 1},
    {{0}, {0.5f, 0.5f, 0.5f}, {0}, {0.1f, 0.4f, 0.6f}, 1.5f, 1, 0, 300},
    {{0.1f, 0.1f, 0.1f}, {0.9f, 0.8f, 0.6f}, {0}, {0}, 1, 0, 1, 64},
    {{0.7f, 0.1f, 0.1f}, {0.5f, 0.5f, 0.5f}, {0}, {0}, 1, 0, 0.04f, 40},
    {{0}, {0}, {1.5f, 1.2f, 0.25f}, {0}, 1, 0, 0, 1}};

void lit_scene_is(lit_scene *s, unsigned material) {
    s->materials.current = (uint16_t)material;
    if (materials_use(&s->materials, s->m.triangles, 0) != 0) {
        abort();
    }
}

static void add_ball(lit_scene *s, float x, float z, unsigned material) {
    mesh ball = {0};
    fail f = {""};
    shape_icosphere(&ball, rig_is_tiny() ? 0 : 2);
    shape_transform(&ball, 1.0f, x, 1.05f, z);
    const uint32_t base = (uint32_t)s->m.vertices;
    for (size_t i = 0; i < ball.vertices; i++) {
        const float *v = ball.vertex + 3 * i;
        mesh_add_vertex(&s->m, v[0], v[1], v[2], &f);
    }
    for (size_t i = 0; i < ball.triangles; i++) {
        const uint32_t *t = ball.triangle + 3 * i;
        mesh_add_triangle(&s->m, base + t[0], base + t[1], base + t[2], &f);
    }
    mesh_free(&ball);
    lit_scene_is(s, material);
}

void lit_scene_make(lit_scene *s) {
    static const float corner[4][2] = {{-6, -6}, {6, -6}, {6, 6}, {-6, 6}};
    fail f = {""};
    memset(s, 0, sizeof *s);
    materials_begin(&s->materials, 0);
    for (int i = 1; i < LIT_MATERIALS; i++) {
        materials_find(&s->materials, (const char *[]){"", "g", "m", "p", "l"}[i], 1);
    }
    for (int i = 0; i < LIT_MATERIALS; i++) {
        s->materials.material[i].values = values[i];
    }
    for (int i = 0; i < 4; i++) {
        mesh_add_vertex(&s->m, corner[i][0], 0, corner[i][1], &f);
    }
    mesh_add_triangle(&s->m, 0, 1, 2, &f);
    mesh_add_triangle(&s->m, 0, 2, 3, &f);
    lit_scene_is(s, LIT_FLOOR);
    add_ball(s, -2.2f, 0.5f, LIT_GLASS);
    add_ball(s, 0.0f, -1.5f, LIT_MIRROR);
    add_ball(s, 2.2f, 0.5f, LIT_PAINT);
    add_ball(s, 0.3f, 2.2f, LIT_LAMP);
}

void lit_scene_free(lit_scene *s) {
    mesh_free(&s->m);
    materials_free(&s->materials);
}

int lit_pack(packed *image, const lit_scene *s, enum lit_image kind) {
    fail f = {""};
    material_stats stats;
    int status;
    memset(image, 0, sizeof *image);
    if (kind == LIT_COMPACT || kind == LIT_LATTICE) {
        const compact_options options = {.lattice_bits = 14,
                                         .numbers = 1,
                                         .floats = kind == LIT_COMPACT,
                                         .leaf_triangles = 2,
                                         .meshes = kind == LIT_LATTICE};
        lattice_loss loss;
        status = pack_compact(image, &s->m, &options, "test", &loss, &f);
    } else {
        const pack_options options = {.build = kind == LIT_LIST     ? PLT_BUILD_NONE
                                               : kind == LIT_DEVICE ? PLT_BUILD_DEVICE
                                                                    : PLT_BUILD_HOST,
                                      .leaf_triangles = 2,
                                      .treelet_nodes = rig_is_tiny() ? 1 : 8,
                                      .checks = 1};
        status = pack_mesh(image, &s->m, &options, "test", &f);
    }
    return status != 0 ? -1 : material_section_add(image, &s->materials, NULL, "test", &stats, &f);
}

static int start(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    (void)tag;
    memcpy(to, (const unsigned char *)context + offset, count);
    return 0;
}

static int wait(void *context, uint32_t tags) {
    (void)context;
    (void)tags;
    return 0;
}

int lit_open(rig *r, const plt_options *options, int fetched) {
    plt_source source = {.mapped = r->image.bytes, .bytes = r->image.size};
    if (fetched) {
        source = (plt_source){
            .bytes = r->image.size, .context = r->image.bytes, .start = start, .wait = wait};
    }
    const size_t need = plt_arena_need(&r->image.info, !fetched, options);
    r->arena_bytes = need > PLT_ALIGN ? need : PLT_ALIGN;
    r->arena = aligned_alloc(PLT_ALIGN, (r->arena_bytes + PLT_ALIGN - 1) / PLT_ALIGN * PLT_ALIGN);
    memset(r->arena, 0xA5, r->arena_bytes);
    return plt_open(&r->engine, r->arena, r->arena_bytes, &source, options, &r->fault);
}

plt_lighting lit_lights(uint8_t bounces) {
    plt_lighting l = {
        .sky = {0.4f, 0.5f, 0.7f}, .ground = {0.2f, 0.2f, 0.1f}, .lights = 3, .bounces = bounces};
    l.light[0] = (plt_light){{-3, 6, 4}, {12, 11, 10}, 0, PLT_LIGHT_POINT, 1};
    l.light[1] = (plt_light){{1, 2, 0.5f}, {0.4f, 0.4f, 0.3f}, 0.05f, PLT_LIGHT_DISTANT, 3};
    l.light[2] = (plt_light){{4, 5, -2}, {9, 9, 9}, 0.6f, PLT_LIGHT_POINT, 4};
    return l;
}

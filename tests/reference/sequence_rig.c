/* sequence_rig - see sequence_rig.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/sequence_rig.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "tests/reference/guarded.h"
#include "tests/reference/random.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

/* A twist that grows, a drift, and a shiver of one vertex in three. */
void sequence_deform(mesh *m, const mesh *first, uint32_t k) {
    random_state r = {k};
    *m = shape_copy(first);
    for (size_t i = 0; i < m->vertices && k > 0; i++) {
        float *p = m->vertex + 3 * i;
        const float c = cosf(0.3f * (float)k * p[1]), s = sinf(0.3f * (float)k * p[1]), x = p[0];
        if (i % 7 == 3) {
            continue; /* it stays where it was */
        }
        p[0] = c * x - s * p[2] + 0.05f * (float)k;
        p[2] = s * x + c * p[2];
        p[1] += i % 3 == 0 ? random_float(&r, -0.1f, 0.1f) : 0.0f;
        p[1] = i % 11 == 0 && k % 2 ? -0.0f : p[1];
    }
}

plt_lattice sequence_lattice(uint32_t bits) {
    plt_lattice l = {{0}, 0, 0};
    if (bits > 0) {
        l = (plt_lattice){{-4.0f, -4.0f, -4.0f, 0}, ldexpf(8.0f, -(int)bits), bits};
    }
    return l;
}

static int pack_first(sequence_rig *r, const sequence_config *config, sequence *s, fail *f) {
    pack_options plain = config->scene.pack;
    plain.checks = 0; /* what moves is not streamed */
    const compact_options blocks = {.splits = plain.splits,
                                    .build = PLT_BUILD_HOST,
                                    .lattice_bits = (uint8_t)config->lattice_bits,
                                    .numbers = !config->without_ids,
                                    .checks = config->is_stills && !config->without_ids,
                                    .leaf_triangles = plain.leaf_triangles,
                                    .moving = &s->moving};
    lattice_loss loss;
    return config->is_compact ? pack_compact(&r->image, &r->frame[0], &blocks, "test", &loss, f)
                              : pack_mesh(&r->image, &r->frame[0], &plain, "test", f);
}

void sequence_rig_pack(sequence_rig *r, const mesh *first, const sequence_config *config) {
    const sequence_options o = {config->frames, 25, config->key_every,
                                sequence_lattice(config->lattice_bits), (uint8_t)config->is_stills};
    sequence s;
    fail f = {""};
    memset(r, 0, sizeof *r);
    r->frames = config->frames;
    for (uint32_t k = 0; k < r->frames; k++) {
        sequence_deform(&r->frame[k], first, k);
        if (o.lattice.bits > 0) {
            sequence_snap(&r->frame[k], &o.lattice);
        }
    }
    int status = sequence_begin(&s, &r->frame[0], &o, "test", &f);
    status = status == 0 ? pack_first(r, config, &s, &f) : status;
    for (uint32_t k = 0; k < r->frames && status == 0; k++) {
        status = sequence_add(&s, &r->frame[k], "test", &f);
    }
    status = status == 0 ? sequence_finish(&s, &r->image, &r->frame[0], "test", &f) : status;
    CHECK(status == 0, "%s", f.text);
    sequence_free(&s);
}

packed sequence_rig_image(const sequence_config *config, uint32_t triangles, uint64_t seed) {
    mesh m = {0};
    sequence_rig s;
    shape_soup(&m, triangles, 0.4f, seed);
    sequence_rig_pack(&s, &m, config);
    const packed image = s.image;
    s.image.bytes = NULL;
    sequence_rig_close(&s);
    mesh_free(&m);
    return image;
}

int sequence_rig_open(sequence_rig *r, const sequence_config *config, size_t short_by) {
    plt_options o = config->scene.run;
    o.movable = 1;
    o.residency = (uint8_t)(config->is_stills ? PLT_RESIDENCY_STREAMED : 0);
    const plt_source source = guarded_source(&r->link, &r->image, config->is_mapped);
    r->arena_bytes = plt_arena_need(&r->image.info, config->is_mapped, &o) - short_by;
    free(r->arena);
    r->arena = guarded_arena(&r->link, r->arena_bytes);
    return plt_open(&r->engine, r->arena, r->arena_bytes, &source, &o, &r->fault);
}

int sequence_rig_start(sequence_rig *r, const mesh *first, const sequence_config *config) {
    sequence_rig_pack(r, first, config);
    const int status = sequence_rig_open(r, config, 0);
    CHECK(status == PLT_OK, "%s: %s", rig_name(&config->scene), r->fault.message);
    return status;
}

int sequence_rig_close(sequence_rig *r) {
    const int good = guarded_whole(r->arena, r->arena_bytes);
    for (uint32_t k = 0; k < r->frames; k++) {
        mesh_free(&r->frame[k]);
    }
    free(r->arena);
    pack_free(&r->image);
    return good && r->link.broken == 0 && fake_unfinished(&r->link) == 0;
}

/* surface_corners - see surface_corners.h
 *
 * Single precision in this order, and no contraction: the same bits on every machine.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/surface/surface_corners.h"

#if PLT_WITH_SURFACE

#include "engine/surface/octahedral.h"

/* ---- what tables say ------------------------------------------------------------------- */

static uint32_t normal_at(const plt_retrieval *t, const uint32_t key[3]) {
    uint32_t place[3], code = 0;
    plt_retrieval_places(t->third, t->seed, key, place);
    for (int i = 0; i < 3; i++) {
        const unsigned char *entry = t->entry + 2 * (size_t)place[i];
        code ^= entry[0] | (uint32_t)entry[1] << 8;
    }
    return code;
}

static uint32_t colour_at(const plt_retrieval *t, const uint32_t key[3]) {
    uint32_t place[3];
    plt_retrieval_places(t->third, t->seed, key, place);
    return t->entry[place[0]] ^ t->entry[place[1]] ^ t->entry[place[2]];
}

static int finds_normal(const plt_surface_tables *t, const uint32_t key[3],
                        const uint32_t corner_key[3], float to[3]) {
    uint32_t code = t->position.third > 0 ? normal_at(&t->position, key) : PLT_NORMAL_SPLIT;
    if (code == PLT_NORMAL_SPLIT && t->corner.third > 0) {
        code = normal_at(&t->corner, corner_key);
    }
    plt_octahedral_normal(code, to);
    return code != PLT_NORMAL_NONE && code != PLT_NORMAL_SPLIT;
}

static void find_colour(const plt_surface_data *d, const uint32_t key[3],
                        const uint32_t corner_key[3], float to[3]) {
    const plt_surface_tables *t = &d->colours;
    uint32_t index = t->position.third > 0 ? colour_at(&t->position, key) : PLT_COLOUR_SPLIT;
    if (index == PLT_COLOUR_SPLIT && t->corner.third > 0) {
        index = colour_at(&t->corner, corner_key);
    }
    index = index < d->palette_count ? index : d->palette_count - 1;
    for (uint32_t c = 0; c < 3; c++) {
        to[c] = (float)d->palette[PLT_PALETTE_BYTES * index + c] / 255.0f;
    }
}

/* ---- the triangle's own ---------------------------------------------------------------- */

static float largest(const float v[3]) {
    const float x = __builtin_fabsf(v[0]), y = __builtin_fabsf(v[1]), z = __builtin_fabsf(v[2]);
    const float xy = x > y ? x : y;
    return xy > z ? xy : z;
}

/* Divided by the largest component first, so that no square vanishes or overflows. 0 stays. */
static void normalise(float v[3]) {
    const float most = largest(v);
    if (!(most > 0.0f)) {
        return;
    }
    float squared = 0.0f;
    for (int a = 0; a < 3; a++) {
        v[a] = v[a] / most;
        squared = squared + v[a] * v[a];
    }
    const float length = __builtin_sqrtf(squared);
    for (int a = 0; a < 3; a++) {
        v[a] = v[a] / length;
    }
}

/* Edges are divided likewise: of a tiny triangle their products would vanish. */
static void flat_normal(const float corner[3][3], float to[3]) {
    float edge[2][3];
    for (int e = 0; e < 2; e++) {
        for (int a = 0; a < 3; a++) {
            edge[e][a] = corner[e + 1][a] - corner[0][a];
        }
        normalise(edge[e]);
    }
    for (int a = 0; a < 3; a++) {
        const int b = a < 2 ? a + 1 : 0, c = b < 2 ? b + 1 : 0;
        to[a] = edge[0][b] * edge[1][c] - edge[0][c] * edge[1][b];
    }
    normalise(to);
}

/* ---- both ------------------------------------------------------------------------------ */

void plt_surface_corners_set(plt_surface_corners *c, const plt_surface_data *d,
                             const plt_record *record) {
    const uint32_t word = plt_get_u32(&record->word[9]), id = plt_primitive_id(word);
    uint32_t canonical = plt_primitive_rotation(word);
    float corner[3][3];
    plt_record_corners(record, corner);
    flat_normal((const float(*)[3])corner, c->flat);
    c->has_normals = d->has_normals;
    c->has_colours = d->has_colours;
    for (uint32_t j = 0; j < 3 && (d->has_normals || d->has_colours); j++) {
        uint32_t key[3], corner_key[3];
        canonical = canonical < 3 ? canonical : 0;
        plt_surface_key(corner[canonical], key);
        plt_surface_corner_key(id, j, corner_key);
        if (d->has_normals && !finds_normal(&d->normals, key, corner_key, c->normal[j])) {
            c->has_normals = 0;
        }
        if (d->has_colours) {
            find_colour(d, key, corner_key, c->colour[j]);
        }
        canonical++;
    }
}

static void weigh(const float of[3][3], float u, float v, float to[3]) {
    const float w = (1.0f - u) - v;
    for (int a = 0; a < 3; a++) {
        to[a] = (w * of[0][a] + u * of[1][a]) + v * of[2][a];
    }
}

void plt_surface_mix(const plt_surface_corners *c, float u, float v, plt_surface_point *p) {
    const plt_surface_point plain = {.flat = {c->flat[0], c->flat[1], c->flat[2]},
                                     .normal = {c->flat[0], c->flat[1], c->flat[2]},
                                     .colour = {1.0f, 1.0f, 1.0f},
                                     .has_normal = c->has_normals,
                                     .has_colour = c->has_colours};
    *p = plain;
    if (c->has_normals) {
        float sum[3];
        weigh((const float(*)[3])c->normal, u, v, sum);
        if (largest(sum) > 0x1p-10f && largest(sum) < 0x1p60f) { /* else they cancel out, or u and v
                                                                  * are none of a hit */
            normalise(sum);
            for (int a = 0; a < 3; a++) {
                p->normal[a] = sum[a];
            }
        }
    }
    if (c->has_colours) {
        weigh((const float(*)[3])c->colour, u, v, p->colour);
        for (int a = 0; a < 3; a++) {
            const float x = p->colour[a];
            p->colour[a] = x > 0.0f ? (x < 1.0f ? x : 1.0f) : 0.0f; /* of NaN 0 */
        }
    }
}

#endif

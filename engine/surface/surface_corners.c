/* surface_corners - see surface_corners.h
 *
 * Single precision in this order, and no contraction: the same bits on every machine.
 *
 * SPDX-License-Identifier: MIT */
#include "engine/surface/surface_corners.h"

#if PLT_WITH_SURFACE

#include "engine/base/vector.h"
#include "engine/surface/octahedral.h"

/* ---- what tables say ------------------------------------------------------------------- */

static int finds_normal(const plt_surface_tables *t, const uint32_t key[3],
                        const uint32_t corner_key[3], float to[3]) {
    const uint32_t code = plt_surface_value(t, PLT_NORMAL_BITS, PLT_NORMAL_SPLIT, key, corner_key);
    plt_octahedral_normal(code, to);
    return code != PLT_NORMAL_NONE && code != PLT_NORMAL_SPLIT;
}

static void find_colour(const plt_surface_data *d, const uint32_t key[3],
                        const uint32_t corner_key[3], float to[3]) {
    const uint32_t count = d->palette_count;
    uint32_t index = plt_surface_value(&d->colours, plt_colour_bits(count), plt_colour_split(count),
                                       key, corner_key);
    index = index < count ? index : count - 1;
    for (uint32_t c = 0; c < 3; c++) {
        to[c] = (float)d->palette[PLT_PALETTE_BYTES * index + c] / 255.0f;
    }
}

/* ---- the triangle's own ---------------------------------------------------------------- */

/* Edges are divided likewise: of a tiny triangle their products would vanish. */
static void flat_normal(const float corner[3][3], float to[3]) {
    float edge[2][3];
    for (int e = 0; e < 2; e++) {
        for (int a = 0; a < 3; a++) {
            edge[e][a] = corner[e + 1][a] - corner[0][a];
        }
        plt_normalise(edge[e]);
    }
    plt_cross(edge[0], edge[1], to);
    plt_normalise(to);
}

/* ---- texture coordinates --------------------------------------------------------------- */

#if PLT_WITH_TEXCOORDS
/* `canonical`: which corner of the record is the mesh's first. */
static void set_texcoords(plt_surface_corners *c, const plt_texcoords *t, uint32_t id,
                          uint32_t canonical, const float corner[3][3]) {
    float at[3][3];
    for (uint32_t j = 0; j < 3; j++, canonical++) {
        uint32_t key[3], corner_key[3];
        canonical = canonical < 3 ? canonical : 0;
        plt_surface_key(corner[canonical], key);
        plt_surface_corner_key(id, j, corner_key);
        if (!plt_texcoord_find(t, key, corner_key, c->texcoord[j])) {
            c->has_texcoords = 0;
            return;
        }
        for (int a = 0; a < 3; a++) {
            at[j][a] = corner[canonical][a];
        }
    }
    c->texcoord_scale = plt_texcoord_scale((const float(*)[3])at, (const float(*)[2])c->texcoord);
}

static float bounded(float x) {
    return x >= -PLT_TEXCOORD_MOST && x <= PLT_TEXCOORD_MOST ? x : 0.0f; /* of NaN, too */
}

static void mix_texcoords(const plt_surface_corners *c, float u, float v, plt_surface_point *p) {
    const float w = (1.0f - u) - v;
    for (int a = 0; a < 2; a++) {
        p->texcoord[a] =
            bounded((w * c->texcoord[0][a] + u * c->texcoord[1][a]) + v * c->texcoord[2][a]);
    }
    p->texcoord_scale = c->texcoord_scale;
    p->has_texcoord = 1;
}
#endif

/* ---- all ------------------------------------------------------------------------------ */

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
#if PLT_WITH_TEXCOORDS
    c->has_texcoords = d->has_texcoords;
    if (d->has_texcoords) {
        set_texcoords(c, &d->texcoords, id, plt_primitive_rotation(word),
                      (const float(*)[3])corner);
    }
#endif
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
        if (plt_largest(sum) > 0x1p-10f &&
            plt_largest(sum) < 0x1p60f) { /* else they cancel out, or u and v
                                           * are none of a hit */
            plt_normalise(sum);
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
#if PLT_WITH_TEXCOORDS
    if (c->has_texcoords) {
        mix_texcoords(c, u, v, p);
    }
#endif
}

#endif

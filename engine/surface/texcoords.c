/* texcoords - see texcoords.h
 *
 * SPDX-License-Identifier: MIT */
#include "engine/surface/texcoords.h"

#if PLT_WITH_TEXCOORDS

#include "engine/base/bytes.h"
#include "engine/base/fault.h"
#include "engine/base/rules.h"
#include "engine/base/vector.h"
#include "engine/image/further.h"

/* Also for NaN. */
static int is_beyond(float x) {
    return !(x >= -PLT_TEXCOORD_MOST && x <= PLT_TEXCOORD_MOST);
}

static int is_axis_wrong(const plt_texcoords *t, int a) {
    return t->bits[a] < PLT_TEXCOORD_BITS_LEAST || t->bits[a] > PLT_TEXCOORD_BITS_MOST ||
           !(t->step[a] >= 0.0f) || is_beyond(t->from[a]) ||
           is_beyond(t->from[a] + (float)((1u << t->bits[a]) - 1) * t->step[a]);
}

int plt_texcoords_read_head(plt_texcoords *t, const unsigned char *head) {
    uint32_t rest = 0;
    for (uint32_t at = PLT_TEXCOORDS_AT_REST; at < PLT_TEXCOORDS_HEAD; at += 4) {
        rest |= plt_get_u32(head + at);
    }
    for (uint32_t a = 0; a < 2; a++) {
        t->bits[a] = plt_get_u32(head + PLT_TEXCOORDS_AT_BITS + 4 * a);
        t->from[a] = plt_get_float(head + PLT_TEXCOORDS_AT_FROM + 4 * a);
        t->step[a] = plt_get_float(head + PLT_TEXCOORDS_AT_STEP + 4 * a);
    }
    return rest == 0 && !is_axis_wrong(t, 0) && !is_axis_wrong(t, 1);
}

int plt_texcoords_set(plt_texcoords *t, const plt_section *s, const unsigned char *bytes,
                      plt_fault *fault) {
    if (!plt_texcoords_read_head(t, bytes) ||
        !plt_further_is_full(s, bytes, plt_texcoords_bytes(bytes, t->bits[0] + t->bits[1]))) {
        return plt_refused(fault, PLT_R18_SURFACE, s->offset,
                           "a section of texture coordinates is not what its head must be");
    }
    plt_surface_tables_set(&t->tables, bytes, bytes + PLT_TEXCOORDS_HEAD, t->bits[0] + t->bits[1]);
    return PLT_OK;
}

int plt_texcoord_find(const plt_texcoords *t, const uint32_t key[3], const uint32_t corner_key[3],
                      float to[2]) {
    const uint32_t bits = t->bits[0] + t->bits[1], split = plt_texcoord_split(t);
    const uint32_t value = plt_surface_value(&t->tables, bits, split, key, corner_key);
    plt_texcoord_decode(t, value, to);
    return (value & split) != split;
}

float plt_texcoord_scale(const float corner[3][3], const float texcoord[3][2]) {
    float edge[2][3], across[2][2], normal[3];
    for (int e = 0; e < 2; e++) {
        for (int a = 0; a < 3; a++) {
            edge[e][a] = corner[e + 1][a] - corner[0][a];
        }
        across[e][0] = texcoord[e + 1][0] - texcoord[0][0];
        across[e][1] = texcoord[e + 1][1] - texcoord[0][1];
    }
    const float longest = plt_even_out(edge[0]) * plt_even_out(edge[1]);
    plt_cross(edge[0], edge[1], normal);
    const float most = plt_even_out(normal);
    const float area = longest * (most * __builtin_sqrtf(plt_dot(normal, normal)));
    const float covered =
        __builtin_fabsf(across[0][0] * across[1][1] - across[0][1] * across[1][0]);
    const float scale = area > 0.0f ? __builtin_sqrtf(covered / area) : 0.0f;
    return scale < 0x1p60f ? scale : 0.0f;
}

#endif

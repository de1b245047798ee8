/* record - one triangle of float geometry, 40 bytes
 *
 * Nine floats (three corners, x y z each), then an id word (primitive_id.h) that says
 * in bit 31 whether this is the last of its list. Lists have 1 .. K records in a row; a
 * last-in-list bit instead of a count leaves the thesis node as it is (thesis, section
 * 8.1.4).
 *
 * Corners stand in canonical order (canonical.h). The rotation says which corner was
 * the packed mesh's first, and so what u and v belong to.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TREE_RECORD_H
#define PLT_TREE_RECORD_H

#include <stdint.h>
#include <string.h>

#include "engine/base/box.h"
#include "engine/base/bytes.h"
#include "engine/image/items.h"
#include "engine/tree/primitive_id.h"

#define PLT_RECORD_LAST 0x80000000u

typedef struct plt_record {
    uint32_t word[10];
} plt_record;

_Static_assert(sizeof(plt_record) == PLT_RECORD_BYTES, "a triangle record has 40 bytes");

static inline float plt_record_float(const plt_record *r, int corner, int axis) {
    return plt_get_float(&r->word[3 * corner + axis]);
}

static inline int plt_record_is_last(const plt_record *r) {
    return (plt_get_u32(&r->word[9]) & PLT_RECORD_LAST) != 0;
}

static inline void plt_record_set_last(plt_record *r, int last) {
    const uint32_t word = plt_get_u32(&r->word[9]) & ~PLT_RECORD_LAST;
    plt_put_u32(&r->word[9], word | (last ? PLT_RECORD_LAST : 0));
}

static inline void plt_record_corners(const plt_record *r, float corner[3][3]) {
    memcpy(corner, r->word, 9 * sizeof r->word[0]);
#if defined(__BYTE_ORDER__) && __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__
    for (int c = 0; c < 3; c++) {
        for (int a = 0; a < 3; a++) {
            corner[c][a] = plt_record_float(r, c, a);
        }
    }
#endif
}

static inline plt_box plt_record_box(const plt_record *r) {
    plt_box b;
    for (int a = 0; a < 3; a++) {
        const float p = plt_record_float(r, 0, a), q = plt_record_float(r, 1, a),
                    s = plt_record_float(r, 2, a);
        const float lo = p < q ? p : q, hi = p > q ? p : q;
        b.lo[a] = s < lo ? s : lo;
        b.hi[a] = s > hi ? s : hi;
    }
    return b;
}

/* The tight box of records begin .. end - 1. */
static inline plt_box plt_records_box(const plt_record *records, uint32_t begin, uint32_t end) {
    plt_box box = plt_box_empty();
    for (uint32_t i = begin; i < end; i++) {
        const plt_box b = plt_record_box(&records[i]);
        plt_box_add(&box, &b);
    }
    return box;
}

#endif

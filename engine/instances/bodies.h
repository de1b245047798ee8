/* bodies - the table of an image with instances: which meshes there are, and what places them
 *
 * A body is a mesh with a tree of its own, in its own space: a range of node slots and a range of
 * records, with links and lists that count from the first of each. Instances name a body each, and
 * have a matrix per frame (matrices.h). SPEC.md, section 4.17.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_INSTANCES_BODIES_H
#define PLT_INSTANCES_BODIES_H

#include "engine/base/box.h"
#include "engine/base/bytes.h"
#include "engine/image/items.h"

typedef struct plt_body {
    uint32_t root; /* link */
    uint32_t first_slot, slots, first_record, records;
    plt_box box; /* of its triangles */
} plt_body;

/* Bodies, then the body of each instance, as they lie in the image. */
typedef struct plt_bodies {
    const unsigned char *bytes;
    uint32_t bodies, instances;
} plt_bodies;

static inline const unsigned char *plt_body_at(const plt_bodies *b, uint32_t body) {
    return b->bytes + (size_t)body * PLT_BODY_BYTES;
}

static inline void plt_body_get(const plt_bodies *b, uint32_t body, plt_body *to) {
    const unsigned char *at = plt_body_at(b, body);
    to->root = plt_get_u32(at);
    to->first_slot = plt_get_u32(at + 4);
    to->slots = plt_get_u32(at + 8);
    to->first_record = plt_get_u32(at + 12);
    to->records = plt_get_u32(at + 16);
    plt_get_floats(to->box.lo, at + PLT_BODY_BOX, 3);
    plt_get_floats(to->box.hi, at + PLT_BODY_BOX + 12, 3);
}

/* The body of an instance. */
static inline uint32_t plt_body_of(const plt_bodies *b, uint32_t instance) {
    return plt_get_u32(plt_body_at(b, b->bodies) + 4 * (size_t)instance);
}

#endif

/* ply_body - see ply_body.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/ply_body.h"

/* Bytes of one item whose lists, `lists` of them, hold `values` values each. */
static uint64_t item_bytes(const ply_element *e, uint64_t values, unsigned *lists) {
    uint64_t bytes = 0;
    *lists = 0;
    for (size_t i = 0; i < e->properties; i++) {
        const ply_property *p = &e->property[i];
        bytes += p->is_list ? ply_type_bytes(p->count_type) + values * ply_type_bytes(p->type)
                            : ply_type_bytes(p->type);
        *lists += (unsigned)p->is_list;
    }
    return bytes;
}

static const ply_element *find_element(const ply_header *h, const char *name) {
    for (size_t i = 0; i < h->elements; i++) {
        if (word_is(h->element[i].name, name) && h->element[i].count > 0) {
            return &h->element[i];
        }
    }
    return NULL;
}

static int has_others(const ply_header *h) {
    int others = 0;
    for (size_t i = 0; i < h->elements; i++) {
        const ply_element *e = &h->element[i];
        others |= e->count > 0 && !word_is(e->name, "vertex") && !word_is(e->name, "face");
    }
    return others;
}

/* What some programs write beside their headers. */
static const struct {
    ply_type said, written;
} SLIPS[] = {{PLY_UINT8, PLY_FLOAT32}, {PLY_INT8, PLY_FLOAT32}, {PLY_FLOAT32, PLY_FLOAT64}};

enum { SLIP_COUNT = sizeof SLIPS / sizeof SLIPS[0] };

/* Bytes of a vertex with that slip; 0: it has nothing to slip on. */
static uint64_t slipped_bytes(const ply_element *vertex, int slip) {
    uint64_t bytes = 0;
    int slips = 0;
    for (size_t i = 0; i < vertex->properties; i++) {
        const ply_property *p = &vertex->property[i];
        const int slipped = p->type == SLIPS[slip].said;
        if (p->is_list) {
            return 0;
        }
        bytes += ply_type_bytes(slipped ? SLIPS[slip].written : p->type);
        slips += slipped;
    }
    return slips > 0 ? bytes : 0;
}

/* Whether a body holds such vertices, and faces that are all triangles or all quads. */
static int fits(const ply_element *vertex, const ply_element *face, uint64_t body, uint64_t each) {
    unsigned lists;
    if (each == 0 || each > body / vertex->count) {
        return 0;
    }
    const uint64_t left = body - each * vertex->count, of_face = left / face->count;
    const int is_whole = left % face->count == 0;
    return is_whole &&
           (of_face == item_bytes(face, 3, &lists) || of_face == item_bytes(face, 4, &lists)) &&
           lists == 1;
}

int ply_body_check(const ply_header *h, const input *in, fail *f) {
    const ply_element *vertex = find_element(h, "vertex"), *face = find_element(h, "face");
    unsigned lists;
    if (h->format == PLY_ASCII || vertex == NULL || face == NULL || has_others(h)) {
        return 0;
    }
    for (int slip = 0; slip < SLIP_COUNT; slip++) {
        const uint64_t takes = slipped_bytes(vertex, slip);
        if (fits(vertex, face, (uint64_t)(h->data.end - h->data.at), takes)) {
            return fail_set(f, in->path,
                            "line %zu: the body does not fit the types of the header, by which a "
                            "vertex takes %llu bytes: it takes %llu; write the mesh as ASCII PLY "
                            "or OBJ",
                            vertex->line, (unsigned long long)item_bytes(vertex, 0, &lists),
                            (unsigned long long)takes);
        }
    }
    return 0;
}

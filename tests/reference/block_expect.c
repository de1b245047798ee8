/* block_expect - what a decoded compact image shall hold, from the mesh
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/block_expect.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static void *allocate(size_t count, size_t bytes) {
    void *memory = calloc(count + 1, bytes);
    if (memory == NULL) {
        fprintf(stderr, "block_expect: out of memory\n");
        exit(1);
    }
    return memory;
}

/* The number nearest to where `p` lies, of two the upper one. */
static int32_t snap(const decoded_header *header, int axis, float p) {
    const double steps = ((double)p - (double)header->origin[axis]) / (double)header->step;
    return (int32_t)(steps + 0.5); /* of a number that is not negative */
}

static int is_flat(const int32_t c[3][3]) {
    int64_t u[3], v[3];
    for (int a = 0; a < 3; a++) {
        u[a] = (int64_t)c[1][a] - c[0][a];
        v[a] = (int64_t)c[2][a] - c[0][a];
    }
    return u[0] * v[1] == u[1] * v[0] && u[1] * v[2] == u[2] * v[1] && u[2] * v[0] == u[0] * v[2];
}

static int compare_points(const int32_t *p, const int32_t *q) {
    for (int a = 0; a < 3; a++) {
        if (p[a] != q[a]) {
            return p[a] < q[a] ? -1 : 1;
        }
    }
    return 0;
}

static int compare_triangles(const void *first, const void *second) {
    const expected_triangle *s = first, *t = second;
    for (int c = 0; c < 3; c++) {
        const int order = compare_points(s->corner[c], t->corner[c]);
        if (order != 0) {
            return order;
        }
    }
    return 0;
}

/* Mesh corner j goes to canonical corner (rotation + j) mod 3. */
static void turn_to_least(expected_triangle *triangle, const int32_t given[3][3]) {
    int least = 0;
    for (int c = 1; c < 3; c++) {
        least = compare_points(given[c], given[least]) < 0 ? c : least;
    }
    triangle->rotation = (uint32_t)(3 - least) % 3;
    for (int c = 0; c < 3; c++) {
        memcpy(triangle->corner[(triangle->rotation + (uint32_t)c) % 3], given[c], sizeof given[c]);
    }
}

expected_triangle *expect_triangles(const mesh *m, const decoded_header *header, uint32_t *count) {
    expected_triangle *triangle = allocate(m->triangles, sizeof *triangle);
    *count = 0;
    for (size_t t = 0; t < m->triangles; t++) {
        int32_t given[3][3];
        for (size_t i = 0; i < 9; i++) {
            const float p = m->vertex[3 * (size_t)m->triangle[3 * t + i / 3] + i % 3];
            given[i / 3][i % 3] = snap(header, (int)(i % 3), p);
        }
        if (!is_flat((const int32_t(*)[3])given)) {
            triangle[*count].number = (uint32_t)t;
            turn_to_least(&triangle[(*count)++], (const int32_t(*)[3])given);
        }
    }
    return triangle;
}

void expect_sort(expected_triangle *triangle, uint32_t count) {
    qsort(triangle, count, sizeof *triangle, compare_triangles);
}

static void add_point(decoded_box *box, const int32_t *corner, const float *point) {
    for (int a = 0; a < 3; a++) {
        box->lo[a] = corner[a] < box->lo[a] ? corner[a] : box->lo[a];
        box->hi[a] = corner[a] > box->hi[a] ? corner[a] : box->hi[a];
        box->float_lo[a] = point[a] < box->float_lo[a] ? point[a] : box->float_lo[a];
        box->float_hi[a] = point[a] > box->float_hi[a] ? point[a] : box->float_hi[a];
    }
}

static decoded_box box_of_leaf(const decoded_image *image, const decoded_leaf *leaf) {
    const decoded_triangle *first = &image->triangle[leaf->first];
    decoded_box box = {{0}, {0}, {0}, {0}};
    memcpy(box.lo, first->corner[0], sizeof box.lo);
    memcpy(box.hi, first->corner[0], sizeof box.hi);
    memcpy(box.float_lo, first->point[0], sizeof box.float_lo);
    memcpy(box.float_hi, first->point[0], sizeof box.float_hi);
    for (uint32_t i = 0; i < 3 * leaf->triangles; i++) {
        add_point(&box, first[i / 3].corner[i % 3], first[i / 3].point[i % 3]);
    }
    return box;
}

static const decoded_box *box_below(const decoded_image *image, const expected_boxes *boxes,
                                    const decoded_child *child) {
    switch (child->kind) {
    case DECODED_INNER:
        return &boxes->node[child->which];
    case DECODED_EDGE:
        return &boxes->node[image->block[child->which].first_node];
    default:
        return &boxes->leaf[child->which];
    }
}

/* Children stand behind their parents, so from the last node to the first. */
expected_boxes expect_boxes(const decoded_image *image) {
    expected_boxes boxes = {allocate(image->nodes, sizeof *boxes.node),
                            allocate(image->leaves, sizeof *boxes.leaf)};
    for (uint32_t u = 0; u < image->leaves; u++) {
        boxes.leaf[u] = box_of_leaf(image, &image->leaf[u]);
    }
    for (uint32_t i = image->nodes; i-- > 0;) {
        const decoded_child *child = image->node[i].child;
        const decoded_box *right = box_below(image, &boxes, &child[1]);
        boxes.node[i] = *box_below(image, &boxes, &child[0]);
        add_point(&boxes.node[i], right->lo, right->float_lo);
        add_point(&boxes.node[i], right->hi, right->float_hi);
    }
    return boxes;
}

void expect_boxes_free(expected_boxes *boxes) {
    free(boxes->node);
    free(boxes->leaf);
}

int expect_holds(const decoded_box *outer, const decoded_box *inner) {
    for (int a = 0; a < 3; a++) {
        if (outer->lo[a] > inner->lo[a] || outer->hi[a] < inner->hi[a] ||
            outer->float_lo[a] > inner->float_lo[a] || outer->float_hi[a] < inner->float_hi[a]) {
            return 0;
        }
    }
    return 1;
}

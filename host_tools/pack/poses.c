/* poses - see poses.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/pack/poses.h"

#include <string.h>

#include "host_tools/base/heap.h"

#define BOXES_MOST 8388608u /* triangles times poses */

uint32_t poses_wanted(uint32_t frames, size_t triangles) {
    const size_t room = triangles > 0 ? BOXES_MOST / triangles : POSES_MOST;
    const uint32_t most = room > POSES_MOST ? POSES_MOST : room > 1 ? (uint32_t)room : 1;
    const uint32_t others = frames > 0 ? frames - 1 : 0;
    return others < most ? others : most;
}

uint32_t poses_frame(uint32_t pose, uint32_t count, uint32_t frames) {
    return (uint32_t)((uint64_t)(pose + 1) * (frames - 1) / count);
}

void poses_begin(poses *p, const mesh *own) {
    *p = (poses){.own = own};
}

int poses_add(poses *p, const mesh *frame) {
    const uint64_t bytes = 3 * (uint64_t)frame->vertices * sizeof(float);
    float *vertex = heap_get(bytes);
    if (vertex == NULL) {
        return -1;
    }
    memcpy(vertex, frame->vertex, (size_t)bytes);
    p->vertex[p->count++] = vertex;
    return 0;
}

static plt_box box_of(const mesh *m, const float *vertex, size_t triangle) {
    const uint32_t *corner = m->triangle + 3 * triangle;
    plt_box box = plt_box_empty();
    for (int c = 0; c < 3; c++) {
        plt_box_add_point(&box, vertex + 3 * (size_t)corner[c]);
    }
    return box;
}

/* Of the box of all triangles. */
static double root_area(const mesh *m, const float *vertex) {
    plt_box all = plt_box_empty();
    for (size_t i = 0; i < m->triangles; i++) {
        const plt_box box = box_of(m, vertex, i);
        plt_box_add(&all, &box);
    }
    return m->triangles > 0 ? (double)plt_box_half_area(&all) : 0.0;
}

void poses_weigh(poses *p) {
    for (uint32_t i = 0; i <= p->count; i++) {
        const double area = root_area(p->own, i == 0 ? p->own->vertex : p->vertex[i - 1]);
        p->weight[i] = area > 0.0 ? 1.0 / ((p->count + 1) * area) : 0.0;
    }
}

plt_box poses_box(const poses *p, uint32_t pose, uint32_t triangle) {
    return box_of(p->own, p->vertex[pose], triangle);
}

void poses_free(poses *p) {
    for (uint32_t i = 0; i < p->count; i++) {
        heap_drop(p->vertex[i]);
    }
    *p = (poses){.own = NULL};
}

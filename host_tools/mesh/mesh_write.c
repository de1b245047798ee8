/* mesh_write - binary little-endian PLY, on any machine
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "host_tools/base/output.h"
#include "host_tools/mesh/mesh.h"

static void put32(unsigned char *to, uint32_t bits) {
    for (int i = 0; i < 4; i++) {
        to[i] = (unsigned char)(bits >> 8 * i);
    }
}

static int write_vertices(const mesh *m, output *o, fail *f) {
    for (size_t i = 0; i < m->vertices; i++) {
        unsigned char bytes[12];
        for (int axis = 0; axis < 3; axis++) {
            uint32_t bits;
            memcpy(&bits, m->vertex + 3 * i + axis, sizeof bits);
            put32(bytes + 4 * axis, bits);
        }
        if (output_write(o, bytes, sizeof bytes, f) != 0) {
            return -1;
        }
    }
    return 0;
}

static int write_triangles(const mesh *m, output *o, fail *f) {
    for (size_t i = 0; i < m->triangles; i++) {
        unsigned char bytes[13] = {3};
        for (int k = 0; k < 3; k++) {
            put32(bytes + 1 + 4 * k, m->triangle[3 * i + (size_t)k]);
        }
        if (output_write(o, bytes, sizeof bytes, f) != 0) {
            return -1;
        }
    }
    return 0;
}

static int write_header(const mesh *m, output *o, fail *f) {
    return output_print(o, f,
                        "ply\n"
                        "format binary_little_endian 1.0\n"
                        "element vertex %zu\n"
                        "property float x\n"
                        "property float y\n"
                        "property float z\n"
                        "element face %zu\n"
                        "property list uchar int vertex_indices\n"
                        "end_header\n",
                        m->vertices, m->triangles);
}

int mesh_write_ply(const mesh *m, const char *path, fail *f) {
    if (m->vertices > (size_t)INT32_MAX + 1) {
        return fail_set(f, path, "PLY numbers only 2^31 vertices with int; split the mesh");
    }
    output *o = output_open(path, f);
    if (!o) {
        return -1;
    }
    if (write_header(m, o, f) != 0 || write_vertices(m, o, f) != 0 ||
        write_triangles(m, o, f) != 0) {
        output_abandon(o);
        return -1;
    }
    return output_commit(o, f);
}

/* fuzz_recipe - a libFuzzer target: any bytes as a recipe, and as one of its members
 *
 * What follows a line "==" is what every file of the recipe's folder holds whose name begins
 * with "it". A few others are there as well (MEMBERS). This file takes the place of
 * host_tools/base/input.c: nothing is opened, whatever a recipe names.
 *
 * What is promised is said in mesh_target.h. SPDX-License-Identifier: MIT */
#include "tests/fuzz/mesh_target.h"

#define FOLDER "scenes/"

typedef struct member {
    const char *name; /* begins so */
    const char *bytes;
    size_t size;
} member;

#define TEXT(text) text, sizeof(text) - 1

static const member MEMBERS[] = {
    {"a.ply", TEXT("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"
                   "property float y\nproperty float z\nelement face 1\n"
                   "property list uchar int vertex_indices\nend_header\n"
                   "0 0 0\n1 0 0\n0 2 0\n3 0 1 2\n")},
    {"b.obj", TEXT("v 0 0 0\nv 1 0 nan\nv 0 1 5\nv 1 1 1\nf 1 3 4\nf 1 2 3\n")},
    {"c.stl", TEXT("solid\nfacet normal 0 0 0\nouter loop\nvertex 1e12 0 0\nvertex 0 0 0\n"
                   "vertex 0 1 0\nendloop\nendfacet\nendsolid\n")},
    {"f_00", TEXT("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")},
    {"flat.obj", TEXT("v 1 1 1\nf 1 1 1\n")},
    {"r.txt", TEXT("a.ply 1 0 0 0\n")},
};

static member it = {"it", "", 0};

static const member *find_member(const char *path) {
    if (strncmp(path, FOLDER, sizeof FOLDER - 1) != 0) {
        return NULL;
    }
    const char *name = path + sizeof FOLDER - 1;
    if (strncmp(name, it.name, strlen(it.name)) == 0) {
        return it.size > 0 ? &it : NULL;
    }
    for (size_t i = 0; i < sizeof MEMBERS / sizeof MEMBERS[0]; i++) {
        if (strncmp(name, MEMBERS[i].name, strlen(MEMBERS[i].name)) == 0) {
            return &MEMBERS[i];
        }
    }
    return NULL;
}

int input_read(input *in, const char *path, fail *f) {
    const member *m = find_member(path);
    *in = (input){.path = path};
    if (m == NULL) {
        return fail_set(f, path, "cannot open: there is no such member; name another");
    }
    in->bytes = malloc(m->size + 1);
    promise(in->bytes != NULL, "memory for a member", path);
    memcpy(in->bytes, m->bytes, m->size);
    in->bytes[m->size] = 0;
    in->size = m->size;
    return 0;
}

void input_free(input *in) {
    free(in->bytes);
    in->bytes = NULL;
    in->size = 0;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {
    size_t recipe = size, rest = size;
    for (size_t i = 0; i + 4 <= size && recipe == size; i++) {
        if (memcmp(data + i, "\n==\n", 4) == 0) {
            recipe = i + 1;
            rest = i + 4;
        }
    }
    it.bytes = (const char *)data + rest;
    it.size = size - rest;
    mesh_target_try(mesh_target_recipe, FOLDER "fuzz.txt", data, recipe, 1);
    return 0;
}

/* mesh_single - see mesh_single.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/mesh_single.h"

#include <string.h>
#include <strings.h>

#include "host_tools/mesh/foreign.h"
#include "host_tools/mesh/readers.h"

static int has_ending(const char *path, const char *ending) {
    const size_t length = strlen(path), tail = strlen(ending);
    return length >= tail && strcasecmp(path + length - tail, ending) == 0;
}

int mesh_is_recipe(const input *in) {
    return has_ending(in->path, ".txt") && !ply_is(in) && !stl_is(in);
}

int mesh_read_bytes(mesh *m, const input *in, mesh_report *report, fail *f) {
    if (ply_is(in)) {
        return ply_read(m, in, report, f);
    }
    const char *foreign = stl_is(in) ? NULL : foreign_is(in);
    if (foreign != NULL) {
        return fail_set(f, in->path, "%s", foreign);
    }
    if (stl_is(in) || has_ending(in->path, ".stl")) {
        return stl_read(m, in, report, f);
    }
    if (has_ending(in->path, ".ply")) {
        return ply_read(m, in, report, f);
    }
    if (has_ending(in->path, ".obj") || obj_is(in)) {
        return obj_read(m, in, report, f);
    }
    if (stl_may_be(in)) {
        return stl_read(m, in, report, f);
    }
    return fail_set(f, in->path, "is neither PLY nor OBJ nor STL, and no .txt recipe; convert it");
}

int mesh_open(input *in, const char *path, fail *f) {
    if (input_read(in, path, f) != 0) {
        return -1;
    }
    if (strcmp(path, "-") == 0) {
        in->path = "standard input";
    }
    return 0;
}

int mesh_read_single(mesh *m, const char *path, mesh_report *report, fail *f) {
    input in;
    if (mesh_open(&in, path, f) != 0) {
        return -1;
    }
    const int result = mesh_is_recipe(&in)
                           ? fail_set(f, path, "is a recipe inside a recipe; write its lines there")
                           : mesh_read_bytes(m, &in, report, f);
    input_free(&in);
    return result;
}

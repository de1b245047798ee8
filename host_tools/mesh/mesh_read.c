/* mesh_read - a mesh, or a recipe of meshes, from a file
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/mesh_single.h"
#include "host_tools/mesh/recipe.h"

int mesh_read(mesh *m, const char *path, unsigned frame, mesh_report *report, fail *f) {
    input in;
    if (mesh_open(&in, path, f) != 0) {
        return -1;
    }
    const int result = mesh_is_recipe(&in) ? recipe_read(m, &in, frame, report, f)
                                           : mesh_read_bytes(m, &in, report, f);
    input_free(&in);
    return result;
}

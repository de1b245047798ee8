/* mesh_read - a mesh, or a recipe of meshes, from a file
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/mesh_single.h"
#include "host_tools/mesh/recipe.h"

int mesh_read(mesh *m, const char *path, unsigned frame, mesh_repair *repair, fail *f) {
    input in;
    if (mesh_open(&in, path, f) != 0) {
        return -1;
    }
    const int result = mesh_is_recipe(&in) ? recipe_read(m, &in, frame, repair, f)
                                           : mesh_read_bytes(m, &in, repair, f);
    input_free(&in);
    return result;
}

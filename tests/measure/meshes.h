/* meshes - the meshes that a measuring program is given, or a small one
 *
 * SPDX-License-Identifier: MIT */
#ifndef MEASURE_MESHES_H
#define MEASURE_MESHES_H

#include "host_tools/mesh/mesh.h"
#include "host_tools/scenes/scenes.h"
#include "tests/reference/rig.h"
#include "tests/test.h"

/* Calls `measure` with each mesh that the command line names; without one with a knot, so that a
 * run of all tests measures, too. What main returns. */
static inline int measure_meshes(int argc, char **argv, const char *sentence,
                                 void (*measure)(const mesh *m, const char *name)) {
    test(sentence);
    for (int i = 1; i < argc || i == 1; i++) {
        mesh m = {0};
        mesh_report report = {0};
        fail f = {""};
        const int status = i < argc ? mesh_read(&m, argv[i], 0, &report, &f)
                                    : scene_knot(&m, rig_is_tiny() ? 100 : 20000, &f);
        CHECK(status == 0, "%s", f.text);
        if (status == 0) {
            measure(&m, i < argc ? argv[i] : "knot");
        }
        mesh_free(&m);
    }
    return test_done();
}

#endif

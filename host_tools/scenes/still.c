/* still - see still.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/scenes/still.h"

#include "host_tools/scenes/counts.h"
#include "host_tools/scenes/scenes.h"

/* What brings the tray back to level, times a marble's matrix: the transpose of the tray's. */
static void level(const double tray[12], const double marble[12], double to[12]) {
    for (unsigned i = 0; i < 3; i++) {
        for (unsigned j = 0; j < 4; j++) {
            to[4 * i + j] =
                tray[i] * marble[j] + tray[4 + i] * marble[4 + j] + tray[8 + i] * marble[8 + j];
        }
    }
}

int still_marbles(painted *p, uint64_t triangles, unsigned frame, fail *f) {
    static double matrix[SCENE_MARBLES_INSTANCES][12];
    if (count_check(&p->m, "tray of marbles", triangles, SCENE_MARBLES_LEAST, SCENE_MARBLES_MOST,
                    f)) {
        return -1;
    }
    const unsigned bodies = scene_marbles_matrices(triangles, frame, matrix);
    int wrong = still_tray(p, f);
    for (unsigned i = 1; i < bodies && !wrong; i++) {
        double moved[12];
        level(matrix[0], matrix[i], moved);
        wrong = still_ball(p, i - 1, moved, f);
    }
    return wrong ? -1 : 0;
}

/* frame_times - see frame_times.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/frame_times.h"

#include <stdlib.h>

int frame_times_make(frame_times *t, unsigned frames, fail *f) {
    *t = (frame_times){.frames = frames, .at = calloc(frames, sizeof *t->at)};
    return t->at == NULL ? fail_set(f, "statistics", "out of memory; close other programs") : 0;
}

void frame_times_free(frame_times *t) {
    free(t->at);
    *t = (frame_times){.frames = 0};
}

static void keep_least(double *least, double seconds, int is_first) {
    *least = is_first || seconds < *least ? seconds : *least;
}

void frame_times_keep(frame_times *t, unsigned index, const frame_time *before,
                      const frame_time *behind, int is_first_run) {
    if (index < t->frames) {
        frame_time *to = &t->at[index];
        keep_least(&to->move, behind->move - before->move, is_first_run);
        keep_least(&to->rebuild, behind->rebuild - before->rebuild, is_first_run);
        keep_least(&to->trace, behind->trace - before->trace, is_first_run);
    }
}

/* `part`: 0 moving, 1 rebuilding, 2 rays. */
static void print_part(output *o, const frame_times *t, const char *name, unsigned part, fail *f) {
    output_print(o, f, "  \"%s\": [", name);
    for (unsigned i = 0; i < t->frames; i++) {
        const frame_time *at = &t->at[i];
        const double seconds[3] = {at->move, at->rebuild, at->trace};
        output_print(o, f, "%s%.9f", i > 0 ? ", " : "", seconds[part]);
    }
    output_print(o, f, "],\n");
}

void frame_times_print(output *o, const frame_times *t, int moves, fail *f) {
    if (moves) {
        print_part(o, t, "frame_move_seconds", 0, f);
        print_part(o, t, "frame_rebuild_seconds", 1, f);
    }
    print_part(o, t, "frame_seconds", 2, f);
}

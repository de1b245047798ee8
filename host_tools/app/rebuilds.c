/* rebuilds - see rebuilds.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/rebuilds.h"

#include <inttypes.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/base/clock.h"

enum { PERCENT_MOST = 1000 };

static const char *const words[] = {"never", "always", "threshold", "cost"};

/* One of the words, of a threshold with its percent. */
static int read_when(rebuilds *r, const char *text) {
    unsigned percent = 0;
    int length = 0;
    for (unsigned i = 0; i < sizeof words / sizeof *words; i++) {
        if (i != PLT_REBUILD_THRESHOLD && strcmp(text, words[i]) == 0) {
            r->when = i;
            return 0;
        }
    }
    const char *number = strncmp(text, "threshold:", 10) == 0 ? text + 10 : "";
    if (strspn(number, "0123456789") != strlen(number) ||
        sscanf(number, "%5u%n", &percent, &length) != 1 || number[length] != '\0' || percent < 1 ||
        percent > PERCENT_MOST) {
        return -1;
    }
    r->when = PLT_REBUILD_THRESHOLD;
    r->percent = percent;
    return 0;
}

void rebuilds_read(rebuilds *r, scene *s, args *a, int moves) {
    const char *when = args_text(a, "--rebuild", NULL);
    *r = (rebuilds){.when = PLT_REBUILD_NEVER};
    r->step = (uint32_t)args_number(a, "--rebuild-step", UINT32_MAX, 1, 4000000000u);
    if (when != NULL && read_when(r, when) != 0) {
        args_complain(
            a, "--rebuild takes never, always, threshold:PERCENT (1 to %d) or cost, not '%s'",
            PERCENT_MOST, when);
    }
    if (when != NULL && !moves) {
        args_complain(a, "--rebuild is for --moved MESH or --frames A:B");
    }
    if (args_has(a, "--rebuild-step") && r->when == PLT_REBUILD_NEVER) {
        args_complain(a, "--rebuild-step is for --rebuild always, threshold:PERCENT or cost");
    }
    if (args_has(a, "--rebuild-most") && r->when == PLT_REBUILD_NEVER) {
        args_complain(a, "--rebuild-most is for --rebuild always, threshold:PERCENT or cost");
    }
    s->options.rebuild = r->when != PLT_REBUILD_NEVER;
    s->options.rebuild_most =
        (uint32_t)args_number(a, "--rebuild-most", 0, PLT_SUBTREE_LEAST, 4000000000u);
}

/* What is due, or has begun: a step of it, or all. 1: no room for the new tree, so the old one goes
 * on. */
static int go_on(const rebuilds *r, plt_engine *e) {
    const int is_whole = r->step == UINT32_MAX;
    plt_fault fault;
    int status, is_due;
    do { /* of subtrees, several may be due */
        is_due = plt_rebuild_due(e, r->when, r->percent);
        if (is_due) {
            plt_rebuild_begin(e, &fault);
        }
        do {
            status = plt_rebuild_step(e, r->step, &fault);
        } while (status == PLT_MORE && is_whole);
    } while (status == PLT_OK && is_due && is_whole && r->when == PLT_REBUILD_COST);
    return status < PLT_OK;
}

void rebuilds_go_on(rebuilds *r, const scene *s) {
    const double began = clock_thread_seconds();
    plt_motion q;
    plt_motion_get(s->engine, &q);
    r->most = q.degradation > r->most ? q.degradation : r->most;
    for (unsigned i = 0; i < s->crew.count && r->when != PLT_REBUILD_NEVER; i++) {
        r->given_up += (unsigned)go_on(r, s->crew.worker[i].engine);
    }
    r->seconds += clock_thread_seconds() - began;
}

void rebuilds_print(output *o, const rebuilds *r, const scene *s, unsigned repeat, fail *f) {
    plt_motion q;
    plt_motion_get(s->engine, &q);
    output_print(o, f,
                 "  \"rebuild\": \"%s\",\n  \"rebuilds\": %" PRIu32
                 ",\n  \"rebuilds_given_up\": %u,\n  \"rebuild_seconds\": %.9f,\n"
                 "  \"degradation\": %.6f,\n  \"degradation_most\": %.6f,\n  \"growth\": %.6f,\n"
                 "  \"excess_work\": %" PRIu64 ",\n  \"build_work\": %" PRIu64
                 ",\n  \"subtrees\": %" PRIu32 ",\n  \"rebuilt_triangles\": %" PRIu64 ",\n",
                 words[r->when], q.rebuilds, r->given_up, r->seconds / repeat,
                 (double)q.degradation, (double)r->most, (double)q.growth, q.excess_work,
                 q.build_work, q.subtrees, q.rebuilt);
}

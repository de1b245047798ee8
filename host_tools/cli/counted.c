/* counted - see counted.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/counted.h"

#include <string.h>

#include "host_tools/cli/baseline.h"

enum { RUN = 1024 }; /* a whole number of packets of every size */

void counted_read(counted *c, args *a) {
    c->is_wanted = args_has(a, "--counts");
    if (!c->is_wanted) {
        return;
    }
    if (!args_has(a, "--json")) {
        args_complain(a, "--counts are written to --json; add that");
    } else if (args_has(a, "--baseline")) {
        args_complain(a, "--baseline counts packets by itself; leave out --counts");
    } else if (args_has(a, "--rays") && strcmp(args_text(a, "--rays", ""), "incoherent") == 0) {
        args_complain(a, "--counts are of packets; leave out --rays incoherent");
    }
}

int counted_start(counted *c, plt_engine *engine, const char *name, fail *f) {
    if (!c->is_wanted) {
        return 0;
    }
    c->engine = counted_engine_open(engine, name, f);
    return c->engine != NULL ? 0 : -1;
}

void counted_end(counted *c) {
    counted_engine_close(c->engine);
    c->engine = NULL;
}

int counted_rays(counted *c, const plt_ray *rays, const plt_hit *hits, uint32_t count, int any,
                 fail *f) {
    plt_hit got[RUN];
    for (uint32_t at = 0; at < count; at += RUN) {
        const uint32_t left = count - at, now = left < RUN ? left : RUN;
        if (counted_engine_trace(c->engine, rays + at, got, now, any, f) != 0) {
            return -1;
        }
        if (memcmp(got, hits + at, now * sizeof *got) != 0) {
            return fail_set(f, "engine", "hits that are counted differ; please report this");
        }
    }
    return 0;
}

int counted_frame(counted *c, const plt_frame *frame, fail *f) {
    return counted_engine_frame(c->engine, frame, f);
}

int counted_print(const counted *c, output *o, fail *f) {
    if (c->engine == NULL) {
        return 0;
    }
    const structure_statistics s = counted_engine_count(c->engine);
    output_print(o, f, ",\n");
    return baseline_print_intersections(&s, o, f);
}

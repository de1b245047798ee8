/* vertices - see vertices.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/app/vertices.h"

static const char *const choices[] = {"auto", "always", "never", NULL};

void vertices_read(scene *s, args *a, int plays) {
    const unsigned choice = (unsigned)args_choice(a, "--records", choices, PLT_RECORDS_AUTO);
    s->options.records = (uint8_t)(plays ? choice : PLT_RECORDS_ALWAYS); /* for --moved */
    s->options.beside = (uint8_t)args_has(a, "--beside");
    if ((args_has(a, "--records") || s->options.beside) && !plays) {
        args_complain(a, "--records and --beside are for --frames A:B of an image that has them");
    }
    if (s->options.beside && s->options.records == PLT_RECORDS_ALWAYS) {
        args_complain(a, "--beside is for --records never, or auto");
    }
    if ((s->options.beside || s->options.records == PLT_RECORDS_NEVER) && s->options.rebuild) {
        args_complain(a, "--rebuild is for --records always, or auto without --beside");
    }
}

void vertices_print(output *o, const scene *s, fail *f) {
    plt_motion q;
    plt_motion_get(s->engine, &q);
    output_print(o, f, "  \"over_vertices\": %u,\n  \"beside\": %u,\n", q.over_vertices,
                 q.is_beside);
}

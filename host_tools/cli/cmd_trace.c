/* cmd_trace - planelet trace: a ray file to a hit file
 *
 * Ray file: 32 bytes a ray, little-endian float32: org[3] tmin dir[3] tmax.
 * Hit file: 16 bytes a ray: t u v and the triangle's number.
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

#include "engine/image/bytes.h"
#include "host_tools/base/input.h"
#include "host_tools/base/output.h"
#include "host_tools/cli/commands.h"
#include "host_tools/cli/scene.h"

enum { RAY_BYTES = 32, HIT_BYTES = 16 };

static const arg_flag flags[] = {
    {"--any", NULL, "whether anything is hit, instead of the nearest hit"},
    {"--repeat", "N", "trace N times, report the best time (default 1)"},
    {"--json", "STATS", "write figures; - is standard output"},
    SCENE_FLAGS,
    {NULL, NULL, NULL}};

const arg_command command_trace = {
    "trace", "SCENE.plt RAYS HITS",
    "Traces a file of rays (org tmin dir tmax, 8 little-endian floats each) and writes a hit\n"
    "for each (t u v, number of the triangle; 4294967295 is a miss).",
    flags, 3, 3};

typedef struct tracing {
    plt_ray *rays;
    plt_hit *hits;
    uint32_t count;
    double seconds; /* of the best run */
} tracing;

static double cpu_seconds(void) {
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Rays are floats of this machine from here on. */
static int read_rays(tracing *t, const char *path, fail *f) {
    input in;
    if (input_read(&in, path, f) != 0) {
        return -1;
    }
    int status = 0;
    if (in.size % RAY_BYTES != 0) {
        status = fail_set(f, path,
                          "byte %zu: the last ray is cut short (a ray has 32 bytes); write it anew",
                          in.size - in.size % RAY_BYTES);
    } else if (in.size / RAY_BYTES > UINT32_MAX) {
        status = fail_set(f, path, "more than 2^32 rays; part the file");
    } else {
        t->count = (uint32_t)(in.size / RAY_BYTES);
        t->rays = malloc(in.size);
        t->hits = malloc((size_t)t->count * sizeof *t->hits);
        if (t->rays == NULL || t->hits == NULL) {
            status = fail_set(f, path, "out of memory for %u rays; part the file", t->count);
        } else {
            plt_get_floats((float *)t->rays, in.bytes, 8 * t->count);
        }
    }
    input_free(&in);
    return status;
}

static void trace_all(tracing *t, plt_engine *engine, int any, unsigned repeat) {
    for (unsigned i = 0; i < repeat; i++) {
        plt_stats_reset(engine);
        const double began = cpu_seconds();
        plt_trace(engine, t->rays, t->hits, t->count, any);
        const double took = cpu_seconds() - began;
        t->seconds = i == 0 || took < t->seconds ? took : t->seconds;
    }
}

static int write_hits(const tracing *t, const char *path, fail *f) {
    output *o = output_open(path, f);
    if (o == NULL) {
        return -1;
    }
    for (uint32_t i = 0; i < t->count; i++) {
        unsigned char bytes[HIT_BYTES];
        const float tuv[3] = {t->hits[i].t, t->hits[i].u, t->hits[i].v};
        plt_put_floats(bytes, tuv, 3);
        plt_put_u32(bytes + 12, t->hits[i].triangle);
        if (output_write(o, bytes, sizeof bytes, f) != 0) {
            output_abandon(o);
            return -1;
        }
    }
    return output_commit(o, f);
}

static int write_stats(const scene *s, const tracing *t, const char *path, fail *f) {
    output *o = output_open(path, f);
    if (o == NULL) {
        return -1;
    }
    output_print(o, f, "{\n");
    scene_print_stats(o, s, t->seconds, f);
    if (output_print(o, f, "\n}\n") != 0) {
        output_abandon(o);
        return -1;
    }
    return output_commit(o, f);
}

int run_trace(args *a) {
    const unsigned repeat = (unsigned)args_number(a, "--repeat", 1, 1, 1000000);
    const char *json = args_text(a, "--json", NULL);
    scene s = {0};
    tracing t = {0};
    fail f = {""};
    int status = scene_open(&s, a, a->file[0], &f);
    if (status == 0) {
        status = read_rays(&t, a->file[1], &f);
    }
    if (status == 0) {
        trace_all(&t, s.engine, args_has(a, "--any"), repeat);
        status = write_hits(&t, a->file[2], &f);
    }
    if (status == 0 && json != NULL) {
        status = write_stats(&s, &t, json, &f);
    }
    scene_close(&s);
    free(t.rays);
    free(t.hits);
    if (a->wrong) {
        return 2;
    }
    if (status != 0) {
        fprintf(stderr, "%s\n", f.text);
    }
    return status == 0 ? 0 : 1;
}

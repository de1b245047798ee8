/* bench_against - see bench_against.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/bench_against.h"

#include <stdlib.h>
#include <string.h>

#include "host_tools/base/clock.h"
#include "host_tools/cli/baseline.h"

enum { ROUNDS_MOST = 1000, SIDES = 4, RAYS_PER_BATCH = 65536 };

void against_free(against *a) {
    free(a->row);
    a->row = NULL;
}

/* ---- the flag ------------------------------------------------------------------------ */

static int read_one(against_wanted *w, const char *text, size_t length, fail *f) {
    if (length >= sizeof w->name) {
        return fail_set(f, "--against", "a name of %zu characters; choose each switch once",
                        length);
    }
    memcpy(w->name, text, length);
    w->name[length] = '\0';
    w->kind = structure_read(w->name, "--against", &w->options, f);
    w->has_side = w->kind != NULL && w->options.choice[STRUCTURE_SIDE] != 0;
    return w->kind != NULL ? 0 : -1;
}

void against_read(against *to, args *a) {
    const char *at = args_text(a, "--against", NULL);
    fail f = {""};
    if (at == NULL) {
        return;
    }
    for (;; to->count++) {
        at += strspn(at, " ");
        const size_t length = strcspn(at, " ");
        if (*at == '\0' && to->count > 0) {
            return;
        }
        if (to->count == AGAINST_MOST) {
            args_complain(a, "--against takes %d structures at most", AGAINST_MOST);
            return;
        }
        if (read_one(&to->wanted[to->count], at, length, &f) != 0) {
            args_complain(a, "%s", f.text);
            return;
        }
        at += length;
    }
}

/* Rays that go one by one are beside the usual packets of the engine. */
static int has_side(const against_wanted *w, unsigned side) {
    if (w->has_side) {
        return w->options.choice[STRUCTURE_SIDE] == side ||
               (w->options.choice[STRUCTURE_SIDE] == 1 && side == SCENE_USUAL_PACKET);
    }
    for (const structure_switch *s = structure_switches(w->kind); s->name != NULL; s++) {
        if (s->group == STRUCTURE_SIDE && s->value == side) {
            return 1;
        }
    }
    return 0;
}

/* Whether one of the packets is measured; a build may be without the larger ones. */
static int is_measured(const against *a, const against_wanted *w) {
    int is = 0;
    for (unsigned i = 0; i < SIDES && 2u << i <= PLT_PACKET_SIDE_MAX; i++) {
        is |= (a->packets >> i & 1u) && has_side(w, 2u << i);
    }
    return is;
}

void against_check(const against *of, args *a) {
    for (unsigned i = 0; i < of->count; i++) {
        if (!is_measured(of, &of->wanted[i])) {
            args_complain(a,
                          "--against %s: none of its packets is in --packets; leave --packets out",
                          of->wanted[i].name);
        }
    }
}

/* ---- measuring ------------------------------------------------------------------------- */

/* What is measured now. */
typedef struct pairing {
    plt_engine *engine;
    baseline other;
    const char *name; /* of the scene */
    plt_hit *hits[2]; /* the engine's, the structure's */
    progress bar;
    uint64_t done;
} pairing;

static double trace_engine(pairing *p, const ray_set *rays, int any) {
    double seconds = 0.0;
    for (uint32_t at = 0, now; at < rays->count; at += now) {
        const uint32_t left = rays->count - at;
        now = left < RAYS_PER_BATCH ? left : RAYS_PER_BATCH;
        const double began = clock_processor_seconds();
        plt_trace(p->engine, rays->rays + at, p->hits[0] + at, now, any); /* mapped: no failures */
        seconds += clock_processor_seconds() - began;
    }
    return seconds;
}

/* Below 0: it failed. */
static double trace_other(pairing *p, const ray_set *rays, int any, fail *f) {
    double seconds = 0.0;
    for (uint32_t at = 0, now; at < rays->count; at += now) {
        const uint32_t left = rays->count - at;
        now = left < RAYS_PER_BATCH ? left : RAYS_PER_BATCH;
        const double began = clock_processor_seconds();
        if (structure_trace(p->other.s, rays->rays + at, p->hits[1] + at, now, any, f) != 0) {
            return -1.0;
        }
        seconds += clock_processor_seconds() - began;
    }
    return seconds;
}

static int by_size(const void *a, const void *b) {
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double at_least(double seconds) {
    return seconds > 1e-9 ? seconds : 1e-9;
}

/* The first round is by no clock: its hits are compared, and its counts are kept. */
static int count_round(pairing *p, against_row *row, const ray_set *rays, fail *f) {
    plt_stats_reset(p->engine);
    structure_forget(p->other.s);
    trace_engine(p, rays, row->any);
    if (trace_other(p, rays, row->any, f) < 0.0) {
        return -1;
    }
    plt_stats_get(p->engine, &row->engine);
    row->counts = structure_count(p->other.s);
    if (memcmp(p->hits[0], p->hits[1], (size_t)rays->count * sizeof **p->hits) != 0) {
        return fail_set(f, p->name, "hits of %s rays differ from those of %s; please report this",
                        ray_kind_names[row->kind], row->name);
    }
    return 0;
}

static int measure_row(pairing *p, against_row *row, const ray_set *rays, unsigned rounds,
                       fail *f) {
    double ratio[ROUNDS_MOST];
    row->rays = rays->count;
    if (count_round(p, row, rays, f) != 0) {
        return -1;
    }
    for (unsigned i = 0; i < rounds; i++) {
        const double mine = at_least(trace_engine(p, rays, row->any));
        const double its = trace_other(p, rays, row->any, f);
        if (its < 0.0) {
            return -1;
        }
        row->engine_seconds = i == 0 || mine < row->engine_seconds ? mine : row->engine_seconds;
        row->seconds = i == 0 || its < row->seconds ? at_least(its) : row->seconds;
        ratio[i] = its / mine;
        progress_show(&p->bar, ++p->done);
    }
    qsort(ratio, rounds, sizeof *ratio, by_size);
    row->ratio = 0.5 * (ratio[(rounds - 1) / 2] + ratio[rounds / 2]);
    return 0;
}

static against_row *add_row(against *a, fail *f) {
    if (a->rows == a->room) {
        const unsigned room = 2 * a->room + 64;
        against_row *row = realloc(a->row, room * sizeof *row);
        if (row == NULL) {
            fail_set(f, "rays", "out of memory; choose a smaller --size");
            return NULL;
        }
        a->row = row;
        a->room = room;
    }
    a->row[a->rows] = (against_row){.scene = NULL};
    return &a->row[a->rows++];
}

static int measure_kinds(against *a, pairing *p, const against_row *like, const ray_kinds *rays,
                         fail *f) {
    for (unsigned k = 0; k < 2 * RAY_KINDS; k++) {
        const unsigned kind = k / 2, any = k % 2;
        if (!(a->kinds >> kind & 1u) || !(a->hits >> any & 1u)) {
            continue;
        }
        against_row *row = add_row(a, f);
        if (row == NULL) {
            return -1;
        }
        *row = *like;
        row->kind = (uint8_t)kind;
        row->any = (uint8_t)any;
        if (measure_row(p, row, &rays->of[kind], a->repeat, f) != 0) {
            return -1;
        }
    }
    return 0;
}

static int measure_one(against *a, pairing *p, const against_wanted *w, unsigned side,
                       const ray_kinds *rays, fail *f) {
    p->other = (baseline){.kind = w->kind, .options = w->options};
    if (!w->has_side) {
        p->other.options.packet_side = (uint8_t)side;
        p->other.options.one_by_one = 0;
    }
    int status = baseline_open(&p->other, p->engine, p->name, f);
    if (status == 0) {
        const plt_info *info = plt_engine_info(p->engine);
        against_row like = {.scene = p->name,
                            .packet_side = (uint8_t)side,
                            .triangles = info->triangles,
                            .engine_bytes = (uint64_t)info->node_slots * 32,
                            .build_seconds = p->other.build_seconds};
        memcpy(like.name, w->name, sizeof like.name);
        status = measure_kinds(a, p, &like, rays, f);
    }
    baseline_close(&p->other);
    return status;
}

static int measure_side(against *a, pairing *p, scene *s, const char *path, unsigned side,
                        const ray_kinds *rays, fail *f) {
    plt_fault fault;
    s->options = (plt_options){.packet_side = (uint8_t)side};
    const int opened = scene_start(s, path, &fault);
    if (opened != PLT_OK) {
        return scene_refused(s, path, opened, &fault, f);
    }
    p->engine = s->engine;
    for (unsigned i = 0; i < a->count; i++) {
        if (has_side(&a->wanted[i], side) && measure_one(a, p, &a->wanted[i], side, rays, f) != 0) {
            return -1;
        }
    }
    return 0;
}

/* Room for the hits of the largest set, twice. */
static int get_hits(pairing *p, const ray_kinds *rays, fail *f) {
    uint32_t most = 1;
    for (unsigned kind = 0; kind < RAY_KINDS; kind++) {
        most = rays->of[kind].count > most ? rays->of[kind].count : most;
    }
    p->hits[0] = calloc(2 * (size_t)most, sizeof **p->hits);
    if (p->hits[0] == NULL) {
        return fail_set(f, "rays", "out of memory; choose a smaller --size");
    }
    p->hits[1] = p->hits[0] + most;
    return 0;
}

int against_measure(against *a, scene *s, const char *path, const ray_kinds *rays, fail *f) {
    pairing p = {.name = scene_name(path)};
    const unsigned ways = (unsigned)(__builtin_popcount(a->kinds) * __builtin_popcount(a->hits) *
                                     __builtin_popcount(a->packets));
    int status = get_hits(&p, rays, f);
    progress_begin(&p.bar, "tracing", (uint64_t)ways * a->count * a->repeat);
    for (unsigned i = 0; i < SIDES && status == 0; i++) {
        if (a->packets >> i & 1u && 2u << i <= PLT_PACKET_SIDE_MAX) {
            status = measure_side(a, &p, s, path, 2u << i, rays, f);
        }
    }
    progress_end(&p.bar);
    free(p.hits[0]);
    return status;
}

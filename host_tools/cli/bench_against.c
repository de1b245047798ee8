/* bench_against - see bench_against.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/bench_against.h"

#include <stdlib.h>
#include <string.h>

#include "host_tools/baselines/turns.h"
#include "host_tools/cli/baseline.h"

void against_free(against *a) {
    free(a->row);
    a->row = NULL;
}

void against_read(against *to, args *a) {
    bench_list_read(&to->list, a, "--against", 0);
    bench_list_check(&to->list, a, "--against", to->packets, SCENE_USUAL_PACKET);
}

/* Rays that go one by one are beside the usual packets of the engine. */
static int has_side(const bench_wanted *w, unsigned side) {
    return bench_wanted_has(w, side) || (side == SCENE_USUAL_PACKET && bench_wanted_has(w, 0));
}

/* What is measured now. */
typedef struct pairing {
    built_structure *engine;
    baseline other;
    const char *name; /* of the scene */
    progress bar;
    uint64_t passes;
} pairing;

static int measure_row(pairing *p, against_row *row, const ray_set *rays, unsigned rounds,
                       fail *f) {
    double ratio[TURNS_ROUNDS_MOST];
    turns t = {
        .side = {{.name = "the engine", .s = p->engine}, {.name = row->name, .s = p->other.s}},
        .sides = 2,
        .rounds = rounds,
        .is_tried = 1,
        .any = row->any,
        .rays = turns_rays_of(rays->rays, rays->count),
        .scene = p->name,
        .kind = ray_kind_names[row->kind],
        .bar = &p->bar,
        .passes = p->passes};
    const turns_side *mine = &t.side[0], *its = &t.side[1];
    row->rays = rays->count;
    if (turns_run(&t, f) != 0) {
        return -1;
    }
    p->passes = t.passes;
    row->engine = mine->counts;
    row->counts = its->counts;
    row->engine_seconds = mine->best;
    row->seconds = its->best;
    for (unsigned i = 0; i < rounds; i++) {
        ratio[i] = its->seconds[i] / mine->seconds[i];
    }
    row->ratio = turns_median(ratio, rounds);
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

static int measure_one(against *a, pairing *p, const plt_engine *engine, const bench_wanted *w,
                       unsigned side, const ray_kinds *rays, fail *f) {
    p->other = (baseline){.kind = w->kind, .options = bench_wanted_options(w, side)};
    int status = baseline_open(&p->other, engine, p->name, f);
    if (status == 0) {
        against_row like = {.scene = p->name,
                            .packet_side = (uint8_t)side,
                            .triangles = plt_engine_info(engine)->triangles,
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
    int status = 0;
    s->options = (plt_options){.packet_side = (uint8_t)side};
    const int opened = scene_start(s, path, &fault);
    if (opened != PLT_OK) {
        return scene_refused(s, path, opened, &fault, f);
    }
    p->engine = structure_of_engine(s->engine, p->name, f);
    if (p->engine == NULL) {
        return -1;
    }
    for (unsigned i = 0; i < a->list.count && status == 0; i++) {
        const bench_wanted *w = &a->list.wanted[i];
        status = has_side(w, side) ? measure_one(a, p, s->engine, w, side, rays, f) : 0;
    }
    structure_close(p->engine);
    return status;
}

int against_measure(against *a, scene *s, const char *path, const ray_kinds *rays, fail *f) {
    pairing p = {.name = scene_name(path)};
    const unsigned ways = (unsigned)(__builtin_popcount(a->kinds) * __builtin_popcount(a->hits) *
                                     __builtin_popcount(a->packets));
    int status = 0;
    progress_begin(&p.bar, "tracing", (uint64_t)ways * a->list.count * 2 * (a->repeat + 1));
    for (unsigned i = 0; i < BENCH_SIDES && status == 0; i++) {
        if (a->packets >> i & 1u && 2u << i <= PLT_PACKET_SIDE_MAX) {
            status = measure_side(a, &p, s, path, 2u << i, rays, f);
        }
    }
    progress_end(&p.bar);
    return status;
}

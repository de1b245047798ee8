/* measure - see measure.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/tables/measure.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/baselines/structure.h"
#include "host_tools/tables/measure_nodes.h"
#include "host_tools/tables/racers.h"

figures figures_none(void) {
    figures none;
    for (unsigned i = 0; i < FIGURES; i++) {
        none.of[i] = (double)NAN;
    }
    return none;
}

/* ---- structures ---------------------------------------------------------- */

static void take_counts(const structure_statistics *c, figures *to) {
    to->of[FIGURE_TRIANGLES] = c->references;
    to->of[FIGURE_NODES] = c->nodes;
    to->of[FIGURE_LEAVES] = c->leaves;
    to->of[FIGURE_BYTES] = (double)(c->thesis_bytes > 0 ? c->thesis_bytes : c->bytes);
}

static void take_rays(const structure_statistics *c, figures *to) {
    to->of[FIGURE_RAYS] = (double)c->rays;
    if (c->packets > 0) {
        to->of[FIGURE_PACKETS] = (double)c->packets;
        to->of[FIGURE_NODE_ISECTS] = (double)c->packet_nodes;
        to->of[FIGURE_TRIANGLE_ISECTS] = (double)c->packet_triangles;
        to->of[FIGURE_MASKED] =
            c->rays_at_nodes > 0 ? (double)c->masked_at_nodes / (double)c->rays_at_nodes : 0.0;
    }
}

/* All rays once, by no clock. */
static int count_rays(stage *s, built_structure *built, const char *name, figures *to, fail *f) {
    turns t = {.sides = 1,
               .is_tried = 1,
               .rays = stage_rays(s),
               .scene = s->name,
               .kind = "primary",
               .side = {{.name = name, .s = built}}};
    const int status = turns_run(&t, f);
    take_rays(&t.side[0].counts, to);
    return status;
}

static int measure_structure(meter *m, stage *s, const char *text, int is_traced, figures *to,
                             fail *f) {
    structure_options options = {.packet_side = 0};
    const structure_kind *kind = structure_read(text, s->name, &options, f);
    built_structure *built = NULL;
    int status = kind != NULL ? 0 : -1;
    if (status == 0 && is_traced) {
        status = stage_look(s, &m->look, f);
    }
    if (status == 0) {
        built = structure_open(kind, &s->m, &options, s->name, f);
        status = built != NULL ? 0 : -1;
    }
    if (status == 0 && is_traced) {
        status = count_rays(s, built, text, to, f);
    }
    if (status == 0) {
        const structure_statistics counted = structure_count(built);
        take_counts(&counted, to);
    }
    structure_close(built);
    return status;
}

int measure_job(meter *m, stage *s, const char *job, figures *to, fail *f) {
    *to = figures_none();
    if (strncmp(job, "pack:", 5) == 0) {
        return measure_packing(s, job + 5, to, f);
    }
    if (strncmp(job, "slots:", 6) == 0) {
        return measure_slots(s, job + 6, to, f);
    }
    const int is_traced = strncmp(job, "trace:", 6) == 0;
    return measure_structure(m, s, job + (is_traced ? 6 : 5), is_traced, to, f);
}

/* ---- races --------------------------------------------------------------- */

static int open_all(racers *all, stage *s, const char *const texts[MEASURE_RACERS], fail *f) {
    memset(all, 0, sizeof *all);
    for (unsigned i = 0; i < MEASURE_RACERS; i++) {
        if (racers_add(all, texts[i], &s->m, s->name, f) != 0) {
            return -1;
        }
    }
    return 0;
}

static void take_times(const racers *all, figures to[MEASURE_RACERS]) {
    for (unsigned i = 0; i < MEASURE_RACERS; i++) {
        const racer_time *t = &all->racer[i].sum;
        to[i] = figures_none();
        to[i].of[FIGURE_RAYS] = t->rays;
        to[i].of[FIGURE_SECONDS] = t->seconds;
        to[i].of[FIGURE_CYCLES] = t->cycles;
        to[i].of[FIGURE_HITS] = t->hits;
    }
}

int measure_race(meter *m, stage *s, const char *const texts[MEASURE_RACERS],
                 figures to[MEASURE_RACERS], fail *f) {
    racers all;
    int status = stage_look(s, &m->look, f);
    if (status != 0) {
        return status;
    }
    status = open_all(&all, s, texts, f);
    if (status == 0) {
        status = racers_run(&all, s, m->rounds, &m->counters, f);
    }
    if (status == 0) {
        take_times(&all, to);
    }
    racers_close(&all);
    return status;
}

static int run_step(racers *all, meter *m, stage *s, const measure_motion *motion, unsigned step,
                    fail *f) {
    mesh now = {0};
    int status = 0;
    if (step > 0) {
        status = motion->frame(motion->context, step, &now, f);
        if (status == 0 && now.triangles != s->m.triangles) {
            status = fail_set(f, s->name,
                              "frame %u has %zu triangles, the first %zu; write all from one mesh",
                              step, now.triangles, s->m.triangles);
        }
        status = status == 0 ? racers_move(all, &now, f) : status;
    }
    mesh_free(&now);
    return status == 0 ? racers_run(all, s, m->rounds, &m->counters, f) : status;
}

int measure_moving_race(meter *m, stage *s, const measure_motion *motion,
                        const char *const texts[MEASURE_RACERS], figures to[MEASURE_RACERS],
                        fail *f) {
    racers all;
    int status = stage_look(s, &m->look, f);
    if (status != 0) {
        return status;
    }
    status = open_all(&all, s, texts, f);
    for (unsigned step = 0; step < motion->steps && status == 0; step++) {
        status = run_step(&all, m, s, motion, step, f);
    }
    if (status == 0) {
        take_times(&all, to);
    }
    racers_close(&all);
    return status;
}

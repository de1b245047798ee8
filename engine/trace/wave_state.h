/* wave_state - what lies in the arena for a wave, and how rays get in and out of it
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WAVE_STATE_H
#define PLT_TRACE_WAVE_STATE_H

#include "engine/trace/traversal.h"
#include "engine/trace/wave_ray.h"

/* Rays in flight: PLT_WAVE_LEAST .. PLT_WAVE_MOST, or 0: there is no wave. */
enum { PLT_WAVE_LEAST = 16, PLT_WAVE_MOST = 64 };

/* Bytes of a wave of so many rays, with stacks for scenes whose tree or wide form has at most
 * `depth` nodes on a path. */
uint64_t plt_wave_bytes(unsigned rays_in_flight, int wide, uint32_t depth);

/* Before a loop over a list that has no branch but its own: apart, so that its jumps can be
 * counted (tests/check/check_branches.sh). */
#ifdef __GNUC__
#define PLT_WAVE_LOOP __attribute__((noinline))
#else
#define PLT_WAVE_LOOP
#endif

/* Lays one out in `memory`. */
void plt_wave_init(void *memory, unsigned rays_in_flight, int wide, uint32_t depth);

/* What is next for a ray in flight, and so which list it is on. */
enum plt_wave_step { PLT_WAVE_VISIT, PLT_WAVE_TEST, PLT_WAVE_DONE, PLT_WAVE_STEPS };

enum { PLT_WAVE_AHEAD = 16 }; /* rays are asked for so many before they are taken */

/* What four rays that are set up together have not in common with their lanes. */
typedef struct plt_wave_staged {
    float own[4][4];   /* [lane] org and reach, in own axes */
    float shear[4][4]; /* slopes and slacks */
    float along[4];
    uint8_t negative[3]; /* lanes, per axis */
    uint8_t valid;       /* lanes of rays that can hit anything */
} plt_wave_staged;

/* What a visit of a node found, until it is acted on. */
typedef struct plt_wave_visited {
    float at[4];  /* wide form: where children are entered; thesis: also minus where left */
    uint32_t met; /* children, a bit each */
    uint32_t row; /* by which they are sorted */
    uint32_t pad[2];
} plt_wave_visited;

typedef struct plt_wave {
    plt_wave_visited visited[PLT_WAVE_MOST]; /* as on the list of visits */
    plt_wave_staged staged;
    uint32_t ray_bytes; /* of a ray in flight and its stack */
    uint32_t rays_in_flight;
    unsigned char *first;                         /* ray in flight */
    uint32_t list[PLT_WAVE_STEPS][PLT_WAVE_MOST]; /* bytes from `first` to the ray */
} plt_wave;

/* One call's rays. */
typedef struct plt_wave_job {
    plt_wave *wave;
    plt_traversal *traversal; /* counts them */
    plt_packet *packet;       /* for coherent rays; its first group sets others up */
    uint32_t packet_rays;
    uint32_t window; /* rays looked at together, a multiple of 4; 0: all go by the wave */
    const plt_ray *rays;
    plt_hit *hits;
    uint32_t count, next;
    uint32_t seen; /* rays below are known to be incoherent */
    int any;
    int status; /* of packets */
} plt_wave_job;

static inline plt_wave_ray *plt_wave_at(const plt_wave *w, uint32_t place) {
    return (plt_wave_ray *)(void *)(w->first + place);
}

/* Puts a ray on the list of what is next for it, without a branch: it is written to all, and one
 * grows. `on`: how many are on each; is_done is 0 unless is_leaf is 1. */
static inline void plt_wave_enlist(plt_wave *w, size_t on[PLT_WAVE_STEPS], uint32_t place,
                                   size_t is_leaf, size_t is_done) {
    w->list[PLT_WAVE_VISIT][on[PLT_WAVE_VISIT]] = place;
    on[PLT_WAVE_VISIT] += 1 - is_leaf;
    w->list[PLT_WAVE_TEST][on[PLT_WAVE_TEST]] = place;
    on[PLT_WAVE_TEST] += is_leaf - is_done;
    w->list[PLT_WAVE_DONE][on[PLT_WAVE_DONE]] = place;
    on[PLT_WAVE_DONE] += is_done;
}

/* What a ray over thesis nodes takes beside plt_wave_ray. */
enum { PLT_WAVE_THESIS_BYTES = 96 };

/* Bytes of a ray's stack: see wave_bvh4.c, wave_thesis.c. */
static inline uint32_t plt_wave_stack_bytes(int wide, uint32_t depth) {
    return wide ? 8 * (3 * depth + 2) : PLT_WAVE_THESIS_BYTES + 16 * (depth + 2);
}

/* Takes the next ray that can hit anything; those that cannot miss. 0: there are no more. */
int plt_wave_take(plt_wave_job *job, plt_wave_ray *to);

/* Writes a ray's hit to its place. */
static inline void plt_wave_write(const plt_wave_job *job, const plt_wave_ray *r) {
    const int found = r->id != PLT_MISS, wanted = found && !job->any;
    plt_hit *hit = &job->hits[r->number];
    hit->t = wanted ? r->tmax[0] : 0.0f;
    hit->u = wanted ? r->u : 0.0f;
    hit->v = wanted ? r->v : 0.0f;
    hit->triangle = job->any ? (uint32_t)found : r->id;
}

#endif

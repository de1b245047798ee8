/* wave_state - what lies in the arena for a wave, and how rays get in and out of it
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TRACE_WAVE_STATE_H
#define PLT_TRACE_WAVE_STATE_H

#include "engine/trace/traversal.h"
#include "engine/trace/wave_density.h"
#include "engine/trace/wave_ray.h"

/* Rays in flight: PLT_WAVE_LEAST .. PLT_WAVE_MOST, or 0: there is no wave. */
enum { PLT_WAVE_LEAST = 16, PLT_WAVE_MOST = 64 };

/* What a wave goes over. */
enum plt_wave_tree { PLT_WAVE_BVH4, PLT_WAVE_THESIS, PLT_WAVE_COMPACT };

/* Whether there is one over scenes of a format, without a wide form. */
static inline int plt_wave_supports(enum plt_format format) {
    return format == PLT_FORMAT_THESIS || (format == PLT_FORMAT_COMPACT && PLT_WITH_WAVE_COMPACT);
}

/* And over what it goes. */
static inline enum plt_wave_tree plt_wave_tree_of(enum plt_format format) {
    return format == PLT_FORMAT_COMPACT ? PLT_WAVE_COMPACT : PLT_WAVE_THESIS;
}

/* Bytes of a wave of so many rays, with stacks for trees that have at most `depth` nodes on a
 * path. */
uint64_t plt_wave_bytes(unsigned rays_in_flight, enum plt_wave_tree tree, uint32_t depth);

/* Before a loop over a list that has no branch but its own: apart, so that its jumps can be
 * counted (tests/check/check_branches.sh). */
#ifdef __GNUC__
#define PLT_WAVE_LOOP __attribute__((noinline))
#else
#define PLT_WAVE_LOOP
#endif

/* Lays one out in `memory`. */
void plt_wave_init(void *memory, unsigned rays_in_flight, enum plt_wave_tree tree, uint32_t depth);

/* What is next for a ray in flight, and so which list it is on. */
enum plt_wave_step {
    PLT_WAVE_VISIT,
    PLT_WAVE_TEST,
    PLT_WAVE_DONE,
    PLT_WAVE_STEPS,
    PLT_WAVE_CROSS = PLT_WAVE_STEPS, /* over compact blocks: it is at an edge */
    PLT_WAVE_ENTER,                  /* and at a block */
    PLT_WAVE_COMPACT_STEPS
};

enum { PLT_WAVE_AHEAD = 16 }; /* rays are asked for so many before they are taken */

/* What four rays that are set up together have not in common with their lanes. */
typedef struct plt_wave_staged {
    float org[4][4];    /* [lane] org and reach */
    float shear[4][4];  /* slopes, slack, component of dir along which they are sheared */
    uint8_t offsets[4]; /* [lane] signs of dir, a bit per axis, and 8 * the own last axis */
    uint8_t valid;      /* lanes of rays that can hit anything */
    uint8_t pad[3];
} plt_wave_staged;

/* What was found in one half of a step, until the other acts on it. */
typedef struct plt_wave_found {
    float at[4];  /* wide form: where children are entered; thesis: also minus where left */
    uint32_t met; /* children or triangles, a bit each */
    uint32_t row; /* of children, by which they are sorted */
} plt_wave_found;

/* Rays that are told apart where packets are tried. */
enum plt_wave_kind {
    PLT_WAVE_GIVEN,
    PLT_WAVE_GIVEN_ANY, /* and any hit will do */
    PLT_WAVE_BOUNCES,
    PLT_WAVE_SHADOWS,
    PLT_WAVE_KINDS
};

/* Arrays of rays_in_flight each lie behind it, and the rays behind those. */
typedef struct plt_wave {
    plt_wave_staged staged;
    plt_wave_ray **list[PLT_WAVE_COMPACT_STEPS];
    plt_wave_found *found; /* as on the list that is worked off */
    unsigned char *first;  /* ray in flight */
    uint32_t ray_bytes;    /* of a ray in flight and its stack */
    uint32_t rays_in_flight;
    plt_wave_density density[PLT_WAVE_KINDS];
    /* Of a packet that is watched; of given rays, of a window for packets that would be dense. */
    uint64_t visits_before;
    uint32_t watched_rays;
    enum plt_wave_kind watched;
    /* Between two steps: rays on each list, and rays of the packet that are taken. */
    uint32_t on[PLT_WAVE_COMPACT_STEPS];
    uint32_t taken;
} plt_wave;

/* One call's rays. */
typedef struct plt_wave_job {
    plt_wave *wave;
    plt_traversal *traversal; /* counts them */
    plt_packet *packet;       /* for coherent rays; its first group sets others up */
    plt_wave_window window; /* of rays looked at together, a multiple of 4; 0: all go by the wave */
    const plt_ray *rays;    /* NULL: those of the packet, which gets their hits */
    plt_hit *hits;
    uint32_t count, next;
    uint32_t seen; /* rays below were looked at, and go by the wave if they are not taken */
    int any;
    int is_begun;    /* slots for rays in flight are on a list */
    uint32_t visits; /* of nodes, after which a step ends, all rays being at the same point of it */
} plt_wave_job;

/* Ray `number` as it came. */
static inline plt_ray plt_wave_ray_get(const plt_wave_job *job, uint32_t number) {
    if (job->rays != NULL) {
        return job->rays[number];
    }
    const plt_group_rays *g = &job->packet->rays[number / 4];
    const unsigned lane = number % 4;
    const plt_ray ray = {.org = {g->org[0][lane], g->org[1][lane], g->org[2][lane]},
                         .tmin = 0, /* nobody asks for the interval */
                         .dir = {g->dir[0][lane], g->dir[1][lane], g->dir[2][lane]},
                         .tmax = 0};
    return ray;
}

/* The lists, and how many rays are on each: a copy, so that counts stay in registers. */
typedef struct plt_wave_lists {
    plt_wave_ray **list[PLT_WAVE_STEPS];
    size_t on[PLT_WAVE_STEPS];
} plt_wave_lists;

static inline plt_wave_lists plt_wave_lists_get(const plt_wave *w) {
    const plt_wave_lists lists = {{w->list[0], w->list[1], w->list[2]},
                                  {w->on[0], w->on[1], w->on[2]}};
    return lists;
}

/* For the next step. */
static inline void plt_wave_lists_keep(plt_wave *w, const plt_wave_lists *lists) {
    for (int i = 0; i < PLT_WAVE_STEPS; i++) {
        w->on[i] = (uint32_t)lists->on[i];
    }
}

/* Whether a step has made the visits that it may; `before`: when it began. */
static inline int plt_wave_is_over(const plt_wave_job *job, uint64_t before) {
    return job->traversal->stats.node_visits - before >= job->visits;
}

/* Puts a ray on the list of what is next for it, without a branch: it is written to both, and
 * one grows. Rays that are done have a leaf for next until they are parted. */
static inline void plt_wave_enlist(plt_wave_lists *l, plt_wave_ray *r, size_t is_leaf) {
    l->list[PLT_WAVE_VISIT][l->on[PLT_WAVE_VISIT]] = r;
    l->list[PLT_WAVE_TEST][l->on[PLT_WAVE_TEST]] = r;
    l->on[PLT_WAVE_VISIT] = l->on[PLT_WAVE_VISIT] - is_leaf + 1;
    l->on[PLT_WAVE_TEST] += is_leaf;
}

/* Parts rays that are done, whose `next` is `end`, from those that have triangles to test. */
static inline void plt_wave_part(plt_wave_lists *l, uintptr_t end) {
    plt_wave_ray **const test = l->list[PLT_WAVE_TEST], **const done = l->list[PLT_WAVE_DONE];
    const size_t count = l->on[PLT_WAVE_TEST];
    size_t tests = 0, ends = 0;
    for (size_t i = 0; i < count; i++) {
        plt_wave_ray *r = test[i];
        const size_t is_done = r->next == end;
        test[tests] = r;
        done[ends] = r;
        tests += is_done ^ 1;
        ends += is_done;
    }
    l->on[PLT_WAVE_TEST] = tests;
    l->on[PLT_WAVE_DONE] = ends;
}

static inline plt_wave_ray *plt_wave_slot(const plt_wave *w, uint32_t index) {
    return (plt_wave_ray *)(void *)(w->first + (size_t)index * w->ray_bytes);
}

/* What a ray takes beside plt_wave_ray, and what an entry of its stack does: see wave_bvh4.c,
 * wave_thesis.c, wave_compact.c. */
enum {
    PLT_WAVE_BVH4_ENTRY_BYTES = 8,
    PLT_WAVE_BINARY_BYTES = 80,
    PLT_WAVE_THESIS_ENTRY_BYTES = 16,
    PLT_WAVE_COMPACT_BYTES = PLT_WAVE_BINARY_BYTES + 64,
    PLT_WAVE_COMPACT_ENTRY_BYTES = 40
};

/* Bytes of a ray behind its plt_wave_ray, its stack among them. */
static inline uint32_t plt_wave_stack_bytes(enum plt_wave_tree tree, uint32_t depth) {
    switch (tree) {
    case PLT_WAVE_BVH4:
        return PLT_WAVE_BVH4_ENTRY_BYTES * (3 * depth + 2);
    case PLT_WAVE_THESIS:
        return PLT_WAVE_BINARY_BYTES + PLT_WAVE_THESIS_ENTRY_BYTES * (depth + 2);
    case PLT_WAVE_COMPACT:
        break;
    }
    return PLT_WAVE_COMPACT_BYTES + PLT_WAVE_COMPACT_ENTRY_BYTES * (depth + 2);
}

/* Where all rays that were looked at are taken, traces windows of coherent ones in packets, up to
 * one that is not, whose rays can be taken then. PLT_OK, or what a fetch failed with. It is not
 * called by the wave, so that packets are not traced on top of its stack. */
int plt_wave_look(plt_wave_job *job);

/* 1: rays wait to be looked at. */
static inline int plt_wave_waits(const plt_wave_job *job) {
    return job->next == job->seen && job->next < job->count;
}

/* Before the first step: all rays in flight are done. */
static inline void plt_wave_fill(const plt_wave *w, plt_wave_job *job, plt_wave_lists *l) {
    if (job->is_begun) {
        return;
    }
    job->is_begun = 1;
    l->on[PLT_WAVE_DONE] = w->rays_in_flight;
    for (uint32_t i = 0; i < w->rays_in_flight; i++) {
        l->list[PLT_WAVE_DONE][i] = plt_wave_slot(w, w->rays_in_flight - 1 - i);
    }
}

/* Takes the next ray that was looked at and can hit anything; those that cannot miss. 0: there are
 * no more. */
int plt_wave_take(plt_wave_job *job, plt_wave_ray *to);

#endif

/* test_task - a dispatcher and workers that share its packets, in every order of calls
 *
 * Workers take turns at random, in the middle of tasks, too: what threads would do, but the same
 * every time. Frames and hits are those of the resident scene.
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/compact_rig.h"
#include "tests/reference/rig.h"
#include "tests/reference/shapes.h"
#include "tests/reference/stream_rig.h"

enum { WORKERS = 5 };

typedef struct team {
    unsigned count;
    run worker[WORKERS]; /* the first is the dispatcher */
    random_state random;
    unsigned failed; /* the worker whose task did */
} team;

static void fill_compact(subject *s, uint32_t triangles) {
    mesh m = {0};
    random_state r = {triangles};
    shape_soup(&m, compact_triangles(triangles, 2), 0.1f, 5);
    rays_mixed(s->rays, RAYS, &m, &r);
    const compact_config c = compact_config_of(2, 14, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    s->image = compact_packed(&m, &c);
    set_due(s);
}

static void fill_thesis(subject *s, uint32_t triangles) {
    mesh m = {0};
    fail f = {""};
    random_state r = {triangles};
    const pack_options o = {.splits = PLT_SPLIT_SAH,
                            .build = PLT_BUILD_HOST,
                            .leaf_triangles = 2,
                            .treelet_nodes = rig_is_tiny() ? 1 : 16,
                            .checks = 1};
    shape_soup(&m, rig_triangles(triangles, 2), 0.1f, 6);
    rays_mixed(s->rays, RAYS, &m, &r);
    CHECK(pack_mesh(&s->image, &m, &o, "test", &f) == 0, "%s", f.text);
    mesh_free(&m);
    set_due(s);
}

static plt_options options_for(unsigned index, uint8_t side, uint16_t packets) {
    plt_options o = options_of(PLT_RESIDENCY_STREAMED, side, 0);
    o.schedule = index == 0 ? PLT_SCHEDULE_TASK : PLT_SCHEDULE_WORKER;
    o.batch = index == 0 ? packets : 0;
    return o;
}

/* With room for as many tasks as `few` says, or 0. */
static void open_team(team *t, const subject *s, unsigned count, uint8_t side, uint16_t packets,
                      uint32_t few) {
    t->count = count;
    t->random.at = count * 1000 + side * 10 + packets;
    for (unsigned i = 0; i < count; i++) {
        run *x = &t->worker[i];
        const plt_options o = options_for(i, side, packets);
        CHECK(open_run(x, &s->image, &o) == PLT_OK, "worker %u: %s", i, x->fault.message);
        if (few > 0) {
            plt_tasks *own = &x->engine->worker.edges, *all = &x->engine->dispatch.edges;
            plt_tasks_init(own, own->queue, few, few);
            if (i == 0) {
                plt_tasks_init(all, all->queue, 2 * few, few);
            }
        }
    }
}

static void close_team(team *t) {
    for (unsigned i = 0; i < t->count; i++) {
        close_run(&t->worker[i]);
    }
}

static void keep_tile(const plt_engine *d, uint8_t frame[3 * WIDTH * HEIGHT]) {
    plt_tile tile;
    plt_render_tile(d, &tile);
    for (unsigned y = 0; y < tile.height; y++) {
        memcpy(frame + 3 * ((tile.y + y) * WIDTH + tile.x), tile.rgb + 3 * y * tile.width,
               3u * tile.width);
    }
}

static uint64_t tasks_of(const team *t) {
    plt_task_stats q;
    plt_task_stats_get(t->worker[0].engine, &q);
    return q.tasks;
}

/* No edge of the list that begins there is nearer than what the worker has. */
static void expect_nearest(const plt_worker *own, const plt_tasks *tasks, uint16_t first) {
    const float distance = own->edges.queue[own->edges.here].nearest;
    for (uint16_t i = first; i != PLT_TASK_NONE; i = tasks->queue[i].after) {
        CHECK(tasks->queue[i].nearest >= distance, "an edge at %g, and then one at %g",
              (double)distance, (double)tasks->queue[i].nearest);
    }
}

/* A worker goes on with an edge of its own: no other that its packet has is nearer. */
static void expect_own_nearest(const plt_worker *own) {
    if (own->edges.here != PLT_TASK_NONE) {
        const float distance = own->edges.queue[own->edges.here].nearest;
        CHECK(distance <= own->others, "an edge at %g, and one at %g waits", (double)distance,
              (double)own->others);
    }
}

/* For all that a worker may give back. */
static int has_room(const plt_tasks *edges) {
    return edges->most - edges->count >= PLT_WORKER_TASKS &&
           edges->queues_most - edges->queues >= PLT_WORKER_QUEUES;
}

/* A worker was given a task, or goes on with one of the edges that it has found: the nearest of
 * all, or one that there was no room for. */
static void expect_task(const plt_dispatch *d, const plt_worker *own, int is_given) {
    const uint16_t others = d->slot[own->slot].edges;
    CHECK(own->has_others == (others != PLT_TASK_NONE) &&
              own->others == (own->has_others ? d->edges.queue[others].nearest : 0x1p127f),
          "edges that wait, or none");
    CHECK(own->packet == &d->packet[d->slot[own->slot].room], "a packet in another's room");
    if (!own->is_new) {
        CHECK(own->packet->active != 0, "a packet that is done goes out");
        expect_nearest(own, &own->edges, own->edges.first);
        if (is_given || has_room(&d->edges)) {
            expect_nearest(own, &d->edges, others);
        }
    }
}

/* One worker does something: goes on for a while, or comes for the next task. PLT_MORE: it is not
 * over for it. */
static int take_turn(team *t, unsigned i, int running[WORKERS], uint8_t *frame) {
    plt_engine *d = t->worker[0].engine, *w = t->worker[i].engine;
    if (running[i]) {
        running[i] = plt_task_run(d, w, 1 + random_below(&t->random, 60)) == PLT_MORE;
        CHECK(running[i] || plt_task_run(d, w, 60) == PLT_OK, "a task that is done stays so");
        if (running[i] && has_room(&d->dispatch.edges)) {
            expect_own_nearest(&w->worker);
        }
        return PLT_MORE;
    }
    const uint64_t before = tasks_of(t);
    const int status = plt_task_next(d, w);
    if (status == PLT_TILE) {
        CHECK(frame != NULL, "a tile of rays");
        keep_tile(d, frame);
    }
    running[i] = status == PLT_MORE;
    if (status == PLT_MORE) {
        expect_task(&d->dispatch, &w->worker, tasks_of(t) > before);
    }
    return status == PLT_OK || status < 0 ? status : PLT_MORE;
}

/* All take turns until it is over for all. PLT_OK, or what failed. */
static int work(team *t, uint8_t *frame) {
    int running[WORKERS] = {0}, ended[WORKERS] = {0}, status = PLT_OK;
    unsigned left = t->count;
    for (uint32_t turns = 0; left > 0; turns++) {
        const unsigned i = random_below(&t->random, t->count);
        const uint64_t before = tasks_of(t);
        const int now = ended[i] ? PLT_MORE : take_turn(t, i, running, frame);
        CHECK(status == PLT_OK || tasks_of(t) == before, "a task after a failure");
        if (!ended[i] && now != PLT_MORE) {
            ended[i] = 1;
            left--;
        }
        if (now < 0) {
            CHECK(status == PLT_OK, "two workers failed");
            status = now;
            t->failed = i;
        }
        if (turns > 10000000) {
            CHECK(0, "it does not end");
            break;
        }
    }
    return status;
}

static int team_trace(team *t, const subject *s, plt_hit hits[RAYS], int any) {
    memset(hits, 0x77, RAYS * sizeof *hits);
    const int status = plt_trace_begin(t->worker[0].engine, s->rays, hits, RAYS, any);
    return status == PLT_OK ? work(t, NULL) : status;
}

static int team_render(team *t, uint8_t frame[3 * WIDTH * HEIGHT]) {
    const plt_frame f = frame_of(plt_engine_info(t->worker[0].engine));
    memset(frame, 0x77, 3 * WIDTH * HEIGHT);
    const int status = plt_render_begin(t->worker[0].engine, &f);
    return status == PLT_OK ? work(t, frame) : status;
}

/* Nothing is left, neither of a run that went well nor of one that failed. */
static void expect_whole(const team *t) {
    const plt_dispatch *d = &t->worker[0].engine->dispatch;
    CHECK(d->count == 0 && d->out == 0 && d->edges.count == 0 && d->edges.queues == 0,
          "%u packets, %u out, %u entries at %u edges are left", d->count, d->out, d->edges.count,
          d->edges.queues);
    for (unsigned i = 0; i < t->count; i++) {
        const plt_tasks *own = &t->worker[i].engine->worker.edges;
        CHECK(own->count == 0 && own->queues == 0, "worker %u has %u entries at %u edges", i,
              own->count, own->queues);
    }
}

static void expect_due(team *t, const subject *s) {
    plt_hit hits[RAYS];
    uint8_t frame[3 * WIDTH * HEIGHT];
    for (int any = 0; any < 2; any++) {
        CHECK(team_trace(t, s, hits, any) == PLT_OK, "any %d", any);
        CHECK(memcmp(hits, s->due[any], sizeof hits) == 0, "%u workers, any %d: hits", t->count,
              any);
        expect_whole(t);
    }
    CHECK(team_render(t, frame) == PLT_OK, "the frame");
    CHECK(memcmp(frame, s->frame, sizeof frame) == 0, "%u workers: frame", t->count);
    expect_whole(t);
}

/* What came in is what was sent; all rays are counted once. */
static void expect_counts(const team *t, uint8_t side) {
    plt_task_stats q;
    uint64_t rays = 0, packets = 0;
    plt_task_stats_get(t->worker[0].engine, &q);
    for (unsigned i = 0; i < t->count; i++) {
        plt_stats own;
        plt_stats_get(t->worker[i].engine, &own);
        rays += own.rays;
        packets += own.packets;
    }
    CHECK(rays == 2 * RAYS + WIDTH * HEIGHT, "%u rays", (unsigned)rays);
    CHECK(packets == q.packets, "%u packets of %u", (unsigned)q.packets, (unsigned)packets);
    CHECK(q.tasks >= packets && q.tasks <= packets + q.edges, "%u tasks, %u packets, %u edges",
          (unsigned)q.tasks, (unsigned)packets, (unsigned)q.edges);
    const plt_tasks *edges = &t->worker[0].engine->dispatch.edges;
    const uint64_t least = /* a place, and at least one entry */
        offsetof(plt_task_queue, place) + edges->place_bytes + sizeof(plt_task);
    const uint64_t results = (2 * RAYS) * sizeof(plt_hit) + 3u * WIDTH * HEIGHT;
    CHECK(q.bytes_back >= results + q.edges * least, "results, and edges that come back");
    CHECK(q.bytes_out >= (q.tasks - packets) * least, "edges that go out");
    CHECK(q.packets_moved == 0 || q.bytes_out > q.packets_moved * plt_packet_bytes(side),
          "packets that move have bytes");
    CHECK(t->count > 1 || q.packets_moved == 0, "packets move from one worker to itself");
}

static void every_team(const subject *s) {
    static const uint16_t packets[] = {1, 2, 7, 64};
    for (unsigned count = 1; count <= WORKERS; count++) {
        for (uint8_t side = 2; side <= PLT_PACKET_SIDE_MAX; side *= 2) {
            for (unsigned i = 0; i < 4; i++) {
                team t = {0};
                open_team(&t, s, count, side, packets[i], 0);
                expect_due(&t, s);
                expect_counts(&t, side);
                close_team(&t);
            }
        }
    }
}

/* Pools that are full all the time: workers go on alone. */
static void few_tasks(const subject *s) {
    for (uint32_t few = 1; few < 5; few++) {
        team t = {0};
        open_team(&t, s, 3, 4 < PLT_PACKET_SIDE_MAX ? 4 : PLT_PACKET_SIDE_MAX, 7, few);
        expect_due(&t, s);
        close_team(&t);
    }
}

/* The source of one worker fails for good: it says so, the others end; mended, all goes on. */
static void one_fails(const subject *s) {
    unsigned failures = 0;
    for (uint32_t call = 2; call < 120; call += 5) {
        for (unsigned who = 0; who < 3; who++) {
            team t = {0};
            plt_hit hits[RAYS];
            plt_fault fault;
            uint8_t frame[3 * WIDTH * HEIGHT];
            open_team(&t, s, 3, 2, 16, 0);
            t.worker[who].link.failure = FAKE_FAILS_FROM_CALL;
            t.worker[who].link.at_call = t.worker[who].link.starts + call;
            const int status = call % 2 ? team_trace(&t, s, hits, 0) : team_render(&t, frame);
            CHECK(status == PLT_ERR_SOURCE && t.failed == who, "status %d of %u", status, t.failed);
            plt_fault_get(t.worker[who].engine, &fault);
            CHECK(fault.offset >= PLT_HEADER_BYTES && fault.offset < s->image.size, "byte %u: %s",
                  (unsigned)fault.offset, fault.message);
            failures += status < 0;
            expect_whole(&t);
            t.worker[who].link.failure = FAKE_WORKS;
            expect_due(&t, s);
            close_team(&t);
        }
    }
    CHECK(failures == 72, "%u failures", failures);
}

/* A frame in the middle of which another one begins, or rays are traced, or a tile is looked for.
 */
static void dropped(const subject *s) {
    team t = {0};
    uint8_t frame[3 * WIDTH * HEIGHT];
    plt_hit hits[RAYS];
    open_team(&t, s, 1, 2, 16, 0);
    plt_engine *d = t.worker[0].engine;
    const plt_frame f = frame_of(plt_engine_info(d));
    for (int steps = 1; steps < 400; steps += 23) {
        CHECK(plt_render_begin(d, &f) == PLT_OK, "begin");
        for (int i = 0; i < steps; i++) {
            plt_render_step(d, 30);
        }
        switch (steps % 3) {
        case 0:
            CHECK(plt_trace(d, s->rays, hits, RAYS, 0) == PLT_OK &&
                      memcmp(hits, s->due[0], sizeof hits) == 0,
                  "rays after %d steps", steps);
            CHECK(plt_render_step(d, 30) == PLT_OK, "the frame has ended");
            break;
        case 1:
            CHECK(plt_render_seek(d, 0, 1) == PLT_OK, "seek");
            while (plt_render_step(d, 30) == PLT_MORE) {
            }
            keep_tile(d, frame);
            CHECK(memcmp(frame, s->frame, 3 * PLT_TILE_SIDE) == 0, "the first tile");
            break;
        default:
            break;
        }
        CHECK(render(d, frame) == PLT_OK && memcmp(frame, s->frame, sizeof frame) == 0,
              "the frame after %d steps", steps);
    }
    close_team(&t);
}

/* The dispatcher works alone until it has given back a packet that waits. 0: none did. */
static int work_until_one_waits(plt_engine *d) {
    int status;
    do {
        while (plt_task_run(d, d, 100) == PLT_MORE) {
        }
        status = plt_dispatch_give(&d->dispatch, &d->worker);
        if (status == PLT_OK && d->dispatch.newest == PLT_TASK_NONE) {
            status = plt_task_next(d, d);
        }
    } while (status == PLT_MORE);
    return d->dispatch.newest != PLT_TASK_NONE;
}

static int is_compact(const subject *s) {
    return s->image.info.nodes_format == PLT_NODES_COMPACT;
}

/* A packet goes out once if its worker has room for its edges, else with many of them at once. */
static void keeps_edges(const subject *s) {
    team t = {0};
    plt_hit hits[RAYS];
    plt_task_stats q;
    open_team(&t, s, 1, 4 < PLT_PACKET_SIDE_MAX ? 4 : PLT_PACKET_SIDE_MAX, 16, 0);
    plt_engine *d = t.worker[0].engine;
    CHECK(plt_trace(d, s->rays, hits, RAYS, 0) == PLT_OK, "it is traced");
    plt_task_stats_get(d, &q);
    if (is_compact(s)) {
        CHECK(q.tasks == q.packets && q.edges == 0, "%u tasks of %u packets, %u edges",
              (unsigned)q.tasks, (unsigned)q.packets, (unsigned)q.edges);
    } else if (!rig_is_tiny()) {
        CHECK(q.tasks > q.packets && 4 * (q.tasks - q.packets) < q.edges,
              "%u tasks of %u packets, %u edges", (unsigned)q.tasks, (unsigned)q.packets,
              (unsigned)q.edges);
    }
    close_team(&t);
}

typedef struct hopping {
    run dispatcher[2], worker[2];
    plt_hit hits[2][RAYS];
    int at[2], ended[2];
    random_state random;
} hopping;

/* A worker, or a dispatcher as its own, does something. Without a task a worker may go. */
static void hop(hopping *h, unsigned i) {
    plt_engine *w = i < 2 ? h->dispatcher[i].engine : h->worker[i - 2].engine;
    if (i >= 2 && !w->worker.has) {
        h->at[i - 2] = (int)random_below(&h->random, 2);
    }
    const unsigned at = i < 2 ? i : (unsigned)h->at[i - 2];
    plt_engine *d = h->dispatcher[at].engine;
    if (w->worker.has && plt_task_run(d, w, 1 + random_below(&h->random, 40)) == PLT_MORE) {
        return;
    }
    h->ended[at] |= plt_task_next(d, w) == PLT_OK && d->dispatch.out == 0;
}

/* Workers go from one dispatcher to another, which may number their packets alike. */
static void two_dispatchers(const subject *s, unsigned rounds) {
    static hopping h;
    unsigned wrong = 0;
    for (unsigned round = 0; round < rounds; round++) {
        const plt_options d = options_for(0, 2, (uint16_t)(1 + round % 5));
        const plt_options w = options_for(1, 2, 0);
        memset(&h, 0, sizeof h);
        h.random.at = round;
        for (int i = 0; i < 2; i++) {
            memset(h.hits[i], 0x77, sizeof h.hits[i]);
            CHECK(open_run(&h.dispatcher[i], &s->image, &d) == PLT_OK &&
                      open_run(&h.worker[i], &s->image, &w) == PLT_OK &&
                      plt_trace_begin(h.dispatcher[i].engine, s->rays, h.hits[i], RAYS, 0) ==
                          PLT_OK,
                  "%u: opened", round);
        }
        while (!(h.ended[0] && h.ended[1])) {
            hop(&h, random_below(&h.random, 4));
        }
        for (int i = 0; i < 2; i++) {
            wrong += memcmp(h.hits[i], s->due[0], sizeof h.hits[i]) != 0;
            close_run(&h.dispatcher[i]);
            close_run(&h.worker[i]);
        }
    }
    CHECK(wrong == 0, "%u of %u arrays of hits differ", wrong, 2 * rounds);
}

/* A worker whose task was dropped, before it had begun or in the middle, takes on a packet that
 * another has begun: nothing of its own is in the way. */
static void left_over(const subject *s) {
    for (uint32_t visits = 0; visits < 40; visits++) {
        team t = {0};
        plt_hit hits[RAYS];
        open_team(&t, s, 2, 4 < PLT_PACKET_SIDE_MAX ? 4 : PLT_PACKET_SIDE_MAX, 16, 0);
        plt_engine *d = t.worker[0].engine, *w = t.worker[1].engine;
        CHECK(plt_trace_begin(d, s->rays, hits, RAYS, 0) == PLT_OK &&
                  plt_task_next(d, w) == PLT_MORE,
              "a task that will be dropped");
        for (uint32_t i = 0; i < visits && plt_task_run(d, w, 1) == PLT_MORE; i++) {
        }
        memset(hits, 0x77, sizeof hits);
        CHECK(plt_trace_begin(d, s->rays, hits, RAYS, 0) == PLT_OK &&
                  plt_task_next(d, d) == PLT_MORE,
              "all anew");
        const int waits = work_until_one_waits(d);
        CHECK(waits || rig_is_tiny() || is_compact(s), "no packet waits at an edge");
        CHECK(!waits || plt_task_next(d, w) == PLT_MORE, "the other worker has it");
        CHECK(!waits || (!w->worker.is_new && w->traversal.waiting == 0),
              "after %u visits something is left", (unsigned)visits);
        CHECK(work(&t, NULL) == PLT_OK && memcmp(hits, s->due[0], sizeof hits) == 0,
              "hits after %u visits", (unsigned)visits);
        expect_whole(&t);
        close_team(&t);
    }
}

static void misuse(const subject *s, const subject *other) {
    team t = {0};
    run x = {0};
    plt_hit hit;
    const plt_frame f = frame_of(&s->image.info);
    open_team(&t, s, 2, 4 < PLT_PACKET_SIDE_MAX ? 4 : PLT_PACKET_SIDE_MAX, 16, 0);
    plt_engine *d = t.worker[0].engine, *w = t.worker[1].engine;
    CHECK(plt_task_next(w, d) == PLT_ERR_ARGUMENT, "a worker that hands out tasks");
    CHECK(plt_task_next(w, w) == PLT_ERR_ARGUMENT, "... to itself");
    CHECK(plt_trace_begin(w, s->rays, &hit, 1, 0) == PLT_ERR_ARGUMENT, "rays of a worker");
    CHECK(plt_trace(w, s->rays, &hit, 1, 0) == PLT_ERR_ARGUMENT, "... at once");
    CHECK(plt_render_begin(w, &f) == PLT_ERR_ARGUMENT, "a frame of a worker");
    CHECK(plt_render_step(w, 1) == PLT_OK && plt_task_run(d, w, 1) == PLT_OK, "nothing to do");
    CHECK(plt_task_next(d, w) == PLT_OK, "no frame, no rays");
    CHECK(plt_trace_begin(d, s->rays, &hit, 0, 0) == PLT_OK && plt_task_next(d, w) == PLT_OK,
          "no rays at all");
    CHECK(plt_trace_begin(d, s->rays, &hit, 1, 0) == PLT_OK, "one ray");
    CHECK(plt_task_next(d, w) == PLT_MORE && plt_task_next(d, w) == PLT_MORE,
          "a task that was not run is still there");
    const plt_options o = options_for(1, 2, 0);
    if (PLT_PACKET_SIDE_MAX > 2) {
        CHECK(open_run(&x, &s->image, &o) == PLT_OK, "%s", x.fault.message);
        CHECK(plt_task_next(d, x.engine) == PLT_ERR_ARGUMENT, "packets of another size");
        close_run(&x);
    }
    memset(&x, 0, sizeof x);
    const plt_options same = options_for(1, (uint8_t)plt_packet_side(d), 0);
    CHECK(open_run(&x, &other->image, &same) == PLT_OK, "%s", x.fault.message);
    CHECK(plt_task_next(d, x.engine) == PLT_ERR_ARGUMENT, "another image");
    close_run(&x);
    memset(&x, 0, sizeof x);
    CHECK(open_run(&x, &s->image, &same) == PLT_OK && plt_task_next(d, x.engine) == PLT_WAIT,
          "a third of the same kind");
    x.engine->scene.info.primitive_id_bits ^= 1;
    CHECK(plt_task_next(d, x.engine) == PLT_ERR_ARGUMENT, "an image that is like it");
    close_run(&x);
    close_team(&t);
}

/* ---- what moves between pools ------------------------------------------------------ */

enum { PLACE = 16, ENTRY = PLACE + PLT_TASK_REST_BYTES };

typedef struct pool {
    plt_tasks tasks;
    unsigned char memory[4096];
} pool;

/* `count` tasks wait at that treelet, each with its number. */
static void wait_there(plt_tasks *t, uint32_t treelet, unsigned count) {
    unsigned char entry[ENTRY];
    for (unsigned i = 0; i < count; i++) {
        memset(entry, (int)treelet, PLACE);
        memset(entry + PLACE, (int)(10 * treelet + i), PLT_TASK_REST_BYTES);
        t->packet = (uint16_t)i;
        CHECK(plt_tasks_wait(t, treelet, 7, (float)i, entry, ENTRY, PLACE), "it waits");
    }
}

/* A bit for each of the tasks that wait at the queue, which are those of `treelet`. */
static unsigned tasks_there(const plt_tasks *t, uint16_t queue, uint32_t treelet) {
    const plt_task_queue *q = &t->queue[queue];
    unsigned found = 0;
    CHECK(q->treelet == treelet && q->scope == 7 && q->nearest == 0.0f && q->place[0] == treelet &&
              q->place[PLACE - 1] == treelet,
          "what the queue of %u says", treelet);
    for (uint16_t i = q->task; i != PLT_TASK_NONE; i = t->task[i].next) {
        const plt_task *task = &t->task[i];
        CHECK(task->rest[0] == 10 * treelet + task->packet, "a task of %u", treelet);
        found |= 1u << task->packet;
    }
    return found;
}

static void moves(void) {
    static _Alignas(16) pool a, b;
    plt_tasks_init(&a.tasks, a.memory, 12, 8);
    plt_tasks_init(&b.tasks, b.memory, 5, 3);
    wait_there(&a.tasks, 1, 3);
    wait_there(&a.tasks, 2, 2);
    wait_there(&a.tasks, 3, 1);
    wait_there(&a.tasks, 4, 1);
    CHECK(plt_tasks_of(&a.tasks, a.tasks.first) == 1, "treelet 4 was met last");
    uint16_t *second = &a.tasks.queue[a.tasks.queue[a.tasks.first].after].after;
    CHECK(plt_tasks_move(&b.tasks, &b.tasks.first, &a.tasks, second), "treelet 2 moves");
    CHECK(plt_tasks_move(&b.tasks, &b.tasks.first, &a.tasks, second), "treelet 1 moves");
    CHECK(!plt_tasks_move(&b.tasks, &b.tasks.first, &a.tasks, &a.tasks.first), "b has no room");
    CHECK(a.tasks.count == 2 && a.tasks.queues == 2 && b.tasks.count == 5 && b.tasks.queues == 2,
          "%u and %u tasks", a.tasks.count, b.tasks.count);
    CHECK(tasks_there(&b.tasks, b.tasks.first, 1) == 7, "all of treelet 1");
    CHECK(tasks_there(&b.tasks, b.tasks.queue[b.tasks.first].after, 2) == 3, "all of treelet 2");
    CHECK(tasks_there(&a.tasks, a.tasks.first, 4) == 1, "treelet 4 is where it was");
    plt_tasks_drop(&b.tasks, &b.tasks.first);
    CHECK(b.tasks.count == 2 && tasks_there(&b.tasks, b.tasks.first, 2) == 3, "treelet 1 is gone");
    CHECK(plt_tasks_move(&b.tasks, &b.tasks.first, &a.tasks, &a.tasks.first), "there is room");
    CHECK(plt_tasks_move(&b.tasks, &b.tasks.first, &a.tasks, &a.tasks.first), "and again");
    CHECK(!plt_tasks_move(&a.tasks, &a.tasks.first, &b.tasks, &b.tasks.first) == 0, "and back");
    wait_there(&a.tasks, 5, 11);
    CHECK(a.tasks.count == 12 && a.tasks.unused == PLT_TASK_NONE, "none was lost");
}

static void everything(subject *s, const char *sentence) {
    test(sentence);
    every_team(s);
    test("... and when there is room for few tasks");
    few_tasks(s);
    test("... and with parts that come ahead");
    parts_ahead = 4;
    few_tasks(s);
    every_team(s);
    parts_ahead = 0;
    test("when the source of one worker fails, it says where, the others end, and all go on later");
    one_fails(s);
    test("what is under way is dropped for something else");
    dropped(s);
    left_over(s);
    test("workers go from one dispatcher to another, and back");
    two_dispatchers(s, 200);
    test("edges go back when a worker has too many of them, and come many at once");
    keeps_edges(s);
}

int main(void) {
    static subject compact, thesis;
    fill_compact(&compact, 3000);
    fill_thesis(&thesis, 3000);
    everything(&compact, "workers share compact blocks: hits and frames of the resident scene");
    everything(&thesis, "workers share thesis nodes: hits and frames of the resident scene");
    test("queues move between pools with all their tasks");
    moves();
    test("misuse is refused");
    misuse(&compact, &thesis);
    misuse(&thesis, &compact);
    pack_free(&compact.image);
    pack_free(&thesis.image);
    return test_done();
}

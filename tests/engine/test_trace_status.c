/* test_trace_status - whichever call of a format fails, its status arrives, and all goes on
 *
 * Packets, arrays of rays and frames over a format of the test's own, in both orders. A
 * run in which nothing fails is compared with the thesis's format, and its calls are
 * counted; then each of them fails once.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>
#include <string.h>

#include "tests/reference/failing_engine.h"
#include "tests/reference/frames.h"
#include "tests/reference/rays.h"
#include "tests/reference/rig.h"
#include "tests/reference/room.h"
#include "tests/reference/shapes.h"
#include "tests/test.h"

enum { GUARD = 64, PATTERN = 0x5A, PACKETS = 6, WIDTH = 19, HEIGHT = 13 };
enum { RAYS_MOST = PACKETS * PLT_PACKET_SIDE_MAX * PLT_PACKET_SIDE_MAX };

/* ---- an engine over the failing format ------------------------------------------------ */

typedef struct stack {
    unsigned char *memory;
    size_t bytes; /* then GUARD bytes of PATTERN */
} stack;

typedef struct subject {
    rig r; /* the engine whose scene this is */
    failing_scene scene;
    failing_node *nodes;
    failing_plan plan;
    plt_engine engine;
    stack stack, local, leaves;
    void *packet;
    uint8_t tile[PLT_TILE_BUFFER_BYTES];
    plt_ray rays[RAYS_MOST];
    plt_hit due[2][RAYS_MOST]; /* of the real engine: nearest, any */
    uint32_t count, most;      /* rays; rays of a packet */
} subject;

static stack stack_of(uint32_t entries, unsigned order) {
    const size_t bytes = entries * plt_failing_entry_bytes(order);
    const stack s = {room_get(bytes + GUARD), bytes};
    memset(s.memory, PATTERN, bytes + GUARD);
    return s;
}

static int is_guarded(const stack *s) {
    for (size_t i = 0; i < GUARD; i++) {
        if (s->memory[s->bytes + i] != PATTERN) {
            return 0;
        }
    }
    return 1;
}

static int are_guarded(const subject *s) {
    return is_guarded(&s->stack) && is_guarded(&s->local) &&
           (s->leaves.memory == NULL || is_guarded(&s->leaves));
}

/* The node behind a link and those below it, from planes to whole boxes. */
static void spread(failing_node *nodes, const plt_tree *tree, uint32_t link, const plt_box *box) {
    if (plt_link_is_leaf(link)) {
        return;
    }
    const plt_node *node = &tree->nodes[plt_link_index(link)];
    failing_node *to = &nodes[plt_link_index(link)];
    plt_node_decode(node, box, to->box);
    for (int i = 0; i < 2; i++) {
        to->link[i] = plt_node_link(node, i);
        spread(nodes, tree, to->link[i], &to->box[i]);
    }
}

static void set_engine(subject *s, const plt_options *options) {
    const plt_info *info = plt_engine_info(s->r.engine);
    const int two = options->order == PLT_ORDER_TWO_STAGE;
    const uint32_t entries = two ? info->global_stack_entries : info->depth_stack_entries;
    s->stack = stack_of(entries > 0 ? entries : 1, options->order);
#if PLT_WITH_HULLS
    if (!two) { /* more of larger entries */
        const uint32_t more = plt_hull_levels(options->packet_side) + 1;
        free(s->stack.memory);
        s->stack = stack_of((entries > 0 ? entries : 1) + more, PLT_ORDER_HULLS);
        s->leaves = stack_of(PLT_LEAVES_WAITING + 2, PLT_ORDER_HULLS);
    }
#endif
    s->local = stack_of(two ? info->local_stack_entries : 0, options->order);
    s->packet = room_get(plt_packet_bytes(options->packet_side));
    static _Alignas(PLT_ALIGN) unsigned char state[64]; /* of thesis nodes, or of ours */
    CHECK(plt_state_bytes(PLT_FORMAT_THESIS) <= sizeof state, "a larger state");
    void *const part[PLT_PARTS_COUNT] = {[PLT_PART_FORMAT] = state,
                                         [PLT_PART_STACK] = s->stack.memory,
                                         [PLT_PART_LEAVES] = s->leaves.memory,
                                         [PLT_PART_LOCAL_STACK] = s->local.memory};
    s->engine.options = *options;
    plt_packet_init(&s->engine.packet, s->packet, options->packet_side);
    plt_traversal_init(&s->engine.traversal, &s->scene.scene, options, part);
    failing_rendering_init(&s->engine.rendering, s->tile, NULL, options->packet_side);
}

static subject *open_subject(mesh *m, uint8_t order) {
    subject *s = calloc(1, sizeof *s);
    rig_config config = rig_config_of(2, 3, PLT_BUILD_HOST, PLT_SPLIT_SAH);
    random_state random = {77};
    config.run.order = order;
    config.run.count_touched = 0;
    const int status = rig_open(&s->r, m, &config);
    CHECK(status == PLT_OK, "%s: %s", rig_name(&config), s->r.fault.message);
    if (status != PLT_OK) {
        exit(test_done());
    }
    const plt_tree *tree = &s->r.engine->scene.thesis;
    s->nodes = calloc(tree->node_slots + 1, sizeof *s->nodes);
    spread(s->nodes, tree, tree->root, &s->r.engine->scene.box);
    s->scene.scene = s->r.engine->scene;
    s->scene.nodes = s->nodes;
    s->scene.plan = &s->plan;
    s->most = (uint32_t)config.run.packet_side * config.run.packet_side;
    s->count = (PACKETS - 1) * s->most + s->most / 2 + 1; /* the last packet is not full */
    rays_mixed(s->rays, s->count, m, &random);
    plt_trace(s->r.engine, s->rays, s->due[0], s->count, 0);
    plt_trace(s->r.engine, s->rays, s->due[1], s->count, 1);
    set_engine(s, &config.run);
    mesh_free(m);
    return s;
}

static void close_subject(subject *s) {
    free(s->stack.memory);
    free(s->local.memory);
    free(s->leaves.memory);
    free(s->packet);
    free(s->nodes);
    rig_close(&s->r);
    free(s);
}

/* From now on call `at` fails; 0: none. Returns the status that it fails with. */
static int plan(subject *s, uint64_t at) {
    const failing_plan fresh = {.fails_at = at, .status = at % 2 ? PLT_ERR_SOURCE : PLT_ERR_LIMIT};
    s->plan = fresh;
    return at > 0 ? fresh.status : PLT_OK;
}

/* After call `at` has failed: no other was made, and the traversal is at rest. */
static void at_rest(subject *s, uint64_t at) {
    CHECK(s->plan.all == at, "%u calls, when the %u. failed", (unsigned)s->plan.all, (unsigned)at);
    CHECK(s->engine.traversal.waiting == 0, "call %u: %u entries wait", (unsigned)at,
          s->engine.traversal.waiting);
    CHECK(are_guarded(s), "call %u: a stack was overrun", (unsigned)at);
}

/* ---- arrays of rays --------------------------------------------------------------------- */

static int is_due(const subject *s, const plt_hit *hits, uint32_t first, uint32_t end, int any) {
    return memcmp(hits + first, s->due[any] + first, (end - first) * sizeof *hits) == 0;
}

static void trace_right(subject *s, int any) {
    static plt_hit hits[RAYS_MOST];
    plan(s, 0);
    memset(hits, PATTERN, sizeof hits);
    CHECK(failing_trace(&s->engine, s->rays, hits, s->count, any) == PLT_OK, "any %d", any);
    CHECK(is_due(s, hits, 0, s->count, any), "any %d: the hits differ", any);
}

/* Nothing fails: hits and statistics of the thesis's format. */
static void same_as_thesis(subject *s) {
    plt_stats due, found;
    uint32_t met = 0;
    plt_stats_reset(s->r.engine);
    failing_stats_reset(&s->engine);
    for (int any = 0; any < 2; any++) {
        plt_hit again[RAYS_MOST];
        plt_trace(s->r.engine, s->rays, again, s->count, any);
        trace_right(s, any);
        CHECK(are_guarded(s), "a stack was overrun");
        CHECK(s->plan.calls[FAILING_RETURN] > 0 && s->plan.calls[FAILING_LEAF] > 0, "no calls");
    }
    plt_stats_get(s->r.engine, &due);
    failing_stats_get(&s->engine, &found);
    CHECK(found.rays == due.rays && found.packets == due.packets &&
              found.mixed_packets == due.mixed_packets,
          "rays or packets");
    CHECK(found.node_visits == due.node_visits && found.group_tests == due.group_tests &&
              found.triangle_tests == due.triangle_tests && found.triangle_tests > 0,
          "visits or tests");
    for (uint32_t i = 0; i < s->count; i++) {
        met += s->due[0][i].triangle != PLT_MISS;
    }
    CHECK(met > 0 && met < s->count, "%u of %u rays hit", met, s->count);
}

/* Packet `number` set up as plt_trace_packet does, then worked off `visits` at a time. */
static int traverse_packet(subject *s, uint32_t number, int any, uint32_t visits) {
    plt_traversal *t = &s->engine.traversal;
    plt_packet *p = &s->engine.packet;
    const plt_ray *rays = s->rays + number * s->most;
    const uint32_t left = s->count - number * s->most, count = left < s->most ? left : s->most;
    int status = PLT_MORE;
    plt_packet_begin(p, &t->scene->box, (count + 3) / 4, any);
    for (unsigned i = 0; i < p->groups; i++) {
        plt_packet_load_rays(p, i, rays + 4 * i, count - 4 * i);
    }
    plt_packet_finish(p);
    failing_traversal_begin(t, p, count);
    while (status == PLT_MORE) {
        status = failing_traverse(t, p, visits);
    }
    return status;
}

/* Packet 0 is traced after each failure. */
static void next_packet_right(subject *s, int any) {
    plt_hit hits[PLT_PACKET_SIDE_MAX * PLT_PACKET_SIDE_MAX];
    plan(s, 0);
    CHECK(failing_trace_packet(&s->engine.traversal, &s->engine.packet, s->rays, hits, s->most,
                               any) == PLT_OK,
          "the next packet");
    CHECK(is_due(s, hits, 0, s->most, any), "the next packet's hits differ");
}

/* Every call of a packet fails once; returns how many there are. */
static uint64_t packet_fails(subject *s, uint32_t number, int any, uint32_t visits) {
    plan(s, 0);
    CHECK(traverse_packet(s, number, any, visits) == PLT_OK, "packet %u", number);
    const uint64_t calls = s->plan.all;
    for (uint64_t at = 1; at <= calls; at++) {
        const int due = plan(s, at), status = traverse_packet(s, number, any, visits);
        CHECK(status == due, "packet %u, call %u: status %d", number, (unsigned)at, status);
        at_rest(s, at);
        CHECK(failing_traverse(&s->engine.traversal, &s->engine.packet, visits) == PLT_OK,
              "it goes on");
        at_rest(s, at);
        next_packet_right(s, any);
    }
    return calls;
}

static void packets_fail(subject *s) {
    uint64_t calls = 0;
    for (uint32_t number = 0; number < PACKETS; number++) {
        for (int any = 0; any < 2; any++) {
            calls += packet_fails(s, number, any, 1);
            calls += packet_fails(s, number, any, 0xFFFFFFFFu);
        }
    }
    CHECK(calls >= 4 * PACKETS, "%u calls", (unsigned)calls);
}

/* How many calls there are up to the end of each packet. */
static void count_calls(subject *s, int any, uint64_t until[PACKETS]) {
    plan(s, 0);
    for (uint32_t i = 0; i < PACKETS; i++) {
        traverse_packet(s, i, any, 0xFFFFFFFFu);
        until[i] = s->plan.all;
    }
}

static void trace_fails(subject *s, int any) {
    static plt_hit hits[RAYS_MOST], untouched[RAYS_MOST];
    uint64_t until[PACKETS];
    uint32_t done = 0;
    plt_stats stats;
    count_calls(s, any, until);
    memset(untouched, PATTERN, sizeof untouched);
    for (uint64_t at = 1; at <= until[PACKETS - 1]; at++) {
        while (until[done] < at) {
            done++;
        }
        const uint32_t good = done * s->most;
        const int due = plan(s, at);
        memcpy(hits, untouched, sizeof hits);
        failing_stats_reset(&s->engine);
        const int status = failing_trace(&s->engine, s->rays, hits, s->count, any);
        CHECK(status == due, "call %u: status %d", (unsigned)at, status);
        CHECK(is_due(s, hits, 0, good, any), "call %u: hits before it differ", (unsigned)at);
        CHECK(memcmp(hits + good, untouched + good, (RAYS_MOST - good) * sizeof *hits) == 0,
              "call %u: hits of its packet or behind it were written", (unsigned)at);
        at_rest(s, at);
        failing_stats_get(&s->engine, &stats);
        const uint32_t left = s->count - good; /* the packet that failed was begun */
        const uint32_t begun = good + (left < s->most ? left : s->most);
        CHECK(stats.rays == begun, "%u rays of %u", (unsigned)stats.rays, begun);
        trace_right(s, any);
    }
    CHECK(done == PACKETS - 1, "only %u packets failed", done);
}

/* ---- frames ------------------------------------------------------------------------------- */

static const uint8_t *due_rgb; /* the frame, of the real engine */

static void compare_tile(const plt_tile *tile) {
    for (uint32_t y = 0; y < tile->height; y++) {
        const size_t pixel = (size_t)(tile->y + y) * WIDTH + tile->x, row = 3u * tile->width;
        CHECK(memcmp(tile->rgb + y * row, due_rgb + 3 * pixel, row) == 0, "tile %u %u, row %u",
              tile->x, tile->y, y);
    }
}

/* The status that the frame ends with; its tiles are compared and counted. `until`: the
 * calls up to the end of each, or NULL. */
static int render(subject *s, const plt_frame *frame, uint32_t visits, uint32_t *tiles,
                  uint64_t *until) {
    int status = failing_render_begin(&s->engine, frame);
    *tiles = 0;
    do {
        status = status < 0 ? status : failing_render_step(&s->engine, visits);
        if (status == PLT_TILE) {
            plt_tile tile;
            failing_render_tile(&s->engine, &tile);
            compare_tile(&tile);
            if (until != NULL) {
                until[*tiles] = s->plan.all;
            }
            ++*tiles;
        }
    } while (status > PLT_OK);
    return status;
}

static void frame_fails(subject *s, const plt_frame *frame, uint32_t visits) {
    enum { TILES = ((WIDTH - 1) / PLT_TILE_SIDE + 1) * ((HEIGHT - 1) / PLT_TILE_SIDE + 1) };
    uint64_t until[TILES];
    uint32_t tiles, done = 0;
    plan(s, 0);
    CHECK(render(s, frame, visits, &tiles, until) == PLT_OK && tiles == TILES, "%u tiles", tiles);
    CHECK(until[TILES - 1] >= 8, "%u calls", (unsigned)until[TILES - 1]);
    for (uint64_t at = 1; at <= until[TILES - 1]; at++) {
        while (until[done] < at) {
            done++;
        }
        const int due = plan(s, at), status = render(s, frame, visits, &tiles, NULL);
        CHECK(status == due, "call %u: status %d", (unsigned)at, status);
        CHECK(tiles == done, "call %u: %u tiles, not %u", (unsigned)at, tiles, done);
        CHECK(failing_render_step(&s->engine, visits) == PLT_OK &&
                  failing_render_step(&s->engine, visits) == PLT_OK,
              "call %u: the frame goes on", (unsigned)at);
        at_rest(s, at);
        plan(s, 0);
        CHECK(render(s, frame, visits, &tiles, NULL) == PLT_OK && tiles == TILES,
              "the next frame has %u tiles", tiles);
    }
}

static void frames_fail(subject *s) {
    static const float eye[3] = {1.5f, 2.0f, 4.0f}, look[3] = {0, 0, 0};
    const plt_frame frame = frame_of(eye, look, WIDTH, HEIGHT, PLT_SHADE_NORMAL);
    const frame_result due = frame_render(s->r.engine, &frame, 100);
    CHECK(due.status == PLT_OK && due.wrong == 0, "%u pixels", due.wrong);
    due_rgb = due.rgb;
    frame_fails(s, &frame, 1);
    frame_fails(s, &frame, 100000);
    trace_right(s, 0);
    free(due.rgb);
}

/* ---- scenes --------------------------------------------------------------------------------- */

/* Many treelets, or, `alone`, a root that is a leaf. */
static subject *some(uint8_t order, int alone) {
    mesh m = {0};
    if (alone) {
        shape_coincident(&m, 1);
        m.triangles = 1;
    } else {
        shape_soup(&m, 100, 0.7f, 9);
        shape_sheet(&m, 3, 1);
    }
    return open_subject(&m, order);
}

static void both(void (*look)(subject *s)) {
    for (unsigned i = 0; i < 4; i++) {
        subject *s = some((uint8_t)(i % 2), (int)(i / 2));
        look(s);
        close_subject(s);
    }
}

static void traces_fail(subject *s) {
    trace_fails(s, 0);
    trace_fails(s, 1);
}

/* Depth first an edge is entered when it is met; two-stage only when it comes back. */
static void all_kinds(subject *s) {
    trace_right(s, 0);
    CHECK((s->plan.calls[FAILING_ENTER] > 0) == (s->engine.options.order == PLT_ORDER_DEPTH_FIRST),
          "%u times an edge was entered", (unsigned)s->plan.calls[FAILING_ENTER]);
}

int main(void) {
    test("a format of the test's own gives the thesis's hits, visits and tests in both orders");
    both(same_as_thesis);
    for (uint8_t order = 0; order < 2; order++) {
        subject *s = some(order, 0);
        all_kinds(s);
        close_subject(s);
    }
    test("whichever call of a packet fails, its status arrives, nothing waits, the next is right");
    both(packets_fail);
    test("a failed plt_trace leaves the hits of its packet and of later ones as they were");
    both(traces_fail);
    test("a failed frame ends: a step more returns PLT_OK, and the next frame is right");
    both(frames_fail);
    return test_done();
}

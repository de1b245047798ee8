/* test_tasks - packets that wait at treelets
 *
 * Against a list of all that wait, searched in the dumbest way; the treelets are a random tree.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/schedule/nearest.h"
#include "tests/reference/random.h"
#include "tests/reference/room.h"
#include "tests/test.h"

enum { PLACE = 32, REST = 8, STORE = 65536, MODEL = 4096, NOWHERE = -1 };

typedef struct entry {
    unsigned char place[PLACE], rest[REST];
} entry;

typedef struct waiting {
    uint32_t treelet;
    uint16_t packet;
    uint32_t name; /* in the rest */
} waiting;

typedef struct rig {
    plt_traversal traversal;
    plt_scene scene;
    plt_stream stream;
    unsigned char store[STORE];
    unsigned char stack[sizeof(entry) + PLT_TASK_REST_BYTES];
    void *memory;
    plt_tasks tasks;
    waiting model[MODEL];
    uint32_t count, names;
} rig;

static void set_up(rig *r, uint32_t most, uint32_t queues) {
    memset(r, 0, sizeof *r);
    r->scene.format = PLT_FORMAT_STREAMED;
    r->traversal.scene = &r->scene;
    r->traversal.state = &r->stream;
    r->traversal.stack = r->stack;
    plt_stream_init(&r->stream, r->store, STORE);
    r->memory = room_get(plt_tasks_bytes(most, queues));
    plt_tasks_init(&r->tasks, r->memory, most, queues);
}

/* An edge to the treelet at so many bytes. */
static uint32_t treelet_at(uint32_t address) {
    return plt_block_link(8 * address, 64);
}

static int wait_at(rig *r, uint32_t treelet, uint16_t packet, float distance) {
    entry e;
    memset(e.place, (int)(treelet % 251), PLACE);
    memset(e.rest, 0, REST);
    memcpy(e.rest, &r->names, sizeof r->names);
    r->tasks.packet = packet;
    const int waits =
        plt_tasks_wait(&r->tasks, treelet, treelet % 7, distance, &e, sizeof e, PLACE);
    if (waits) {
        const waiting w = {treelet, packet, r->names};
        r->model[r->count++] = w;
    }
    r->names++;
    return waits;
}

/* The treelet of what comes next, which must be in the model; NOWHERE: nothing came. */
static int64_t next(rig *r) {
    uint32_t name;
    while (!plt_tasks_next(&r->tasks, &r->traversal)) {
        if (plt_nearest_begin(&r->tasks, &r->traversal)) {
            continue;
        }
        CHECK(r->count == 0, "%u still wait", r->count);
        return NOWHERE;
    }
    memcpy(&name, r->stack + PLACE, sizeof name);
    for (uint32_t i = 0; i < r->count; i++) {
        if (r->model[i].name == name) {
            const waiting w = r->model[i];
            r->model[i] = r->model[--r->count];
            CHECK(r->tasks.packet == w.packet, "packet %u, not %u", r->tasks.packet, w.packet);
            CHECK(r->stack[0] == w.treelet % 251 && r->stack[PLACE - 1] == w.treelet % 251,
                  "the place is another's");
            CHECK(r->traversal.waiting == 1, "nothing is on the stack");
            return w.treelet;
        }
    }
    CHECK(0, "an entry that nobody left, or that came twice");
    return NOWHERE;
}

/* The first of a queue waits no longer. */
static void drop(rig *r, uint16_t *at) {
    uint32_t name, i = 0;
    plt_tasks_peek(&r->tasks, &r->tasks.queue[*at], &r->traversal);
    memcpy(&name, r->stack + PLACE, sizeof name);
    while (i < r->count && r->model[i].name != name) {
        i++;
    }
    CHECK(i < r->count && r->tasks.packet == r->model[i].packet, "an entry that nobody left");
    r->model[i] = r->model[--r->count];
    plt_tasks_drop_one(&r->tasks, at);
}

static uint32_t waiting_at(const rig *r, int64_t treelet) {
    uint32_t count = 0;
    for (uint32_t i = 0; i < r->count; i++) {
        count += r->model[i].treelet == treelet;
    }
    return count;
}

static void are_nearest_first(void) {
    static rig r;
    set_up(&r, 100, 100);
    for (uint16_t i = 0; i < 20; i++) {
        CHECK(wait_at(&r, treelet_at(1 + i % 5), i, (float)(100 - i % 5 * 10)), "no room");
    }
    wait_at(&r, treelet_at(2), 20, 1.0f);
    const uint32_t due[5] = {2, 5, 4, 3, 1};
    for (unsigned i = 0; i < 5; i++) {
        for (unsigned k = 0; k < 4u + (i == 0); k++) {
            CHECK(next(&r) == treelet_at(due[i]), "treelet %u, packet %u", due[i], k);
        }
    }
    CHECK(next(&r) == NOWHERE && next(&r) == NOWHERE, "the end");
    free(r.memory);
}

static void are_at_hand_first(void) {
    static rig r;
    set_up(&r, 100, 100);
    wait_at(&r, treelet_at(1), 0, 5.0f);
    wait_at(&r, treelet_at(2), 0, 50.0f);
    wait_at(&r, treelet_at(3), 0, 9.0f);
    CHECK(plt_store_take(&r.stream.fetcher.store, 16, 64) != PLT_STORE_NONE, "the store has room");
    CHECK(next(&r) == treelet_at(2), "the treelet that is there comes first");
    CHECK(next(&r) == treelet_at(1) && next(&r) == treelet_at(3), "then the nearest");
    free(r.memory);
}

/* What is met when a treelet is worked off waits; an edge to itself does not. */
static void crosses_here(void) {
    static rig r;
    set_up(&r, 10, 10);
    wait_at(&r, treelet_at(7), 3, 0.0f);
    CHECK(next(&r) == treelet_at(7), "the root");
    CHECK(!wait_at(&r, treelet_at(7), 3, 0.0f), "it waits at the treelet that it has entered");
    CHECK(wait_at(&r, treelet_at(8), 3, 0.0f), "it does not wait below");
    CHECK(next(&r) == treelet_at(8), "what is below");
    CHECK(wait_at(&r, treelet_at(7), 3, 0.0f), "the treelet is not worked off any more");
    plt_tasks_clear(&r.tasks);
    r.count = 0;
    CHECK(next(&r) == NOWHERE, "cleared");
    free(r.memory);
}

static void has_room(uint32_t most, uint32_t queues) {
    static rig r;
    set_up(&r, most, queues);
    uint32_t fits = 0;
    while (fits < MODEL && wait_at(&r, treelet_at(1 + fits / 2), (uint16_t)fits, 0.0f)) {
        fits++;
    }
    const uint32_t due = most < 2 * queues ? most : 2 * queues;
    CHECK(fits == due, "%u tasks, %u queues: %u fit", most, queues, fits);
    while (next(&r) != NOWHERE) {
    }
    CHECK(wait_at(&r, treelet_at(1), 0, 0.0f), "nothing is free again");
    free(r.memory);
}

/* A walk over a random tree: whoever comes to a treelet waits at some of its children. All that
 * wait at one come together, and it is never come back to, as long as there is room. */
static void is_walked_through(uint32_t seed, uint32_t most, uint32_t queues) {
    static rig r;
    static uint8_t left[1 << 14];
    random_state random = {seed};
    int64_t last = NOWHERE;
    uint32_t refused = 0, taken = 0;
    memset(left, 0, sizeof left);
    set_up(&r, most, queues);
    for (uint16_t i = 0; i < 8; i++) {
        wait_at(&r, treelet_at(1), i, 0.0f);
    }
    for (int64_t at; (at = next(&r)) != NOWHERE; last = at, taken++) {
        const uint32_t address = plt_block_address((uint32_t)at) / 8;
        if (at != last && last != NOWHERE) {
            left[plt_block_address((uint32_t)last) / 8] = 1;
            CHECK(waiting_at(&r, last) == 0, "seed %u: a treelet is left before its end", seed);
        }
        CHECK(refused > 0 || !left[address], "seed %u: a treelet comes again", seed);
        for (uint32_t child = 4 * address; child < 4 * address + 4 && child < 1 << 10; child++) {
            if (random_below(&random, 3) > 0 && r.count < MODEL) {
                refused += !wait_at(&r, treelet_at(child), r.tasks.packet,
                                    random_float(&random, 0.0f, 9.0f));
            }
        }
    }
    CHECK(taken > (refused == 0 ? 200u : 20u), "seed %u: %u tasks", seed, taken);
    CHECK(r.tasks.count == 0 && r.tasks.queues == 0, "something is counted still");
    CHECK((refused == 0) == (most >= 2000), "%u refused, room for %u", refused, most);
    free(r.memory);
}

/* The same walk, but wherever a treelet is begun some of those that wait elsewhere are let go. */
static void some_are_let_go(uint32_t seed) {
    static rig r;
    random_state random = {seed};
    int64_t last = NOWHERE;
    uint32_t dropped = 0;
    set_up(&r, 3000, 1024);
    for (uint16_t i = 0; i < 8; i++) {
        wait_at(&r, treelet_at(1), i, 0.0f);
    }
    for (int64_t at; (at = next(&r)) != NOWHERE; last = at) {
        const uint32_t address = plt_block_address((uint32_t)at) / 8;
        CHECK(at == last || last == NOWHERE || waiting_at(&r, last) == 0, "left before its end");
        for (uint32_t i = 0; at != last && i < random_below(&random, 4); i++) {
            uint16_t *queue = &r.tasks.first;
            for (uint32_t k = random_below(&random, 9); k > 0 && *queue != PLT_TASK_NONE; k--) {
                queue = &r.tasks.queue[*queue].after;
            }
            if (*queue != PLT_TASK_NONE) {
                drop(&r, queue);
                dropped++;
            }
        }
        for (uint32_t child = 4 * address; child < 4 * address + 4 && child < 1 << 10; child++) {
            CHECK(r.count == MODEL || wait_at(&r, treelet_at(child), (uint16_t)(child % 8),
                                              random_float(&random, 0.0f, 9.0f)),
                  "seed %u: no room", seed);
        }
    }
    CHECK(dropped > 20 && r.tasks.count == 0 && r.tasks.queues == 0, "seed %u: %u let go", seed,
          dropped);
    free(r.memory);
}

int main(void) {
    test("the nearest treelet comes first, with all that wait there");
    are_nearest_first();
    test("a treelet that is at hand comes before the nearest");
    are_at_hand_first();
    test("packets wait at edges below the treelet that is worked off, not at its own");
    crosses_here();
    test("as many fit as there is room for");
    for (uint32_t most = 1; most < 40; most++) {
        has_room(most, 1 + most % 7);
    }
    test("a treelet is met once, as long as there is room; nobody is lost");
    for (uint32_t seed = 0; seed < 200; seed++) {
        is_walked_through(seed, 3000, 1024);
        is_walked_through(seed, 8 + seed % 20, 8 + seed % 3);
    }
    test("whoever need not wait any longer is let go, and nobody else");
    for (uint32_t seed = 0; seed < 200; seed++) {
        some_are_let_go(seed);
    }
    return test_done();
}

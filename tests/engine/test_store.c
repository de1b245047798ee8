/* test_store - parts stay whole while others come, move and go
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "engine/memory/store.h"
#include "tests/reference/random.h"
#include "tests/test.h"

enum { KEYS = 400, STEPS = 60000, HELD_MOST = 3, GUARD = 64 };

typedef struct subject {
    unsigned char *memory;
    uint32_t bytes;
    plt_store store;
    uint32_t count[KEYS]; /* bytes of the part of each key */
    uint16_t held[HELD_MOST];
    uint32_t held_at[HELD_MOST], held_count;
    uint32_t found, taken, refused;
} subject;

static unsigned char byte_of(uint32_t key, uint32_t i) {
    return (unsigned char)(key * 31 + i * 7 + (i >> 5));
}

static int is_whole(const subject *s, uint16_t part, uint32_t key) {
    const unsigned char *bytes = plt_store_bytes(&s->store, part);
    for (uint32_t i = 0; i < s->count[key]; i++) {
        if (bytes[i] != byte_of(key, i)) {
            return 0;
        }
    }
    return 1;
}

static void fill(const subject *s, uint16_t part, uint32_t key) {
    for (uint32_t i = 0; i < s->count[key]; i++) {
        plt_store_bytes(&s->store, part)[i] = byte_of(key, i);
    }
}

static void release(subject *s) {
    for (uint32_t i = 0; i < s->held_count; i++) {
        plt_store_part *p = &s->store.part[s->held[i]];
        CHECK(p->at == s->held_at[i], "a held part has moved");
        p->held--;
    }
    s->held_count = 0;
}

static void hold(subject *s, uint16_t part) {
    s->store.part[part].held++;
    s->held[s->held_count] = part;
    s->held_at[s->held_count++] = s->store.part[part].at;
}

static void step(subject *s, random_state *r) {
    /* Some keys are wanted often. */
    const uint32_t key = random_below(r, random_below(r, 2) ? 20 : KEYS);
    uint16_t part = plt_store_find(&s->store, key);
    if (part != PLT_STORE_NONE) {
        s->found++;
        CHECK(is_whole(s, part, key), "part %u is not what was put there", key);
    } else {
        part = plt_store_take(&s->store, key, s->count[key]);
        s->taken += part != PLT_STORE_NONE;
        s->refused += part == PLT_STORE_NONE;
        if (part != PLT_STORE_NONE) {
            CHECK(s->store.part[part].at % 8 == 0, "not aligned");
            fill(s, part, key);
        }
    }
    if (part == PLT_STORE_NONE || s->held_count == HELD_MOST || random_below(r, 9) == 0) {
        release(s);
    } else if (random_below(r, 4) == 0) {
        hold(s, part);
    } else if (random_below(r, 50) == 0) {
        plt_store_forget(&s->store, part);
        CHECK(plt_store_find(&s->store, key) == PLT_STORE_NONE, "forgotten, and found");
    }
}

static void start(subject *s, uint32_t bytes, uint32_t largest, random_state *r) {
    s->bytes = bytes;
    s->memory = aligned_alloc(16, (bytes + GUARD + 15) & ~15u);
    memset(s->memory + bytes, 0x5A, GUARD);
    plt_store_init(&s->store, s->memory, bytes);
    for (uint32_t key = 0; key < KEYS; key++) {
        s->count[key] = 1 + random_below(r, random_below(r, 8) ? largest / 8 : largest);
    }
}

static void finish(subject *s) {
    for (uint32_t i = 0; i < GUARD; i++) {
        CHECK(s->memory[s->bytes + i] == 0x5A, "written behind its end");
    }
    free(s->memory);
}

static void random_steps(uint32_t bytes, uint32_t largest) {
    static subject s;
    random_state r = {bytes + largest};
    memset(&s, 0, sizeof s);
    start(&s, bytes, largest, &r);
    for (uint32_t i = 0; i < STEPS; i++) {
        step(&s, &r);
    }
    CHECK(s.found > STEPS / 8 && s.taken > STEPS / 8, "%u found, %u taken", s.found, s.taken);
    CHECK(s.refused < STEPS / 50, "%u refused", s.refused);
    finish(&s);
}

/* The sizes that planelet.h names, the two first held, in every order of what was there before. */
static void largest_parts(void) {
    static const uint32_t largest[] = {739, 8184, 1886};
    for (uint32_t seed = 0; seed < 2000; seed++) {
        static subject s;
        random_state r = {seed};
        memset(&s, 0, sizeof s);
        start(&s, PLT_STORE_LEAST, 8184, &r);
        for (uint32_t i = 0; i < seed % 37; i++) {
            const uint32_t key = random_below(&r, KEYS);
            if (plt_store_find(&s.store, key) == PLT_STORE_NONE) {
                CHECK(plt_store_take(&s.store, key, s.count[key]) != PLT_STORE_NONE, "seed %u",
                      seed);
            }
        }
        for (uint32_t i = 0; i < 3; i++) {
            const uint16_t part = plt_store_take(&s.store, KEYS + i, largest[i]);
            CHECK(part != PLT_STORE_NONE, "seed %u: no room for part %u", seed, i);
            if (part != PLT_STORE_NONE) {
                hold(&s, part);
            }
        }
        release(&s);
        finish(&s);
    }
}

/* Oldest first, but what was found stays once more. */
static void second_chance(void) {
    static subject s;
    random_state r = {1};
    memset(&s, 0, sizeof s);
    start(&s, PLT_STORE_LEAST, 64, &r);
    const uint32_t size = s.store.bytes / 4 & ~7u;
    for (uint32_t key = 0; key < 4; key++) {
        CHECK(plt_store_take(&s.store, key, size) != PLT_STORE_NONE, "part %u", key);
    }
    CHECK(plt_store_find(&s.store, 0) != PLT_STORE_NONE, "part 0 is not there");
    CHECK(plt_store_take(&s.store, 4, size) != PLT_STORE_NONE, "part 4");
    CHECK(plt_store_find(&s.store, 1) == PLT_STORE_NONE, "the oldest that nobody wanted stays");
    CHECK(plt_store_find(&s.store, 0) != PLT_STORE_NONE, "what was found has gone");
    CHECK(s.store.given_up == 1, "%u given up", (unsigned)s.store.given_up);
    CHECK(plt_store_take(&s.store, 9, s.store.bytes + 8) == PLT_STORE_NONE,
          "larger than the store");
    finish(&s);
}

int main(void) {
    test("what is found in a store is what was put there, and what is held stays where it is");
    random_steps(PLT_STORE_LEAST, 2000);
    random_steps(98304, 8184);
    random_steps(65536, 300); /* entries of the table run out first */
    test("the largest parts of a block fit the smallest store together, whatever was there");
    largest_parts();
    test("the oldest part is given up first, unless it was found");
    second_chance();
    return test_done();
}

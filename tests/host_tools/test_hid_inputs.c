/* test_hid_inputs - touched panels, strips and keys beside a panel: the bytes of the notes
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/display_bench.h"
#include "tests/reference/random.h"

/* What a report does to the entries of the driver's list, each change counted. */
static uint8_t changes[KEYS_MOST];

static void hear(bench *b, const uint8_t *report, size_t bytes) {
    const keys_state before = b->display.keys;
    queue.count = queue.at = 0;
    add(report, bytes);
    CHECK(b->display.by->tick(&b->display) == DISPLAY_OK, "gone");
    CHECK(queue.at == queue.count, "the report waits");
    for (unsigned k = 0; k < KEYS_MOST; k++) {
        changes[k] = (uint8_t)(b->display.keys.changes[k] - before.changes[k]);
    }
}

/* The entry for `name`; how often it changed, if no other did. */
static int changed(const bench *b, const char *name) {
    const display_key *keys = b->display.by->keys;
    int times = -1;
    for (unsigned k = 0; k < KEYS_MOST && keys[k].name != NULL; k++) {
        if (strcmp(keys[k].name, name) == 0) {
            times = changes[k];
        } else if (changes[k] != 0) {
            return -1;
        }
    }
    return times;
}

static int is_quiet(void) {
    for (unsigned k = 0; k < KEYS_MOST; k++) {
        if (changes[k] != 0) {
            return 0;
        }
    }
    return 1;
}

/* ---- a Nexus --------------------------------------------------------------------------- */

static void finger(bench *b, int is_there, unsigned column) {
    const uint8_t report[64] = {
        1, 2, 0x21, 0, 0, (uint8_t)is_there, (uint8_t)column, (uint8_t)(column >> 8)};
    hear(b, report, sizeof report);
}

static void nexus(void) {
    bench b;
    test("nexus: a scene goes with a finger, a step for 32 columns");
    open_bench(&b, &model_nexus);
    finger(&b, 1, 100);
    CHECK(is_quiet(), "a finger that has just come");
    finger(&b, 1, 131);
    CHECK(is_quiet(), "less than a step");
    finger(&b, 1, 132);
    CHECK(changed(&b, "swipe to the right") == 2, "a step");
    finger(&b, 1, 200);
    CHECK(changed(&b, "swipe to the right") == 4, "two steps");
    test("nexus: ... also when it is lost for a report on its way");
    finger(&b, 0, 300);
    CHECK(changed(&b, "swipe to the right") == 6, "three");
    finger(&b, 1, 228);
    CHECK(changed(&b, "swipe to the left") == 4, "back");
    finger(&b, 0, 0);
    CHECK(is_quiet(), "gone after a swipe: no tap");
    test("nexus: a tap is farther, the first view or nearer, by its third");
    static const struct {
        unsigned column;
        const char *name;
    } taps[] = {{5, "tap, left third"},     {212, "tap, left third"},  {214, "tap, middle"},
                {426, "tap, middle"},       {428, "tap, right third"}, {639, "tap, right third"},
                {65535, "tap, right third"}};
    for (unsigned i = 0; i < sizeof taps / sizeof taps[0]; i++) {
        finger(&b, 1, taps[i].column);
        finger(&b, 1, taps[i].column);
        CHECK(is_quiet(), "%u: still there", taps[i].column);
        finger(&b, 0, 0);
        CHECK(changed(&b, taps[i].name) == 2, "%u is no %s", taps[i].column, taps[i].name);
        finger(&b, 0, 0);
        CHECK(is_quiet(), "%u: gone", taps[i].column);
    }
    test("nexus: short reports, and others, are no finger's");
    const uint8_t small[7] = {1, 2, 0x21, 0, 0, 1, 9}, other[64] = {1, 3, 0x21, 0, 0, 1, 9};
    hear(&b, small, sizeof small);
    hear(&b, other, sizeof other);
    finger(&b, 0, 0);
    CHECK(is_quiet(), "a tap of nobody");
    close_bench(&b);
}

/* ---- a Stream Deck + ------------------------------------------------------------------- */

static void strip(bench *b, unsigned what, unsigned from, unsigned to) {
    uint8_t report[14] = {1, 2, 10, 0, (uint8_t)what, 0, (uint8_t)from, (uint8_t)(from >> 8)};
    report[10] = (uint8_t)to, report[11] = (uint8_t)(to >> 8);
    hear(b, report, sizeof report);
}

static void plus(void) {
    bench b;
    test("streamdeck-plus: a swipe turns a scene, a step for 50 pixels, at most eight");
    open_bench(&b, &model_deck_plus);
    strip(&b, 3, 100, 149);
    CHECK(is_quiet(), "less than a step");
    strip(&b, 3, 100, 250);
    CHECK(changed(&b, "swipe to the right") == 6, "three steps");
    strip(&b, 3, 250, 199);
    CHECK(changed(&b, "swipe to the left") == 2, "one back");
    strip(&b, 3, 0, 65535);
    CHECK(changed(&b, "swipe to the right") == 16, "eight");
    strip(&b, 3, 65535, 0);
    CHECK(changed(&b, "swipe to the left") == 16, "eight");
    test("streamdeck-plus: a touch stops a sequence, a longer one is the first view");
    strip(&b, 1, 400, 0);
    CHECK(changed(&b, "strip, touched") == 2, "a touch");
    strip(&b, 2, 400, 0);
    CHECK(changed(&b, "strip, held") == 2, "held");
    strip(&b, 4, 400, 0);
    CHECK(is_quiet(), "something else");
    const uint8_t small[13] = {1, 2, 10, 0, 1};
    hear(&b, small, sizeof small);
    CHECK(is_quiet(), "a short report");
    close_bench(&b);
    test("streamdeck: what has no strip is not turned by one");
    open_bench(&b, &model_deck);
    strip(&b, 3, 0, 300);
    CHECK(is_quiet(), "turned");
    close_bench(&b);
}

/* ---- keys of Logitech and a picoLCD ------------------------------------------------------- */

typedef struct key_bit {
    unsigned number, bytes, byte, bit;
    const char *name;
} key_bit;

static void key_bits(bench *b, const key_bit *k) {
    uint8_t report[9] = {(uint8_t)k->number, 0, 0, 0, 0, 0, 0, 0, 0};
    if (k->bytes == 8) {
        report[1] = report[2] = 128;
    }
    hear(b, report, k->bytes);
    CHECK(is_quiet(), "%s: nothing is down", k->name);
    report[k->byte] |= (uint8_t)(1 << k->bit);
    hear(b, report, k->bytes);
    CHECK(changed(b, k->name) == 1, "%s of %u bytes is not down", k->name, k->bytes);
    report[k->byte] ^= (uint8_t)(1 << k->bit);
    hear(b, report, k->bytes);
    CHECK(changed(b, k->name) == 1, "%s of %u bytes is not up", k->name, k->bytes);
}

static void logitech(void) {
    static const char *const row[] = {"first below the panel", "second", "third", "fourth"};
    static const struct {
        const char *name;
        unsigned axis, value;
    } stick[] = {{"G13, stick left", 1, 63},
                 {"G13, stick right", 1, 192},
                 {"G13, stick up", 2, 0},
                 {"G13, stick down", 2, 255}};
    bench b;
    open_bench(&b, &model_logitech);
    test("logitech: the row of keys below the panel, and the round one, of all four layouts");
    for (unsigned k = 0; k < 4; k++) {
        key_bits(&b, &(key_bit){1, 8, 6, 1 + k, row[k]});
        key_bits(&b, &(key_bit){2, 9, 2 + k, 7, row[k]});
        key_bits(&b, &(key_bit){2, 5, 2, 1 + k, row[k]});
        key_bits(&b, &(key_bit){3, 5, 4, 1 + k, row[k]});
    }
    key_bits(&b, &(key_bit){1, 8, 6, 0, "round, beside it"});
    key_bits(&b, &(key_bit){2, 9, 8, 7, "round, beside it"});
    key_bits(&b, &(key_bit){2, 5, 2, 7, "round, beside it"});
    key_bits(&b, &(key_bit){3, 5, 4, 0, "round, beside it"});
    test("logitech: the stick of a G13, beyond its middle half");
    for (unsigned i = 0; i < 4; i++) {
        uint8_t report[8] = {1, 191, 64};
        hear(&b, report, sizeof report);
        CHECK(is_quiet(), "in the middle");
        report[stick[i].axis] = (uint8_t)stick[i].value;
        hear(&b, report, sizeof report);
        CHECK(changed(&b, stick[i].name) == 1, "%s", stick[i].name);
        report[stick[i].axis] = 128;
        hear(&b, report, sizeof report);
        CHECK(changed(&b, stick[i].name) == 1, "%s is over", stick[i].name);
    }
    close_bench(&b);
}

static void picolcd(void) {
    static const struct {
        uint8_t number;
        const char *name;
    } of[] = {{1, "back"}, {2, "home"}, {5, "scroll up"}, {6, "OK"}, {7, "scroll down"}};
    const uint8_t up[3] = {0x11};
    bench b;
    test("picolcd: the numbers of its five keys, in either place");
    open_bench(&b, &model_picolcd);
    for (unsigned i = 0; i < 10; i++) {
        uint8_t report[3] = {0x11, 3, 4};
        report[1 + i / 5] = of[i % 5].number;
        hear(&b, report, sizeof report);
        CHECK(changed(&b, of[i % 5].name) == 1, "%s", of[i % 5].name);
        hear(&b, up, sizeof up);
        CHECK(changed(&b, of[i % 5].name) == 1, "%s is up", of[i % 5].name);
    }
    const uint8_t other[3] = {0x10, 1, 2};
    hear(&b, other, sizeof other);
    CHECK(is_quiet(), "another report");
    close_bench(&b);
}

/* ---- any bytes ------------------------------------------------------------------------- */

static void any_bytes(const model_kind *kind) {
    bench b;
    random_state r = {11};
    open_bench(&b, kind);
    for (unsigned round = 0; round < 3000; round++) {
        uint8_t report[64];
        for (unsigned i = 0; i < sizeof report; i++) {
            report[i] = (uint8_t)(random_below(&r, 2) ? random_below(&r, 4) : random_bits(&r));
        }
        hear(&b, report, 1 + random_below(&r, round % 2 ? 14 : 64));
        for (unsigned k = 0; k < KEYS_MOST; k++) {
            CHECK(changes[k] <= 16, "%u changes", changes[k]);
        }
    }
    close_bench(&b);
}

int main(void) {
    static const model_kind *const all[] = {&model_nexus,   &model_deck_plus, &model_deck,
                                            &model_deck_xl, &model_deck_neo,  &model_logitech,
                                            &model_picolcd, &model_original};
    nexus();
    plus();
    logitech();
    picolcd();
    test("reports of any bytes: no entry changes more than eight times up and down");
    for (unsigned i = 0; i < sizeof all / sizeof all[0]; i++) {
        any_bytes(all[i]);
    }
    return test_done();
}

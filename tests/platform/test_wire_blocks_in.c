/* test_wire_blocks_in - replies to requests for blocks, as a host may send them that errs or lies
 *
 * The asking side alone, on a clock of the test's own. The memory of each request lies between
 * guards, and the bytes of each reply in memory of exactly their size, so that a sanitizer sees
 * a read beyond them.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "platform/wire/services.h"
#include "tests/test.h"

enum { GUARD = 64, ROOM = 512, IMAGE = 1024, UNTOUCHED = 0xFF };
enum { TAG = 3, FROM = 100, BYTES = 40 };

static struct {
    wire_peer peer;
    wire_blocks_in in;
    uint8_t image[IMAGE];
    uint8_t memory[GUARD + ROOM + GUARD];
} b;

static int gives_up(void *context) {
    (void)context;
    return -1;
}

static void open_at(uint32_t now_ms) {
    memset(&b, 0, sizeof b);
    memset(b.memory, UNTOUCHED, sizeof b.memory);
    for (unsigned i = 0; i < IMAGE; i++) {
        b.image[i] = (uint8_t)(i * 7 % 251);
    }
    b.peer.now_ms = now_ms;
    wire_blocks_in_open(&b.in, &b.peer, gives_up, NULL);
}

static void ask(unsigned tag, uint32_t offset, uint32_t to, uint32_t count) {
    CHECK(wire_source_start(&b.in, tag, offset, b.memory + GUARD + to, count) == 0, "tag %u", tag);
}

/* A reply of bytes that are all `value`, or, when that is negative, those of the image. */
static void reply_with(int value, unsigned tag, uint32_t offset, uint32_t count) {
    uint8_t *bytes = malloc(count > 0 ? count : 1);
    for (uint32_t i = 0; i < count; i++) {
        bytes[i] = value < 0 ? b.image[(offset + i) % IMAGE] : (uint8_t)value;
    }
    wire_blocks_in_head(&b.in, tag, offset);
    wire_blocks_in_bytes(&b.in, bytes, count);
    free(bytes);
}

static void reply(unsigned tag, uint32_t offset, uint32_t count) {
    reply_with(-1, tag, offset, count);
}

/* `has` bytes of the image from `offset` are at `to`; those up to `end` are not touched. */
static int holds(uint32_t to, uint32_t offset, uint32_t has, uint32_t end) {
    const uint8_t *at = b.memory + GUARD + to;
    int right = memcmp(at, b.image + offset, has) == 0;
    for (uint32_t i = has; to + i < end; i++) {
        right &= at[i] == UNTOUCHED;
    }
    return right;
}

/* Of one request at the front of the memory: so many bytes came, and nothing else was written. */
static int has_only(uint32_t offset, uint32_t has) {
    int right = b.in.want[0].has == has;
    for (unsigned i = 0; i < GUARD; i++) {
        right &= b.memory[i] == UNTOUCHED;
    }
    return right && holds(0, offset, has, ROOM + GUARD);
}

static int state(void) {
    return wire_block_state(&b.in, 1u << TAG);
}

/* ---- where replies lie ----------------------------------------------------------------------- */

/* Of the bytes that a request lacks from `next`, those that a reply brings. */
static uint32_t due(int64_t at, uint32_t count, uint32_t next, uint32_t left) {
    const int64_t brought = at <= next ? at + count - next : 0;
    return brought <= 0 ? 0 : brought < left ? (uint32_t)brought : left;
}

/* Offsets below zero are those before 2^32: such a reply goes round. */
static void check_all(uint32_t offset, uint32_t had) {
    for (int64_t at = -80; at < 240; at++) {
        for (uint32_t count = 0; count < 160; count += count < 70 ? 1 : 30) {
            const int64_t from = at < 0 ? at + (INT64_C(1) << 32) : at;
            open_at(7);
            ask(TAG, offset, 0, BYTES);
            reply(TAG, offset, had);
            reply(TAG, (uint32_t)at, count);
            const uint32_t has = had + due(from, count, offset + had, BYTES - had);
            CHECK(has_only(offset, has), "%u had, then %u from %lld: %u of %u", had, count,
                  (long long)from, b.in.want[0].has, has);
            CHECK(state() == (has == BYTES ? WIRE_OK : WIRE_BUSY), "%u bytes", has);
        }
    }
}

static void test_places(void) {
    test("of a reply exactly the bytes are taken that are lacking next, wherever it begins");
    check_all(FROM, 0);
    check_all(FROM, 13);
    test("likewise at the image's first byte, which an offset that goes round reaches");
    check_all(0, 0);
    check_all(0, 13);
    test("a request at the end of all offsets gets its bytes, and none behind it");
    open_at(7);
    ask(TAG, UINT32_MAX - BYTES + 1, 0, BYTES);
    reply(TAG, 0, BYTES);
    CHECK(has_only(IMAGE - BYTES, 0), "%u bytes from 0", b.in.want[0].has);
    reply(TAG, UINT32_MAX - BYTES - 9, 10 + BYTES + 10);
    CHECK(has_only(IMAGE - BYTES, BYTES), "%u bytes", b.in.want[0].has);
    test("a reply in pieces, as reports cut it, is taken as one");
    for (uint32_t piece = 1; piece <= 60; piece++) {
        open_at(7);
        ask(TAG, FROM, 0, BYTES);
        wire_blocks_in_head(&b.in, TAG, FROM - 30);
        for (uint32_t i = 0; i < 120; i += piece) {
            wire_blocks_in_bytes(&b.in, b.image + FROM - 30 + i, piece);
        }
        CHECK(has_only(FROM, BYTES) && state() == WIRE_OK, "pieces of %u", piece);
    }
}

static void test_tags(void) {
    test("a reply of another tag is not taken, though its offset is the one that is asked for");
    for (unsigned tag = 0; tag < 256; tag++) {
        open_at(7);
        ask(TAG, FROM, 0, BYTES);
        reply(tag, FROM, BYTES);
        CHECK(has_only(FROM, tag == TAG ? BYTES : 0), "tag %u", tag);
    }
    test("a refusal of another tag or place is not for this request; its own ends the wait");
    static const uint8_t other_tag[5] = {TAG + 32, FROM}, place[5] = {TAG, FROM + 1},
                         own[5] = {TAG, FROM}, rest[5] = {TAG, FROM + 10};
    open_at(7);
    ask(TAG, FROM, 0, BYTES);
    wire_blocks_in_receive(&b.in, other_tag);
    wire_blocks_in_receive(&b.in, place);
    CHECK(state() == WIRE_BUSY, "refused");
    reply(TAG, FROM, 10);
    wire_blocks_in_receive(&b.in, own);
    CHECK(state() == WIRE_BUSY, "refused of bytes that are here");
    wire_blocks_in_receive(&b.in, rest);
    reply(TAG, FROM + 10, BYTES);
    CHECK(has_only(FROM, 10) && state() == WIRE_ERR_DOWN, "not refused");
}

/* ---- more replies than requests ------------------------------------------------------------- */

static void test_too_many(void) {
    test("what came is not written again, however often a host sends it, and with whatever bytes");
    open_at(7);
    ask(TAG, FROM, 0, BYTES);
    reply(TAG, FROM, 25);
    reply_with(0xAA, TAG, FROM, 25);
    CHECK(has_only(FROM, 25), "before its end");
    reply(TAG, FROM, BYTES);
    for (uint32_t at = 0; at < 2 * FROM; at++) {
        reply_with(0xAA, TAG, at, 200);
    }
    CHECK(has_only(FROM, BYTES) && state() == WIRE_OK, "%u bytes", b.in.want[0].has);
    test("as many requests as there are places, and one more that is refused, keep to their own");
    open_at(7);
    for (unsigned i = 0; i < WIRE_BLOCKS; i++) {
        ask(i / 2, 50 * i, 60 * i, 30 + i);
    }
    CHECK(wire_source_start(&b.in, 9, 0, b.memory, BYTES) == -1, "one too many");
    for (int round = 0; round < 3; round++) {
        for (unsigned tag = 0; tag < 12; tag++) {
            reply(tag, 0, 1000);
        }
    }
    for (unsigned i = 0; i < WIRE_BLOCKS; i++) {
        CHECK(holds(60 * i, 50 * i, 30 + i, 60 * i + 60), "request %u", i);
    }
    CHECK(b.memory[GUARD - 1] == UNTOUCHED && b.memory[0] == UNTOUCHED, "before the memory");
    CHECK(wire_source_wait(&b.in, 15) == 0, "not all are there");
}

/* ---- time ------------------------------------------------------------------------------------ */

enum { DRIP_MS = 4000 };

/* A host that sends the next byte only. */
static int drips(void *context) {
    (void)context;
    b.peer.now_ms += DRIP_MS;
    reply(TAG, FROM + b.in.want[0].has, 1);
    return 0;
}

static void check_times(uint32_t now) {
    open_at(now);
    ask(TAG, FROM, 0, BYTES);
    b.peer.now_ms = now + WIRE_BLOCK_DEAD_MS - 1;
    CHECK(state() == WIRE_BUSY, "given up early");
    reply(TAG, FROM, 1);
    b.peer.now_ms += WIRE_BLOCK_DEAD_MS - 1;
    CHECK(state() == WIRE_BUSY, "given up early after a byte");
    b.peer.now_ms++;
    CHECK(state() == WIRE_ERR_DOWN, "not given up");
    open_at(now);
    ask(TAG, FROM, 0, BYTES);
    for (uint32_t i = 0; i * DRIP_MS < WIRE_BLOCK_MOST_MS; i++) {
        b.peer.now_ms = now + i * DRIP_MS;
        reply(TAG, FROM + i, 1);
    }
    b.peer.now_ms = now + WIRE_BLOCK_MOST_MS - 1;
    CHECK(state() == WIRE_BUSY, "a drip: given up early");
    b.peer.now_ms++;
    CHECK(state() == WIRE_ERR_DOWN, "a drip: not given up");
}

static void test_time(void) {
    test("a request ends when no byte came for five seconds, and after thirty in any case");
    check_times(7);
    check_times(UINT32_MAX - 3000);
    test("replies that bring nothing new do not keep a request");
    open_at(7);
    ask(TAG, FROM, 0, BYTES);
    reply(TAG, FROM, 10);
    while (b.peer.now_ms < 7 + WIRE_BLOCK_DEAD_MS) {
        CHECK(state() == WIRE_BUSY, "given up early");
        b.peer.now_ms++;
        reply(TAG, FROM, 10);
        reply(TAG, FROM + 10, 0);
        reply(TAG, FROM + 11, BYTES);
        reply(TAG + 1, FROM + 10, BYTES);
    }
    CHECK(state() == WIRE_ERR_DOWN, "kept");
    test("a host that sends one byte every four seconds does not hold the engine for longer");
    for (uint32_t count = 1; count <= BYTES; count++) {
        const uint32_t most = WIRE_BLOCK_MOST_MS / DRIP_MS + 1; /* the last one is just late */
        open_at(7);
        b.in.pump = drips;
        ask(TAG, FROM, 0, count);
        const int status = wire_source_wait(&b.in, 1u << TAG);
        CHECK(status == (count <= most ? 0 : -1), "%u bytes: %d", count, status);
        CHECK(b.peer.now_ms - 7 <= WIRE_BLOCK_MOST_MS + DRIP_MS, "%u ms", b.peer.now_ms);
        CHECK(holds(0, FROM, count < most ? count : most, ROOM), "%u bytes", count);
    }
    test("a byte of any request keeps the others, too");
    open_at(7);
    ask(TAG, FROM, 0, BYTES);
    ask(TAG + 1, 0, BYTES, BYTES);
    for (uint32_t i = 1; i * DRIP_MS < WIRE_BLOCK_MOST_MS; i++) {
        b.peer.now_ms = 7 + i * DRIP_MS;
        CHECK(state() == WIRE_BUSY, "given up after %u ms", i * DRIP_MS);
        reply(TAG + 1, i - 1, 1);
    }
}

/* ---- after the wait ------------------------------------------------------------------------ */

static void check_forgotten(const char *how) {
    const uint8_t refusal[5] = {TAG, FROM};
    for (uint32_t at = 0; at < 2 * FROM; at++) {
        reply(TAG, at, 200);
    }
    wire_blocks_in_receive(&b.in, refusal);
    wire_blocks_in_begin(&b.in);
    CHECK(holds(0, FROM, 0, ROOM), "%s: written after the wait", how);
    CHECK(b.in.want[0].state == 0, "%s: not forgotten", how);
    CHECK(wire_blocks_in_write(&b.in, b.memory) == 0, "%s: still asked for", how);
}

static int lets_time_pass(void *context) {
    (void)context;
    b.peer.now_ms += 10;
    wire_blocks_in_poll(&b.in);
    return 0;
}

static void test_after(void) {
    test("nothing is written once a wait has ended: given up, without replies, or refused");
    const uint8_t refusal[5] = {TAG, FROM};
    open_at(7);
    ask(TAG, FROM, 0, BYTES);
    CHECK(wire_source_wait(&b.in, 1u << TAG) == -1, "waited");
    check_forgotten("given up");
    open_at(7);
    b.in.pump = lets_time_pass;
    ask(TAG, FROM, 0, BYTES);
    CHECK(wire_source_wait(&b.in, 1u << TAG) == -1, "waited");
    CHECK(b.peer.now_ms == 7 + WIRE_BLOCK_DEAD_MS, "%u ms", b.peer.now_ms);
    check_forgotten("late");
    open_at(7);
    ask(TAG, FROM, 0, BYTES);
    wire_blocks_in_receive(&b.in, refusal);
    CHECK(wire_source_wait(&b.in, 1u << TAG) == -1, "waited");
    check_forgotten("refused");
    test("a wait that fails forgets all requests of its tags, and no other");
    open_at(7);
    ask(TAG, FROM, 0, BYTES);
    ask(TAG, FROM + BYTES, BYTES, BYTES);
    ask(TAG + 1, 0, 2 * BYTES, BYTES);
    CHECK(wire_source_wait(&b.in, 1u << TAG) == -1, "waited");
    reply(TAG, FROM, 2 * BYTES);
    reply(TAG + 1, 0, BYTES);
    CHECK(holds(0, FROM, 0, 2 * BYTES), "written after the wait");
    CHECK(holds(2 * BYTES, 0, BYTES, ROOM), "the other one");
    CHECK(wire_source_wait(&b.in, 2u << TAG) == 0, "the other one");
}

/* ---- the image of another host ----------------------------------------------------------- */

static struct {
    wire_peer peer;
    wire_blocks_out out;
    uint8_t image[IMAGE];
} host;

/* What a host whose image has its first byte changed by `flip` does with a request. */
static int is_answered(const uint8_t *body, uint32_t bytes, uint8_t flip) {
    memset(&host, 0, sizeof host);
    memcpy(host.image, b.image, IMAGE);
    host.image[0] ^= flip;
    host.peer.own.out_bytes = 64;
    wire_blocks_out_open(&host.out, &host.peer, host.image, IMAGE);
    wire_blocks_out_receive(&host.out, body, bytes);
    wire_blocks_out_fill(&host.out);
    return wire_queue_bytes(host.peer.queue) > 0 || host.peer.pending != 0;
}

static void test_images(void) {
    uint8_t body[WIRE_CONTROL_BYTES];
    test("a request that names its image is answered by a host that has it, and by no other");
    open_at(7);
    is_answered(body, 0, 0);
    const uint32_t crc = host.out.crc;
    wire_blocks_in_image(&b.in, crc);
    ask(TAG, FROM, 0, BYTES);
    uint32_t bytes = wire_blocks_in_write(&b.in, body);
    CHECK(bytes == 13 && wire_get32(body + 9) == crc, "%u bytes", bytes);
    CHECK(is_answered(body, bytes, 0), "its own host");
    CHECK(!is_answered(body, bytes, 1) && host.out.crc != crc, "another one");
    test("repeated, it names the image, too, and asks only for the bytes that are lacking");
    reply(TAG, FROM, 15);
    b.peer.now_ms += WIRE_BLOCK_AGAIN_MS - 1;
    wire_blocks_in_poll(&b.in);
    CHECK(wire_blocks_in_write(&b.in, body) == 0, "early");
    b.peer.now_ms++;
    wire_blocks_in_poll(&b.in);
    bytes = wire_blocks_in_write(&b.in, body);
    CHECK(bytes == 13 && wire_get32(body + 9) == crc, "%u bytes", bytes);
    CHECK(body[0] == TAG && wire_get32(body + 1) == FROM + 15 && wire_get32(body + 5) == BYTES - 15,
          "tag %u, %u bytes from %u", body[0], wire_get32(body + 5), wire_get32(body + 1));
}

/* Requests whose replies come `late_ms` after they were asked for, once for each time that they
 * were; how often that was. */
static uint32_t times_asked(uint32_t requests, uint32_t late_ms) {
    uint8_t body[WIRE_CONTROL_BYTES];
    uint32_t asked = 0;
    for (uint32_t i = 0; i < requests; i++) {
        uint32_t times = 0;
        ask(TAG, FROM, 0, BYTES);
        for (uint32_t ms = 0; ms < late_ms; ms++) {
            wire_blocks_in_poll(&b.in);
            times += wire_blocks_in_write(&b.in, body) > 0;
            b.peer.now_ms++;
        }
        for (uint32_t reply_of = 0; reply_of < times; reply_of++) {
            reply(TAG, FROM, BYTES);
        }
        CHECK(state() == WIRE_OK, "request %u", i);
        asked += times;
    }
    return asked;
}

static void test_pace(void) {
    test("where bytes come twice, requests are repeated later, up to a second; and then sooner");
    open_at(7);
    CHECK(times_asked(50, WIRE_BLOCK_AGAIN_MS) == 50, "asked twice in time");
    uint32_t asked = times_asked(50, 750);
    CHECK(asked > 50 + 5 && asked < 50 + 60, "%u for 50", asked);
    asked = times_asked(50, 750);
    CHECK(asked < 50 + 5, "%u for 50 more", asked);
    times_asked(20, 4000);
    CHECK(b.in.more_ms <= WIRE_BLOCK_SLOW_MS - WIRE_BLOCK_AGAIN_MS, "%u ms", b.in.more_ms);
    times_asked(1000, 20);
    CHECK(b.in.more_ms == 0, "%u ms more still", b.in.more_ms);
    test("bytes that come out of order teach nothing");
    open_at(7);
    ask(TAG, FROM, 0, BYTES);
    for (uint32_t i = 0; i < 100; i++) {
        reply(TAG, FROM + 20, 5);
    }
    CHECK(b.in.more_ms == 0, "%u ms", b.in.more_ms);
}

int main(void) {
    test_places();
    test_tags();
    test_too_many();
    test_time();
    test_pace();
    test_after();
    test_images();
    return test_done();
}

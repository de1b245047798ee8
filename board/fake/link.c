/* link - a source that counts, delays and fails on order
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "board/fake/fake.h"

/* plt_image_info has no arena: it reads the header to the stack. */
enum { GARBAGE = 0xA5, HEADER_BYTES = 256 };

const char *const fake_failure_name[FAKE_FAILURES] = {
    [FAKE_WORKS] = "works",
    [FAKE_FAILS_AT_START] = "fails at a start",
    [FAKE_FAILS_AT_WAIT] = "fails at a wait",
    [FAKE_FAILS_AT_CALL] = "fails at a call",
    [FAKE_FAILS_FROM_CALL] = "fails from a call on",
    [FAKE_SHORT_AT_START] = "comes up short",
    [FAKE_GARBLED_AT_START] = "has a bit wrong",
    [FAKE_GARBLED_FROM_START] = "has a bit wrong in each from a transfer on",
    [FAKE_SILENT_AT_START] = "delivers nothing",
    [FAKE_STALE_AT_START] = "leaves what was there",
    [FAKE_STALLS_AT_START] = "is busy for two starts",
    [FAKE_NEVER_ENDS] = "never ends under a tag",
    [FAKE_LAST_FIRST] = "ends in the other order",
    [FAKE_LOSES_BYTE] = "loses a byte",
    [FAKE_REPEATS_BYTE] = "repeats a byte",
};

static int break_contract(fake_link *link, const char *sentence) {
    link->broken++;
    link->sentence = sentence;
    return -1;
}

static int in_arena(const fake_link *link, const unsigned char *to, uint32_t count) {
    const uintptr_t begin = (uintptr_t)link->arena, at = (uintptr_t)to;
    return !link->arena || (at >= begin && at - begin <= link->arena_bytes &&
                            count <= link->arena_bytes - (at - begin));
}

static int check_start(fake_link *link, unsigned tag, uint32_t offset, const unsigned char *to,
                       uint32_t count) {
    if (tag > 31) {
        return break_contract(link, "a tag above 31");
    }
    if (offset > link->bytes || count > link->bytes - offset) {
        return break_contract(link, "a transfer beyond the end of the image");
    }
    if (count == 0) {
        return break_contract(link, "a transfer of no bytes");
    }
    const int header = offset + count <= HEADER_BYTES;
    if (!header && !in_arena(link, to, count)) {
        return break_contract(link, "a transfer to outside the arena");
    }
    return 0;
}

/* Whether this start (or wait) is the one ordered to fail. */
static int fails(const fake_link *link, enum fake_failure kind, uint32_t number) {
    const uint32_t call = link->starts + link->waits;
    return (link->failure == kind && number == link->at_call) ||
           (link->failure == FAKE_STALLS_AT_START && kind == FAKE_FAILS_AT_START &&
            (number == link->at_call || number == link->at_call + 1)) ||
           (link->failure == FAKE_FAILS_AT_CALL && call == link->at_call) ||
           (link->failure == FAKE_FAILS_FROM_CALL && call >= link->at_call);
}

static int is_ordered(const fake_link *link, const fake_transfer *t, enum fake_failure kind) {
    return link->failure == kind && t->number == link->at_call;
}

/* One bit is wrong, which and where differs from transfer to transfer. */
static int is_garbled(const fake_link *link, const fake_transfer *t) {
    return is_ordered(link, t, FAKE_GARBLED_AT_START) ||
           (link->failure == FAKE_GARBLED_FROM_START && t->number >= link->at_call);
}

/* Somewhere within: a byte is left out, or comes twice. What is missing at the end stays garbage.
 */
static void deliver_slipped(const fake_link *link, const fake_transfer *t, int is_repeated) {
    const unsigned char *from = link->image + t->offset;
    const uint32_t at = (t->number * 0x9E3779B1u >> 8) % t->count, rest = t->count - at - 1;
    memcpy(t->to, from, at + (uint32_t)is_repeated);
    memcpy(t->to + at + is_repeated, from + at + !is_repeated, rest);
}

static int deliver(fake_link *link, const fake_transfer *t) {
    uint32_t count = t->count;
    if (is_ordered(link, t, FAKE_SILENT_AT_START) || is_ordered(link, t, FAKE_STALE_AT_START)) {
        return 0;
    }
    if (is_ordered(link, t, FAKE_LOSES_BYTE) || is_ordered(link, t, FAKE_REPEATS_BYTE)) {
        deliver_slipped(link, t, link->failure == FAKE_REPEATS_BYTE);
        link->bytes_moved += count;
        return 0;
    }
    if (link->failure == FAKE_LAST_FIRST) {
        for (uint32_t i = count; i-- > 0;) {
            t->to[i] = link->image[t->offset + i];
        }
        link->bytes_moved += count;
        return 0;
    }
    if (is_ordered(link, t, FAKE_SHORT_AT_START)) {
        count /= 2;
    }
    memcpy(t->to, link->image + t->offset, count);
    link->bytes_moved += count;
    if (is_garbled(link, t)) {
        const uint32_t mixed = t->number * 0x9E3779B1u;
        t->to[(mixed >> 8) % count] ^= (unsigned char)(1u << (mixed >> 3) % 8);
    }
    return is_ordered(link, t, FAKE_SHORT_AT_START) ? -1 : 0;
}

static fake_transfer *free_transfer(fake_link *link) {
    for (int i = 0; i < FAKE_TRANSFERS; i++) {
        if (link->pending[i].tag_bit == 0) {
            return &link->pending[i];
        }
    }
    return NULL;
}

static int start(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    fake_link *link = context;
    link->starts++;
    if (check_start(link, tag, offset, to, count) < 0) {
        return -1;
    }
    if (fails(link, FAKE_FAILS_AT_START, link->starts)) {
        link->failed++;
        return -1;
    }
    fake_transfer *t = free_transfer(link);
    if (!t) {
        return break_contract(link, "more transfers at a time than the fake holds");
    }
    *t = (fake_transfer){UINT32_C(1) << tag, offset, count, link->starts, to};
    const uint32_t pending = fake_unfinished(link);
    link->pending_most = pending > link->pending_most ? pending : link->pending_most;
    if (!is_ordered(link, t, FAKE_STALE_AT_START)) {
        memset(to, GARBAGE, count);
    }
    if (is_ordered(link, t, FAKE_NEVER_ENDS)) {
        link->dead_tags |= t->tag_bit;
    }
    if (link->at_once && !is_ordered(link, t, FAKE_SHORT_AT_START) &&
        !(link->dead_tags & t->tag_bit)) {
        deliver(link, t);
    }
    return 0;
}

/* Which of those that wait is next: in the order in which they lie, or from the end. */
static fake_transfer *transfer_of(fake_link *link, int index) {
    return &link->pending[link->failure == FAKE_LAST_FIRST ? FAKE_TRANSFERS - 1 - index : index];
}

static int wait(void *context, uint32_t tags) {
    fake_link *link = context;
    int status = 0;
    link->waits++;
    if (fails(link, FAKE_FAILS_AT_WAIT, link->waits)) {
        status = -1;
    }
    if (link->dead_tags & tags) {
        status = -1;
    }
    for (int i = 0; i < FAKE_TRANSFERS; i++) {
        fake_transfer *t = transfer_of(link, i);
        if (!(t->tag_bit & tags)) {
            continue;
        }
        if (status == 0 && (!link->at_once || is_ordered(link, t, FAKE_SHORT_AT_START))) {
            status = deliver(link, t);
        }
        t->tag_bit = 0;
    }
    link->failed += status < 0;
    return status;
}

plt_source fake_source(fake_link *link) {
    const plt_source source = {.bytes = link->bytes, .context = link, .start = start, .wait = wait};
    return source;
}

unsigned fake_unfinished(const fake_link *link) {
    unsigned count = 0;
    for (int i = 0; i < FAKE_TRANSFERS; i++) {
        count += link->pending[i].tag_bit != 0;
    }
    return count;
}

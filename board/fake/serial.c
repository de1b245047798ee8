/* serial - the line of board/wired/serial.h, of bytes that a test sends and records
 *
 * SPDX-License-Identifier: MIT */
#include "board/wired/serial.h"

#include "board/fake/fake.h"

fake_serial fake_line;

const char *const fake_line_failure_name[FAKE_LINE_FAILURES] = {
    [FAKE_LINE_WORKS] = "works",
    [FAKE_LINE_LOSES] = "loses a byte",
    [FAKE_LINE_DROPS] = "drops a byte",
    [FAKE_LINE_REPEATS] = "repeats a byte",
    [FAKE_LINE_GARBLES] = "has a bit wrong",
    [FAKE_LINE_STALLS] = "stalls",
    [FAKE_LINE_FILLS] = "is full",
    [FAKE_LINE_DIES] = "dies",
};

static int break_contract(const char *sentence) {
    fake_line.broken++;
    fake_line.sentence = sentence;
    return 0;
}

/* The byte that comes now, or that goes out now, is the one ordered to fail so. */
static int is_ordered(enum fake_line_failure failure, uint32_t done) {
    return fake_line.failure == failure && done + 1 == fake_line.at;
}

static int stalls(enum fake_line_failure failure, uint32_t done) {
    if (!is_ordered(failure, done) || fake_line.stalled == FAKE_STALL_CALLS) {
        return 0;
    }
    fake_line.stalled++;
    return 1;
}

uint32_t board_serial_open(void) {
    fake_line.is_open = 1;
    return fake_line.room_bytes;
}

int board_serial_get(void) {
    if (!fake_line.is_open) {
        break_contract("a byte is asked for before the line is open");
        return -1;
    }
    if (is_ordered(FAKE_LINE_LOSES, fake_line.taken) ||
        is_ordered(FAKE_LINE_DROPS, fake_line.taken)) {
        if (fake_line.taken < fake_line.in_bytes) {
            fake_line.taken++;
            fake_line.lost += fake_line.failure == FAKE_LINE_LOSES;
        }
    }
    if (fake_line.taken == fake_line.in_bytes || is_ordered(FAKE_LINE_DIES, fake_line.taken) ||
        stalls(FAKE_LINE_STALLS, fake_line.taken)) {
        return -1;
    }
    const uint8_t byte = fake_line.in[fake_line.taken];
    if (is_ordered(FAKE_LINE_REPEATS, fake_line.taken) && !fake_line.is_repeated) {
        fake_line.is_repeated = 1;
        return byte;
    }
    const int is_garbled = is_ordered(FAKE_LINE_GARBLES, fake_line.taken);
    fake_line.taken++;
    return is_garbled ? byte ^ (1 << fake_line.at % 8) : byte;
}

int board_serial_put(uint8_t byte) {
    if (!fake_line.is_open) {
        return break_contract("a byte is sent before the line is open");
    }
    if (fake_line.out_bytes == FAKE_LINE_BYTES) {
        return break_contract("more bytes than the fake records");
    }
    if (stalls(FAKE_LINE_FILLS, fake_line.out_bytes)) {
        return 0;
    }
    fake_line.out[fake_line.out_bytes++] = byte;
    return 1;
}

uint32_t board_serial_lost(void) {
    return fake_line.lost;
}

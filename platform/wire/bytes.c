/* bytes - see wire_bytes.h
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/wire_bytes.h"

size_t wire_bytes_put(uint8_t *to, const uint8_t *report, size_t count) {
    size_t code_at = 0, used = 1;
    uint8_t code = 1;
    for (size_t i = 0; i < count; i++) {
        if (report[i] != 0) {
            to[used++] = report[i];
            code++;
        }
        if (report[i] == 0 || code == 255) {
            to[code_at] = code;
            code_at = used++;
            code = 1;
        }
    }
    to[code_at] = code;
    to[used++] = 0;
    return used;
}

static void add(wire_bytes_reader *r, uint8_t byte) {
    if (r->used < WIRE_REPORT_BYTES_MAX) {
        r->report[r->used++] = byte;
    } else {
        r->is_bad = 1;
    }
}

/* The report is complete: the zero that its last run stands for is not part of it. */
static size_t end_report(wire_bytes_reader *r) {
    const size_t count = r->is_bad || r->left > 0 || !r->is_begun ? 0 : r->used;
    r->used = 0;
    r->left = r->is_full_run = r->is_bad = r->is_begun = 0;
    return count;
}

size_t wire_bytes_read(wire_bytes_reader *r, uint8_t byte) {
    if (byte == 0) {
        return end_report(r);
    }
    if (r->left > 0) {
        r->left--;
        add(r, byte);
        return 0;
    }
    if (r->is_begun && !r->is_full_run) {
        add(r, 0);
    }
    r->is_begun = 1;
    r->left = (uint8_t)(byte - 1);
    r->is_full_run = byte == 255;
    return 0;
}

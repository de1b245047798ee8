/* report - how a report is laid out, and the checksum that says whose it is
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_REPORT_H
#define PLT_WIRE_REPORT_H

#include <stddef.h>
#include <stdint.h>

/* The key of hello reports; their number is just its low byte. */
enum { WIRE_HELLO_KEY = 0x31544C50 };

/* Bytes of a report before its payload. */
static inline uint32_t wire_header_bytes(uint32_t report_bytes) {
    return report_bytes > 128 ? 7 : 6;
}

/* The `first` of a report in whose payload no message begins. */
static inline uint32_t wire_first_none(uint32_t report_bytes) {
    return report_bytes > 128 ? 32767 : 127;
}

/* A bijection of 32 bits in which every bit depends on every other. */
uint32_t wire_scramble(uint32_t number);

uint32_t wire_session_key(uint32_t host_half, uint32_t device_half);

/* Finishes a report of `bytes` bytes whose payload is in place: header and
 * checksum. `from`: enum wire_role of the sender. */
void wire_report_seal(uint8_t *report, uint32_t bytes, unsigned from, uint32_t key, uint32_t number,
                      uint32_t first, int is_control);

/* key ^ scramble(number) of an undamaged report that `from` sent. */
uint32_t wire_report_tag(const uint8_t *report, size_t bytes, unsigned from);

typedef struct wire_report_view {
    const uint8_t *payload;
    uint32_t count; /* bytes of it */
    uint32_t first; /* offset of the first message that begins in it, or more than `count` */
    int is_control;
} wire_report_view;

wire_report_view wire_report_read(const uint8_t *report, uint32_t bytes);

#endif

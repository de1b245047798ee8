/* report - see report.h; platform/WIRE.md, section 2
 *
 * Source of the bijection: C. Wellons, "Hash prospector", 2018.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/report.h"

#include "engine/planelet_crc32.h"
#include "platform/wire/base.h"

uint32_t wire_scramble(uint32_t x) {
    x ^= x >> 16;
    x *= UINT32_C(0x7FEB352D);
    x ^= x >> 15;
    x *= UINT32_C(0x846CA68B);
    return x ^ x >> 16;
}

uint32_t wire_session_key(uint32_t host_half, uint32_t device_half) {
    return wire_scramble(wire_scramble(host_half) + device_half);
}

/* Over all that is behind it; a device's is inverted, so that an echo is wrong. */
static uint32_t checksum(const uint8_t *report, size_t bytes, unsigned from) {
    return plt_crc32(0, report + 4, bytes - 4) ^ (from == WIRE_HOST ? 0 : UINT32_MAX);
}

void wire_report_seal(uint8_t *report, uint32_t bytes, unsigned from, uint32_t key, uint32_t number,
                      uint32_t first, int is_control) {
    const uint32_t none = wire_first_none(bytes), control = is_control ? none + 1 : 0;
    report[4] = (uint8_t)number;
    report[5] = (uint8_t)(first | control);
    if (bytes > 128) {
        report[6] = (uint8_t)((first | control) >> 8);
    }
    wire_put32(report, checksum(report, bytes, from) ^ key ^ wire_scramble(number));
}

uint32_t wire_report_tag(const uint8_t *report, size_t bytes, unsigned from) {
    return checksum(report, bytes, from) ^ wire_get32(report);
}

wire_report_view wire_report_read(const uint8_t *report, uint32_t bytes) {
    const uint32_t none = wire_first_none(bytes), head = wire_header_bytes(bytes);
    const uint32_t word = bytes > 128 ? wire_get16(report + 5) : report[5];
    return (wire_report_view){report + head, bytes - head, word & none, word > none};
}

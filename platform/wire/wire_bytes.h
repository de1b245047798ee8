/* wire_bytes - reports over a stream of bytes: UART, pseudo terminal, socket
 *
 * A report is stuffed so that it holds no zero (COBS), and ends in one; so a
 * reader that comes late or misses bytes is in step again at the next zero.
 * Whether a report is undamaged is for its own checksum to say.
 *
 * Source: S. Cheshire, M. Baker, "Consistent overhead byte stuffing", 1999.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_BYTES_H
#define PLT_WIRE_BYTES_H

#include <stddef.h>
#include <stdint.h>

#include "platform/wire/wire_peer.h"

#ifdef __cplusplus
extern "C" {
#endif

/* A report of 1024 bytes, a code byte every 254, the zero. */
enum { WIRE_BYTES_MOST = WIRE_REPORT_BYTES_MAX + 5 + 1 };

/* Stuffs `report` into `to` (count + count / 254 + 2 bytes of room); returns
 * the bytes. */
size_t wire_bytes_put(uint8_t *to, const uint8_t *report, size_t count);

typedef struct wire_bytes_reader {
    uint16_t used; /* bytes of the report so far */
    uint8_t left;  /* of the run of bytes that are not zero; 0: a code comes */
    uint8_t is_full_run, is_bad, is_begun;
    uint8_t report[WIRE_REPORT_BYTES_MAX];
} wire_bytes_reader;

/* Reads a byte of the stream (begin with a zeroed reader). Returns the bytes of
 * a report that is complete in reader->report, else 0. */
size_t wire_bytes_read(wire_bytes_reader *reader, uint8_t byte);

#ifdef __cplusplus
}
#endif
#endif

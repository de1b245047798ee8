/* link - where reports go to and come from on a host
 *
 * A transport is two functions, so that the code above it does not know
 * whether reports travel as bytes (here) or as HID reports: an adapter for
 * hidapi fills `send` and `receive` with hid_write and hid_read_timeout.
 *
 * SPDX-License-Identifier: MIT */
#ifndef LINK_H
#define LINK_H
#include <stddef.h>
#include <stdint.h>

#include "host_tools/base/fail.h"
#include "platform/wire/wire_bytes.h"

typedef struct transport {
    void *context;
    /* Sends a report: 1 taken, 0 busy (try again later), -1 the link is down. */
    int (*send)(void *context, const uint8_t *report, size_t count);
    /* Waits at most `ms` for a report, into WIRE_REPORT_BYTES_MAX bytes: its
     * size, 0 none yet, -1 the link is down. */
    int (*receive)(void *context, uint8_t *report, int ms);
} transport;

/* A stream of bytes with one other end: whoever opens the pseudo terminal, or
 * connects to the socket; the next one after it has gone. */
typedef struct stream_link {
    int listener, peer; /* -1: none */
    int is_pty;
    char name[108]; /* what the other end opens */
    char made[108]; /* a socket's path, to be removed */
    wire_bytes_reader reader;
    uint8_t out[2 * WIRE_BYTES_MOST], in[512];
    size_t out_used, in_used, in_gone;
} stream_link;

int link_open_pty(stream_link *l, fail *f);
int link_open_socket(stream_link *l, const char *path, fail *f);
int link_open_port(stream_link *l, unsigned port, fail *f); /* on 127.0.0.1 */
/* An open socket or pipe end, owned by the link from then on. */
void link_of_file(stream_link *l, int file);
void link_close(stream_link *l);

transport link_transport(stream_link *l);

/* Whether somebody is at the other end. A pty cannot tell and says yes. */
int link_is_connected(const stream_link *l);

#endif

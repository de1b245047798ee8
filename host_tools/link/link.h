/* link - where reports go to and come from on a host
 *
 * A transport is two functions; the code above it does not know what carries
 * the reports. Here they travel as bytes of a stream, separated by COBS.
 *
 * SPDX-License-Identifier: MIT */
#ifndef LINK_H
#define LINK_H
#include <stddef.h>
#include <stdint.h>

#include "host_tools/base/fail.h"
#include "host_tools/base/temporary.h"
#include "platform/wire/wire_bytes.h"

typedef struct transport {
    void *context;
    /* Sends a report: 1 sent, 0 busy (try again later), -1 the link is down. */
    int (*send)(void *context, const uint8_t *report, size_t count);
    /* Waits at most `ms` for a report, into WIRE_REPORT_BYTES_MAX bytes: its
     * size, 0 none yet, -1 the link is down. */
    int (*receive)(void *context, uint8_t *report, int ms);
} transport;

/* A stream of bytes to one peer: whoever opens the pseudo terminal or connects to the
 * socket, and after it has gone the next one. At one address from opening to closing. */
typedef struct stream_link {
    int listener, peer; /* -1: none */
    int is_pty;
    char name[108]; /* what the peer opens */
    temporary made; /* a socket's path */
    wire_bytes_reader reader;
    uint8_t out[2 * WIRE_BYTES_MOST], in[512];
    size_t out_used, in_used, in_read;
} stream_link;

int link_open_pty(stream_link *l, fail *f);
int link_open_socket(stream_link *l, const char *path, fail *f);
int link_open_port(stream_link *l, unsigned port, fail *f); /* on 127.0.0.1 */
/* An open socket or pipe, owned by the link from then on. */
void link_of_file(stream_link *l, int file);
void link_close(stream_link *l);

transport link_transport(stream_link *l);

#endif

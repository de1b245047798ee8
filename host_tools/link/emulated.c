/* emulated - see emulated.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/link/emulated.h"

#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/types.h>
#include <unistd.h>

#include "host_tools/base/clock.h"
#include "platform/wire/wire_device.h"

enum { VISITS = 20000, STEPS = 8 }; /* node visits per step; steps between reports */

/* Sends all reports that are due; -1: the link is down. With a busy link the report stays
 * in `held`. */
static int send_reports(wire_device *d, const transport *t, uint8_t *report, size_t *held) {
    for (;;) {
        if (*held == 0) {
            *held = wire_next_report(&d->peer, report, clock_ms());
        }
        const int sent = *held > 0 ? t->send(t->context, report, *held) : 0;
        if (sent <= 0) {
            return sent;
        }
        *held = 0;
    }
}

int emulated_device(const transport *t, unsigned report_bytes, size_t memory_bytes) {
    static const plt_options options = {.packet_side =
                                            PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8};
    const wire_setup setup = {.role = WIRE_DEVICE,
                              .caps = {.session = clock_ms(),
                                       .in_bytes = (uint16_t)report_bytes,
                                       .out_bytes = (uint16_t)report_bytes,
                                       .credits = 16}};
    uint8_t in[WIRE_REPORT_BYTES_MAX], out[WIRE_REPORT_BYTES_MAX];
    size_t held = 0;
    wire_device *d = malloc(sizeof *d);
    void *memory = aligned_alloc(PLT_ALIGN, (memory_bytes + PLT_ALIGN - 1) / PLT_ALIGN * PLT_ALIGN);
    int n =
        d == NULL || memory == NULL ||
                wire_device_open(d, &setup, &options, memory, memory_bytes, clock_ms()) != WIRE_OK
            ? -1
            : 0;
    const int status = n;
    while (n >= 0) {
        int works = 0;
        for (int i = 0; i < STEPS; i++) {
            works |= wire_device_run(d, VISITS);
        }
        while ((n = t->receive(t->context, in, works ? 0 : 2)) > 0) {
            wire_on_report(&d->peer, in, (size_t)n, clock_ms());
        }
        wire_poll(&d->peer, clock_ms());
        if (n == 0) {
            n = send_reports(d, t, out, &held);
        }
    }
    free(d);
    free(memory);
    return status;
}

int emulated_start(stream_link *l, unsigned report_bytes, size_t memory_bytes, fail *f) {
    int pair[2];
    void *volatile trial = malloc(memory_bytes); /* the device cannot say that it got none */
    free(trial);
    if (trial == NULL) {
        return fail_set(f, "device", "no room for its %zu bytes; give it fewer with --emulate",
                        memory_bytes);
    }
    if (socketpair(AF_UNIX, SOCK_STREAM, 0, pair) != 0) {
        return fail_set(f, "device", "no connection to it: %s; %s", strerror(errno),
                        errno == EMFILE || errno == ENFILE
                            ? "too many files are open: raise the limit with ulimit -n"
                            : "close other programs");
    }
    const pid_t child = fork();
    if (child < 0) {
        close(pair[0]);
        close(pair[1]);
        return fail_set(
            f, "device",
            "no process for it: %s; close other programs or raise the limit with ulimit -u",
            strerror(errno));
    }
    if (child == 0) {
        stream_link own;
        close(pair[0]);
        link_of_file(&own, pair[1]);
        const transport t = link_transport(&own);
        _exit(emulated_device(&t, report_bytes, memory_bytes) == 0 ? 0 : 1);
    }
    close(pair[1]);
    link_of_file(l, pair[0]);
    return 0;
}

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

typedef struct emulated {
    wire_device device;
    const transport *t;
    uint8_t report[WIRE_REPORT_BYTES_MAX]; /* that goes out next, if `held` bytes are in it */
    size_t held;
    void *memory;
} emulated;

/* Sends all reports that are due; -1: the link is down. */
static int send_reports(emulated *e) {
    const transport *t = e->t;
    for (;;) {
        if (e->held == 0) {
            e->held = wire_next_report(&e->device.peer, e->report, clock_ms());
        }
        const int sent = e->held > 0 ? t->send(t->context, e->report, e->held) : 0;
        if (sent <= 0) {
            return sent;
        }
        e->held = 0;
    }
}

/* Waits at most `ms` for reports, and lets those leave that can; -1: the link is down. */
static int exchange(emulated *e, int ms) {
    uint8_t in[WIRE_REPORT_BYTES_MAX];
    int n;
    while ((n = e->t->receive(e->t->context, in, ms)) > 0) {
        wire_on_report(&e->device.peer, in, (size_t)n, clock_ms());
        ms = 0;
    }
    wire_poll(&e->device.peer, clock_ms());
    return n < 0 ? n : send_reports(e);
}

#if PLT_WITH_STREAMED
/* What is asked for leaves before the answer is waited for. */
static int pump(void *context) {
    return send_reports(context) < 0 ? -1 : exchange(context, 1);
}
#endif

static int open_device(emulated *e, unsigned report_bytes, size_t memory_bytes) {
    static const plt_options options = {.packet_side =
                                            PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8};
    const wire_setup setup = {.role = WIRE_DEVICE,
                              .caps = {.session = clock_ms(),
                                       .in_bytes = (uint16_t)report_bytes,
                                       .out_bytes = (uint16_t)report_bytes,
                                       .credits = 16}};
    e->memory = aligned_alloc(PLT_ALIGN, (memory_bytes + PLT_ALIGN - 1) / PLT_ALIGN * PLT_ALIGN);
    if (e->memory == NULL || wire_device_open(&e->device, &setup, &options, e->memory, memory_bytes,
                                              clock_ms()) != WIRE_OK) {
        return -1;
    }
#if PLT_WITH_STREAMED
    wire_device_stream(&e->device, pump, e);
#endif
    return 0;
}

int emulated_device(const transport *t, unsigned report_bytes, size_t memory_bytes) {
    emulated *e = calloc(1, sizeof *e);
    int status = -1;
    if (e != NULL) {
        e->t = t;
        status = open_device(e, report_bytes, memory_bytes);
    }
    for (int n = status; n >= 0;) {
        int works = 0;
        for (int i = 0; i < STEPS; i++) {
            works |= wire_device_run(&e->device, VISITS);
        }
        n = exchange(e, works ? 0 : 2);
    }
    free(e != NULL ? e->memory : NULL);
    free(e);
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

/* device_usbip - a whole USB device in user space, plugged into vhci_hcd
 *
 * The kernel's USB/IP client is handed one end of a socket pair, so that
 * neither a network nor the usbip tool is needed; the other end answers
 * control requests and moves reports. Paced, an OUT transfer ends only after
 * the milliseconds that a full-speed bus would take, a packet of 64 bytes
 * each: the rate of the host is then that of the real bus.
 *
 * Sources: Linux, Documentation/usb/usbip_protocol.rst; USB 2.0, chapter 9;
 * HID 1.11, chapters 6 and 7. SPDX-License-Identifier: MIT */
#define _GNU_SOURCE /* ppoll: waits of less than a millisecond */
#include "host_tools/base/clock.h"
#include "tests/hid/usbip.h"

#include <arpa/inet.h>
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdio.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

enum { TICK_US = 2000, SUBMIT = 1, UNLINK = 2, RET_SUBMIT = 3, RET_UNLINK = 4 };

static int64_t now_us(void) {
    return (int64_t)(1e6 * clock_seconds());
}

static void move_all(usbip *u, void *bytes, size_t count, int out) {
    char *at = bytes;
    while (count > 0 && !u->closed) {
        const ssize_t n =
            out ? send(u->socket, at, count, MSG_NOSIGNAL) : recv(u->socket, at, count, 0);
        if (n <= 0 && !(n < 0 && errno == EINTR)) {
            u->closed = 1;
        } else if (n > 0) {
            at += n;
            count -= (size_t)n;
        }
    }
}

static void reply(usbip *u, uint32_t kind, uint32_t number, int32_t status, uint32_t length,
                  const void *data, size_t bytes) {
    uint32_t packet[12 + 1024] = {htonl(kind), htonl(number)};
    packet[5] = htonl((uint32_t)status);
    packet[6] = htonl(length);
    if (bytes > 0) {
        memcpy(packet + 12, data, bytes);
    }
    move_all(u, packet, 48 + bytes, 1);
}

void usbip_in_done(usbip *u) {
    while (u->ins > 0) {
        uint8_t report[64];
        const size_t bytes = device_input(u->device, report, sizeof report);
        if (bytes == 0) {
            return;
        }
        reply(u, RET_SUBMIT, u->in[0], 0, (uint32_t)bytes, report, bytes);
        memmove(u->in, u->in + 1, --u->ins * sizeof u->in[0]);
    }
}

static void out_done(usbip *u) {
    while (u->outs > 0 && u->out[0].due_us <= now_us()) {
        reply(u, RET_SUBMIT, u->out[0].number, 0, u->out[0].bytes, NULL, 0);
        memmove(u->out, u->out + 1, --u->outs * sizeof u->out[0]);
    }
}

static void queue_out(usbip *u, uint32_t number, uint32_t bytes) {
    const int64_t now = now_us();
    if (u->bus_free_us < now) {
        u->bus_free_us = now;
    }
    if (u->device->paced) {
        u->bus_free_us = (u->bus_free_us / 1000 + (bytes + 63) / 64) * 1000;
    }
    u->out[u->outs++] = (usbip_out){number, bytes, u->bus_free_us};
}

/* Cancels a transfer, if it still waits. */
static int unlink_waiting(usbip *u, uint32_t number) {
    for (unsigned i = 0; i < u->ins; i++) {
        if (u->in[i] == number) {
            memmove(u->in + i, u->in + i + 1, (--u->ins - i) * sizeof u->in[0]);
            return 1;
        }
    }
    for (unsigned i = 0; i < u->outs; i++) {
        if (u->out[i].number == number) {
            memmove(u->out + i, u->out + i + 1, (--u->outs - i) * sizeof u->out[0]);
            return 1;
        }
    }
    return 0;
}

static void take_control(usbip *u, uint32_t number, const uint8_t setup[8], uint32_t length) {
    uint8_t answer[256];
    const int bytes = usbip_control(u, setup, u->buffer, length, answer);
    if (bytes < 0) {
        reply(u, RET_SUBMIT, number, -EPIPE, 0, NULL, 0);
    } else if (setup[0] & 0x80) {
        const uint32_t most = setup[6] | (uint32_t)setup[7] << 8;
        const uint32_t sent = (uint32_t)bytes < most ? (uint32_t)bytes : most;
        reply(u, RET_SUBMIT, number, 0, sent, answer, sent);
    } else {
        reply(u, RET_SUBMIT, number, 0, length, NULL, 0);
    }
}

static void take_request(usbip *u) {
    uint32_t head[12];
    move_all(u, head, sizeof head, 0);
    const uint32_t kind = ntohl(head[0]), number = ntohl(head[1]), in = ntohl(head[3]);
    const uint32_t endpoint = ntohl(head[4]), length = ntohl(head[6]);
    if (u->closed) {
        return;
    }
    if (kind == UNLINK) {
        const int was = unlink_waiting(u, ntohl(head[5]));
        reply(u, RET_UNLINK, number, was ? -ECONNRESET : 0, 0, NULL, 0);
        return;
    }
    if (in == 0 && length > 0) {
        move_all(u, u->buffer, length < sizeof u->buffer ? length : sizeof u->buffer, 0);
    }
    if (endpoint == 0) {
        take_control(u, number, (const uint8_t *)&head[10], length);
    } else if (in != 0) {
        u->in[u->ins++] = number;
    } else {
        queue_out(u, number, length);
        device_output(u->device, u->buffer, length);
    }
}

static int attach(usbip *u) {
    int pair[2];
    char line[64];
    const device *d = u->device;
    const int fd = open("/sys/devices/platform/vhci_hcd.0/attach", O_WRONLY);
    if (fd < 0 || socketpair(AF_UNIX, SOCK_STREAM, 0, pair) != 0) {
        perror("device: vhci_hcd");
        return -1;
    }
    const int length = snprintf(line, sizeof line, "%u %d %u %u", d->port, pair[1],
                                0x10001 + d->port, d->high_speed ? 3 : 2);
    const int wrote = write(fd, line, (size_t)length) == length;
    if (!wrote) {
        perror("device: vhci_hcd attach");
    }
    close(fd);
    close(pair[1]);
    u->socket = pair[0];
    return wrote ? 0 : -1;
}

int device_usbip(device *d) {
    static usbip u;
    u.device = d;
    if (attach(&u) != 0) {
        return -1;
    }
    while (device_goes_on(d) && !u.closed) {
        struct pollfd p = {u.socket, POLLIN, 0};
        int64_t wait = TICK_US;
        out_done(&u);
        usbip_in_done(&u);
        if (u.outs > 0 && u.out[0].due_us - now_us() < wait) {
            wait = u.out[0].due_us - now_us();
        }
        const struct timespec t = {0, wait > 0 ? (long)wait * 1000 : 0};
        if (u.outs < USBIP_QUEUE && u.ins < USBIP_QUEUE && ppoll(&p, 1, &t, NULL) > 0) {
            take_request(&u);
        }
    }
    close(u.socket);
    return 0;
}

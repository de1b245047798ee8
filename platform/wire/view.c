/* view - what to render: the latest one wins, repeated until it is acknowledged
 *
 * Floats travel as their bits, so both peers see exactly the same camera.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/services.h"

void wire_view_out_open(wire_view_out *out, wire_peer *peer) {
    memset(out, 0, sizeof *out);
    out->peer = peer;
    out->have = 1;
    peer->view_out = out;
}

void wire_view_send(wire_view_out *out, const wire_view *view) {
    const uint8_t number = (uint8_t)(out->view.number + 1);
    out->view = *view;
    out->view.number = number;
    out->have = 0;
    out->is_set = 1;
    out->sent_ms = out->peer->now_ms;
    wire_queue_control(out->peer, WIRE_VIEW);
}

void wire_view_out_begin(wire_view_out *out) {
    if (out->is_set) {
        out->have = 0;
        out->sent_ms = out->peer->now_ms;
        wire_queue_control(out->peer, WIRE_VIEW);
    }
}

void wire_view_out_poll(wire_view_out *out) {
    if (!out->have && out->peer->now_ms - out->sent_ms >= WIRE_IDLE_MS) {
        out->sent_ms = out->peer->now_ms;
        wire_queue_control(out->peer, WIRE_VIEW);
    }
}

static void floats_put(uint8_t *to, const float *from, unsigned count) {
    for (unsigned i = 0; i < count; i++) {
        uint32_t bits;
        memcpy(&bits, from + i, 4);
        wire_put32(to + 4 * i, bits);
    }
}

static void floats_get(float *to, const uint8_t *at, unsigned count) {
    for (unsigned i = 0; i < count; i++) {
        const uint32_t bits = wire_get32(at + 4 * i);
        memcpy(to + i, &bits, 4);
    }
}

uint32_t wire_view_out_write(wire_view_out *out, uint8_t *body) {
    const wire_view *v = &out->view;
    body[0] = v->number;
    body[1] = v->shader;
    floats_put(body + 2, v->eye, 3);
    floats_put(body + 14, v->look, 3);
    floats_put(body + 26, v->up, 3);
    floats_put(body + 38, &v->tan_half_fov, 1);
    return 42;
}

void wire_view_out_receive(wire_view_out *out, const uint8_t *body) {
    out->have = out->have || body[0] == out->view.number;
}

void wire_view_in_open(wire_view_in *in, wire_peer *peer) {
    memset(in, 0, sizeof *in);
    peer->view_in = in;
}

void wire_view_in_receive(wire_view_in *in, const uint8_t *body) {
    wire_view *v = &in->view;
    v->number = body[0];
    v->shader = body[1];
    floats_get(v->eye, body + 2, 3);
    floats_get(v->look, body + 14, 3);
    floats_get(v->up, body + 26, 3);
    floats_get(&v->tan_half_fov, body + 38, 1);
    in->fresh = 1;
}

uint32_t wire_view_in_write(const wire_view_in *in, uint8_t *body) {
    body[0] = in->view.number;
    return 1;
}

int wire_view_read(wire_view_in *in) {
    const int fresh = in->fresh;
    in->fresh = 0;
    return fresh;
}

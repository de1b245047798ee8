/* view - what to render: the latest one wins, repeated until it is acknowledged
 *
 * Floats travel as their bits, so both peers see exactly the same camera.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/services.h"

/* A body of the first 42 bytes alone is that of an older host. */
enum { HAS_BACKGROUND = 16, BODY_BYTES = 46 };

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
    body[42] = (uint8_t)((v->samples & 15) | (v->has_background ? HAS_BACKGROUND : 0));
    memcpy(body + 43, v->background, 3);
    return BODY_BYTES;
}

/* Older devices say nothing of what they leave out: it is all. */
void wire_view_out_receive(wire_view_out *out, const uint8_t *body, uint32_t bytes) {
    if (body[0] == out->view.number) {
        out->have = 1;
        out->obeyed = bytes > 1 ? body[1] : 0;
    }
}

unsigned wire_view_left_out(const wire_view_out *out) {
    const wire_view *v = &out->view;
    const unsigned asked =
        (v->has_background ? WIRE_VIEW_BACKGROUND : 0u) | (v->samples ? WIRE_VIEW_SAMPLES : 0u);
    return out->is_set && out->have ? asked & ~(unsigned)out->obeyed : 0;
}

void wire_view_in_open(wire_view_in *in, wire_peer *peer) {
    memset(in, 0, sizeof *in);
    peer->view_in = in;
}

/* Of an older host what it does not say is what it always was. */
static void receive_more(wire_view *v, const uint8_t *body, uint32_t bytes) {
    v->samples = v->has_background = 0;
    if (bytes >= BODY_BYTES) {
        v->samples = body[42] & 15;
        v->has_background = (body[42] & HAS_BACKGROUND) != 0;
        memcpy(v->background, body + 43, 3);
    }
}

void wire_view_in_receive(wire_view_in *in, const uint8_t *body, uint32_t bytes) {
    wire_view *v = &in->view;
    v->number = body[0];
    v->shader = body[1];
    floats_get(v->eye, body + 2, 3);
    floats_get(v->look, body + 14, 3);
    floats_get(v->up, body + 26, 3);
    floats_get(&v->tan_half_fov, body + 38, 1);
    receive_more(v, body, bytes);
    in->fresh = 1;
}

uint32_t wire_view_in_write(const wire_view_in *in, uint8_t *body) {
    body[0] = in->view.number;
    body[1] = in->obeys;
    return 2;
}

int wire_view_read(wire_view_in *in) {
    const int fresh = in->fresh;
    in->fresh = 0;
    return fresh;
}

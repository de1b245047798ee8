/* end - sessions: how an end comes up, stays up, and notices that it is down
 *
 * Invariant: outside WIRE_IS_UP nothing but hellos is sent or believed.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/parts.h"

/* Bijective on 32 bits, every bit depends on every other (C. Wellons, "Hash
 * prospector", 2018). */
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

static int is_right(const wire_setup *setup) {
    const wire_caps *c = &setup->caps;
    return setup->role <= WIRE_HOST && c->in_bytes >= WIRE_REPORT_BYTES_MIN &&
           c->in_bytes <= WIRE_REPORT_BYTES_MAX && c->out_bytes >= WIRE_REPORT_BYTES_MIN &&
           c->out_bytes <= WIRE_REPORT_BYTES_MAX && c->window >= 2 &&
           c->window <= WIRE_WINDOW_MAX && c->format < WIRE_FORMATS &&
           (!(c->features & WIRE_SHOWS) || (c->width > 0 && c->height > 0));
}

int wire_end_open(wire_end *end, const wire_setup *setup, uint32_t now_ms) {
    if (!is_right(setup)) {
        return WIRE_ERR_SETUP;
    }
    memset(end, 0, sizeof *end);
    end->own = setup->caps;
    end->own.version = WIRE_VERSION;
    end->role = setup->role;
    wire_on_link(end, 1, now_ms);
    return WIRE_OK;
}

/* A new half of a session's number: hellos and sessions of before are over. */
static void renew(wire_end *end) {
    end->own.session = wire_scramble(end->own.session + 1);
}

/* Numbers and streams as at the start. */
static void forget(wire_end *end) {
    end->out_number = end->out_acked = end->out_asks = end->in_number = 0;
    end->pending = 0;
    end->control_used = end->control_gone = 0;
    end->unacked_in = 0;
    memset(&end->control, 0, sizeof end->control);
    memset(&end->data, 0, sizeof end->data);
    if (end->frames_in != NULL) {
        wire_frames_in_begin(end->frames_in);
    }
    if (end->queue != NULL) {
        end->queue->used = end->queue->gone = end->queue->left = 0;
    }
}

void wire_session_end(wire_end *end) {
    forget(end);
    renew(end);
    end->state = WIRE_IS_DOWN;
    if (end->role == WIRE_HOST) {
        end->state = WIRE_IS_ASKING;
        end->hello_number = 0;
        end->asked_ms = end->now_ms;
        wire_owe(end, WIRE_HELLO);
    }
}

void wire_session_begin(wire_end *end) {
    forget(end);
    end->state = WIRE_IS_UP;
    end->has_next = 0;
    end->heard_ms = end->asked_ms = end->now_ms;
    end->stats.sessions++;
    if (end->frames_out != NULL) {
        wire_frames_out_begin(end->frames_out);
    }
    if (end->scene_out != NULL) {
        wire_scene_out_begin(end->scene_out);
    }
    if (end->view_out != NULL) {
        wire_view_out_begin(end->view_out);
    }
    if (end->blocks_in != NULL) {
        wire_blocks_in_begin(end->blocks_in);
    }
    if (end->role == WIRE_HOST) {
        wire_owe(end, WIRE_PING); /* tells the device that its welcome came */
    }
    if (end->settings_to_go > 0) {
        wire_owe(end, WIRE_SET);
    }
}

void wire_on_link(wire_end *end, int up, uint32_t now_ms) {
    end->now_ms = now_ms;
    end->has_next = 0;
    wire_session_end(end);
    if (!up) {
        end->state = WIRE_IS_DOWN;
        end->pending = 0;
    }
}

static int is_over(uint32_t now, uint32_t since, uint32_t most) {
    return now - since >= most;
}

static void poll_session(wire_end *end, uint32_t now) {
    if (is_over(now, end->heard_ms, WIRE_DEAD_MS)) {
        wire_session_end(end);
        return;
    }
    const int is_stalled =
        (int32_t)(end->out_asks - end->out_acked) > 0 && is_over(now, end->asked_ms, WIRE_PING_MS);
    const int is_idle = end->role == WIRE_HOST && is_over(now, end->heard_ms, WIRE_IDLE_MS);
    if ((is_stalled || is_idle) && is_over(now, end->asked_ms, WIRE_PING_MS)) {
        end->asked_ms = now;
        wire_owe(end, WIRE_PING);
    }
    if (end->settings_to_go && is_over(now, end->set_ms, WIRE_IDLE_MS)) {
        end->set_ms = now;
        wire_owe(end, WIRE_SET);
    }
    if (end->frames_out != NULL) {
        wire_frames_out_poll(end->frames_out);
    }
    if (end->scene_out != NULL) {
        wire_scene_out_poll(end->scene_out);
    }
    if (end->scene_in != NULL) {
        wire_scene_in_poll(end->scene_in);
    }
    if (end->view_out != NULL) {
        wire_view_out_poll(end->view_out);
    }
    if (end->blocks_in != NULL) {
        wire_blocks_in_poll(end->blocks_in);
    }
}

void wire_poll(wire_end *end, uint32_t now_ms) {
    end->now_ms = now_ms;
    if (end->state == WIRE_IS_UP) {
        poll_session(end, now_ms);
    } else if (end->state == WIRE_IS_ASKING && is_over(now_ms, end->asked_ms, WIRE_HELLO_MS)) {
        end->asked_ms = now_ms;
        wire_owe(end, WIRE_HELLO);
    }
}

int wire_is_up(const wire_end *end) {
    return end->state == WIRE_IS_UP;
}

const wire_caps *wire_peer(const wire_end *end) {
    return &end->peer;
}

uint32_t wire_unacked(const wire_end *end) {
    return end->out_number - end->out_acked;
}

void wire_tell(wire_end *end, unsigned code, uint32_t detail) {
    end->error = (uint8_t)code;
    end->error_detail = detail;
    wire_owe(end, WIRE_ERROR);
}

unsigned wire_told(wire_end *end, uint32_t *detail) {
    const unsigned code = end->peer_error;
    *detail = end->peer_detail;
    end->peer_error = WIRE_FINE;
    return code;
}

void wire_set(wire_end *end, unsigned key, unsigned value) {
    end->setting[0] = (uint8_t)key;
    end->setting[1] = (uint8_t)value;
    end->settings_to_go = 1;
    wire_owe(end, WIRE_SET);
}

unsigned wire_setting_take(wire_end *end, unsigned *value) {
    const unsigned key = end->peer_setting[0];
    *value = end->peer_setting[1];
    end->peer_setting[0] = 0;
    return key;
}

void wire_stats_ask(wire_end *end, wire_stats *to) {
    memset(to, 0, sizeof *to);
    end->peer_stats = to;
    wire_owe(end, WIRE_STATS_ASK);
}

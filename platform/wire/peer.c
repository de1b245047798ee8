/* peer - sessions: how a peer comes up, stays up, and notices that it is down
 *
 * Invariants: outside WIRE_IS_UP nothing but hellos is sent or accepted. Of a session in which the
 * other peer is silent reports are accepted, and all that it needs to go on is kept; but nothing
 * leaves, so that numbers do not run away, but hellos of the host, who asks for this or another
 * session, and the acknowledgement by which a device says that it is in this one.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/report.h"
#include "platform/wire/services.h"
#include "platform/wire/session.h"

static int is_valid(const wire_setup *setup) {
    const wire_caps *c = &setup->caps;
    return setup->role <= WIRE_HOST && c->in_bytes >= WIRE_REPORT_BYTES_MIN &&
           c->in_bytes <= WIRE_REPORT_BYTES_MAX && c->out_bytes >= WIRE_REPORT_BYTES_MIN &&
           c->out_bytes <= WIRE_REPORT_BYTES_MAX && c->credits >= 2 &&
           c->credits <= WIRE_CREDITS_MAX && c->format < WIRE_FORMATS &&
           (!(c->features & WIRE_SHOWS) || (c->width > 0 && c->height > 0));
}

int wire_peer_open(wire_peer *peer, const wire_setup *setup, uint32_t now_ms) {
    if (!is_valid(setup)) {
        return WIRE_ERR_SETUP;
    }
    memset(peer, 0, sizeof *peer);
    peer->own = setup->caps;
    peer->own.version = WIRE_VERSION;
    peer->role = setup->role;
    wire_on_link(peer, 1, now_ms);
    return WIRE_OK;
}

/* A new half of a session's number: hellos and sessions of before are over. */
static void renew_session(wire_peer *peer) {
    peer->own.session = wire_scramble(peer->own.session + 1);
}

/* Numbers and streams as at the start. */
static void forget(wire_peer *peer) {
    peer->out_number = peer->out_acked = peer->out_asks = peer->in_number = 0;
    peer->pending = 0;
    peer->control_used = peer->control_gone = 0;
    peer->unacked_in = 0;
    memset(&peer->control, 0, sizeof peer->control);
    memset(&peer->data, 0, sizeof peer->data);
    if (peer->frames_in != NULL) {
        wire_frames_in_begin(peer->frames_in);
    }
    if (peer->queue != NULL) {
        peer->queue->used = peer->queue->gone = peer->queue->left = 0;
    }
}

static void say_hello(wire_peer *peer) {
    peer->hello_number = 0;
    peer->asked_ms = peer->now_ms;
    wire_queue_control(peer, WIRE_HELLO);
}

static void session_end(wire_peer *peer) {
    forget(peer);
    renew_session(peer);
    peer->state = WIRE_IS_DOWN;
    peer->is_silent = 0;
    if (peer->role == WIRE_HOST) {
        peer->state = WIRE_IS_ASKING;
        say_hello(peer);
    }
}

/* The session stays, unless too many reports may have been lost to tell their numbers later. */
static void fall_silent(wire_peer *peer) {
    if (wire_unacked(peer) > WIRE_UNACKED_MOST) {
        session_end(peer);
        return;
    }
    peer->is_silent = 1;
    if (peer->role == WIRE_HOST) {
        renew_session(peer);
        say_hello(peer);
    }
}

/* The host pings, so that the device hears it, too. */
void wire_session_resume(wire_peer *peer) {
    peer->is_silent = 0;
    peer->asked_ms = peer->now_ms;
    if (peer->role == WIRE_HOST) {
        peer->pending &= ~wire_bit(WIRE_HELLO);
        wire_queue_control(peer, WIRE_PING);
    }
}

void wire_session_begin(wire_peer *peer) {
    forget(peer);
    peer->state = WIRE_IS_UP;
    peer->is_silent = peer->has_next = 0;
    peer->heard_ms = peer->asked_ms = peer->now_ms;
    peer->stats.sessions++;
    if (peer->frames_out != NULL) {
        wire_frames_out_begin(peer->frames_out);
    }
    if (peer->scene_out != NULL) {
        wire_scene_out_begin(peer->scene_out);
    }
    if (peer->view_out != NULL) {
        wire_view_out_begin(peer->view_out);
    }
    if (peer->blocks_in != NULL) {
        wire_blocks_in_begin(peer->blocks_in);
    }
    if (peer->keys_out != NULL) {
        wire_keys_out_begin(peer->keys_out);
    }
    if (peer->keys_in != NULL) {
        wire_keys_in_begin(peer->keys_in);
    }
    if (peer->role == WIRE_HOST) {
        wire_queue_control(peer, WIRE_PING); /* shows the device that its welcome came */
    }
    if (peer->settings_to_go > 0) {
        wire_queue_control(peer, WIRE_SET);
    }
}

void wire_on_link(wire_peer *peer, int up, uint32_t now_ms) {
    peer->now_ms = now_ms;
    peer->has_next = 0;
    session_end(peer);
    if (!up) {
        peer->state = WIRE_IS_DOWN;
        peer->pending = 0;
    }
}

static int is_over(uint32_t now, uint32_t since, uint32_t most) {
    return now - since >= most;
}

static void poll_session(wire_peer *peer, uint32_t now) {
    if (is_over(now, peer->heard_ms, WIRE_DEAD_MS)) {
        fall_silent(peer);
        return;
    }
    const int is_stalled = (int32_t)(peer->out_asks - peer->out_acked) > 0 &&
                           is_over(now, peer->asked_ms, WIRE_PING_MS);
    const int is_idle = peer->role == WIRE_HOST && is_over(now, peer->heard_ms, WIRE_IDLE_MS);
    if ((is_stalled || is_idle) && is_over(now, peer->asked_ms, WIRE_PING_MS)) {
        peer->asked_ms = now;
        wire_queue_control(peer, WIRE_PING);
    }
    if (peer->settings_to_go && is_over(now, peer->set_ms, WIRE_IDLE_MS)) {
        peer->set_ms = now;
        wire_queue_control(peer, WIRE_SET);
    }
    if (peer->frames_out != NULL) {
        wire_frames_out_poll(peer->frames_out);
    }
    if (peer->scene_out != NULL) {
        wire_scene_out_poll(peer->scene_out);
    }
    if (peer->scene_in != NULL) {
        wire_scene_in_poll(peer->scene_in);
    }
    if (peer->view_out != NULL) {
        wire_view_out_poll(peer->view_out);
    }
    if (peer->blocks_in != NULL) {
        wire_blocks_in_poll(peer->blocks_in);
    }
    if (peer->keys_out != NULL) {
        wire_keys_out_poll(peer->keys_out);
    }
}

void wire_poll(wire_peer *peer, uint32_t now_ms) {
    peer->now_ms = now_ms;
    const int asks = peer->state == WIRE_IS_ASKING || (peer->is_silent && peer->role == WIRE_HOST);
    if (wire_is_up(peer)) {
        poll_session(peer, now_ms);
    } else if (asks && is_over(now_ms, peer->asked_ms, WIRE_HELLO_MS)) {
        peer->asked_ms = now_ms;
        wire_queue_control(peer, WIRE_HELLO);
    }
}

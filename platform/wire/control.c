/* control - control messages: written when they can leave, read when they came
 *
 * Every one of them may be lost; each is repeated until what it asks for is
 * seen (hellos, offers, views, settings, requests), or its loss is noticed
 * otherwise (acknowledgements, frame answers).
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/services.h"
#include "platform/wire/session.h"

/* ---- acknowledgement and statistics ------------------------------------------------------ */

static uint32_t write_ack(wire_peer *peer, uint8_t *body) {
    peer->unacked_in = 0;
    wire_put32(body, peer->in_number);
    return 4;
}

static void receive_ack(wire_peer *peer, const uint8_t *body) {
    const uint32_t number = wire_get32(body);
    const int32_t news = (int32_t)(number - peer->out_acked);
    if (news > 0 && (int32_t)(peer->out_number - number) >= 0) {
        peer->out_acked = number;
        peer->asked_ms = peer->now_ms;
    }
}

enum { STATS = 10 };

static uint32_t write_stats(const wire_peer *peer, uint8_t *body) {
    const wire_stats *s = &peer->stats;
    const uint32_t list[STATS] = {s->reports_out, s->reports_in, s->reports_lost, s->reports_late,
                                  s->reports_bad, s->sessions,   s->frames_out,   s->frames_in,
                                  s->tiles_out,   s->tiles_in};
    for (int i = 0; i < STATS; i++) {
        wire_put32(body + 4 * i, list[i]);
    }
    return 4 * STATS;
}

/* ---- settings and errors -------------------------------------------------------------------- */

/* A device sends back what it received, and the host stops repeating it. */
static uint32_t write_set(const wire_peer *peer, uint8_t *body) {
    memcpy(body, peer->setting, 2);
    return 2;
}

static void receive_set(wire_peer *peer, const uint8_t *body) {
    if (peer->role == WIRE_HOST) {
        if (memcmp(body, peer->setting, 2) == 0) {
            peer->settings_to_go = 0;
        }
        return;
    }
    if (memcmp(body, peer->setting, 2) != 0 || peer->setting[0] == 0) {
        memcpy(peer->other_setting, body, 2);
    }
    memcpy(peer->setting, body, 2);
    wire_queue_control(peer, WIRE_SET);
}

static uint32_t write_error(const wire_peer *peer, uint8_t *body) {
    body[0] = peer->error;
    wire_put32(body + 1, peer->error_detail);
    wire_put32(body + 5, peer->error_place);
    body[9] = peer->error_kind;
    return 10;
}

/* Older peers send no place: of a refused image it is in the detail, as far as it fits there. */
static void receive_error(wire_peer *peer, const uint8_t *body, uint32_t bytes) {
    peer->other_error = body[0];
    peer->other_detail = wire_get32(body + 1);
    peer->other_place = bytes >= 10 ? wire_get32(body + 5) : peer->other_detail & 0xFFFFFFu;
    peer->other_kind = bytes >= 10 && body[9] == 'I' ? 'I' : 'R';
}

/* ---- all -------------------------------------------------------------------------------- */

uint32_t wire_control_write(wire_peer *peer, unsigned type, uint8_t *body) {
    switch (type) {
    case WIRE_HELLO:
    case WIRE_WELCOME:
        return wire_hello_write(peer, body);
    case WIRE_ACK:
        return write_ack(peer, body);
    case WIRE_PING:
        body[0] = 0;
        peer->stats.pings_out++;
        return 1;
    case WIRE_FRAME_GOOD:
    case WIRE_FRAME_BAD:
        return wire_frames_in_write(peer->frames_in, type, body);
    case WIRE_SCENE_OFFER:
        return wire_scene_out_write(peer->scene_out, body);
    case WIRE_SCENE_STATE:
        return wire_scene_in_write(peer->scene_in, body);
    case WIRE_VIEW:
        return wire_view_out_write(peer->view_out, body);
    case WIRE_VIEW_HAVE:
        return wire_view_in_write(peer->view_in, body);
    case WIRE_BLOCK_ASK:
        return wire_blocks_in_write(peer->blocks_in, body);
    case WIRE_BLOCK_REFUSE:
        return wire_blocks_out_write(peer->blocks_out, body);
    case WIRE_ERROR:
        return write_error(peer, body);
    case WIRE_SET:
        return write_set(peer, body);
    case WIRE_STATS:
        return write_stats(peer, body);
    case WIRE_KEYS_ARE:
        return wire_keys_out_write(peer->keys_out, body);
    case WIRE_KEYS_HAVE:
        return wire_keys_in_write(peer->keys_in, body);
    default:
        return 0;
    }
}

/* Bytes that a body has; 0: the type is not known, or nobody here wants it. */
static uint32_t bytes_wanted(const wire_peer *peer, unsigned type) {
    switch (type) {
    case WIRE_ACK:
        return 4;
    case WIRE_PING:
    case WIRE_STATS_ASK:
        return 1;
    case WIRE_FRAME_GOOD:
        return peer->frames_out != NULL ? 2 : 0;
    case WIRE_FRAME_BAD:
        return peer->frames_out != NULL ? 34 : 0;
    case WIRE_SCENE_OFFER:
        return peer->scene_in != NULL ? 8 : 0;
    case WIRE_SCENE_STATE:
        return peer->scene_out != NULL ? 10 : 0;
    case WIRE_VIEW:
        return peer->view_in != NULL ? 42 : 0;
    case WIRE_VIEW_HAVE:
        return peer->view_out != NULL ? 1 : 0;
    case WIRE_BLOCK_ASK:
        return peer->blocks_out != NULL ? 9 : 0;
    case WIRE_BLOCK_REFUSE:
        return peer->blocks_in != NULL ? 5 : 0;
    case WIRE_KEYS_ARE:
        return peer->keys_in != NULL ? 2 : 0;
    case WIRE_KEYS_HAVE:
        return peer->keys_out != NULL ? 1 : 0;
    case WIRE_ERROR:
        return 5;
    case WIRE_SET:
        return 2;
    default:
        return 0;
    }
}

static void receive(wire_peer *peer, unsigned type, const uint8_t *body, uint32_t bytes) {
    switch (type) {
    case WIRE_ACK:
        receive_ack(peer, body);
        break;
    case WIRE_PING:
        wire_queue_control(peer, WIRE_ACK);
        break;
    case WIRE_STATS_ASK:
        wire_queue_control(peer, WIRE_STATS);
        break;
    case WIRE_FRAME_GOOD:
    case WIRE_FRAME_BAD:
        wire_frames_out_receive(peer->frames_out, type, body);
        break;
    case WIRE_SCENE_OFFER:
        wire_scene_in_receive(peer->scene_in, body);
        break;
    case WIRE_SCENE_STATE:
        wire_scene_out_receive(peer->scene_out, body);
        break;
    case WIRE_VIEW:
        wire_view_in_receive(peer->view_in, body, bytes);
        wire_queue_control(peer, WIRE_VIEW_HAVE);
        break;
    case WIRE_VIEW_HAVE:
        wire_view_out_receive(peer->view_out, body, bytes);
        break;
    case WIRE_BLOCK_ASK:
        wire_blocks_out_receive(peer->blocks_out, body, bytes);
        break;
    case WIRE_BLOCK_REFUSE:
        wire_blocks_in_receive(peer->blocks_in, body);
        break;
    case WIRE_KEYS_ARE:
        wire_keys_in_receive(peer->keys_in, body, bytes);
        wire_queue_control(peer, WIRE_KEYS_HAVE);
        break;
    case WIRE_KEYS_HAVE:
        wire_keys_out_receive(peer->keys_out, body);
        break;
    case WIRE_ERROR:
        receive_error(peer, body, bytes);
        break;
    default: /* WIRE_SET */
        receive_set(peer, body);
    }
}

void wire_control_receive(wire_peer *peer, unsigned type, const uint8_t *body, uint32_t bytes,
                          int hello) {
    if (hello) {
        wire_hello_receive(peer, type, body, bytes);
        return;
    }
    const uint32_t wanted = bytes_wanted(peer, type);
    if (wanted > 0 && bytes >= wanted) { /* later versions may append to a body */
        receive(peer, type, body, bytes);
    }
}

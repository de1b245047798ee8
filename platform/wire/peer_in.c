/* peer_in - a report that came: is it one of ours, is it new, what is in it
 *
 * Invariants: no byte of a report is looked at before its checksum, which
 * covers session, direction and full number, was found right; numbers only go up;
 * after a gap a channel is silent until a message is known to begin.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/report.h"
#include "platform/wire/services.h"
#include "platform/wire/session.h"

enum stage { IN_TYPE, IN_LOW, IN_LENGTH, IN_LENGTH2, IN_HEAD, IN_BODY };

/* ---- data messages, as their bytes come ----------------------------------------------- */

static uint32_t head_bytes(unsigned type) {
    return type == WIRE_FRAME_END    ? WIRE_FRAME_END_BODY
           : type == WIRE_SCENE_DATA ? 4
           : type == WIRE_BLOCK_DATA ? 5
                                     : 0;
}

static void begin_body(wire_peer *peer) {
    const wire_stream *s = &peer->data;
    const uint8_t *head = peer->data_head;
    if (s->type & WIRE_TILE) {
        if (peer->frames_in != NULL) {
            wire_frames_in_tile(peer->frames_in, s->type, s->low, s->left);
        }
    } else if (s->type == WIRE_FRAME_END && peer->frames_in != NULL) {
        wire_frames_in_end(peer->frames_in, head);
    } else if (s->type == WIRE_SCENE_DATA && peer->scene_in != NULL) {
        wire_scene_in_head(peer->scene_in, wire_get32(head));
    } else if (s->type == WIRE_BLOCK_DATA && peer->blocks_in != NULL) {
        wire_blocks_in_head(peer->blocks_in, head[0], wire_get32(head + 1));
    }
}

static void receive_data(wire_peer *peer, const uint8_t *bytes, uint32_t count) {
    const unsigned type = peer->data.type;
    peer->stats.payload_in += count;
    if (type & WIRE_TILE && peer->frames_in != NULL) {
        wire_frames_in_bytes(peer->frames_in, bytes, count);
    } else if (type == WIRE_SCENE_DATA && peer->scene_in != NULL) {
        wire_scene_in_bytes(peer->scene_in, bytes, count);
    } else if (type == WIRE_BLOCK_DATA && peer->blocks_in != NULL) {
        wire_blocks_in_bytes(peer->blocks_in, bytes, count);
    }
}

/* ---- both channels ------------------------------------------------------------------------ */

static void read_type(wire_stream *s, unsigned byte) {
    s->type = (uint8_t)byte;
    s->used = 0;
    s->stage = byte & WIRE_TILE ? IN_LOW : IN_LENGTH;
}

static void length_known(wire_peer *peer, wire_stream *s) {
    const uint32_t head = s == &peer->data ? head_bytes(s->type) : 0;
    if (s->left < head) { /* not a message of this protocol: skip it */
        s->type = WIRE_PAD;
    }
    s->stage = head > 0 && s->type != WIRE_PAD ? IN_HEAD : IN_BODY;
    if (s->stage == IN_BODY && s == &peer->data) {
        begin_body(peer);
    }
}

/* One byte of a message's head; a body follows at once. */
static void read_head(wire_peer *peer, wire_stream *s, unsigned byte) {
    switch (s->stage) {
    case IN_TYPE:
        read_type(s, byte);
        break;
    case IN_LOW:
        s->low = (uint8_t)byte;
        s->stage = IN_LENGTH;
        break;
    case IN_LENGTH:
        s->left = (uint16_t)(byte & 127);
        s->stage = IN_LENGTH2;
        if (byte < 128) {
            length_known(peer, s);
        }
        break;
    case IN_LENGTH2:
        s->left = (uint16_t)(s->left | byte << 7);
        length_known(peer, s);
        break;
    default:
        peer->data_head[s->used++] = (uint8_t)byte;
        s->left--;
        if (s->used == head_bytes(s->type)) {
            s->stage = IN_BODY;
            begin_body(peer);
        }
    }
}

static void receive_body(wire_peer *peer, wire_stream *s, const uint8_t *at, uint32_t count) {
    if (s == &peer->data) {
        receive_data(peer, at, count);
        return;
    }
    for (uint32_t i = 0; i < count && s->used < WIRE_CONTROL_BYTES; i++) {
        peer->control_in[s->used++] = at[i];
    }
}

static void stream(wire_peer *peer, wire_stream *s, const uint8_t *at, uint32_t count) {
    while (count > 0) {
        if (s->stage == IN_TYPE && *at == WIRE_PAD) {
            return;
        }
        if (s->stage != IN_BODY) {
            read_head(peer, s, *at++);
            count--;
        }
        if (s->stage == IN_BODY) {
            const uint32_t n = s->left < count ? s->left : count;
            receive_body(peer, s, at, n);
            at += n;
            count -= n;
            s->left = (uint16_t)(s->left - n);
            if (s->left == 0) {
                s->stage = IN_TYPE;
                if (s == &peer->control) {
                    wire_control_receive(peer, s->type, peer->control_in, s->used, 0);
                }
            }
        }
    }
}

static void note_gap(wire_peer *peer) {
    peer->control.is_lost = peer->data.is_lost = 1;
    if (peer->frames_in != NULL) {
        wire_frames_in_cut(peer->frames_in);
    }
}

/* ---- reports --------------------------------------------------------------------------------- */

static void receive_payload(wire_peer *peer, const wire_report_view *r) {
    wire_stream *s = r->is_control ? &peer->control : &peer->data;
    uint32_t from = 0;
    if (r->is_control) {
        peer->hello_in = 255; /* they share a buffer */
    }
    if (s->is_lost) {
        if (r->first >= r->count) {
            return;
        }
        from = r->first;
        s->is_lost = 0;
        s->stage = IN_TYPE;
    }
    stream(peer, s, r->payload + from, r->count - from);
}

static int receive_report(wire_peer *peer, const wire_report_view *r, uint32_t number) {
    const int32_t ahead = (int32_t)(number - peer->in_number);
    peer->heard_ms = peer->now_ms;
    if (peer->is_silent) {
        wire_session_resume(peer);
    }
    if (ahead < 0) {
        peer->stats.reports_late++;
        return 0;
    }
    if (ahead > 0) {
        peer->stats.reports_lost += (uint32_t)ahead;
        note_gap(peer);
        wire_queue_control(peer, WIRE_ACK);
    }
    peer->in_number = number + 1;
    peer->stats.reports_in++;
    if (++peer->unacked_in >= (peer->own.credits + 1) / 2) {
        wire_queue_control(peer, WIRE_ACK);
    }
    receive_payload(peer, r);
    return 1;
}

/* Hellos are numbered from 0 each; their message holds a checksum of its own. */
static int receive_hello(wire_peer *peer, const wire_report_view *r, unsigned number) {
    if (number == 0) {
        peer->hello_in = 0;
        peer->hello_used = 0;
        peer->control.is_lost = 1; /* they share a buffer */
    }
    if (number != peer->hello_in || !r->is_control || number == 255) {
        return 0;
    }
    peer->hello_in++;
    uint8_t *held = peer->control_in;
    for (uint32_t i = 0; i < r->count && peer->hello_used < WIRE_CONTROL_BYTES; i++) {
        held[peer->hello_used++] = r->payload[i];
    }
    if (peer->hello_used < 2 || held[1] > WIRE_CONTROL_BYTES - 2 ||
        peer->hello_used < held[1] + 2u) {
        return 1;
    }
    peer->hello_in = 255;
    wire_control_receive(peer, held[0], held + 2, held[1], 1);
    return 1;
}

int wire_on_report(wire_peer *peer, const uint8_t *report, size_t bytes, uint32_t now_ms) {
    peer->now_ms = now_ms;
    if (bytes == 0) {
        return 0;
    }
    if (bytes != peer->own.in_bytes) {
        peer->stats.reports_bad++;
        return 0;
    }
    const unsigned from = peer->role == WIRE_HOST ? WIRE_DEVICE : WIRE_HOST;
    const uint32_t tag = wire_report_tag(report, bytes, from);
    const wire_report_view r = wire_report_read(report, (uint32_t)bytes);
    const unsigned low = report[4];
    const uint32_t number = peer->in_number + (uint32_t)(int8_t)(low - peer->in_number);
    if (peer->state == WIRE_IS_UP && tag == (peer->key ^ wire_scramble(number))) {
        return receive_report(peer, &r, number);
    }
    if (peer->has_next && tag == (peer->next_key ^ wire_scramble(low))) {
        peer->key = peer->next_key;
        peer->other = peer->next_other;
        wire_session_begin(peer);
        return receive_report(peer, &r, low);
    }
    if (tag == (WIRE_HELLO_KEY ^ wire_scramble(low))) {
        return receive_hello(peer, &r, low);
    }
    peer->stats.reports_bad++;
    return 0;
}

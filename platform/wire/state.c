/* state - what is known of a peer at any time: session, errors, settings
 *
 * Only data of the peer is read and written here; the services use it, too.
 *
 * SPDX-License-Identifier: MIT */
#include "platform/wire/base.h"

int wire_is_up(const wire_peer *peer) {
    return wire_has_session(peer) && !peer->is_silent;
}

const wire_caps *wire_other(const wire_peer *peer) {
    return &peer->other;
}

uint32_t wire_unacked(const wire_peer *peer) {
    return peer->out_number - peer->out_acked;
}

void wire_error_send(wire_peer *peer, unsigned code, uint32_t detail) {
    peer->error = (uint8_t)code;
    peer->error_detail = detail;
    peer->error_place = detail & 0xFFFFFFu;
    peer->error_kind = 'R';
    wire_queue_control(peer, WIRE_ERROR);
}

void wire_fault_send(wire_peer *peer, unsigned code, unsigned rule, uint32_t place, char kind) {
    const uint32_t low = place & 0xFFFFFFu;
    wire_error_send(peer, code, code == WIRE_E_SCENE ? (uint32_t)rule << 24 | low : place);
    peer->error_place = place;
    peer->error_kind = (uint8_t)kind;
}

void wire_error_repeat(wire_peer *peer) {
    wire_queue_control(peer, WIRE_ERROR);
}

unsigned wire_error_read(wire_peer *peer, uint32_t *detail) {
    const unsigned code = peer->other_error;
    *detail = peer->other_detail;
    peer->other_error = WIRE_FINE;
    return code;
}

uint32_t wire_error_place(const wire_peer *peer, char *kind) {
    *kind = (char)peer->other_kind;
    return peer->other_place;
}

void wire_setting_send(wire_peer *peer, unsigned key, unsigned value) {
    peer->setting[0] = (uint8_t)key;
    peer->setting[1] = (uint8_t)value;
    peer->settings_to_go = 1;
    wire_queue_control(peer, WIRE_SET);
}

unsigned wire_setting_read(wire_peer *peer, unsigned *value) {
    const unsigned key = peer->other_setting[0];
    *value = peer->other_setting[1];
    peer->other_setting[0] = 0;
    return key;
}

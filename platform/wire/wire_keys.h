/* wire_keys - keys and dials of a device, for the host that shows it pictures
 *
 * What travels is how often each key has changed, so a message that is lost, or comes twice, loses
 * no press and adds none; and whether a key is down, as it is after an odd number of changes. A
 * device tells it only to hosts that want it, a host hears it only from devices that have keys:
 * neither is anything new to a peer that is older.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_KEYS_H
#define PLT_WIRE_KEYS_H

#include "platform/wire/wire_peer.h"

#ifdef __cplusplus
extern "C" {
#endif

/* What the first keys mean where a scene is shown; the rest mean what host and device agree on. */
enum wire_key {
    WIRE_KEY_LEFT = 0, /* the eye goes there */
    WIRE_KEY_RIGHT = 1,
    WIRE_KEY_UP = 2,
    WIRE_KEY_DOWN = 3,
    WIRE_KEY_NEARER = 4,
    WIRE_KEY_FARTHER = 5,
    WIRE_KEY_RESET = 6, /* the first view again */
    WIRE_KEY_STILL = 7, /* stops what moves by itself, or lets it go on */
    WIRE_KEYS_MOST = 16
};

/* ---- out: a device ------------------------------------------------------------- */

typedef struct wire_keys_out {
    wire_peer *peer;
    uint32_t sent_ms;
    uint8_t changes[WIRE_KEYS_MOST]; /* in this session, modulo 256 */
    uint8_t number, have;
} wire_keys_out;

/* The device has keys; call it before the link comes up. */
void wire_keys_out_open(wire_keys_out *out, wire_peer *peer);

/* Key `key` (below WIRE_KEYS_MOST, others are ignored) is down, or up; also when nothing has
 * changed. A dial's step is a key down, then up. Not to be called from an interrupt. */
void wire_key_set(wire_keys_out *out, unsigned key, int is_down);

/* ---- in: a host ---------------------------------------------------------------- */

typedef struct wire_keys_in {
    uint8_t changes[WIRE_KEYS_MOST]; /* in this session, modulo 256; odd: the key is down */
    uint8_t number;
} wire_keys_in;

/* The host wants to know; call it before the link comes up. */
void wire_keys_in_open(wire_keys_in *in, wire_peer *peer);

#ifdef __cplusplus
}
#endif
#endif

/* session - what the files of a peer call of each other, above the services
 *
 * Not for users.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_SESSION_H
#define PLT_WIRE_SESSION_H

#include "platform/wire/base.h"

/* A session is up (peer.c): numbers begin at 0, every service begins anew. */
void wire_session_begin(wire_peer *peer);

/* The other peer of the session was silent and is heard again. */
void wire_session_resume(wire_peer *peer);

/* Body of a HELLO or WELCOME (hello.c). */
uint32_t wire_hello_write(const wire_peer *peer, uint8_t *body);
void wire_hello_receive(wire_peer *peer, unsigned type, const uint8_t *body, uint32_t bytes);

/* Body of a control message (control.c): written when it can leave, its bytes
 * returned, 0 when there is nothing to say any more; and one that came. `hello`:
 * its report was under the hello key. */
uint32_t wire_control_write(wire_peer *peer, unsigned type, uint8_t *body);
void wire_control_receive(wire_peer *peer, unsigned type, const uint8_t *body, uint32_t bytes,
                          int hello);

#endif

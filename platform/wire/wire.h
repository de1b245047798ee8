/* wire - pictures and scenes over small reports: the whole public interface
 *
 *   wire_format.h  pixel formats, and RGB to each of them
 *   wire_tile.h    the codec: 16 x 16 pixels to bytes and back
 *   wire_peer.h    a peer: reports, sessions, credits, statistics
 *   wire_frames.h  frames out (any peer) and frames in (a peer with a panel)
 *   wire_scene.h   a scene image out and in, resumed after a cut
 *   wire_block.h   pieces of a scene image on request
 *   wire_device.h  the engine as a device (not included here: it needs the
 *                  engine; all the rest needs only its CRC-32)
 *
 * Freestanding C11: no allocation, no operating system, no static data that
 * changes. Everything a peer knows lies in structures of the caller. Calls for
 * one peer come from one thread (or interrupt level) at a time.
 *
 * A host that shows frames on a display:
 *
 *     wire_peer peer;                          a display behind a USB stack:
 *     wire_frames_out out;
 *     const wire_setup setup = {...};          wire_peer peer;
 *     wire_peer_open(&peer, &setup, now_ms);   wire_frames_in in;
 *     wire_frames_out_open(&out, &peer);       wire_peer_open(&peer, &setup, now_ms);
 *     for (;;) {                               wire_frames_in_open(&in, &peer, &panel);
 *         while (receive(report, &n)) {        on a report from the host:
 *             wire_on_report(&peer, report,        wire_on_report(&peer, report, n, now_ms);
 *                            n, now_ms);       when the last one has left, and
 *         }                                    20 times per second:
 *         wire_poll(&peer, now_ms);                wire_poll(&peer, now_ms);
 *         while (can_send() && (n =                n = wire_next_report(&peer, report, now_ms);
 *             wire_next_report(&peer,              if (n > 0) send(report, n);
 *                 report, now_ms)) > 0) {
 *             send(report, n);
 *         }
 *         if (wire_frames_out_idle(&out)) {
 *             wire_frames_show(&out, rgb, 3 * width);
 *         }
 *     }
 *
 * platform/WIRE.md specifies every byte and says what is promised.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_H
#define PLT_WIRE_H

#include "platform/wire/wire_block.h"
#include "platform/wire/wire_format.h"
#include "platform/wire/wire_frames.h"
#include "platform/wire/wire_keys.h"
#include "platform/wire/wire_peer.h"
#include "platform/wire/wire_scene.h"
#include "platform/wire/wire_tile.h"

#endif

/* wire_device - the engine as a device: a scene in, views in, frames out
 *
 * Receives a scene image into the front of its memory, opens it with the rest as
 * arena, renders the latest view tile by tile with
 * plt_render_step, and sends what changed to a peer that shows. With wire_device_stream a scene
 * that has no room stays with its host, who is asked for blocks of it while they are needed.
 *
 * Needs PLT_TILE_SIDE 16, as tiles of the engine are tiles of the wire.
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_WIRE_DEVICE_H
#define PLT_WIRE_DEVICE_H

#include "engine/planelet.h"
#include "platform/wire/wire.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct wire_device {
    wire_peer peer;
    wire_frames_out out;
    wire_scene_in scene;
    wire_view_in view;
    wire_blocks_in blocks;
    int (*pump)(void *context);
    void *pump_context;
    plt_engine *engine;
    plt_source source;
    plt_options options;
    uint8_t *memory;
    size_t memory_bytes;
    plt_tile tile;
    uint32_t frames; /* rendered and handed over whole */
    uint32_t failed_session, failed_ms;
    uint8_t step, is_viewed;
    uint8_t is_streamed; /* the scene that is open stays with the host */
    uint8_t is_failed;   /* the frame that is being sent will not be whole */
    uint8_t is_deserted; /* ... as the host was silent: it begins again when that is heard */
} wire_device;

/* `memory` (aligned to PLT_ALIGN) holds image and arena. `setup`: role
 * WIRE_DEVICE; features and arena_bytes are filled in. WIRE_ERR_SETUP as
 * wire_peer_open, or a build of another tile side. */
int wire_device_open(wire_device *device, const wire_setup *setup, const plt_options *options,
                     void *memory, size_t memory_bytes, uint32_t now_ms);

#if PLT_WITH_STREAMED
/* Scenes for which the memory is too small are streamed from now on (PLT_RESIDENCY_STREAMED:
 * thesis nodes, or compact blocks with lattice geometry). `pump`, called while the engine waits for
 * a block, moves reports that come and go for some milliseconds at most and calls wire_poll, or
 * returns -1 to give up; it does not call wire_device_run. */
void wire_device_stream(wire_device *device, int (*pump)(void *context), void *context);
#endif

/* Does some work: about `visits` node visits of rendering at most, or a scene
 * opened. Call it in the main loop beside wire_poll(&device->peer). Returns 1
 * when it did something, 0 when it waits for reports to leave or to come. While a streamed block
 * comes, the call lasts: for each five seconds after the last byte that came and thirty in all, at
 * most, and three times as long, as the engine tries a block three times. A frame that fails so is
 * given up, and the host told why, four times per second; the next view, or session, begins
 * another. */
int wire_device_run(wire_device *device, uint32_t visits);

#ifdef __cplusplus
}
#endif
#endif

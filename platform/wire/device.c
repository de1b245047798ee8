/* device - see wire_device.h
 *
 * A state machine; wire_device_run does one step of it. The image lies at the
 * front of the memory, the engine's arena behind it.
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "platform/wire/wire_device.h"

enum step { NEEDS_SCENE, NEEDS_VIEW, BEGINS, RENDERS, HAS_TILE, ENDS, RESTS };

int wire_device_open(wire_device *d, const wire_setup *setup, const plt_options *options,
                     void *memory, size_t memory_bytes, uint32_t now_ms) {
    wire_setup own = *setup;
    own.caps.features |= WIRE_RENDERS | WIRE_SENDS;
    own.caps.arena_bytes = memory_bytes < UINT32_MAX ? (uint32_t)memory_bytes : UINT32_MAX;
    memset(d, 0, sizeof *d);
    if (PLT_TILE_SIDE != WIRE_TILE_SIDE || own.role != WIRE_DEVICE) {
        return WIRE_ERR_SETUP;
    }
    const int status = wire_peer_open(&d->peer, &own, now_ms);
    d->memory = memory;
    d->memory_bytes = memory_bytes;
    d->options = *options;
    wire_frames_out_open(&d->out, &d->peer);
    wire_scene_in_open(&d->scene, &d->peer, memory, own.caps.arena_bytes);
    wire_view_in_open(&d->view, &d->peer);
    return status;
}

/* Why the engine refused the image, for the host. */
static void report_refusal(wire_device *d, int status, const plt_fault *fault) {
    if (status == PLT_ERR_ARENA) {
        wire_error_send(&d->peer, WIRE_E_ARENA, (uint32_t)fault->need_bytes + d->source.bytes);
    } else {
        wire_error_send(&d->peer, WIRE_E_SCENE,
                        (uint32_t)fault->rule << 24 | (fault->offset & 0xFFFFFFu));
    }
}

static void open_scene(wire_device *d) {
    plt_fault fault = {0};
    uint32_t bytes;
    wire_scene_in_state(&d->scene, &bytes);
    const size_t front = ((size_t)bytes + PLT_ALIGN - 1) / PLT_ALIGN * PLT_ALIGN;
    const size_t rest = front < d->memory_bytes ? d->memory_bytes - front : 0;
    d->source = (plt_source){.mapped = d->memory, .bytes = bytes};
    const int status = plt_open(&d->engine, rest > 0 ? d->memory + front : d->memory, rest,
                                &d->source, &d->options, &fault);
    if (status < 0) {
        d->engine = NULL;
        report_refusal(d, status, &fault);
    }
    wire_scene_in_verdict(&d->scene, status < 0 ? WIRE_SCENE_REFUSED : WIRE_SCENE_OPEN);
}

/* The host may replace the scene at any time; then there is no engine any more. */
static int check_scene(wire_device *d) {
    uint32_t bytes;
    const unsigned state = wire_scene_in_state(&d->scene, &bytes);
    if (state == WIRE_SCENE_HERE) {
        open_scene(d);
        d->step = d->engine != NULL ? NEEDS_VIEW : NEEDS_SCENE;
        d->is_viewed = 0;
        return 1;
    }
    if (state != WIRE_SCENE_OPEN) {
        d->engine = NULL;
        d->step = NEEDS_SCENE;
    }
    return 0;
}

static int has_view(wire_device *d) {
    d->is_viewed |= (uint8_t)wire_view_read(&d->view);
    return d->view.view.number != 0 || d->is_viewed;
}

static int begin(wire_device *d) {
    const wire_view *v = &d->view.view;
    plt_frame frame = {.width = d->out.width, .height = d->out.height, .shader = v->shader};
    memcpy(frame.camera.eye, v->eye, sizeof v->eye);
    memcpy(frame.camera.look, v->look, sizeof v->look);
    memcpy(frame.camera.up, v->up, sizeof v->up);
    frame.camera.tan_half_fov = v->tan_half_fov;
    d->is_viewed = 0;
    const int sent = wire_frame_begin(&d->out, v->number);
    if (sent != WIRE_OK) {
        d->is_viewed = 1;
        return 0;
    }
    d->step = RENDERS;
    if (plt_render_begin(d->engine, &frame) != PLT_OK) {
        wire_error_send(&d->peer, WIRE_E_VIEW, v->number);
        d->step = ENDS;
    }
    return 1;
}

static int render(wire_device *d, uint32_t visits) {
    const int status = plt_render_step(d->engine, visits);
    if (status == PLT_TILE) {
        plt_render_tile(d->engine, &d->tile);
        d->step = HAS_TILE;
    } else if (status <= PLT_OK) {
        d->step = ENDS;
    }
    return 1;
}

/* With a session its frame ends, too: it is rendered again in the next. */
static int after(wire_device *d, int status, unsigned next) {
    if (status == WIRE_OK) {
        d->step = (uint8_t)next;
        return 1;
    }
    if (status == WIRE_ERR_DOWN) {
        d->is_viewed = 1;
        d->step = BEGINS;
    }
    return 0;
}

static int send_tile(wire_device *d) {
    const plt_tile *t = &d->tile;
    return after(d, wire_frame_tile(&d->out, t->x, t->y, t->rgb, 3u * t->width), RENDERS);
}

static int end_frame(wire_device *d) {
    const int went = after(d, wire_frame_end(&d->out), RESTS);
    d->frames += went > 0;
    return went;
}

/* Begins again for a new view, or when something of this one was lost. */
static int rest(wire_device *d) {
    const int is_lost = d->out.unanswered == 0 && !wire_frames_out_done(&d->out);
    if (!wire_is_up(&d->peer) || d->out.tiles == 0 || (has_view(d) && d->is_viewed) || is_lost) {
        d->step = BEGINS;
        return 1;
    }
    return 0;
}

int wire_device_run(wire_device *d, uint32_t visits) {
    if (check_scene(d)) {
        return 1;
    }
    switch (d->step) {
    case NEEDS_SCENE:
        d->step = d->engine != NULL ? NEEDS_VIEW : NEEDS_SCENE;
        return 0;
    case NEEDS_VIEW:
        d->step = has_view(d) ? BEGINS : NEEDS_VIEW;
        return d->step == BEGINS;
    case BEGINS:
        has_view(d);
        return begin(d);
    case RENDERS:
        return render(d, visits);
    case HAS_TILE:
        return send_tile(d);
    case ENDS:
        return end_frame(d);
    default:
        return rest(d);
    }
}

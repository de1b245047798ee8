/* device - see wire_device.h
 *
 * A state machine; wire_device_run does one step of it. The image lies at the
 * front of the memory, the engine's arena behind it; of a streamed scene all is arena.
 *
 * SPDX-License-Identifier: MIT */
#include <string.h>

#include "platform/wire/base.h"
#include "platform/wire/wire_device.h"

enum step { NEEDS_SCENE, NEEDS_VIEW, BEGINS, RENDERS, HAS_TILE, ENDS, RESTS, HAS_FAILED };

/* No view has it whose frame is waited for: of a frame that is given up. */
enum { MARK_FAILED = 0x80 };

/* A number of samples that no engine takes. */
enum { NO_SAMPLES = 2 };

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
    d->view.obeys = (PLT_WITH_BACKGROUND ? WIRE_VIEW_BACKGROUND : 0) |
                    (PLT_WITH_SAMPLES ? WIRE_VIEW_SAMPLES : 0);
    return status;
}

/* ---- streamed scenes ---- */

#if PLT_WITH_STREAMED
/* Meanwhile the engine is at work in the memory: the image of another host must wait, and ends
 * the work. */
static int pump_held(void *context) {
    wire_device *d = context;
    d->scene.is_held = 1;
    const int status = d->pump(d->pump_context);
    d->scene.is_held = 0;
    return d->scene.is_replaced ? -1 : status;
}

void wire_device_stream(wire_device *d, int (*pump)(void *context), void *context) {
    d->pump = pump;
    d->pump_context = context;
    wire_blocks_in_open(&d->blocks, &d->peer, pump_held, d);
    wire_scene_in_blocks(&d->scene);
    d->peer.own.features |= WIRE_STREAMS;
}

static int has_blocks(const wire_device *d) {
    return d->scene.takes_blocks && d->peer.other.features & WIRE_SCENES;
}

static int open_streamed(wire_device *d, uint32_t bytes, plt_fault *fault) {
    plt_options options = d->options;
    options.residency = PLT_RESIDENCY_STREAMED;
    wire_blocks_in_image(&d->blocks, d->scene.crc);
    d->source = (plt_source){.bytes = bytes,
                             .context = &d->blocks,
                             .start = wire_source_start,
                             .wait = wire_source_wait};
    wire_scene_in_verdict(&d->scene, WIRE_SCENE_BLOCKS);
    const int status =
        plt_open(&d->engine, d->memory, d->memory_bytes, &d->source, &options, fault);
    d->is_streamed = status == PLT_OK;
    return status;
}
#endif

/* ---- the scene ---- */

/* Bytes did not come, as the host is silent. When it is heard again, so are requests. */
static int is_deserted(const wire_device *d, int status) {
    return status == PLT_ERR_SOURCE && !wire_is_up(&d->peer);
}

/* Why there is no scene or no frame, for the host; but not for one that offers another scene, or is
 * silent. */
static void report_fault(wire_device *d, int status, const plt_fault *fault) {
    if (d->scene.is_replaced || is_deserted(d, status)) {
        return;
    }
    if (status == PLT_ERR_ARENA) {
        wire_error_send(&d->peer, WIRE_E_ARENA, (uint32_t)fault->need_bytes);
    } else {
        wire_fault_send(&d->peer, status == PLT_ERR_SOURCE ? WIRE_E_SOURCE : WIRE_E_SCENE,
                        fault->rule, fault->offset, fault->kind);
    }
}

static int open_whole(wire_device *d, uint32_t bytes, plt_fault *fault) {
    const size_t front = ((size_t)bytes + PLT_ALIGN - 1) / PLT_ALIGN * PLT_ALIGN;
    const size_t rest = front < d->memory_bytes ? d->memory_bytes - front : 0;
    d->source = (plt_source){.mapped = d->memory, .bytes = bytes};
    const int status = plt_open(&d->engine, rest > 0 ? d->memory + front : d->memory, rest,
                                &d->source, &d->options, fault);
    fault->need_bytes += status == PLT_ERR_ARENA ? bytes : 0;
    return status;
}

/* What has no room is streamed, if it can be; if not, there is no room. */
static unsigned open_somehow(wire_device *d, unsigned state, uint32_t bytes) {
    plt_fault fault = {0};
    int status = state == WIRE_SCENE_HERE ? open_whole(d, bytes, &fault) : PLT_ERR_ARENA;
#if PLT_WITH_STREAMED
    if (status == PLT_ERR_ARENA && has_blocks(d)) {
        plt_fault other = {0};
        const int streams = open_streamed(d, bytes, &other);
        const int can_be = streams != PLT_ERR_ARGUMENT && streams != PLT_ERR_LIMIT;
        if (!can_be && state != WIRE_SCENE_HERE) {
            return WIRE_SCENE_LARGE;
        }
        status = can_be ? streams : status;
        fault = can_be ? other : fault;
    }
#endif
    if (status < 0) {
        report_fault(d, status, &fault);
        return status == PLT_ERR_SOURCE ? WIRE_SCENE_NONE : WIRE_SCENE_REFUSED;
    }
    return WIRE_SCENE_OPEN;
}

static void open_scene(wire_device *d, unsigned state, uint32_t bytes) {
    d->is_streamed = d->is_failed = 0;
    const unsigned verdict = open_somehow(d, state, bytes);
    d->engine = verdict == WIRE_SCENE_OPEN ? d->engine : NULL;
    wire_scene_in_verdict(&d->scene, verdict);
}

/* The host may replace the scene at any time; then there is no engine any more. */
static int check_scene(wire_device *d) {
    uint32_t bytes;
    const unsigned state = wire_scene_in_state(&d->scene, &bytes);
    if (state == WIRE_SCENE_HERE || state == WIRE_SCENE_BLOCKS) {
        open_scene(d, state, bytes);
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

/* A frame whose scene went away before it was whole ends here. */
static void end_orphan(wire_device *d) {
    if (d->out.in_frame) {
        d->out.mark = (uint8_t)(d->view.view.number ^ MARK_FAILED);
        wire_frame_end(&d->out);
    }
}

/* The frame that the view asks for, as far as this engine has it. */
static plt_frame get_frame(const wire_device *d) {
    const wire_view *v = &d->view.view;
    plt_frame frame = {.width = d->out.width, .height = d->out.height, .shader = v->shader};
    memcpy(frame.camera.eye, v->eye, sizeof v->eye);
    memcpy(frame.camera.look, v->look, sizeof v->look);
    memcpy(frame.camera.up, v->up, sizeof v->up);
    frame.camera.tan_half_fov = v->tan_half_fov;
#if PLT_WITH_SAMPLES
    static const uint8_t samples[] = {PLT_SAMPLES_ONE, PLT_SAMPLES_FOUR, PLT_SAMPLES_SIXTEEN,
                                      PLT_SAMPLES_ADAPTIVE};
    frame.samples = v->samples < sizeof samples ? samples[v->samples] : NO_SAMPLES;
#endif
#if PLT_WITH_BACKGROUND
    frame.has_background = v->has_background;
    memcpy(frame.background, v->background, sizeof v->background);
#endif
    return frame;
}

/* Whether the engine takes the frame; if it does not, the host is told what it does not take. */
static int is_begun(wire_device *d) {
    plt_frame frame = get_frame(d);
    if (plt_render_begin(d->engine, &frame) == PLT_OK) {
        return 1;
    }
    const int is_many = frame.samples > PLT_SAMPLES_ONE;
    frame.samples = PLT_SAMPLES_ONE;
    wire_error_send(&d->peer,
                    is_many && plt_render_begin(d->engine, &frame) == PLT_OK ? WIRE_E_SAMPLES
                                                                             : WIRE_E_VIEW,
                    d->view.view.number);
    return 0;
}

static int begin(wire_device *d) {
    end_orphan(d);
    d->is_viewed = d->is_failed = 0;
    const int sent = wire_frame_begin(&d->out, d->view.view.number);
    if (sent != WIRE_OK) {
        d->is_viewed = 1;
        return 0;
    }
    d->step = is_begun(d) ? RENDERS : ENDS;
    return 1;
}

/* A block did not come, or is not valid: the frame ends, unfit to be shown. */
static void fail(wire_device *d, int status) {
    plt_fault fault = {0};
    plt_fault_get(d->engine, &fault);
    report_fault(d, status, &fault);
    d->is_deserted = (uint8_t)is_deserted(d, status);
    d->failed_session = d->peer.stats.sessions;
    d->failed_ms = d->peer.now_ms;
    d->out.mark ^= MARK_FAILED;
    d->is_failed = 1;
}

static int render(wire_device *d, uint32_t visits) {
    const int status = plt_render_step(d->engine, visits);
    if (status < 0) {
        fail(d, status);
    }
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
    const int went = after(d, wire_frame_end(&d->out), d->is_failed ? HAS_FAILED : RESTS);
    d->frames += went > 0 && !d->is_failed;
    return went;
}

/* The host that was there then hears of it again, as one message may be lost; a view, which also
 * every new session brings, is tried anew. */
static int stay_failed(wire_device *d) {
    if ((has_view(d) && d->is_viewed) || (d->is_deserted && wire_is_up(&d->peer))) {
        d->step = BEGINS;
        return 1;
    }
    if (!d->is_deserted && d->peer.stats.sessions == d->failed_session && !d->scene.is_replaced &&
        d->peer.now_ms - d->failed_ms >= WIRE_IDLE_MS) {
        d->failed_ms = d->peer.now_ms;
        wire_error_repeat(&d->peer);
    }
    return 0;
}

/* Begins again for a new view, or when something of this one was lost. */
static int rest(wire_device *d) {
    const int is_lost = d->out.unanswered == 0 && !wire_frames_out_done(&d->out);
    if (!wire_has_session(&d->peer) || d->out.tiles == 0 || (has_view(d) && d->is_viewed) ||
        is_lost) {
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
    case HAS_FAILED:
        return stay_failed(d);
    default:
        return rest(d);
    }
}

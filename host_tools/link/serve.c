/* serve - see serve.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/link/serve.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "host_tools/base/clock.h"
#include "host_tools/base/progress.h"

/* What the progress line is about. */
enum phase { PHASE_NONE, PHASE_SCENE, PHASE_FRAME };

typedef struct serving {
    const serve_job *job;
    const transport *t;
    wire_peer peer;
    wire_frames_in in;
    wire_scene_out scene;
    wire_view_out view;
    wire_blocks_out blocks;
    uint8_t *panel;
    picture shown;
    unsigned number; /* frames received */
    uint32_t seen;   /* whole frames received when the view was sent */
    uint32_t began_ms;
    uint32_t moved_ms; /* when a frame came, or a part of one, or bytes of the scene were sent */
    uint64_t moved;    /* such things, until then */
    int is_up, is_heard;
    progress bar;
    enum phase phase;
    uint32_t tiles; /* received when the frame began */
    char what[40];
} serving;

static int open_end(serving *s, fail *f) {
    const serve_job *job = s->job;
    const wire_setup setup = {.role = WIRE_HOST,
                              .caps = {.session = (uint32_t)clock_day_us(),
                                       .width = (uint16_t)job->width,
                                       .height = (uint16_t)job->height,
                                       .format = (uint8_t)job->format,
                                       .formats = 1u << job->format,
                                       .in_bytes = (uint16_t)job->report_bytes,
                                       .out_bytes = (uint16_t)job->report_bytes,
                                       .credits = 16,
                                       .features = WIRE_SHOWS | WIRE_READS | WIRE_SCENES}};
    const uint32_t stride = wire_row_bytes(job->format, job->width);
    s->panel = calloc(stride, job->height);
    const wire_panel panel = {s->panel, stride, NULL, NULL};
    if (s->panel == NULL || picture_make(&s->shown, job->width, job->height, f) != 0) {
        return fail_set(f, "frame", "out of memory; choose a smaller --size");
    }
    if (wire_peer_open(&s->peer, &setup, clock_ms()) != WIRE_OK ||
        wire_frames_in_open(&s->in, &s->peer, &panel) != WIRE_OK) {
        return fail_set(f, "--size", "%ux%u has more than %d tiles of 16x16; choose a smaller one",
                        job->width, job->height, WIRE_TILES_MAX);
    }
    wire_scene_out_open(&s->scene, &s->peer, job->image, job->image_bytes);
    wire_blocks_out_open(&s->blocks, &s->peer, job->image, job->image_bytes);
    wire_view_out_open(&s->view, &s->peer);
    wire_on_link(&s->peer, 0, clock_ms());
    return 0;
}

/* Receives and sends all reports that can go; whether the link is there. */
static int exchange(serving *s) {
    uint8_t report[WIRE_REPORT_BYTES_MAX];
    int n = s->t->receive(s->t->context, report, 2);
    for (; n > 0; n = s->t->receive(s->t->context, report, 0)) {
        wire_on_report(&s->peer, report, (size_t)n, clock_ms());
    }
    if (n < 0) {
        return 0;
    }
    wire_poll(&s->peer, clock_ms());
    for (size_t bytes; (bytes = wire_next_report(&s->peer, report, clock_ms())) > 0;) {
        int sent;
        while ((sent = s->t->send(s->t->context, report, bytes)) == 0) {
            clock_sleep(0.0005);
        }
        if (sent < 0) {
            return 0;
        }
    }
    return 1;
}

static void say(const serving *s, const char *what) {
    if (s->job->verbose) {
        fprintf(stderr, "serve: %s\n", what);
    }
}

static void end_progress(serving *s) {
    progress_end(&s->bar);
    s->phase = PHASE_NONE;
}

static void enter(serving *s, enum phase phase) {
    if (s->phase == phase) {
        return;
    }
    end_progress(s);
    s->phase = phase;
    if (phase == PHASE_SCENE) {
        progress_begin(&s->bar, "serve: sending the scene", s->job->image_bytes);
    } else if (phase == PHASE_FRAME) {
        const unsigned tiles = (s->job->width + 15) / 16 * ((s->job->height + 15) / 16);
        snprintf(s->what, sizeof s->what, "serve: rendering, frame %u", s->number + 1);
        s->tiles = s->peer.stats.tiles_in;
        progress_begin(&s->bar, s->what, tiles);
    }
}

/* A device may need long for a scene and for a frame: shows how far it is. */
static void show_progress(serving *s) {
    uint32_t has = 0;
    const unsigned state = wire_scene_out_state(&s->scene, &has);
    enter(s, !wire_is_up(&s->peer)       ? PHASE_NONE
             : state == WIRE_SCENE_GOING ? PHASE_SCENE
             : state == WIRE_SCENE_OPEN  ? PHASE_FRAME
                                         : PHASE_NONE);
    if (s->phase != PHASE_NONE) {
        const uint64_t done = s->phase == PHASE_SCENE ? has : s->peer.stats.tiles_in - s->tiles;
        progress_show(&s->bar, done < s->bar.total ? done : s->bar.total);
    }
}

static void update_link(serving *s, int is_there) {
    if (wire_is_up(&s->peer) != s->is_heard) {
        s->is_heard = !s->is_heard;
        say(s, s->is_heard ? "the device is heard" : "the device is silent, waiting");
    }
    if (is_there != s->is_up) {
        s->is_up = is_there;
        wire_on_link(&s->peer, is_there, clock_ms());
        say(s, is_there ? "the link is there" : "the link is down, waiting");
    }
}

/* A device that streams has looked at the scene, and cannot. */
static int refuse_size(const serving *s, fail *f) {
    const wire_caps *device = wire_other(&s->peer);
    return fail_set(f, "device", "the image of %u bytes does not fit in its %u; pack it %s",
                    s->job->image_bytes, device->arena_bytes,
                    device->features & WIRE_STREAMS
                        ? "with --nodes compact --geometry lattice:14 --build host, and it can "
                          "be streamed"
                        : "smaller");
}

/* Fails with a sentence for the device's error, or when the scene does not fit; else 0. */
static int refusal(serving *s, fail *f) {
    uint32_t detail, has;
    const unsigned state = wire_scene_out_state(&s->scene, &has);
    const unsigned code = wire_error_read(&s->peer, &detail);
    char kind;
    const uint32_t place = wire_error_place(&s->peer, &kind);
    if (code == WIRE_E_ARENA) {
        return fail_set(f, "device", "the scene needs %u bytes there, it has %u; pack it smaller",
                        detail, wire_other(&s->peer)->arena_bytes);
    }
    if (code == WIRE_E_SCENE) {
        return fail_set(f, "device", "the scene was refused: rule %c%u at byte %u; pack it again",
                        kind, detail >> 24, place);
    }
    if (code == WIRE_E_SOURCE) {
        return fail_set(f, "device",
                        "bytes of the scene did not come, from byte %u on; check the link and "
                        "serve it again",
                        place);
    }
    if (code == WIRE_E_VERSION) {
        return fail_set(
            f, "device",
            "speaks version %u of the protocol, this program %d; build both from the same source",
            detail, WIRE_VERSION);
    }
    if (state == WIRE_SCENE_LARGE) {
        return refuse_size(s, f);
    }
    if (code == WIRE_E_SAMPLES) {
        return fail_set(f, "device",
                        "its engine does not take so many samples; use --samples 4, or 1");
    }
    if (wire_view_left_out(&s->view) & WIRE_VIEW_BACKGROUND) {
        return fail_set(f, "device",
                        "its firmware knows no background; leave out --background, or build it "
                        "with PARTS that say background");
    }
    if (wire_view_left_out(&s->view) & WIRE_VIEW_SAMPLES) {
        return fail_set(f, "device",
                        "its firmware knows one sample per pixel; leave out --samples, or build "
                        "it with PARTS that say samples");
    }
    if (code == WIRE_E_VIEW) {
        return fail_set(f, "device",
                        "eye and look coincide, up runs along the view, or one of them is beyond "
                        "2^40; change --eye, --look, --up or --fov");
    }
    return 0;
}

static void send_view(serving *s) {
    wire_view v = {.number = 0};
    s->job->view(s->job->context, s->number, &v);
    wire_view_send(&s->view, &v);
    s->seen = wire_frames_shown(&s->in);
}

static int receive_frame(serving *s, fail *f) {
    const serve_job *job = s->job;
    const uint32_t stride = wire_row_bytes(job->format, job->width);
    for (unsigned y = 0; y < job->height; y++) {
        wire_row_to_rgb(s->shown.rgb + 3 * (size_t)y * job->width, job->format,
                        s->panel + (size_t)y * stride, job->width);
    }
    end_progress(s);
    const int status = job->frame(job->context, s->number, &s->shown, f);
    s->number++;
    if (status == 0 && s->number != job->frames) {
        send_view(s);
    }
    return status;
}

/* A frame may take long: whoever sends a part of it, or asks for parts of the scene, is at work. */
static int is_out_of_patience(serving *s) {
    uint32_t has;
    wire_scene_out_state(&s->scene, &has);
    const uint64_t moved = (uint64_t)s->number + s->peer.stats.tiles_in + s->blocks.sent + has;
    if (moved != s->moved) {
        s->moved = moved;
        s->moved_ms = clock_ms();
    }
    return s->job->patience_ms > 0 && clock_ms() - s->moved_ms > s->job->patience_ms;
}

/* A whole frame of the view that was sent: the device marks it with the
 * view's number. */
static int has_frame(const serving *s) {
    return wire_frames_shown(&s->in) != s->seen && wire_frames_mark(&s->in) == s->view.view.number;
}

int serve_run(const serve_job *job, const transport *t, serve_result *result, fail *f) {
    serving *s = calloc(1, sizeof *s);
    int status = s == NULL ? fail_set(f, "serve", "out of memory; close other programs") : 0;
    if (status == 0) {
        s->job = job;
        s->t = t;
        s->began_ms = s->moved_ms = clock_ms();
        status = open_end(s, f);
    }
    if (status == 0) {
        send_view(s);
    }
    while (status == 0 && (job->frames == 0 || s->number < job->frames)) {
        update_link(s, exchange(s));
        status = refusal(s, f);
        show_progress(s);
        if (status == 0 && has_frame(s)) {
            status = receive_frame(s, f);
        }
        if (status == 0 && is_out_of_patience(s)) {
            status =
                fail_set(f, "device", "%s; is it connected, and does it render?",
                         wire_is_up(&s->peer) ? "sent no frame in time" : "did not answer in time");
        }
    }
    if (s != NULL) {
        end_progress(s);
        *result = (serve_result){.host = s->peer.stats,
                                 .block_bytes = s->blocks.sent,
                                 .blocks = s->blocks.asked,
                                 .frames = s->number,
                                 .ms = clock_ms() - s->began_ms};
        free(s->panel);
        picture_free(&s->shown);
    }
    free(s);
    return status;
}

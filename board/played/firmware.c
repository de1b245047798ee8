/* played/firmware - plays the frames of an image's sequence, each in bounded steps
 *
 * Replaces board/firmware.c; the board calls it in the same manner. What a device would do in its
 * main loop, frame by frame: read the next one (plt_sequence_step), show it (records, and a refit
 * or a new grid; or a refit, or what was refitted beside), go on with a rebuild if one pays
 * (plt_rebuild_step), render (plt_render_step). Each call lies between two marks of marks.h, so
 * that a counter has the longest of each.
 *
 * Parameters beside those of job.c (board/firmware.c lists them):
 *   frames=0:500       the first, and the one after the last (all of the image)
 *   blocks=8           of 64 vertices, per plt_sequence_step
 *   rebuild=never|always|cost    if the engine has PLT_WITH_REBUILD
 *   rebuild_most=600   triangles of a subtree that is rebuilt, if it has PLT_WITH_SUBTREES (the
 *                      whole tree)
 *   triangles=1000     per plt_rebuild_step, one step per frame
 *   records=auto|always|never    if it has PLT_WITH_VERTICES
 *   beside=0           1: the next frame's tree is refitted in plt_sequence_step, likewise
 *
 * Prints a line for each frame, "played frame=K frame_hash=... used=... peak=... touched=...":
 * bytes of the arena in use, the most that ever were, and where the last byte lies that has changed
 * since the scene is open (spare.h).
 *
 * SPDX-License-Identifier: MIT */
#include "board/board.h"
#include "board/hash.h"
#include "board/line.h"
#include "board/played/marks.h"
#include "board/played/orders.h"
#include "board/played/spare.h"
#include "board/report.h"

typedef struct player {
    plt_engine *engine;
    orders orders;
    spare spare;
    uint32_t given_up;  /* rebuilds for want of room */
    plt_stats had;      /* statistics before this frame */
    const uint8_t *rgb; /* of this frame; NULL on a board that keeps none */
} player;

static int open_scene(player *p, const plt_source *source, plt_fault *fault) {
    const orders *o = &p->orders;
    firmware_open_begin();
    int status = plt_open_begin(&p->engine, p->spare.arena, o->arena_bytes, source,
                                &o->picture.options, fault);
    firmware_open_end();
    while (status == PLT_MORE) {
        firmware_open_begin();
        status = plt_open_step(p->engine, 16, fault);
        firmware_open_end();
    }
    return status;
}

static int read_frame(player *p, uint32_t frame, plt_fault *fault) {
    int status = plt_sequence_begin(p->engine, frame, fault);
    while (status >= PLT_OK) {
        firmware_read_begin();
        status = plt_sequence_step(p->engine, p->orders.blocks, fault);
        firmware_read_end();
        if (status == PLT_OK) {
            return PLT_OK;
        }
    }
    return status;
}

static int show_frame(player *p, uint32_t frame, plt_fault *fault) {
    firmware_show_begin();
    const int status = plt_sequence_show(p->engine, frame, fault);
    firmware_show_end();
    return status;
}

/* A step, if a rebuild has begun or it is time for one. */
static int rebuild_some(player *p, plt_fault *fault) {
#if PLT_WITH_REBUILD
    plt_motion motion;
    plt_motion_get(p->engine, &motion);
    const int is_due = plt_rebuild_due(p->engine, p->orders.rebuild_when, 1);
    if (!is_due && !motion.is_building) {
        return PLT_OK;
    }
    firmware_rebuild_begin();
    int status = is_due ? plt_rebuild_begin(p->engine, fault) : PLT_OK;
    status = status < 0 ? status : plt_rebuild_step(p->engine, p->orders.triangles, fault);
    firmware_rebuild_end();
    if (status == PLT_ERR_ARENA || status == PLT_ERR_LIMIT) { /* the old tree goes on */
        p->given_up++;
        return PLT_OK;
    }
    return status < 0 ? status : PLT_OK;
#else
    (void)p;
    (void)fault;
    return PLT_OK;
#endif
}

static int render(player *p, plt_fault *fault) {
    const job *j = &p->orders.picture;
    int status = plt_render_begin(p->engine, &j->frame);
    if (status < 0) {
        fault->message = "the camera has no direction, or the frame no size";
        return status;
    }
    do {
        firmware_render_begin();
        status = plt_render_step(p->engine, j->visits);
        firmware_render_end();
        if (status == PLT_TILE) {
            plt_tile tile;
            plt_render_tile(p->engine, &tile);
            board_tile(&tile);
        }
    } while (status > 0);
    if (status < 0) {
        plt_fault_get(p->engine, fault);
    }
    return status;
}

static void print_frame(player *p, uint32_t frame) {
    const plt_frame *f = &p->orders.picture.frame;
    const plt_stats had = p->had;
    plt_motion motion;
    line l;
    plt_motion_get(p->engine, &motion);
    plt_stats_get(p->engine, &p->had);
    line_start(&l);
    line_text(&l, "played");
    line_item(&l, "frame", frame);
    if (p->rgb) {
        line_text(&l, " frame_hash=");
        line_hex(&l, hash_bytes(p->rgb, (size_t)f->width * f->height * 3), 16);
    }
    line_item(&l, "used", plt_arena_used(p->engine));
    line_item(&l, "peak", plt_arena_peak(p->engine));
    line_item(&l, "touched", spare_touched(&p->spare));
    line_item(&l, "rays", p->had.rays - had.rays);
    line_item(&l, "visits", p->had.node_visits - had.node_visits);
    line_item(&l, "rebuilds", motion.rebuilds);
    line_item(&l, "given_up", p->given_up);
    line_print(&l);
}

static int play_frame(player *p, uint32_t frame, plt_fault *fault) {
    int status = read_frame(p, frame, fault);
    status = status < 0 ? status : show_frame(p, frame, fault);
    status = status < 0 ? status : rebuild_some(p, fault);
    status = status < 0 ? status : render(p, fault);
    return status;
}

/* All frames; a FIRMWARE_ status. */
static int play(player *p) {
    const orders *o = &p->orders;
    for (uint32_t frame = o->first; frame < o->end; frame++) {
        plt_fault fault = {.message = NULL};
        if (board_frame_begin(o->picture.frame.width, o->picture.frame.height) < 0) {
            return FIRMWARE_FAILED;
        }
        const int status = play_frame(p, frame, &fault);
        if (status < 0) {
            return report_fault(&fault, status, o->arena_bytes);
        }
        p->rgb = board_frame_end(o->parameters);
        print_frame(p, frame);
        firmware_frame_done();
    }
    return FIRMWARE_DONE;
}

/* What the engine does in one call, and with which bound. */
static void print_bounds(const player *p) {
    const orders *o = &p->orders;
    line l;
    line_start(&l);
    line_text(&l, "bounds");
    line_item(&l, "blocks", o->blocks);
    line_item(&l, "visits", o->picture.visits);
    line_item(&l, "triangles", o->triangles);
    line_item(&l, "packet", plt_packet_side(p->engine));
#if PLT_WITH_VERTICES
    plt_motion motion;
    plt_motion_get(p->engine, &motion);
    line_item(&l, "over_vertices", motion.over_vertices);
    line_item(&l, "beside", motion.is_beside);
#endif
    line_print(&l);
}

int firmware(const char *parameters) {
    player p = {.given_up = 0};
    plt_source source = {0};
    plt_fault fault = {0};
    size_t arena_bytes;
    p.spare.arena = board_arena(&arena_bytes);
    if (orders_read(&p.orders, parameters, arena_bytes) < 0) {
        return FIRMWARE_USAGE;
    }
    report_name();
    if (board_scene(parameters, &source) < 0) {
        return FIRMWARE_FAILED;
    }
    const int status = open_scene(&p, &source, &fault);
    if (status < 0) {
        return report_fault(&fault, status, p.orders.arena_bytes);
    }
    const plt_info *info = plt_engine_info(p.engine);
    if (p.orders.end == 0) { /* of an image without frames the first is asked for, and refused */
        p.orders.end = info->frames > 0 ? info->frames : 1;
    }
    job_set_camera(&p.orders.picture, info);
    p.spare.used = plt_arena_used(p.engine);
    p.spare.bytes = p.orders.arena_bytes;
    spare_fill(&p.spare);
    report_scene(info);
    print_bounds(&p);
    report_memory(p.engine, p.orders.arena_bytes);
    firmware_frame_done();
    const int result = play(&p);
    report_memory(p.engine, p.orders.arena_bytes);
    return result;
}

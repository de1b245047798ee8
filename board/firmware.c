/* firmware - opens a scene, renders one frame in a main loop, prints statistics
 *
 * Parameters, key=value; numbers of three are x,y,z; a float is decimal or
 * its bits in hexadecimal (0x3f800000), with which two machines can use
 * exactly the same camera:
 *   size=320x240       pixels          eye= look= up= tan=   the camera; tan is
 *   packet=8           rays per side               of half the vertical angle
 *   walk=depth|two     order of traversal          shader=eyelight|normal|triangle|smooth|whitted
 *   sun= point=        with shader=whitted, where the engine has PLT_WITH_WHITTED: x,y,z of the
 *                      direction or place, power, radius and samples; sky= ground= r,g,b; depth=4
 *                      shadows=clear|solid: light comes through glass, or none
 *   flight=32 rays=auto|coherent|incoherent        likewise, with PLT_WITH_WAVE: rays in flight,
 *                      without it none, and which of those off surfaces
 *   textures=none|nearest|bilinear                 with shader=smooth, too, if the engine has
 *                      PLT_WITH_TEXTURE
 *   visits=20000       node visits per step of the main loop
 *   arena=65536        use less of the arena than there is
 *   structure=tree|grid                            if the engine has PLT_WITH_GRID
 *   show=0             frame of the image's sequence, if the engine has PLT_WITH_SEQUENCE,
 *                      or of its instances (PLT_WITH_INSTANCES)
 *   records=auto|always|never    of its triangles, if it has PLT_WITH_VERTICES
 *   scene= bytes= frame= hold=   are the board's: where the image is, where the frame goes, how
 *                      long a panel shows it
 *
 * Prints one line per topic, each a word and name=value items, or one line that
 * begins with "error: ". What it returns is in board.h.
 *
 * SPDX-License-Identifier: MIT */
#include "board/board.h"
#include "board/hash.h"
#include "board/job.h"
#include "board/line.h"
#include "board/report.h"

/* Where an instruction counter starts and stops: around opening the scene,
 * and around every step of the renderer but not the board's copying. */
__attribute__((noinline)) void firmware_open_begin(void);
__attribute__((noinline)) void firmware_open_end(void);
__attribute__((noinline)) void firmware_render_begin(void);
__attribute__((noinline)) void firmware_render_end(void);

void firmware_open_begin(void) {
    __asm__ volatile("");
}

void firmware_open_end(void) {
    __asm__ volatile("");
}

void firmware_render_begin(void) {
    __asm__ volatile("");
}

void firmware_render_end(void) {
    __asm__ volatile("");
}

static void print_stats(const plt_engine *engine) {
    plt_stats stats;
    line l;
    plt_stats_get(engine, &stats);
    line_start(&l);
    line_text(&l, "stats");
    line_item(&l, "rays", stats.rays);
    line_item(&l, "node_visits", stats.node_visits);
    line_item(&l, "group_tests", stats.group_tests);
    line_item(&l, "triangle_tests", stats.triangle_tests);
    line_item(&l, "packets", stats.packets);
    line_print(&l);
    line_text(&l, "streamed");
    line_item(&l, "treelet_fetches", stats.treelet_fetches);
    line_item(&l, "bytes_fetched", stats.bytes_fetched);
    line_item(&l, "retries", stats.fetch_retries);
    line_print(&l);
}

static void print_frame(const plt_frame *frame, uint32_t tiles, uint32_t ticks,
                        const uint8_t *rgb) {
    line l;
    line_start(&l);
    line_text(&l, "frame");
    line_item(&l, "width", frame->width);
    line_item(&l, "height", frame->height);
    line_item(&l, "tiles", tiles);
    line_item(&l, "ticks", ticks);
    line_item(&l, "ticks_per_second", board_ticks_per_second());
    line_print(&l);
    if (rgb) {
        line_text(&l, "frame_hash=");
        line_hex(&l, hash_bytes(rgb, (size_t)frame->width * frame->height * 3), 16);
        line_print(&l);
    }
}

/* The main loop of a device: a step of the renderer, then whatever else there
 * is to do (here: the tile). Returns PLT_OK or an error. */
static int render(plt_engine *engine, const job *j, uint32_t *tiles) {
#if PLT_WITH_WHITTED
    const int lit =
        j->frame.shader == PLT_SHADE_WHITTED ? plt_lighting_set(engine, &j->lighting) : PLT_OK;
#else
    const int lit = PLT_OK;
#endif
    int status = lit == PLT_OK ? plt_render_begin(engine, &j->frame) : lit;
    if (status < 0) {
        return status;
    }
    do {
        firmware_render_begin();
        status = plt_render_step(engine, j->visits);
        firmware_render_end();
        if (status == PLT_TILE) {
            plt_tile tile;
            plt_render_tile(engine, &tile);
            board_tile(&tile);
            ++*tiles;
        }
    } while (status > 0);
    return status;
}

static int run(plt_engine *engine, const job *j, const char *parameters) {
    uint32_t tiles = 0;
    if (board_frame_begin(j->frame.width, j->frame.height) < 0) {
        return FIRMWARE_FAILED;
    }
    plt_stats_reset(engine);
    const uint32_t before = board_ticks();
    const int status = render(engine, j, &tiles);
    const uint32_t ticks = board_ticks() - before;
    if (status == PLT_ERR_ARGUMENT) {
        board_print("error: the camera has no direction, or the frame no size\n");
        return FIRMWARE_FAILED;
    }
    if (status < 0) {
        plt_fault fault;
        plt_fault_get(engine, &fault);
        return report_fault(&fault, status, 0);
    }
    print_frame(&j->frame, tiles, ticks, board_frame_end(parameters));
    print_stats(engine);
    return FIRMWARE_DONE;
}

#define SHOWS_FRAMES (PLT_WITH_SEQUENCE || PLT_WITH_INSTANCES)
#if PLT_WITH_VERTICES
#define OWN_KEYS "show records"
#elif SHOWS_FRAMES
#define OWN_KEYS "show"
#else
#define OWN_KEYS ""
#endif

/* show=K: *shown is K, and there is one. 1: it is given. */
static int read_shown(const char *parameters, job *j, uint32_t *shown) {
#if PLT_WITH_VERTICES
    static const char *const words[] = {"auto", "always", "never"};
    if (job_word(parameters, "records", words, 3, &j->options.records) < 0) {
        return -1;
    }
#else
    (void)j;
#endif
#if SHOWS_FRAMES
    return job_u32(parameters, "show", 0, UINT32_MAX, shown);
#else
    (void)parameters;
    (void)shown;
    return 0;
#endif
}

/* Frames of vertices are shown by a scene that was opened to be moved. */
static void set_movable(job *j, const plt_source *source, int shows) {
#if PLT_WITH_SEQUENCE
    plt_info info = {0};
    plt_fault fault;
    j->options.movable =
        shows && !(plt_image_info(source, &info, &fault) == PLT_OK && info.instances > 0);
#else
    (void)j;
    (void)source;
    (void)shows;
#endif
}

/* Of the image; else nothing. */
static int show_frame(plt_engine *engine, int shows, uint32_t shown, plt_fault *fault) {
#if SHOWS_FRAMES
    return shows ? plt_sequence_show(engine, shown, fault) : PLT_OK;
#else
    (void)engine;
    (void)shows;
    (void)shown;
    (void)fault;
    return PLT_OK;
#endif
}

int firmware(const char *parameters) {
    plt_source source = {0};
    plt_fault fault = {0};
    plt_engine *engine = NULL;
    job j;
    size_t arena_bytes;
    uint32_t shown = 0;
    unsigned char *arena = board_arena(&arena_bytes);
    if (job_read(&j, parameters, OWN_KEYS, &arena_bytes) < 0) {
        return FIRMWARE_USAGE;
    }
    const int shows = read_shown(parameters, &j, &shown);
    if (shows < 0) {
        return FIRMWARE_USAGE;
    }
    report_name();
    if (board_scene(parameters, &source) < 0) {
        return FIRMWARE_FAILED;
    }
    set_movable(&j, &source, shows);
    firmware_open_begin();
    int status = plt_open_begin(&engine, arena, arena_bytes, &source, &j.options, &fault);
    while (status == PLT_MORE) { /* a product would do its other work here */
        status = plt_open_step(engine, 16, &fault);
    }
    firmware_open_end();
    if (status < 0) {
        return report_fault(&fault, status, arena_bytes);
    }
    status = show_frame(engine, shows, shown, &fault);
    if (status < 0) {
        return report_fault(&fault, status, arena_bytes);
    }
    report_scene(plt_engine_info(engine));
    job_set_camera(&j, plt_engine_info(engine));
    const int result = run(engine, &j, parameters);
    report_memory(engine, arena_bytes);
    return result;
}

/* wired/firmware - the firmware that gets its scene over a serial line and sends frames
 *
 * Replaces board/firmware.c; the board calls it in the same manner. Image and
 * arena share board_arena(), reports travel as bytes over board_serial
 * (platform/WIRE.md), and the host is `planelet serve`. It never ends: hosts come
 * and go, and the scene stays; one that has no room in the arena stays with the host, in a build
 * that has streamed scenes, and comes block by block. The only parameter is report=BYTES,
 * the size of a report, 8 to 1024 (64), the same as the host's.
 *
 * SPDX-License-Identifier: MIT */
#include "board/board.h"
#include "board/line.h"
#include "board/parameters.h"
#include "board/wired/serial.h"
#include "platform/wire/wire_bytes.h"
#include "platform/wire/wire_device.h"

/* Between two looks at the serial line: some milliseconds at 25 MHz. */
enum { VISITS_PER_STEP = 1000 };

/* A report has stopped coming when the line is quiet for QUIET_MS. Then, and after
 * MOVE_MS of moving bytes at most, the engine works again. */
enum { QUIET_MS = 2, MOVE_MS = 20 };

/* Credits: as many reports with data as the line keeps, beside some without. */
enum { CREDITS_MOST = 16, CREDITS_LEAST = 2, SPARE_REPORTS = 4, REPORT_BYTES = 64 };

static wire_device device;
static wire_bytes_reader incoming;

/* A report on its way out: `gone` of `used` bytes have left. */
static uint8_t report[WIRE_REPORT_BYTES_MAX], outgoing[WIRE_BYTES_MOST];
static size_t used, gone;

/* ---- a clock in milliseconds ----------------------------------------------- */

/* The clock is read more often than this. If it was not, the processor stood still, as an emulator
 * does when its host has other things to do: nobody could be heard in that time, and nobody is late
 * for it. */
enum { STOOD_STILL_MS = 250 };

static uint32_t last_ticks, spare_ticks, clock_ms;

/* Adds up differences, so that the counter may wrap between any two calls. */
static uint32_t now_ms(void) {
    const uint32_t ticks = board_ticks(), ticks_per_ms = board_ticks_per_second() / 1000;
    const uint32_t passed = ticks - last_ticks, most = STOOD_STILL_MS * ticks_per_ms;
    spare_ticks += passed < most ? passed : most;
    last_ticks = ticks;
    clock_ms += spare_ticks / ticks_per_ms;
    spare_ticks %= ticks_per_ms;
    return clock_ms;
}

/* ---- reports over the serial line ------------------------------------------- */

static int is_within; /* the last byte that came was not the end of a report */

/* Both return whether a byte moved. */
static int receive(void) {
    const int byte = board_serial_get();
    if (byte < 0) {
        return 0;
    }
    const size_t bytes = wire_bytes_read(&incoming, (uint8_t)byte);
    is_within = byte != 0;
    if (bytes > 0) {
        wire_on_report(&device.peer, incoming.report, bytes, now_ms());
    }
    return 1;
}

static int send(void) {
    if (gone == used) {
        const size_t bytes = wire_next_report(&device.peer, report, now_ms());
        used = bytes > 0 ? wire_bytes_put(outgoing, report, bytes) : 0;
        gone = 0;
    }
    if (gone == used || !board_serial_put(outgoing[gone])) {
        return 0;
    }
    gone++;
    return 1;
}

/* Moves the bytes that can move, and waits for the rest of a report that has begun
 * to come: a step of rendering is long, a byte is not. */
static void move_reports(void) {
    const uint32_t begun_ms = now_ms();
    uint32_t moved_ms = begun_ms, ms = begun_ms;
    while (ms - moved_ms <= QUIET_MS && ms - begun_ms < MOVE_MS) {
        const int received = receive(), sent = send();
        ms = now_ms();
        if (received || sent) {
            moved_ms = ms;
        } else if (!is_within) {
            return;
        }
    }
    if (ms - moved_ms > QUIET_MS) {
        is_within = 0; /* the rest does not come */
    }
}

#if PLT_WITH_STREAMED
/* While the engine waits for a block of the scene. */
static int await_reports(void *context) {
    (void)context;
    move_reports();
    wire_poll(&device.peer, now_ms());
    return 0;
}
#endif

/* ---- events, on the board's log ------------------------------------------ */

static unsigned scene_said;

static void say_name(void) {
    line l;
    line_start(&l);
    line_text(&l, "planelet wired board=");
    line_text(&l, board_name());
    line_item(&l, "memory", device.memory_bytes);
    line_print(&l);
}

/* A line whenever a scene was opened or refused. */
static void say_scene(void) {
    uint32_t bytes;
    const unsigned state = wire_scene_in_state(&device.scene, &bytes);
    line l;
    if (state != scene_said && (state == WIRE_SCENE_OPEN || state == WIRE_SCENE_REFUSED)) {
        line_start(&l);
        line_text(&l, state == WIRE_SCENE_OPEN ? "scene opened" : "scene refused");
        line_item(&l, "image_bytes", bytes);
        line_item(&l, "streamed", device.is_streamed);
        line_print(&l);
    }
    scene_said = state;
}

/* A line for every frame that was sent whole, with what was fetched for it and all before. Each
 * byte that the serial line loses is a lost report. */
static void print_frame(uint32_t number) {
    uint32_t painted, size;
    plt_stats stats;
    line l;
    board_stack(&painted, &size);
    plt_stats_get(device.engine, &stats);
    line_start(&l);
    line_text(&l, "frame");
    line_item(&l, "number", number);
    line_item(&l, "ms", now_ms());
    line_item(&l, "arena", plt_arena_peak(device.engine));
    line_item(&l, "painted", painted);
    line_item(&l, "lost_bytes", board_serial_lost());
    line_item(&l, "lost_reports", device.peer.stats.reports_lost);
    line_item(&l, "rays", stats.rays);
    if (device.is_streamed) {
        line_item(&l, "fetched", stats.bytes_fetched);
        line_item(&l, "retries", stats.fetch_retries);
    }
    line_print(&l);
}

static void say_frame(void) {
    static uint32_t said;
    if (device.frames != said) {
        said = device.frames;
        print_frame(said);
    }
}

/* ---- the program ------------------------------------------------------------------ */

static uint8_t credits_for(uint32_t room_bytes, uint32_t report_bytes) {
    const uint32_t reports = room_bytes / (report_bytes + report_bytes / 254 + 2);
    if (reports < CREDITS_LEAST + SPARE_REPORTS) {
        return CREDITS_LEAST;
    }
    return reports - SPARE_REPORTS < CREDITS_MOST ? (uint8_t)(reports - SPARE_REPORTS)
                                                  : CREDITS_MOST;
}

static int open_device(uint16_t report_bytes) {
    const uint32_t room_bytes = board_serial_open();
    static const plt_options options = {.packet_side =
                                            PLT_PACKET_SIDE_MAX < 8 ? PLT_PACKET_SIDE_MAX : 8};
    const wire_setup setup = {.role = WIRE_DEVICE,
                              .caps = {.session = board_ticks(),
                                       .in_bytes = report_bytes,
                                       .out_bytes = report_bytes,
                                       .credits = credits_for(room_bytes, report_bytes)}};
    size_t bytes;
    unsigned char *memory = board_arena(&bytes);
    last_ticks = board_ticks();
    if (wire_device_open(&device, &setup, &options, memory, bytes, now_ms()) != WIRE_OK) {
        return -1;
    }
#if PLT_WITH_STREAMED
    wire_device_stream(&device, await_reports, NULL);
#endif
    return 0;
}

static int read_report_size(const char *parameters, uint32_t *bytes) {
    parameter p;
    *bytes = REPORT_BYTES;
    if (parameter_unknown(parameters, "report", "", &p) ||
        (parameter_find(parameters, "report", &p) &&
         (parameter_u32(&p, bytes) < 0 || *bytes < WIRE_REPORT_BYTES_MIN ||
          *bytes > WIRE_REPORT_BYTES_MAX))) {
        board_print("error: report=BYTES, 8 .. 1024, is the only parameter\n");
        return -1;
    }
    return 0;
}

int firmware(const char *parameters) {
    uint32_t report_bytes;
    if (read_report_size(parameters, &report_bytes) < 0) {
        return FIRMWARE_USAGE;
    }
    if (open_device((uint16_t)report_bytes) < 0) {
        board_print("error: this build's tiles are not those of the wire\n");
        return FIRMWARE_FAILED;
    }
    say_name();
    for (;;) {
        move_reports();
        wire_poll(&device.peer, now_ms());
        wire_device_run(&device, VISITS_PER_STEP);
        say_scene();
        say_frame();
    }
}

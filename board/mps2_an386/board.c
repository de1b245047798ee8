/* mps2_an386 - the board functions on Arm's MPS2 with a Cortex-M4F
 *
 * The scene image lies in PSRAM at 0x21000000, put there by a debugger or by
 * QEMU's loader device; bytes= says how long it is. With scene=PATH it is a
 * file of the semihosting host instead, fetched piece by piece. The frame is
 * assembled in PSRAM; frame=PATH writes it as a PPM.
 *
 * SPDX-License-Identifier: MIT */
#include "board/board.h"
#include "board/line.h"
#include "board/parameters.h"
#include "platform/cortex_m/semihost.h"
#include "platform/cortex_m/start.h"

enum { CLOCK_HERTZ = 25000000, PATH_BYTES = 256, COMMAND_LINE_BYTES = 1024 };

/* FPGAIO counter: 32 bits, counts the 25 MHz clock when its prescaler is 0. */
#define FPGAIO_COUNTER (*(volatile uint32_t *)0x40028018u)
#define FPGAIO_PRESCALE (*(volatile uint32_t *)0x4002801Cu)

extern uint8_t plt_scene_start[], plt_scene_end[], plt_frame_start[], plt_frame_end[];

__attribute__((section(".arena"),
               aligned(PLT_ALIGN))) static unsigned char arena[PLT_BOARD_ARENA_BYTES];
static char command_line[COMMAND_LINE_BYTES];
static uint16_t frame_width, frame_height;
static int scene_file;

/* Of two symbols of the linker script, which C takes for two objects. */
static uint32_t bytes_between(const uint8_t *from, const uint8_t *to) {
    return (uint32_t)((uintptr_t)to - (uintptr_t)from);
}

const char *board_name(void) {
    return "mps2_an386";
}

unsigned char *board_arena(size_t *bytes) {
    *bytes = sizeof arena;
    return arena;
}

/* ---- the scene ---------------------------------------------------------- */

static int complain(const char *sentence) {
    board_print(sentence);
    return -1;
}

static int scene_start(void *context, unsigned tag, uint32_t offset, void *to, uint32_t count) {
    (void)tag; /* semihosting stops the CPU until the bytes are there */
    return semihost_read_at(*(const int *)context, offset, to, count);
}

static int scene_wait(void *context, uint32_t tags) {
    (void)context;
    (void)tags;
    return 0;
}

static int scene_from_file(const parameter *path, plt_source *source) {
    char name[PATH_BYTES];
    if (parameter_copy(path, name, sizeof name) < 0) {
        return complain("error: scene= is empty or longer than 255 characters\n");
    }
    scene_file = semihost_open(name, 0);
    const int32_t size = scene_file < 0 ? -1 : semihost_size(scene_file);
    if (size < 0) {
        return complain("error: cannot open the file of scene=\n");
    }
    source->bytes = (uint32_t)size;
    source->context = &scene_file;
    source->start = scene_start;
    source->wait = scene_wait;
    return 0;
}

int board_scene(const char *parameters, plt_source *source) {
    const uint32_t room = bytes_between(plt_scene_start, plt_scene_end);
    parameter p;
    if (parameter_find(parameters, "scene", &p)) {
        return scene_from_file(&p, source);
    }
    source->mapped = plt_scene_start;
    source->bytes = room;
    if (parameter_find(parameters, "bytes", &p) &&
        (parameter_u32(&p, &source->bytes) < 0 || source->bytes > room)) {
        return complain("error: bytes= is not a size of 0 .. 12582912 bytes\n");
    }
    return 0;
}

/* ---- the frame ------------------------------------------------------------ */

int board_frame_begin(uint16_t width, uint16_t height) {
    if ((uint64_t)width * height * 3 > bytes_between(plt_frame_start, plt_frame_end)) {
        return complain("error: the frame is larger than the 4 MiB this board keeps for it\n");
    }
    frame_width = width;
    frame_height = height;
    return 0;
}

void board_tile(const plt_tile *tile) {
    const uint8_t *from = tile->rgb;
    for (unsigned row = 0; row < tile->height; row++) {
        uint8_t *to = plt_frame_start + ((tile->y + row) * (size_t)frame_width + tile->x) * 3;
        for (unsigned i = 0; i < tile->width * 3u; i++) {
            *to++ = *from++;
        }
    }
}

static int write_ppm(const char *path) {
    line head;
    line_start(&head);
    line_text(&head, "P6 ");
    line_u64(&head, frame_width);
    line_text(&head, " ");
    line_u64(&head, frame_height);
    line_text(&head, " 255\n");
    const int file = semihost_open(path, 1);
    if (file < 0) {
        return -1;
    }
    const int bad = semihost_write(file, head.text, head.used) < 0 ||
                    semihost_write(file, plt_frame_start, 3u * frame_width * frame_height) < 0;
    semihost_close(file);
    return bad ? -1 : 0;
}

const uint8_t *board_frame_end(const char *parameters) {
    parameter p;
    char path[PATH_BYTES];
    if (parameter_find(parameters, "frame", &p) &&
        (parameter_copy(&p, path, sizeof path) < 0 || write_ppm(path) < 0)) {
        board_print("error: cannot write the file of frame=\n");
        semihost_exit(FIRMWARE_FAILED);
    }
    return plt_frame_start;
}

/* ---- the rest --------------------------------------------------------------- */

void board_print(const char *text) {
    semihost_print(text);
}

uint32_t board_ticks(void) {
    return FPGAIO_COUNTER;
}

uint32_t board_ticks_per_second(void) {
    return CLOCK_HERTZ;
}

void board_stack(uint32_t *used_bytes, uint32_t *size_bytes) {
    cortex_m_stack(used_bytes, size_bytes);
}

void cortex_m_print(const char *text) {
    semihost_print(text);
}

_Noreturn void cortex_m_exit(int status) {
    semihost_exit(status);
}

/* The parameters: the command line behind the program's name. */
static const char *parameters(void) {
    const char *at = command_line;
    while (*at && *at != ' ') {
        at++;
    }
    return at;
}

_Noreturn void cortex_m_main(void) {
    FPGAIO_PRESCALE = 0;
    if (semihost_command_line(command_line, sizeof command_line) < 0) {
        board_print("error: the command line is longer than 1023 characters\n");
        semihost_exit(FIRMWARE_USAGE);
    }
    semihost_exit(firmware(parameters()));
}

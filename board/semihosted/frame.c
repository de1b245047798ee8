/* frame - of a semihosted board: in its memory, where there is room, or in a file of the host
 *
 * frame=PATH writes it as a PPM. Without room, rows of tiles go where they belong in that file. A
 * panel shows it as well (panel.c).
 *
 * SPDX-License-Identifier: MIT */
#include "board/board.h"
#include "board/line.h"
#include "board/parameters.h"
#include "board/semihosted/semihosted.h"
#include "platform/bare/semihost.h"

extern uint8_t plt_frame_start[], plt_frame_end[];

static uint16_t frame_width, frame_height;
static int frame_file; /* of a board without room: -1 without frame= */
static uint8_t frame_head_bytes;

static uint32_t room_bytes(void) {
    return (uint32_t)((uintptr_t)plt_frame_end - (uintptr_t)plt_frame_start);
}

/* Opens the file of frame= with a PPM's head: the file; -1: there is no frame=, -2: a mistake. */
static int begin_ppm(const char *parameters) {
    parameter p;
    char path[SEMIHOSTED_PATH_BYTES];
    line head;
    if (!parameter_find(parameters, "frame", &p)) {
        return -1;
    }
    line_start(&head);
    line_text(&head, "P6 ");
    line_u64(&head, frame_width);
    line_text(&head, " ");
    line_u64(&head, frame_height);
    line_text(&head, " 255\n");
    frame_head_bytes = (uint8_t)head.used;
    const int file = parameter_copy(&p, path, sizeof path) < 0 ? -1 : semihost_open(path, 1);
    return file >= 0 && semihost_write(file, head.text, head.used) == 0 ? file : -2;
}

static void stop_without_file(void) {
    board_print("error: cannot write the file of frame=\n");
    semihost_exit(FIRMWARE_FAILED);
}

int board_frame_begin(uint16_t width, uint16_t height) {
    const uint64_t bytes = (uint64_t)width * height * 3;
    frame_width = width;
    frame_height = height;
    if (semihosted_panel_begin(width, height) < 0) {
        return -1;
    }
    if (room_bytes() > 0) {
        return bytes > room_bytes() ? semihosted_too_large("the frame", bytes, room_bytes()) : 0;
    }
    frame_file = begin_ppm(semihosted_parameters());
    if (frame_file == -2) {
        stop_without_file();
    }
    return 0;
}

void board_tile(const plt_tile *tile) {
    semihosted_panel_tile(tile);
    for (unsigned row = 0; row < tile->height; row++) {
        const uint8_t *from = tile->rgb + 3u * row * tile->width;
        const uint32_t at = ((tile->y + row) * (uint32_t)frame_width + tile->x) * 3;
        if (room_bytes() > 0) {
            uint8_t *to = plt_frame_start + at;
            for (unsigned i = 0; i < tile->width * 3u; i++) {
                *to++ = *from++;
            }
        } else if (frame_file >= 0 && semihost_write_at(frame_file, frame_head_bytes + at, from,
                                                        3u * tile->width) < 0) {
            stop_without_file();
        }
    }
}

const uint8_t *board_frame_end(const char *parameters) {
    semihosted_panel_end(parameters);
    if (room_bytes() == 0) {
        if (frame_file >= 0) {
            semihost_close(frame_file);
        }
        return NULL;
    }
    const int file = begin_ppm(parameters);
    if (file == -2 ||
        (file >= 0 && semihost_write(file, plt_frame_start, 3u * frame_width * frame_height) < 0)) {
        stop_without_file();
    }
    if (file >= 0) {
        semihost_close(file);
    }
    return plt_frame_start;
}

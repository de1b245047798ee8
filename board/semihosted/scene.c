/* scene - of a semihosted board: an image in its memory, or a file of the debugger's host
 *
 * Mapped, it lies at plt_scene_start, put there by a debugger or by QEMU's loader device;
 * bytes= says how long it is. With scene=PATH it is fetched piece by piece.
 *
 * SPDX-License-Identifier: MIT */
#include "board/board.h"
#include "board/parameters.h"
#include "board/semihosted/semihosted.h"
#include "platform/bare/semihost.h"

extern uint8_t plt_scene_start[], plt_scene_end[];

static int scene_file;

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
    char name[SEMIHOSTED_PATH_BYTES];
    if (parameter_copy(path, name, sizeof name) < 0) {
        return semihosted_complain("error: scene= is empty or longer than 255 characters\n");
    }
    scene_file = semihost_open(name, 0);
    const int32_t size = scene_file < 0 ? -1 : semihost_size(scene_file);
    if (size < 0) {
        return semihosted_complain("error: cannot open the file of scene=\n");
    }
    source->bytes = (uint32_t)size;
    source->context = &scene_file;
    source->start = scene_start;
    source->wait = scene_wait;
    return 0;
}

int board_scene(const char *parameters, plt_source *source) {
    /* Of two symbols of the linker script, which C takes for two objects. */
    const uint32_t room = (uint32_t)((uintptr_t)plt_scene_end - (uintptr_t)plt_scene_start);
    parameter p;
    if (parameter_find(parameters, "scene", &p)) {
        return scene_from_file(&p, source);
    }
    source->mapped = plt_scene_start;
    source->bytes = room;
    if (parameter_find(parameters, "bytes", &p) && parameter_u32(&p, &source->bytes) < 0) {
        return semihosted_complain("error: bytes= is not a number of bytes\n");
    }
    return source->bytes > room ? semihosted_too_large("the scene", source->bytes, room) : 0;
}

/* emulated_main - planelet-hid with a display that is drawn in the terminal
 *
 * planelet-hid as it is, linked with the fake of hidapi; on the fake bus is a
 * Planelet panel of 160x120 that accepts a report of 64 bytes per millisecond,
 * as a full-speed device would. SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <unistd.h>

#include "host_tools/picture/terminal.h"
#include "tests/hid/model.h"
#include "tests/reference/fake_hidapi.h"

int planelet_hid_main(int argc, char **argv);

static void on_output(void *context, const uint8_t *report, size_t bytes) {
    model *m = context;
    m->kind->output(m, report, bytes);
}

static size_t on_input(void *context, uint8_t *report, size_t room) {
    model *m = context;
    return m->kind->input(m, report, room);
}

static void draw(void *context, model *m) {
    const picture p = {m->rgb, m->width, m->height};
    unsigned columns, rows;
    (void)context;
    picture_terminal_size(stdout, &columns, &rows);
    printf(isatty(STDOUT_FILENO) ? "\x1b[H" : "\n");
    picture_show(stdout, &p, PICTURE_AUTO, columns, rows > 3 ? rows - 2 : rows);
}

int main(int argc, char **argv) {
    model *m = model_make(&model_planelet, (model_shape){.width = 160, .height = 120, .reads = 1});
    if (m == NULL) {
        fprintf(stderr, "planelet-hid-emulated: out of memory; close other programs\n");
        return 1;
    }
    m->changed = draw;
    const fake_device device = {.path = "emulated",
                                .vendor = m->kind->vendor,
                                .product = m->kind->id,
                                .serial = L"EMULATED",
                                .maker = L"Planelet",
                                .name = L"panel in a terminal, 160x120",
                                .context = m,
                                .output = on_output,
                                .input = on_input};
    fake_bus_reset();
    fake_bus.slow_us = 1000;
    fake_plug(0, &device);
    const int status = planelet_hid_main(argc, argv);
    if (isatty(STDOUT_FILENO)) {
        printf("\x1b[0m"); /* Ctrl-C may have thrown away the one of the last picture */
    }
    model_free(m);
    return status;
}

/* deck_reports - deck_reports DRIVER PRODUCT PICTURE: what planelet-hid sends for a picture
 *
 * Prints how many output reports the driver sent, and FNV-1a of all their bytes. The symbols of
 * keys are in the picture, as they are in scenes.
 *
 * SPDX-License-Identifier: MIT */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>

#include "board/hash.h"
#include "host_tools/hid/device/symbols.h"
#include "host_tools/hid/drivers/drivers.h"
#include "host_tools/picture/picture_read.h"
#include "tests/reference/fake_hidapi.h"

static uint64_t hash = HASH_BASIS;

static void take(void *context, const uint8_t *report, size_t bytes) {
    (void)context;
    hash = hash_update(hash, report, bytes);
}

/* Of a PPM or PNG file, 4 MiB at most. */
static int read_picture(picture *to, const char *path, fail *f) {
    enum { ROOM = 4 << 20 };
    static uint8_t file[ROOM];
    FILE *from = fopen(path, "rb");
    if (from == NULL) {
        return fail_set(f, path, "cannot be read");
    }
    const size_t bytes = fread(file, 1, ROOM, from);
    fclose(from);
    return picture_read(to, file, bytes, path, f);
}

int main(int argc, char **argv) {
    picture p = {NULL, 0, 0};
    fail f = {""};
    if (argc != 4 || read_picture(&p, argv[3], &f) != 0) {
        fprintf(stderr, "deck_reports DRIVER PRODUCT PICTURE; %s\n", f.text);
        return 1;
    }
    const fake_device device = {.path = "deck",
                                .vendor = 0x0FD9,
                                .product = (unsigned short)strtoul(argv[2], NULL, 16),
                                .numbered = 1,
                                .output = take};
    port_info *list;
    display d;
    fake_bus_reset();
    fake_plug(0, &device);
    const driver *by = driver_named(argv[1]);
    if (port_list(&list) != 1 || by == NULL || display_open(&d, by, list, NULL, &f) != 0) {
        fprintf(stderr, "%s\n", f.text);
        free(list);
        return 1;
    }
    symbols_draw(&p, by->keys);
    const int status = by->show(&d, &p, &f);
    display_close(&d);
    free(list);
    picture_free(&p);
    printf("%" PRIu64 " %016" PRIx64 "\n", fake_bus.outputs, hash);
    return status != DISPLAY_OK;
}

/* scripted_main - planelet-hid on a bus where a script happens: scripted SCRIPT ARGUMENT...
 *
 * At the end each device writes a line to standard error, and its panel to device0.ppm ... in the
 * current folder:
 *
 *     device 0 KIND changes=N wrong=N brightness=N releases=N reports=N WHY
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>

#include "tests/hid/script.h"

int planelet_hid_main(int argc, char **argv);

static void tell(const script *s, unsigned number) {
    char name[32];
    const script_device *d = &s->devices[number];
    const model *m = d->model;
    snprintf(name, sizeof name, "device%u.ppm", number);
    FILE *file = fopen(name, "wb");
    if (file != NULL) {
        fprintf(file, "P6 %u %u 255\n", m->width, m->height);
        fwrite(m->rgb, 3, (size_t)m->width * m->height, file);
        fclose(file);
    }
    fprintf(stderr, "device %u %s changes=%u wrong=%u brightness=%d releases=%u reports=%u %s\n",
            number, m->kind->name, m->changes, m->wrong, m->brightness, m->releases, d->reports,
            m->why);
}

int main(int argc, char **argv) {
    static script s;
    FILE *file = argc > 1 ? fopen(argv[1], "r") : NULL;
    if (file == NULL) {
        fprintf(stderr, "scripted: use it as: scripted SCRIPT ARGUMENT...\n");
        return 2;
    }
    const int wrong = script_read(&s, file);
    fclose(file);
    if (wrong != 0) {
        fprintf(stderr, "scripted: %s: line %d is no device or event\n", argv[1], wrong);
        return 2;
    }
    script_begin(&s);
    argv[1] = argv[0];
    const int status = planelet_hid_main(argc - 1, argv + 1);
    for (unsigned i = 0; i < s.count; i++) {
        tell(&s, i);
    }
    if (fake_bus.wrong > 0) {
        fprintf(stderr, "hidapi was used against its rules\n");
    }
    script_free(&s);
    return status;
}

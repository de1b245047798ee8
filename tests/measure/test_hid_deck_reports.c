/* test_hid_deck_reports [FOLDER] - what each Stream Deck is sent for a picture, for other programs
 *
 * With a folder: for each model MODEL.ppm, the panel's picture, MODEL.reports and MODEL.features,
 * each report after four bytes of its length, little-endian, the report that opens the device
 * first; and MODEL.size, the picture that keys with gaps would show. Without one it only makes
 * them.
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>

#include "host_tools/hid/device/gaps.h"
#include "tests/reference/display_bench.h"

enum { MODELS = 6 };

static const model_kind *const models[MODELS] = {&model_mini,    &model_original, &model_deck,
                                                 &model_deck_xl, &model_deck_neo, &model_deck_plus};

static FILE *open_file(const char *folder, const char *name, const char *ending) {
    char path[1024];
    snprintf(path, sizeof path, "%s/%s.%s", folder, name, ending);
    FILE *file = fopen(path, "wb");
    CHECK(file != NULL, "%s", path);
    return file;
}

static void save_reports(const char *folder, const char *name, const char *ending, unsigned from) {
    FILE *file = folder == NULL ? NULL : open_file(folder, name, ending);
    for (unsigned i = from; file != NULL && i < record.count; i++) {
        const size_t bytes = record.size[i];
        const uint8_t head[4] = {(uint8_t)bytes, (uint8_t)(bytes >> 8), 0, 0};
        CHECK(fwrite(head, 1, 4, file) == 4 && fwrite(record.bytes[i], 1, bytes, file) == bytes,
              "%s: report %u", name, i);
    }
    CHECK(file == NULL || fclose(file) == 0, "%s.%s", name, ending);
}

static void save_picture(const char *folder, const bench *b) {
    const picture *p = &b->shown;
    const size_t bytes = (size_t)3 * p->width * p->height;
    unsigned width, height;
    FILE *file = open_file(folder, b->model->kind->name, "ppm");
    if (file != NULL) {
        fprintf(file, "P6\n%u %u\n255\n", p->width, p->height);
        CHECK(fwrite(p->rgb, 1, bytes, file) == bytes && fclose(file) == 0, "the picture");
    }
    const key_grid *grid = b->display.by->grid;
    file = open_file(folder, b->model->kind->name, "size");
    if (file != NULL) {
        gaps_size(grid, grid->columns * grid->side, grid->rows * grid->side, &width, &height);
        fprintf(file, "%u %u %u %u %u\n", grid->columns, grid->rows, grid->side, width, height);
        CHECK(fclose(file) == 0, "the size");
    }
}

/* Shades that change slowly, and some edges: what a scene looks like. */
static void fill(picture *p) {
    for (unsigned i = 0; i < p->width * p->height; i++) {
        const unsigned x = i % p->width, y = i / p->width;
        const int dx = (int)x - (int)p->width / 2, dy = (int)y - (int)p->height / 2;
        const int inside = dx * dx + dy * dy < (int)(p->height * p->height) / 6;
        p->rgb[3 * i] = (uint8_t)(inside ? 220 - y * 90 / p->height : 40 + x * 60 / p->width);
        p->rgb[3 * i + 1] = (uint8_t)(inside ? 150 : 60 + y * 60 / p->height);
        p->rgb[3 * i + 2] = (uint8_t)(inside ? 60 + x * 90 / p->width : 130);
    }
}

static void send_all(const char *folder, const model_kind *kind) {
    bench b;
    fail f = {""};
    test(kind->name);
    open_bench(&b, kind);
    fill(&b.shown);
    CHECK(b.display.by->show(&b.display, &b.shown, &f) == DISPLAY_OK, "%s", f.text);
    save_reports(folder, kind->name, "reports", 0);
    const unsigned pictures = record.count;
    CHECK(b.display.by->brightness(&b.display, 70, &f) == DISPLAY_OK, "%s", f.text);
    CHECK(b.display.by->release(&b.display, &f) == DISPLAY_OK, "%s", f.text);
    CHECK(record.count == pictures + 2, "%u feature reports", record.count - pictures);
    save_reports(folder, kind->name, "features", pictures);
    if (folder != NULL) {
        save_picture(folder, &b);
    }
    close_bench(&b);
}

int main(int argc, char **argv) {
    for (unsigned i = 0; i < MODELS; i++) {
        send_all(argc > 1 ? argv[1] : NULL, models[i]);
    }
    return test_done();
}

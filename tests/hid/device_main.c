/* device_main - device uhid|usbip|gadget DRIVER [key=value ...]: a display that judges
 *
 * Plays a display until SIGTERM, and compares its panel with the pictures of
 * pattern.h whenever it changed. Ends in one line:
 *
 *     device changes=C matched=M other=O last=L wrong=W brightness=B reports=R WHY
 *
 * M pictures came in their order, each pixel right, the last being number L;
 * O times the panel was none of them (keys or windows that change one by one
 * pass through such states, whole frames never may).
 *
 * Keys: size=WxH format=0..4 report=BYTES (Planelet panels), vendor= id= in
 * hexadecimal, serial=, port=, speed=full|high, paced=1, no_out=1,
 * path=/dev/hidgN, die_after=REPORTS, slow=MICROSECONDS, first=NUMBER of the
 * first picture to expect, blind=1 compares nothing (when speed is measured),
 * reads=1 has a panel that can be read, show=1 draws it in the terminal.
 *
 * SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "host_tools/picture/picture.h"
#include "tests/hid/device.h"

enum { AHEAD = 40 /* pictures that may be left out between two */ };

static volatile sig_atomic_t stop;

typedef struct judge {
    unsigned next, matched, other;
    int last, show;
} judge;

static void on_signal(int number) {
    (void)number;
    stop = 1;
}

static void draw(const model *m) {
    const picture p = {m->rgb, m->width, m->height};
    printf("\x1b[H");
    picture_show(stdout, &p, PICTURE_AUTO, 0, 0);
}

static void on_change(void *context, model *m) {
    judge *j = context;
    if (j->show) {
        draw(m);
        return;
    }
    if (j->last >= 0 && model_shows_pattern(m, (unsigned)j->last, 1) >= 0) {
        return; /* the same again */
    }
    const int found = model_shows_pattern(m, j->next, AHEAD);
    if (found < 0) {
        j->other++;
        return;
    }
    j->matched++;
    j->last = found;
    j->next = (unsigned)found + 1;
}

void device_output(device *d, const uint8_t *report, size_t bytes) {
    if (d->slow_us > 0) {
        const struct timespec t = {0, (long)d->slow_us * 1000};
        nanosleep(&t, NULL);
    }
    d->model->kind->output(d->model, report, bytes);
    if (++d->reports == d->die_after) {
        _exit(0);
    }
}

void device_feature(device *d, const uint8_t *report, size_t bytes) {
    d->reports++;
    if (d->model->kind->feature == NULL) {
        model_breach(d->model, "a feature report");
        return;
    }
    d->model->kind->feature(d->model, report, bytes);
    if (d->reports == d->die_after) {
        _exit(0);
    }
}

size_t device_input(device *d, uint8_t *report, size_t room) {
    return d->model->kind->input == NULL ? 0 : d->model->kind->input(d->model, report, room);
}

/* The value of key=value among the words. */
static const char *value(char **words, const char *key, const char *otherwise) {
    const size_t length = strlen(key);
    for (; *words != NULL; words++) {
        if (strncmp(*words, key, length) == 0 && (*words)[length] == '=') {
            return *words + length + 1;
        }
    }
    return otherwise;
}

static unsigned long number(char **words, const char *key, int base) {
    return strtoul(value(words, key, "0"), NULL, base);
}

static model *make_model(const model_kind *kind, char **words) {
    unsigned width = 0, height = 0;
    sscanf(value(words, "size", "0x0"), "%ux%u", &width, &height);
    const model_shape shape = {width, height, (unsigned)number(words, "format", 10),
                               (unsigned)number(words, "report", 10),
                               (int)number(words, "reads", 10)};
    return model_make(kind, shape);
}

static void read_words(device *d, char **words) {
    const model_kind *k = d->model->kind;
    d->vendor = (unsigned)number(words, "vendor", 16);
    d->id = (unsigned)number(words, "id", 16);
    if (d->vendor == 0) {
        d->vendor = k->vendor;
        d->id = k->id;
    }
    d->serial = value(words, "serial", "SN0001");
    d->port = (unsigned)number(words, "port", 10);
    d->high_speed = strcmp(value(words, "speed", "full"), "high") == 0;
    d->paced = (int)number(words, "paced", 10);
    d->no_out = (int)number(words, "no_out", 10);
    d->path = value(words, "path", "/dev/hidg0");
    d->die_after = number(words, "die_after", 10);
    d->slow_us = (unsigned)number(words, "slow", 10);
}

static int run(device *d, const char *transport) {
    if (strcmp(transport, "uhid") == 0) {
        return device_uhid(d);
    }
    return strcmp(transport, "usbip") == 0 ? device_usbip(d) : device_gadget(d);
}

int main(int argc, char **argv) {
    const model_kind *kind = argc < 3 ? NULL : model_kind_named(argv[2]);
    if (kind == NULL) {
        fprintf(stderr, "device: use it as: device uhid|usbip|gadget DRIVER [key=value ...]\n");
        return 2;
    }
    char **words = argv + 3;
    judge j = {.next = (unsigned)number(words, "first", 10), .last = -1};
    j.show = (int)number(words, "show", 10);
    device d = {.model = make_model(kind, words), .stop = &stop};
    if (d.model == NULL) {
        return 1;
    }
    const struct sigaction action = {.sa_handler = on_signal};
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGINT, &action, NULL);
    read_words(&d, words);
    d.model->changed = number(words, "blind", 10) ? NULL : on_change;
    d.model->context = &j;
    const int status = run(&d, argv[1]);
    const model *m = d.model;
    printf("device changes=%u matched=%u other=%u last=%d wrong=%u brightness=%d reports=%llu %s\n",
           m->changes, j.matched, j.other, j.last, m->wrong, m->brightness,
           (unsigned long long)d.reports, m->why);
    model_free(d.model);
    return status == 0 ? 0 : 1;
}

/* device_main - device uhid|usbip|gadget DRIVER [key=value ...]: a display that judges
 *
 * Plays a display until SIGTERM, and compares its panel with the pictures of
 * pattern.h in every pixel whenever it changed. Ends in one line:
 *
 *     device format=F changes=C matched=M other=O last=L wrong=W brightness=B reports=R WHY
 *
 * M pictures came in their order, each pixel right, the last being number L;
 * O times the panel was none of them (keys or windows that change one by one
 * pass through such states; whole frames must not).
 *
 * SIGUSR1 prints the line, too, and what is plugged in goes on as a new display
 * with the next of the five formats: plugging in would take longer than pictures.
 *
 * `device descriptor DRIVER ...` writes its report descriptor instead.
 *
 * Keys: size=WxH format=0..4 report=BYTES in=BYTES (Planelet panels), vendor=
 * id= in hexadecimal, serial=, port=, speed=full|high, paced=1, no_out=1,
 * path=/dev/hidgN, die_after=REPORTS, slow=MICROSECONDS, first=NUMBER of the
 * first picture to expect, blind=1 compares nothing (when speed is measured),
 * reads=1 has a panel that can be read, show=1 draws it in the terminal,
 * eager=1 goes before all other processes whenever a report waits for it,
 * key=1 .. has keys, and presses this one of them four times, each for a tenth of
 * a second, once something is shown; then it says "pressed".
 *
 * SPDX-License-Identifier: MIT */
#include <sched.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "host_tools/base/clock.h"
#include "host_tools/picture/terminal.h"
#include "platform/wire/wire_format.h"
#include "tests/hid/device.h"

enum { AHEAD = 40 /* pictures that may be left out between two */ };

static volatile sig_atomic_t stop, change;

typedef struct judge {
    unsigned next, matched, other;
    int last, show;
} judge;

static judge seen;
static char **words; /* key=value */

static void on_signal(int number) {
    if (number == SIGUSR1) {
        change = 1;
    } else {
        stop = 1;
    }
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
        clock_sleep(1e-6 * d->slow_us);
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

static const char *value(const char *key, const char *otherwise) {
    const size_t length = strlen(key);
    for (char **word = words; *word != NULL; word++) {
        if (strncmp(*word, key, length) == 0 && (*word)[length] == '=') {
            return *word + length + 1;
        }
    }
    return otherwise;
}

static unsigned long number(const char *key, int base) {
    return strtoul(value(key, "0"), NULL, base);
}

/* Judges it, too. */
static model *make_model(const model_kind *kind, unsigned format) {
    unsigned width = 0, height = 0;
    sscanf(value("size", "0x0"), "%ux%u", &width, &height);
    const model_shape shape = {.width = width,
                               .height = height,
                               .format = format,
                               .report_bytes = (unsigned)number("report", 10),
                               .reads = (int)number("reads", 10),
                               .has_keys = number("key", 10) > 0,
                               .in_bytes = (unsigned)number("in", 10)};
    model *m = model_make(kind, shape);
    if (m == NULL) {
        fprintf(stderr, "device: no such display: out of memory, or the wire refuses it\n");
        exit(1);
    }
    seen = (judge){.next = (unsigned)number("first", 10), .last = -1};
    seen.show = (int)number("show", 10);
    m->changed = number("blind", 10) ? NULL : on_change;
    m->context = &seen;
    return m;
}

static void say_what_was_seen(const device *d) {
    const model *m = d->model;
    printf(
        "device format=%u changes=%u matched=%u other=%u last=%d wrong=%u brightness=%d "
        "reports=%llu %s\n",
        m->format, m->changes, seen.matched, seen.other, seen.last, m->wrong, m->brightness,
        (unsigned long long)d->reports, m->why);
    fflush(stdout);
}

/* Counts from 1. */
static void press_keys(device *d) {
    static double due;
    static unsigned changes;
    const unsigned key = (unsigned)number("key", 10);
    if (key == 0 || d->model->changes == 0 || changes == 8 || clock_seconds() < due) {
        return;
    }
    due = clock_seconds() + 0.1;
    changes++;
    d->model->kind->key(d->model, key - 1, changes % 2 == 1);
    if (changes == 8) {
        printf("pressed\n");
        fflush(stdout);
    }
}

int device_goes_on(device *d) {
    press_keys(d);
    if (change) {
        model *old = d->model;
        change = 0;
        say_what_was_seen(d);
        d->model = make_model(old->kind, (old->format + 1) % WIRE_FORMATS);
        model_free(old);
    }
    return !stop;
}

static void read_words(device *d) {
    const model_kind *k = d->model->kind;
    d->vendor = (unsigned)number("vendor", 16);
    d->id = (unsigned)number("id", 16);
    if (d->vendor == 0) {
        d->vendor = k->vendor;
        d->id = k->id;
    }
    d->serial = value("serial", "SN0001");
    d->port = (unsigned)number("port", 10);
    d->high_speed = strcmp(value("speed", "full"), "high") == 0;
    d->paced = (int)number("paced", 10);
    d->no_out = (int)number("no_out", 10);
    d->path = value("path", "/dev/hidg0");
    d->die_after = number("die_after", 10);
    d->slow_us = (unsigned)number("slow", 10);
}

/* uhid queues 32 reports and drops the next; so it never has more than one. */
static int go_first(void) {
    const struct sched_param first = {.sched_priority = 1};
    const int status = sched_setscheduler(0, SCHED_FIFO, &first);
    if (status != 0) {
        perror("device: eager=1");
    }
    return status;
}

static int write_descriptor(const model *m) {
    uint8_t bytes[96];
    const size_t count = model_descriptor(m, bytes);
    return fwrite(bytes, 1, count, stdout) == count ? 0 : -1;
}

static void catch_signals(void) {
    const struct sigaction action = {.sa_handler = on_signal};
    sigaction(SIGTERM, &action, NULL);
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGUSR1, &action, NULL);
}

static int run(device *d, const char *transport) {
    if (strcmp(transport, "descriptor") == 0) {
        return write_descriptor(d->model);
    }
    const int status = strcmp(transport, "uhid") == 0    ? device_uhid(d)
                       : strcmp(transport, "usbip") == 0 ? device_usbip(d)
                                                         : device_gadget(d);
    say_what_was_seen(d);
    return status;
}

int main(int argc, char **argv) {
    const model_kind *kind = argc < 3 ? NULL : model_kind_named(argv[2]);
    if (kind == NULL) {
        fprintf(stderr, "device: use it as: device uhid|usbip|gadget DRIVER [key=value ...]\n");
        return 2;
    }
    words = argv + 3;
    catch_signals();
    device d = {.model = make_model(kind, (unsigned)number("format", 10))};
    read_words(&d);
    const int is_set = number("eager", 10) == 0 || go_first() == 0;
    const int status = is_set ? run(&d, argv[1]) : -1;
    model_free(d.model);
    return status == 0 ? 0 : 1;
}

/* script - see script.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/hid/script.h"

#include <string.h>

#include "host_tools/base/clock.h"

static const char *const names[SCRIPT_WHATS] = {"unplug", "plug", "dark",  "refuse",
                                                "late",   "slow", "stall", "deny"};

/* ---- a device's side ---------------------------------------------------------------------- */

static void on_output(void *context, const uint8_t *report, size_t bytes) {
    script_device *d = context;
    d->reports++;
    if (d->model->kind->output != NULL) {
        d->model->kind->output(d->model, report, bytes);
    }
}

static void on_feature(void *context, const uint8_t *report, size_t bytes) {
    script_device *d = context;
    d->reports++;
    if (d->model->kind->feature != NULL) {
        d->model->kind->feature(d->model, report, bytes);
    }
}

static size_t on_input(void *context, uint8_t *report, size_t room) {
    const script_device *d = context;
    return d->model->kind->input == NULL ? 0 : d->model->kind->input(d->model, report, room);
}

static void go_dark(model *m) {
    memset(m->rgb, 0, 3 * (size_t)m->width * m->height);
}

/* What comes back has lost its power meanwhile: it is as at the start. */
static void on_plug(void *context, int in) {
    script_device *d = context;
    model *old = d->model;
    model *fresh = in && d->reports > 0 ? model_make(old->kind, (model_shape){0}) : NULL;
    if (fresh != NULL) {
        fresh->wrong = old->wrong;
        memcpy(fresh->why, old->why, sizeof fresh->why);
        fresh->changed = old->changed;
        fresh->context = old->context;
        model_free(old);
        d->model = fresh;
    }
}

/* ---- events -----------------------------------------------------------------------------------
 */

static void happen(script *s, script_event *e) {
    script_device *d = &s->devices[e->value < s->count ? e->value : 0];
    const unsigned socket = s->other_count + (unsigned)(d - s->devices);
    e->is_done = 1;
    switch (e->what) {
    case SCRIPT_UNPLUG:
        fake_unplug(socket);
        break;
    case SCRIPT_PLUG:
        if (e->path[0] != '\0') {
            memcpy(d->path, e->path, sizeof d->path);
        }
        if (fake_bus.device[socket] == NULL) {
            fake_plug(socket, &d->device);
        }
        break;
    case SCRIPT_DARK:
        go_dark(d->model);
        break;
    case SCRIPT_REFUSE:
        fake_bus.refuse_reports = e->value;
        break;
    case SCRIPT_LATE:
        fake_bus.late_ms = e->value;
        break;
    case SCRIPT_SLOW:
        fake_bus.slow_us = e->value;
        break;
    case SCRIPT_STALL:
        fake_bus.stall_ms = e->value;
        break;
    default:
        fake_bus.denied = (int)e->value;
        break;
    }
}

/* What is due by the clock, in the order of time. */
static void passes(void *context) {
    script *s = context;
    const double now = clock_seconds() - s->began;
    for (unsigned i = 0; i < s->event_count; i++) {
        script_event *e = &s->events[i];
        if (!e->is_done && e->report == 0 && now >= e->at) {
            happen(s, e);
        }
    }
}

static void before(void *context) {
    script *s = context;
    s->reports++;
    for (unsigned i = 0; i < s->event_count; i++) {
        script_event *e = &s->events[i];
        if (!e->is_done && e->report > 0 && s->reports >= e->report) {
            e->report = 0;
            e->at += e->at > 0.0 ? clock_seconds() - s->began : 0.0;
        }
        if (!e->is_done && e->report == 0 && e->at <= 0.0) {
            happen(s, e);
        }
    }
}

/* ---- scripts ------------------------------------------------------------------------------------
 */

int script_add_device(script *s, const model_kind *kind, const char *path, const char *serial,
                      const char *place, unsigned collections) {
    if (kind == NULL || s->count == SCRIPT_DEVICES) {
        return -1;
    }
    script_device *d = &s->devices[s->count++];
    d->model = model_make(kind, (model_shape){0});
    snprintf(d->path, sizeof d->path, "%s", path);
    snprintf(d->place, sizeof d->place, "%s", place);
    for (size_t i = 0; i + 1 < SCRIPT_TEXT && serial[i] != '\0'; i++) {
        d->serial[i] = (wchar_t)serial[i];
    }
    d->device = (fake_device){.path = d->path,
                              .place = place[0] == '\0' ? NULL : d->place,
                              .collections = collections,
                              .vendor = kind->vendor,
                              .product = kind->id,
                              .interface = kind->interface,
                              .serial = serial[0] == '\0' ? NULL : d->serial,
                              .maker = L"Planelet",
                              .name = L"scripted",
                              .numbered = kind->output_number != 0,
                              .context = d,
                              .output = on_output,
                              .feature = on_feature,
                              .input = on_input,
                              .plugged = on_plug};
    return d->model == NULL ? -1 : 0;
}

int script_add(script *s, script_event event) {
    if (s->event_count == SCRIPT_EVENTS) {
        return -1;
    }
    s->events[s->event_count++] = event;
    return 0;
}

static const char *unless_dash(const char *text) {
    return strcmp(text, "-") == 0 ? "" : text;
}

static int read_device(script *s, const char *line) {
    char kind[32], path[SCRIPT_TEXT], serial[SCRIPT_TEXT] = "-", place[SCRIPT_TEXT] = "-";
    unsigned collections = 1;
    return sscanf(line, "device %31s %63s %63s %63s %u", kind, path, serial, place, &collections) <
                   2
               ? -1
               : script_add_device(s, model_kind_named(kind), path, unless_dash(serial),
                                   unless_dash(place), collections);
}

static int read_event(script *s, script_event e, const char *text) {
    char name[16];
    if (sscanf(text, "%15s %u %63s", name, &e.value, e.path) < 2) {
        return -1;
    }
    for (e.what = 0; e.what < SCRIPT_WHATS; e.what++) {
        if (strcmp(name, names[e.what]) == 0) {
            return script_add(s, e);
        }
    }
    return -1;
}

static int read_line(script *s, const char *line) {
    script_event e = {.report = 0};
    unsigned long long number = 0;
    unsigned delay;
    int used = 0;
    if (strncmp(line, "device ", 7) == 0) {
        return read_device(s, line);
    }
    if (sscanf(line, "others %u", &s->other_count) == 1) {
        return s->other_count <= SCRIPT_OTHERS ? 0 : -1;
    }
    if (sscanf(line, "before %llu %n", &number, &used) == 1 && number > 0) {
        e.report = number;
    } else if (sscanf(line, "after %llu %u %n", &number, &delay, &used) == 2 && number > 0) {
        e.report = number;
        e.at = 1e-3 * delay;
    } else if (sscanf(line, "at %llu %n", &number, &used) == 1) {
        e.at = 1e-3 * (double)number;
    }
    return used > 0 ? read_event(s, e, line + used) : read_event(s, e, line);
}

int script_read(script *s, FILE *file) {
    char line[256];
    for (int number = 1; fgets(line, sizeof line, file) != NULL; number++) {
        if (line[strspn(line, " \n")] != '\0' && read_line(s, line) != 0) {
            return number;
        }
    }
    return 0;
}

void script_begin(script *s) {
    fake_bus_reset();
    for (unsigned i = 0; i < s->other_count; i++) {
        snprintf(s->other_paths[i], sizeof s->other_paths[i], "/dev/other%u", i);
        s->others[i] =
            (fake_device){.path = s->other_paths[i], .vendor = 0x046D, .product = 0xC548};
        fake_plug(i, &s->others[i]);
    }
    for (unsigned i = 0; i < s->count; i++) {
        fake_plug(s->other_count + i, &s->devices[i].device);
    }
    s->began = clock_seconds();
    fake_bus.context = s;
    fake_bus.passes = passes;
    fake_bus.before = before;
}

void script_free(script *s) {
    for (unsigned i = 0; i < s->count; i++) {
        model_free(s->devices[i].model);
    }
}

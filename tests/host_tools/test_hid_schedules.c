/* test_hid_schedules - 10,000 seeded schedules of what goes wrong with displays
 *
 * Each driver shows a film or a still picture on one of two equal displays, while reports are
 * refused, stall or are not acknowledged, panels lose their pictures, and displays are unplugged
 * and come back in another order. By a clock of its own it takes seconds.
 *
 * test_hid_schedules [FIRST [COUNT]]: other seeds, or one that failed once more.
 *
 * SPDX-License-Identifier: MIT */
#include <signal.h>
#include <stdlib.h>

#include "host_tools/base/clock.h"
#include "host_tools/hid/device/session.h"
#include "host_tools/hid/drivers/drivers.h"
#include "tests/hid/pattern.h"
#include "tests/hid/script.h"
#include "tests/test.h"

static unsigned long seed;

/* ---- a clock that goes when it is asked, or slept by ---------------------------------------- */

static struct {
    double now;
    double stop_at, end; /* `stop` is set; whoever is still at work then is in a loop */
    unsigned long asked; /* since the seed began */
} virtual;

static volatile sig_atomic_t stop;

static void loop_found(void) {
    fprintf(stdout, "FAIL seed %lu: a loop, at %.3f s after %lu looks at the clock\n", seed,
            virtual.now, virtual.asked);
    exit(1);
}

double clock_seconds(void) {
    virtual.now += 1e-6;
    if (++virtual.asked > 20000000 || virtual.now > virtual.end) {
        loop_found();
    }
    stop = virtual.now >= virtual.stop_at;
    return virtual.now;
}

uint32_t clock_ms(void) {
    return (uint32_t)(1e3 * clock_seconds());
}

void clock_sleep(double seconds) {
    virtual.now += seconds > 0.0 ? seconds : 0.0;
    clock_seconds();
}

double clock_processor_seconds(void) {
    return clock_seconds();
}

double clock_thread_seconds(void) {
    return clock_seconds();
}

unsigned clock_processors(void) {
    return 1;
}

uint64_t clock_day_us(void) {
    return (uint64_t)(1e6 * clock_seconds());
}

/* ---- schedules ---------------------------------------------------------------------------------
 */

static uint64_t noise;

/* 0 .. below - 1 */
static unsigned any(unsigned below) {
    noise = noise * UINT64_C(6364136223846793005) + UINT64_C(1442695040888963407);
    return (unsigned)((noise >> 33) % below);
}

enum { OPEN_MOST = 4 }; /* reports of a driver's open, which is not tried again: a picoLCD's */

enum ports { LIBUSB, HIDRAW, UNKNOWN };

typedef struct plan {
    const model_kind *kind;
    enum ports ports;
    unsigned mine;                        /* device: the other is its equal neighbour */
    int by_path, is_film, is_still_there; /* it comes back in the end */
    int reopens; /* some fault is one that the display is opened anew for */
    int stops;
    double end; /* of the faults */
} plan;

static script bus;

static void add(double at, enum script_what what, unsigned value, const char *path) {
    script_event e = {.at = at, .what = what, .value = value};
    snprintf(e.path, sizeof e.path, "%s", path);
    CHECK(script_add(&bus, e) == 0, "seed %lu: too many events", seed);
}

/* Where they come back on hidraw numbers are given in the order in which they come. */
static void unplug(plan *p, double at, double back, unsigned device) {
    static unsigned number = 10;
    char path[SCRIPT_TEXT] = "";
    add(at, SCRIPT_UNPLUG, device, "");
    if (p->ports == HIDRAW) {
        snprintf(path, sizeof path, "/dev/fake%u", number++);
    }
    add(back, SCRIPT_PLUG, device, path);
    p->reopens |= device == p->mine;
}

/* Both are away at once, and are each other's number when they are back. */
static void exchange(plan *p, double at, double back) {
    for (unsigned device = 0; device < 2; device++) {
        add(at, SCRIPT_UNPLUG, device, "");
    }
    const int swaps = p->ports == HIDRAW;
    add(back, SCRIPT_PLUG, !p->mine, swaps ? "/dev/fake0" : "");
    add(back + 0.1 * any(4), SCRIPT_PLUG, p->mine, swaps ? "/dev/fake1" : "");
    p->reopens = 1;
}

/* By the clock mostly between two pictures; by their count in the middle of one. */
static void refuse(double at) {
    if (any(2)) {
        add(at, SCRIPT_REFUSE, 1 + any(1u << any(10)), "");
    } else {
        const script_event e = {
            .report = OPEN_MOST + 1 + any(300), .what = SCRIPT_REFUSE, .value = 1 + any(10)};
        CHECK(script_add(&bus, e) == 0, "seed %lu: too many events", seed);
    }
}

static void add_fault(plan *p, double at, double end) {
    switch (any(p->stops ? 5 : 7)) {
    case 0:
        add(at, SCRIPT_DARK, p->mine, "");
        break;
    case 1:
        unplug(p, at, end, p->mine);
        break;
    case 2:
        unplug(p, at, end, !p->mine);
        break;
    case 3:
        exchange(p, at, end);
        break;
    case 4:
        refuse(at);
        p->reopens = 1;
        break;
    case 5:
        add(at, SCRIPT_LATE, 200 + any(1000), "");
        break;
    default:
        add(at, SCRIPT_STALL, 1 + any(5000), "");
        p->reopens = 1;
        break;
    }
}

static void add_faults(plan *p) {
    double at = 0.3;
    for (unsigned faults = any(5); faults > 0; faults--) {
        const double end = at + 0.05 + 0.01 * any(120);
        add_fault(p, at, end);
        at = any(3) > 0 ? end : at + 0.01 * any(40);
        p->end = end + 0.4 > p->end ? end + 0.4 : p->end;
    }
    p->end = at > p->end ? at : p->end;
    add(p->end, SCRIPT_REFUSE, 0, "");
    add(p->end, SCRIPT_LATE, 0, "");
    add(p->end, SCRIPT_STALL, 0, "");
    if (p->is_still_there) {
        add(p->end, SCRIPT_PLUG, p->mine, "");
    } else {
        add(p->end - 0.01, SCRIPT_UNPLUG, p->mine, "");
    }
}

/* Displays whose pictures are files take a hundred times as long: one seed in 40 is for them. */
static const model_kind *kind_for(unsigned long number) {
    const model_kind *of[2][40];
    unsigned count[2] = {0, 0};
    for (unsigned i = 0; drivers[i] != NULL; i++) {
        const model_kind *kind = model_kind_named(drivers[i]->name);
        CHECK(kind != NULL, "%s has no model", drivers[i]->name);
        if (kind != NULL) {
            of[kind->lossy > 0][count[kind->lossy > 0]++] = kind;
        }
    }
    const unsigned is_file = number % 40 == 39;
    return of[is_file][(is_file ? number / 40 : number) % count[is_file]];
}

static plan make_plan(void) {
    noise = seed * UINT64_C(0x9E3779B97F4A7C15) + 1;
    any(2);
    plan p = {.kind = kind_for(seed), .ports = (enum ports)any(3), .mine = any(2)};
    p.by_path = p.mine == 1 || any(2);
    p.is_film = (int)any(2);
    p.stops = any(8) == 0;
    p.is_still_there = any(8) != 0;
    const char *const serial = any(2) ? "000000000000" : "";
    static const char *const paths[3][2] = {
        {"1-1:1.0", "1-2:1.0"}, {"/dev/fake0", "/dev/fake1"}, {"/dev/fake0", "/dev/fake1"}};
    static const char *const places[3][2] = {{"", ""}, {"1-1", "1-2"}, {"", ""}};
    bus = (script){.count = 0};
    for (unsigned i = 0; i < 2; i++) {
        script_add_device(&bus, p.kind, paths[p.ports][i], serial, places[p.ports][i], 1 + any(2));
    }
    add(0.0, SCRIPT_SLOW, p.stops && any(2) ? 20000 : 125, "");
    add_faults(&p);
    return p;
}

/* ---- a session
 * ------------------------------------------------------------------------------------ */

typedef struct run {
    plan plan;
    session session;
    picture picture;
    unsigned shown; /* picture */
    int status;
    fail f;
} run;

static void show_next(run *r) {
    r->shown = (r->shown + 1) % 5;
    pattern_fill(r->shown, r->picture.width, r->picture.height, r->picture.rgb);
    r->status = session_show(&r->session, &r->picture, &r->f);
}

static double faults_end(const run *r) {
    const double end = bus.began + r->plan.end;
    return end > fake_bus.last_fault ? end : fake_bus.last_fault;
}

/* A film, or a picture that stays, until two seconds after the faults. */
static void show_all(run *r) {
    double next = virtual.now + 0.2;
    show_next(r);
    while (r->status == 0 && !stop && virtual.now < faults_end(r) + 2.0) {
        clock_sleep(0.01);
        if (session_tick(&r->session) != 0) {
            r->status = session_show(&r->session, &r->picture, &r->f);
        } else if (r->plan.is_film && virtual.now > next && virtual.now < faults_end(r)) {
            show_next(r);
            next = virtual.now + 0.2;
        }
    }
}

static const script_device *mine(const run *r) {
    return &bus.devices[r->plan.mine];
}

/* A brightness that has to be set again, or everything but the reports of pictures. */
static void check(run *r, double stopped) {
    const script_device *other = &bus.devices[!r->plan.mine];
    const double seconds = virtual.now - bus.began;
    CHECK(other->reports == 0, "seed %lu: %u reports for another display", seed, other->reports);
    CHECK(mine(r)->model->wrong == 0, "seed %lu: %s", seed, mine(r)->model->why);
    CHECK(fake_bus.wrong == 0, "seed %lu: hidapi was used against its rules", seed);
    CHECK(fake_bus.opens < 12 * seconds + 3, "seed %lu: opened %u times in %.1f s", seed,
          (unsigned)fake_bus.opens, seconds);
    CHECK(r->plan.reopens || !r->plan.is_still_there || r->session.reconnects == 0,
          "seed %lu: opened anew %u times for nothing", seed, r->session.reconnects);
    if (r->plan.stops && stop) {
        CHECK(stopped < 0.2, "seed %lu: %.3f s after a signal", seed, stopped);
    } else if (r->plan.is_still_there) {
        CHECK(r->status == 0, "seed %lu: %s", seed, r->f.text);
        CHECK(model_shows_pattern(mine(r)->model, r->shown, 1) == (int)r->shown,
              "seed %lu, %s: not whole after two seconds", seed, r->plan.kind->name);
    } else {
        CHECK(r->status != 0 && strstr(r->f.text, "did not come back in 8 seconds"),
              "seed %lu: %d '%s'", seed, r->status, r->f.text);
    }
}

/* Of a seed that is run alone. */
static void tell(const plan *p) {
    static const char *const ports[] = {"libusb", "hidraw", "unknown ports"};
    static const char *const whats[SCRIPT_WHATS] = {"unplug", "plug", "dark",  "refuse",
                                                    "late",   "slow", "stall", "deny"};
    printf("    %s, %s, device %u%s, a %s; faults end at %.2f s\n", p->kind->name, ports[p->ports],
           p->mine, p->by_path ? " by path" : "", p->is_film ? "film" : "picture", p->end);
    for (unsigned i = 0; i < bus.event_count; i++) {
        const script_event *e = &bus.events[i];
        printf("    %.2f s", e->at);
        if (e->report > 0) {
            printf(" after report %llu", (unsigned long long)e->report);
        }
        printf(": %s %u %s\n", whats[e->what], e->value, e->path);
    }
}

static void run_one(int is_alone) {
    static run r;
    virtual.end = 1e9;
    r = (run){.plan = make_plan()};
    virtual.asked = 0;
    virtual.stop_at = r.plan.stops ? virtual.now + 0.3 + 0.01 * any(200) : 1e9;
    virtual.end = virtual.now + 90.0;
    r.session = (session){.wish.drivers = drivers,
                          .wish.device = r.plan.by_path ? mine(&r)->path : NULL,
                          .brightness = -1,
                          .patience = 8.0,
                          .stop = &stop};
    char path[SCRIPT_TEXT]; /* as the user gave it */
    snprintf(path, sizeof path, "%s", mine(&r)->path);
    r.session.wish.device = r.plan.by_path ? path : NULL;
    if (is_alone) {
        tell(&r.plan);
    }
    script_begin(&bus);
    fake_bus.libusb = r.plan.ports == LIBUSB;
    CHECK(session_open(&r.session, &r.f) == 0, "seed %lu: %s", seed, r.f.text);
    picture_make(&r.picture, r.session.panel.width, r.session.panel.height, &r.f);
    show_all(&r);
    check(&r, virtual.now - virtual.stop_at);
    session_close(&r.session);
    picture_free(&r.picture);
    script_free(&bus);
}

int main(int argc, char **argv) {
    const unsigned long first = argc > 1 ? strtoul(argv[1], NULL, 10) : 0;
    const unsigned long count = argc > 2 ? strtoul(argv[2], NULL, 10) : argc > 1 ? 1 : 10000;
    if (freopen("/dev/null", "w", stderr) == NULL) {
        return 1;
    }
    virtual.end = 1e9;
    test("schedules of faults: no loop, no other display, and the picture whole in two seconds");
    for (seed = first; seed < first + count; seed++) {
        run_one(count == 1);
    }
    return test_done();
}

/* cmd_show - planelet-hid show: pictures, films and scenes on a display
 *
 * SPDX-License-Identifier: MIT */
#include <signal.h>
#include <stdio.h>
#include <string.h>

#include "host_tools/app/scene.h"
#include "host_tools/app/view.h"
#include "host_tools/base/clock.h"
#include "host_tools/base/progress.h"
#include "host_tools/hid/commands.h"
#include "host_tools/hid/device/session.h"
#include "host_tools/hid/drivers/drivers.h"
#include "host_tools/hid/sources/frames_kinds.h"
#include "host_tools/hid/sources/frames_open.h"
#include "host_tools/hid/statistics.h"
#include "platform/wire/wire_tile.h"

static const arg_flag flags[] = {
    {"--device", "WHICH", "vid:pid, path or serial number (default: the first display)"},
    {"--driver", "NAME|auto", "see planelet-hid list (default auto: by vid:pid)"},
    {"--fit", "contain|cover|stretch|none", "a picture of another size (default contain)"},
    {"--gaps", NULL, "keys show what a picture as large as all of them has, not what is between"},
    {"--brightness", "0..100", "percent, where the display has it"},
    {"--near", "auto|0..15", "planelet: steps that moving colours may be off by (default auto)"},
    {"--fps", "N",
     "auto: the fewest steps with which N frames per second, 1 to 100, get through (default 12)"},
    {"--frames", "N", "stop after N frames, 1 to 1000000000"},
    {"--hold", "SECONDS", "how long a picture stays before the next, 0 or more (default 1)"},
    {"--every", NULL, "every frame of a film, each until the display has confirmed it"},
    {"--repeat", NULL, "from the first file again, until stopped"},
    {"--wait", "SECONDS",
     "for a display that was unplugged to come back to its port, 0 or more (default 60)"},
    {"--release", NULL,
     "at the end hand the display back to its own picture, a Nexus at full brightness"},
    {"--json", "STATS", "write statistics; - is standard output"},
    FRAMES_SCENE_FLAGS,
    VIEW_FLAGS,
    VIEW_BACKGROUND_FLAG,
    SCENE_FLAGS,
    {NULL, NULL, NULL}};

const arg_command hid_command_show = {
    "show",
    "FILE... | -",
    "Shows pictures (PNG, PPM, PGM), films (Y4M; - is standard input) and packed scenes, rendered "
    "live, whose own frames are played over and over; the display's keys turn them (list --keys). "
    "A film keeps its time: frames that come too "
    "late are left out. Where the link is too slow, planelet lets moving colours be a little off; "
    "what stands still for a "
    "tenth of a second is exact. Drivers other than planelet are " DISPLAY_DISCLAIMER ".",
    flags,
    1,
    100000,
    NULL,
    NULL};

typedef struct showing {
    session session;
    frames source;
    picture frame, ahead;
    progress bar;
    statistics statistics;
    double film_began; /* clock */
    double hold;
    uint64_t film_frames; /* of the film that is shown, left out ones too */
    uint64_t limit;
    int every, repeat;
    output *stats_out; /* NULL: none */
} showing;

static volatile sig_atomic_t stop;

static void on_signal(int number) {
    (void)number;
    stop = 1;
}

static int tick(void *context) {
    return session_tick(context) != 0 || stop;
}

static void steer_by(void *context, unsigned count[STEER_ACTIONS]) {
    session_steer(context, count);
}

static void pause_until(session *s, double end) {
    int is_lost = 0;
    for (double left; !is_lost && !stop && (left = end - clock_seconds()) > 0.0;) {
        clock_sleep(left < 0.004 ? left : 0.004);
        is_lost = session_tick(s);
    }
}

/* Whether the film is already at the frame after this one. A film that arrives too
 * slowly is never late: its clock is set back. */
static int is_late(showing *s, double period) {
    const double now = clock_seconds();
    if (now <= s->film_began + (double)(s->film_frames + 1) * period) {
        return 0;
    }
    if (s->source.from.waited > period / 2.0) {
        s->film_began = now - (double)s->film_frames * period;
        return 0;
    }
    return 1;
}

/* The next frame that is not too late, in s->frame; the last one is never
 * left out. */
static int next_frame(showing *s, fail *f) {
    s->source.from.waited = 0.0;
    int status = s->source.next(&s->source, &s->frame, f);
    const double period = s->every ? 0.0 : s->source.period;
    while (status == FRAMES_ONE && period > 0.0 && is_late(s, period)) {
        const int more = s->source.next(&s->source, &s->ahead, f);
        if (more != FRAMES_ONE) {
            return more == FRAMES_FAILED ? more : FRAMES_ONE;
        }
        const picture late = s->frame;
        s->frame = s->ahead;
        s->ahead = late;
        s->film_frames++;
        s->statistics.left_out++;
    }
    return status;
}

static int is_done(const showing *s) {
    return stop || (s->limit > 0 && s->session.shown >= s->limit);
}

/* What a signal has interrupted is no failure. */
static int unless_stopped(int status, fail *f) {
    if (stop) {
        *f = (fail){""};
    }
    return stop ? FRAMES_END : status;
}

static int show_source(showing *s, fail *f) {
    s->film_began = clock_seconds();
    s->film_frames = 0;
    while (!is_done(s)) {
        const int status = next_frame(s, f);
        if (s->session.is_lost && !stop) {
            return session_confirm(&s->session, f);
        }
        if (status != FRAMES_ONE || stop) {
            return unless_stopped(status, f);
        }
        if (s->source.period > 0.0 && !s->every) {
            pause_until(&s->session, s->film_began + (double)s->film_frames * s->source.period);
        }
        if (session_show(&s->session, &s->frame, f) != 0 ||
            (s->every && session_confirm(&s->session, f) != 0)) {
            return FRAMES_FAILED;
        }
        statistics_mark(&s->statistics, &s->session);
        s->film_frames++;
        progress_show(&s->bar, s->session.shown);
    }
    return FRAMES_END;
}

/* A picture is a source of one frame without a period. */
static int show_file(showing *s, args *a, const char *path, int is_last, fail *f) {
    const picture *size = session_picture(&s->session);
    int status = unless_stopped(frames_open(&s->source, a, path, size->width, size->height, f), f);
    if (status == 0 && !stop) {
        const unsigned before = s->session.shown;
        status = show_source(s, f);
        if (status == 0 && s->source.period <= 0.0 && s->session.shown == before + 1 && !is_last &&
            !is_done(s)) {
            status = session_confirm(&s->session, f);
            pause_until(&s->session, clock_seconds() + s->hold);
        }
    }
    frames_close(&s->source);
    return status;
}

static int show_files(showing *s, args *a, fail *f) {
    do {
        const unsigned before = s->session.shown;
        for (int i = 0; i < a->files && !is_done(s); i++) {
            if (show_file(s, a, a->file[i], i + 1 == a->files && !s->repeat, f) != 0) {
                return -1;
            }
        }
        if (s->session.shown == before) {
            break;
        }
    } while (s->repeat && !is_done(s));
    return 0;
}

/* Opened first: what cannot be written fails before anything is shown. */
static int open_all(showing *s, args *a, fail *f) {
    const char *json = args_text(a, "--json", NULL);
    if (json != NULL && (s->stats_out = output_open_text(json, f)) == NULL) {
        return -1;
    }
    if (session_open(&s->session, f) != 0) {
        return -1;
    }
    return args_has(a, "--release") ? session_can_release(&s->session, f) : 0;
}

static int write_stats(showing *s, double seconds, fail *f) {
    output *o = s->stats_out;
    s->stats_out = NULL;
    return o == NULL ? 0 : statistics_write(&s->statistics, &s->session, o, seconds, f);
}

static int run_all(showing *s, args *a, fail *f) {
    if (open_all(s, a, f) != 0) {
        return -1;
    }
    const double began = clock_seconds();
    progress_begin(&s->bar, "showing, frame", s->limit);
    s->source = (frames){.from = {.tick = tick, .context = &s->session},
                         .keys = session_keys(&s->session),
                         .steer = steer_by};
    const int status = show_files(s, a, f) != 0 ? -1 : session_confirm(&s->session, f);
    const double seconds = clock_seconds() - began;
    progress_end(&s->bar);
    if (status != 0) {
        fail unsaid = {""}; /* what ended the show is said */
        if (args_has(a, "--release") && s->session.display.port != NULL) {
            session_release(&s->session, &unsaid);
        }
        return -1;
    }
    statistics_print(&s->statistics, &s->session, seconds);
    if (args_has(a, "--release") && session_release(&s->session, f) != 0) {
        return -1;
    }
    return write_stats(s, seconds, f);
}

static void read_driver(session *s, args *a) {
    const char *name = args_text(a, "--driver", "auto");
    s->wish.drivers = drivers;
    s->wish.device = args_text(a, "--device", NULL);
    if (strcmp(name, "auto") != 0) {
        s->wish.by = driver_named(name);
        if (s->wish.by == NULL) {
            args_complain(a, "--driver: there is none called '%s', planelet-hid list shows them",
                          name);
        }
    }
}

static double read_seconds(args *a, const char *flag, float otherwise) {
    float value = otherwise;
    if (args_floats(a, flag, &value, 1) && value < 0.0f) {
        args_complain(a, "%s takes seconds, 0 or more", flag);
    }
    return (double)value;
}

/* With --every each frame is confirmed before the next, and so exact. */
static void read_near(session *s, args *a, int every) {
    const int is_auto = strcmp(args_text(a, "--near", "auto"), "auto") == 0;
    s->fps = (unsigned)args_number(a, "--fps", 12, 1, 100);
    s->near = !is_auto ? (unsigned)args_number(a, "--near", 0, 0, WIRE_NEAR_MOST)
              : every  ? 0
                       : DISPLAY_NEAR_AUTO;
    if (args_has(a, "--fps") && s->near != DISPLAY_NEAR_AUTO) {
        args_complain(a, "--fps goes with --near auto and without --every");
    }
}

static void read_flags(showing *s, args *a) {
    static const char *const fits[] = {"contain", "cover", "stretch", "none", NULL};
    read_driver(&s->session, a);
    s->session.fit = (enum fit_mode)args_choice(a, "--fit", fits, FIT_CONTAIN);
    s->session.gaps = args_has(a, "--gaps");
    s->session.brightness =
        args_has(a, "--brightness") ? (int)args_number(a, "--brightness", 0, 0, 100) : -1;
    read_near(&s->session, a, args_has(a, "--every"));
    s->session.patience = read_seconds(a, "--wait", 60.0f);
    s->session.stop = &stop;
    s->hold = read_seconds(a, "--hold", 1.0f);
    s->limit = args_number(a, "--frames", 0, 1, 1000000000);
    s->every = args_has(a, "--every");
    s->repeat = args_has(a, "--repeat");
}

int hid_run_show(args *a) {
    showing s = {0};
    fail f = {""};
    struct sigaction action = {.sa_handler = on_signal};
    stop = 0;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
    read_flags(&s, a);
    const int status = a->wrong ? -1 : run_all(&s, a, &f);
    output_abandon(s.stats_out);
    session_close(&s.session);
    picture_free(&s.frame);
    picture_free(&s.ahead);
    if (status != 0 && !a->wrong) {
        fprintf(stderr, "%s\n", f.text);
    }
    return a->wrong ? 2 : status == 0 ? 0 : 1;
}

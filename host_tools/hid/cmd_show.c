/* cmd_show - planelet-hid show: pictures, films and scenes on a display
 *
 * SPDX-License-Identifier: MIT */
#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "host_tools/base/output.h"
#include "host_tools/base/progress.h"
#include "host_tools/cli/scene.h"
#include "host_tools/cli/view.h"
#include "host_tools/hid/commands.h"
#include "host_tools/hid/frames.h"
#include "host_tools/hid/session.h"
#include "platform/wire/wire_tile.h"

static const arg_flag flags[] = {
    {"--device", "WHICH", "vid:pid, path or serial number (default: the first display)"},
    {"--driver", "NAME|auto", "see planelet-hid list (default auto: by vid:pid)"},
    {"--fit", "contain|cover|stretch|none", "a picture of another size (default contain)"},
    {"--brightness", "0..100", "percent, where the display has it"},
    {"--near", "auto|0..15", "planelet: steps that moving colours may be off by (default auto)"},
    {"--fps", "N", "auto: no more steps than let N frames a second through (default 12)"},
    {"--frames", "N", "stop after N frames"},
    {"--hold", "SECONDS", "how long a picture stays before the next (default 1)"},
    {"--every", NULL, "every frame of a film, each until the display has confirmed it"},
    {"--repeat", NULL, "from the first file again, until stopped"},
    {"--wait", "SECONDS", "for a display that was unplugged to come back (default 60)"},
    {"--release", NULL, "at the end hand the display back to its own picture"},
    {"--json", "STATS", "write figures; - is standard output"},
    FRAMES_SCENE_FLAGS,
    VIEW_FLAGS,
    SCENE_FLAGS,
    {NULL, NULL, NULL}};

const arg_command hid_command_show = {
    "show",
    "FILE... | -",
    "Shows pictures (PNG, PPM, PGM), films (Y4M; - is standard input) and packed scenes, rendered "
    "live. A film keeps its time: frames that come too late are left out. Where the link is too "
    "slow, planelet lets moving colours be a little off, up to a tenth; what stands still for a "
    "tenth of a second is exact. Drivers other than planelet are " DISPLAY_HONESTY ".",
    flags,
    1,
    100000,
    "planelet-hid"};

typedef struct showing {
    session session;
    frames source;
    picture frame, ahead;
    progress bar;
    double began, film_began, first_shown, last_shown; /* clock */
    double hold;
    uint64_t film_frames; /* of the film that is shown, left out ones too */
    uint64_t limit, left_out, first_reports, last_reports;
    int every, repeat;
} showing;

static volatile sig_atomic_t stop;

static void on_signal(int number) {
    (void)number;
    stop = 1;
}

static void tick(void *context) {
    session_tick(context);
}

static void pause_until(session *s, double end) {
    for (double left; !stop && (left = end - progress_seconds()) > 0.0;) {
        const struct timespec t = {0, left < 0.004 ? (long)(1e9 * left) : 4000000};
        nanosleep(&t, NULL);
        session_tick(s);
    }
}

/* The next frame that is not too late, in s->frame; the last one is never
 * left out. */
static int next_frame(showing *s, fail *f) {
    int status = s->source.next(&s->source, &s->frame, f);
    const double period = s->every ? 0.0 : s->source.period;
    while (status == FRAMES_ONE && period > 0.0 &&
           progress_seconds() > s->film_began + (double)(s->film_frames + 1) * period) {
        const int more = s->source.next(&s->source, &s->ahead, f);
        if (more != FRAMES_ONE) {
            return more == FRAMES_FAILED ? more : FRAMES_ONE;
        }
        const picture late = s->frame;
        s->frame = s->ahead;
        s->ahead = late;
        s->film_frames++;
        s->left_out++;
    }
    return status;
}

static int enough(const showing *s) {
    return stop || (s->limit > 0 && s->session.shown >= s->limit);
}

/* What it took from the first frame to the last: the first is all new, and
 * after the last the display may still be refining it. */
static void mark_time(showing *s) {
    port_figures p;
    session_figures(&s->session, &p);
    s->last_shown = progress_seconds();
    s->last_reports = p.reports;
    if (s->session.shown == 1) {
        s->first_shown = s->last_shown;
        s->first_reports = s->last_reports;
    }
}

static int show_source(showing *s, fail *f) {
    s->film_began = progress_seconds();
    s->film_frames = 0;
    while (!enough(s)) {
        const int status = next_frame(s, f);
        if (status != FRAMES_ONE) {
            return status;
        }
        if (s->source.period > 0.0 && !s->every) {
            pause_until(&s->session, s->film_began + (double)s->film_frames * s->source.period);
        }
        if (session_show(&s->session, &s->frame, f) != 0 ||
            (s->every && session_settle(&s->session, f) != 0)) {
            return FRAMES_FAILED;
        }
        mark_time(s);
        s->film_frames++;
        progress_show(&s->bar, s->session.shown);
    }
    return FRAMES_END;
}

/* A picture is a source of one frame without a time of its own. */
static int show_file(showing *s, args *a, const char *path, int is_last, fail *f) {
    const unsigned width = s->session.panel.width, height = s->session.panel.height;
    int status = frames_open(&s->source, a, path, width, height, f);
    if (status == 0) {
        const unsigned before = s->session.shown;
        status = show_source(s, f);
        if (status == 0 && s->source.period <= 0.0 && s->session.shown == before + 1 && !is_last &&
            !enough(s)) {
            status = session_settle(&s->session, f);
            pause_until(&s->session, progress_seconds() + s->hold);
        }
    }
    frames_close(&s->source);
    return status;
}

static int show_files(showing *s, args *a, fail *f) {
    do {
        const unsigned before = s->session.shown;
        for (int i = 0; i < a->files && !enough(s); i++) {
            if (show_file(s, a, a->file[i], i + 1 == a->files && !s->repeat, f) != 0) {
                return -1;
            }
        }
        if (s->session.shown == before) {
            break;
        }
    } while (s->repeat && !enough(s));
    return 0;
}

static double steady_rate(const showing *s) {
    const double seconds = s->last_shown - s->first_shown;
    return seconds > 0.0 ? (s->session.shown - 1) / seconds : 0.0;
}

static double steady_reports(const showing *s) {
    return (double)(s->last_reports - s->first_reports) /
           (s->session.shown > 1 ? s->session.shown - 1 : 1);
}

static int write_figures(const showing *s, const char *path, double seconds, fail *f) {
    port_figures p;
    session_figures(&s->session, &p);
    output *o = output_open(path, f);
    if (o != NULL &&
        output_print(o, f,
                     "{\n  \"driver\": \"%s\",\n  \"width\": %u,\n  \"height\": %u,\n"
                     "  \"frames\": %u,\n  \"left_out\": %llu,\n  \"seconds\": %.6f,\n"
                     "  \"frames_per_s\": %.3f,\n  \"steady_frames_per_s\": %.3f,\n"
                     "  \"steady_reports_per_frame\": %.2f,\n"
                     "  \"reports\": %llu,\n  \"bytes\": %llu,\n"
                     "  \"reconnects\": %u,\n  \"longest_gap_s\": %.3f\n}\n",
                     s->session.display.by->name, s->session.panel.width, s->session.panel.height,
                     s->session.shown, (unsigned long long)s->left_out, seconds,
                     seconds > 0.0 ? s->session.shown / seconds : 0.0, steady_rate(s),
                     steady_reports(s), (unsigned long long)p.reports, (unsigned long long)p.bytes,
                     s->session.reconnects, s->session.longest_gap) != 0) {
        output_abandon(o);
        return -1;
    }
    return o == NULL ? -1 : output_commit(o, f);
}

static void print_figures(const showing *s, double seconds) {
    port_figures p;
    session_figures(&s->session, &p);
    fprintf(stderr,
            "%u frames in %.2f s, %.2f a second; %llu left out; %llu reports, %.1f KB a second; "
            "%u reconnects\n",
            s->session.shown, seconds, seconds > 0.0 ? s->session.shown / seconds : 0.0,
            (unsigned long long)s->left_out, (unsigned long long)p.reports,
            seconds > 0.0 ? 1e-3 * (double)p.bytes / seconds : 0.0, s->session.reconnects);
}

static int run_all(showing *s, args *a, fail *f) {
    if (session_open(&s->session, f) != 0) {
        return -1;
    }
    s->began = progress_seconds();
    progress_begin(&s->bar, "showing, frame", s->limit);
    s->source = (frames){.tick = tick, .context = &s->session};
    const int status = show_files(s, a, f) != 0 ? -1 : session_settle(&s->session, f);
    const double seconds = progress_seconds() - s->began;
    progress_end(&s->bar);
    if (status != 0) {
        return -1;
    }
    print_figures(s, seconds);
    if (args_has(a, "--release") && session_release(&s->session, f) != 0) {
        return -1;
    }
    const char *json = args_text(a, "--json", NULL);
    return json == NULL ? 0 : write_figures(s, json, seconds, f);
}

static void read_driver(session *s, args *a) {
    const char *name = args_text(a, "--driver", "auto");
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

/* Frames that each wait until they are confirmed do not move. */
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
    session_close(&s.session);
    picture_free(&s.frame);
    picture_free(&s.ahead);
    if (status != 0 && !a->wrong) {
        fprintf(stderr, "%s\n", f.text);
    }
    return a->wrong ? 2 : status == 0 ? 0 : 1;
}

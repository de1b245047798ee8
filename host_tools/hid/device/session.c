/* session - see session.h
 *
 * Keeps: `panel` is the picture that a display that comes back gets first.
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/session.h"

#include <stdio.h>

#include "host_tools/base/clock.h"
#include "host_tools/hid/device/gaps.h"
#include "host_tools/hid/device/retry.h"

static const double LOOK_SECONDS = 0.1;
static const double RENEWAL_SECONDS = 1.5; /* in which every piece is sent again */
static const double PAUSE_MOST = 0.5;      /* seconds between two pieces of a slow link */
static const double RELEASE_SECONDS = 1.0; /* of tries, should the display refuse */

static int set_brightness(session *s, fail *f) {
    const driver *by = s->display.by;
    if (s->brightness < 0) {
        return DISPLAY_OK;
    }
    if (by->brightness == NULL) {
        return fail_set(f, by->name, "its brightness cannot be set; leave out --brightness");
    }
    return by->brightness(&s->display, (unsigned)s->brightness, f);
}

/* The device may have come back with another firmware. */
static int check_size(session *s, fail *f) {
    const display *d = &s->display;
    if (d->width == s->panel.width && d->height == s->panel.height) {
        return DISPLAY_OK;
    }
    fail_set(f, s->info.path,
             "the display came back with %u x %u pixels instead of %u x %u; "
             "start again",
             d->width, d->height, s->panel.width, s->panel.height);
    return DISPLAY_FAILED;
}

static int open_display(session *s, const driver *by, fail *f) {
    int status = display_open(&s->display, by, &s->info, s->stop, f);
    s->keys = (keys_track){.is_reset = 0}; /* what was held is not held here */
    if (status == DISPLAY_OK && by->near != NULL) {
        by->near(&s->display, s->near, s->fps);
    }
    if (status == DISPLAY_OK) {
        status = set_brightness(s, f);
        if (status != DISPLAY_OK) {
            display_close(&s->display);
        }
    }
    return status;
}

static int make_span(session *s, fail *f) {
    const driver *by = s->display.by;
    unsigned width, height;
    if (by->grid == NULL) {
        return fail_set(f, by->name, "its panel has no gaps; leave out --gaps");
    }
    if (by->keys != NULL) {
        gaps_keys(by->grid, by->keys, s->moved);
    }
    gaps_size(by->grid, s->panel.width, s->panel.height, &width, &height);
    return picture_make(&s->span, width, height, f);
}

int session_open(session *s, fail *f) {
    const driver *by = find_display(&s->wish, &s->info, f);
    if (by == NULL) {
        return -1;
    }
    const int status = open_display(s, by, f);
    if (status == DISPLAY_GONE) {
        fail_set(f, s->info.path, "the display went away or does not answer; plug it in again");
    } else if (status == DISPLAY_STOPPED) {
        fail_set(f, s->info.path, "stopped before the display had answered");
    }
    if (status != DISPLAY_OK) {
        return -1;
    }
    if (picture_make(&s->panel, s->display.width, s->display.height, f) != 0) {
        return -1;
    }
    return s->gaps ? make_span(s, f) : 0;
}

const picture *session_picture(const session *s) {
    return s->gaps ? &s->span : &s->panel;
}

const display_key *session_keys(const session *s) {
    const display_key *keys = s->display.by->keys;
    return s->gaps && keys != NULL ? s->moved : keys;
}

/* What there is to say when there are no more tries: why the last did not work. */
static int say_end(const session *s, enum retry_status end, const retry *r, fail *f) {
    if (end == RETRY_STOPPED) {
        return fail_set(f, s->info.path, "stopped before the display was back");
    }
    if (r->why.text[0] != '\0') {
        *f = r->why;
        return DISPLAY_FAILED;
    }
    return fail_set(f, s->info.path,
                    "the display did not come back in %g seconds; plug it in where it was",
                    s->patience);
}

/* Waits until the device is there and opens, or there are no more tries. A failed open is not the
 * end: right after a plug-in the system may still be setting permissions. */
static int come_back(session *s, retry *r, fail *f) {
    const driver *by = s->display.by;
    enum retry_status next;
    session_statistics(s, &s->before);
    display_close(&s->display);
    while ((next = retry_next(r, LOOK_SECONDS)) == RETRY_AGAIN) {
        r->why = (fail){""};
        if (!find_again(&s->wish, &s->info)) {
            continue;
        }
        const int status = open_display(s, by, &r->why);
        if (status == DISPLAY_OK || r->why.text[0] == '\0') {
            fail_set(&r->why, s->info.path,
                     "the display is there, but refuses reports; plug it in again, or choose "
                     "another with --device or --driver");
        }
        if (status == DISPLAY_OK) {
            s->reconnects++;
            return check_size(s, f);
        }
    }
    return say_end(s, next, r, f);
}

static double pieces_of(const display *d) {
    return d->by->forget != NULL && d->pieces > 0 ? d->pieces : 1;
}

/* Whether a piece should be sent again although it is as it was. */
static int is_due(const session *s) {
    return s->shown > 0 && !s->display.by->renews && clock_seconds() >= s->due;
}

/* Shows `panel`, and with it a piece that is due. Pieces that are sent again take half of
 * a slow link's time. */
static int show_panel(session *s, fail *f) {
    display *d = &s->display;
    const double began = clock_seconds(), pause = RENEWAL_SECONDS / pieces_of(d);
    const int renews = is_due(s), has_pieces = d->by->forget != NULL && d->pieces > 0;
    if (renews && has_pieces) {
        d->by->forget(d, s->piece);
        s->piece = (s->piece + 1) % d->pieces;
    }
    const int status = d->by->show(d, &s->panel, f);
    if (renews || !has_pieces) {
        const double now = clock_seconds(), took = now - began;
        const double rest = took < PAUSE_MOST ? took : PAUSE_MOST;
        s->due = now + (rest > pause ? rest : pause);
    }
    return status;
}

/* Shows `panel`; or, with `confirm`, waits until the device has confirmed it. */
static int put_picture(session *s, int confirm, fail *f) {
    const driver *by = s->display.by;
    if (s->display.port == NULL) { /* the last picture did not bring it back */
        return DISPLAY_GONE;
    }
    int status = !confirm || s->again ? show_panel(s, f) : DISPLAY_OK;
    if (status == DISPLAY_OK && by->confirm != NULL && (confirm || s->again)) {
        status = by->confirm(&s->display, f);
    }
    s->again = s->again && status != DISPLAY_OK;
    return status;
}

/* What a tick has found is told once. */
static int take_loss(session *s, fail *f) {
    const int was_lost = s->is_lost;
    if (was_lost) {
        *f = s->why;
    }
    s->is_lost = 0;
    return was_lost;
}

/* Until the picture is out; a display that came back gets all of it. The tries for one picture
 * have one limit, however often the display opens and then refuses it. `status` is what is known:
 * DISPLAY_OK, or DISPLAY_GONE. */
static int deliver(session *s, int confirm, int status, fail *f) {
    double gone = 0.0;
    retry tries;
    for (;; status = DISPLAY_OK) {
        status = status == DISPLAY_OK ? put_picture(s, confirm, f) : status;
        if (status == DISPLAY_OK) {
            break;
        }
        if (status == DISPLAY_STOPPED) {
            return 0;
        }
        s->again = 1;
        if (status == DISPLAY_GONE && gone <= 0.0) {
            gone = clock_seconds();
            retry_begin(&tries, s->patience, s->stop);
            fprintf(stderr, "%04x:%04x went away; waiting for it\n", s->info.vendor, s->info.id);
        }
        if (status == DISPLAY_FAILED || come_back(s, &tries, f) != DISPLAY_OK) {
            return -1;
        }
    }
    if (gone > 0.0) {
        const double gap = clock_seconds() - gone;
        s->longest_gap = gap > s->longest_gap ? gap : s->longest_gap;
        fprintf(stderr, "back after %.2f s\n", gap);
    }
    return 0;
}

int session_show(session *s, const picture *p, fail *f) {
    fit_picture(p, s->gaps ? &s->span : &s->panel, s->fit);
    if (s->gaps) {
        gaps_cut(s->display.by->grid, &s->span, &s->panel);
    }
    if (take_loss(s, f) || deliver(s, 0, DISPLAY_OK, f) != 0) {
        return -1;
    }
    s->shown++;
    return 0;
}

int session_confirm(session *s, fail *f) {
    if (take_loss(s, f)) {
        return -1;
    }
    return s->shown == 0 ? 0 : deliver(s, 1, DISPLAY_OK, f);
}

int session_tick(session *s) {
    if (s->display.port == NULL || s->is_lost) {
        return s->is_lost;
    }
    const int status = display_tick(&s->display) == DISPLAY_OK ? DISPLAY_OK : DISPLAY_GONE;
    if (s->shown > 0 && (status != DISPLAY_OK || is_due(s))) {
        s->is_lost = deliver(s, 0, status, &s->why) != 0;
    }
    return s->is_lost;
}

void session_steer(session *s, unsigned count[STEER_ACTIONS]) {
    keys_take(&s->keys, &s->display.keys, s->display.by->keys, clock_seconds(), count);
    for (unsigned action = 0; action < STEER_ACTIONS; action++) {
        s->steered += count[action];
    }
}

int session_can_release(const session *s, fail *f) {
    const driver *by = s->display.by;
    return by->release != NULL
               ? 0
               : fail_set(f, by->name, "it has no picture of its own; leave out --release");
}

/* The first try is made in any case: a signal is what mostly ends a program. */
int session_release(session *s, fail *f) {
    display *d = &s->display;
    int status = DISPLAY_GONE, is_there = 1;
    retry tries;
    if (session_can_release(s, f) != 0) {
        return -1;
    }
    if (d->port == NULL) {
        return fail_set(f, s->info.path, "stopped before the display was back");
    }
    retry_begin(&tries, RELEASE_SECONDS, NULL);
    while (status == DISPLAY_GONE && is_there && retry_next(&tries, LOOK_SECONDS) == RETRY_AGAIN) {
        status = d->by->release(d, f);
        is_there = status != DISPLAY_GONE || display_tick(d) == DISPLAY_OK;
        tries.stop = s->stop;
    }
    if (status == DISPLAY_GONE) {
        return fail_set(f, s->info.path,
                        is_there ? "refuses to show its own picture again; plug it in again, which "
                                   "gives it back, too"
                                 : "went away before it had its own picture back; plug it in "
                                   "again, which gives it back, too");
    }
    return status == DISPLAY_FAILED ? -1 : 0;
}

void session_statistics(const session *s, port_statistics *statistics) {
    *statistics = s->before;
    if (s->display.port != NULL) {
        port_statistics now;
        port_statistics_get(s->display.port, &now);
        statistics->reports += now.reports;
        statistics->bytes += now.bytes;
        statistics->cut += now.cut;
    }
}

void session_close(session *s) {
    display_close(&s->display);
    picture_free(&s->panel);
    picture_free(&s->span);
}

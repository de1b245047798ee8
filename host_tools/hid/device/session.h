/* session - a display that comes back after it was unplugged
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_SESSION_H
#define HID_SESSION_H

#include <signal.h>

#include "host_tools/hid/device/display.h"
#include "host_tools/hid/device/find.h"
#include "host_tools/picture/fit.h"

typedef struct session {
    find_wish wish;
    enum fit_mode fit;
    int gaps;                          /* pictures go on behind the frame around keys (gaps.h) */
    int brightness;                    /* percent; -1 leaves it as it is */
    unsigned near, fps;                /* of what moves, arguments of driver.near */
    double patience;                   /* seconds: a display that is gone, or refuses reports */
    const volatile sig_atomic_t *stop; /* set from outside: wait no longer */

    display display;
    port_info info;
    picture panel;                    /* what is shown, at the panel's size; owned */
    picture span;                     /* with gaps: what it is cut from; owned */
    display_key moved[KEYS_MOST + 1]; /* with gaps: the display's keys, where they are in `span` */
    keys_track keys;
    uint64_t steered; /* what keys asked for, in all */
    int again;        /* the display came back and has not confirmed `panel` */
    unsigned piece;   /* to be sent again next */
    double due;       /* clock: when */
    int is_lost;      /* a tick found the display gone for good, and nobody was told */
    fail why;         /* ... for this reason */
    unsigned shown, reconnects;
    double longest_gap;     /* seconds from an unplug to the whole picture again */
    port_statistics before; /* of the displays before the last unplug */
} session;

/* Finds and opens; `s` holds wish, fit, brightness, patience, the rest zero.
 * A display that is not there is an error at once. */
int session_open(session *s, fail *f);

/* The picture that those for this display should have the size of. */
const picture *session_picture(const session *s);

/* The display's keys, their symbols where they are in such a picture; NULL: it has none. */
const display_key *session_keys(const session *s);

/* Shows a picture of any size. If the display is unplugged, or refuses reports, says so on standard
 * error, looks for it every 100 ms and shows the whole picture when it is back. -1, when it is not
 * after `patience`, or within 0.2 s of `stop`: `f` says which, and why. */
int session_show(session *s, const picture *p, fail *f);

/* Waits until the device has confirmed the picture, if its protocol can, or until shortly
 * after `stop`. */
int session_confirm(session *s, fail *f);

/* Keeps the link alive between pictures: call it at least ten times per second
 * while a picture is rendered or stays. Parts of the picture are sent again now and then, all of
 * them within 1.5 s: a panel that lost its picture is whole again. A display that was unplugged is
 * waited for, as by session_show. Not 0: it is not back; the next session_show or session_confirm
 * says why. */
int session_tick(session *s);

/* What the display's keys ask for since the last call: how often each action. Keys are heard by
 * session_tick. */
void session_steer(session *s, unsigned count[STEER_ACTIONS]);

/* The device's own picture again, where it has one. A display that refuses is asked for a second,
 * or until `stop`. */
int session_release(session *s, fail *f);
/* 0, or -1: the display has no picture of its own, which `f` says. */
int session_can_release(const session *s, fail *f);

void session_statistics(const session *s, port_statistics *statistics);
void session_close(session *s); /* also after a failed open */

#endif

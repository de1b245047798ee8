/* frames - a source of pictures, and what its kinds have in common
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_FRAMES_H
#define HID_FRAMES_H

#include "host_tools/base/fail.h"
#include "host_tools/hid/device/keys.h"
#include "host_tools/hid/sources/stream.h"
#include "host_tools/picture/picture.h"

typedef struct frames frames;

enum frames_status { FRAMES_END = 0, FRAMES_ONE = 1, FRAMES_FAILED = -1 };

/* A source of frames. `next` fills `p`, and resizes it when it has to. */
struct frames {
    int (*next)(frames *s, picture *p, fail *f);
    void (*close)(frames *s);
    const char *path; /* not owned */
    stream from;      /* its tick is called while a frame is awaited or rendered */
    void *state;      /* owned by the kind of source */
    double period;    /* seconds per frame, as the film says; 0: none */
    /* Set by whoever opens it, like `from`: the keys of the display that it is for, NULL where
     * there are none, and what they ask for since the last call, of from.context. */
    const display_key *keys;
    void (*steer)(void *context, unsigned count[STEER_ACTIONS]);
};

/* The stream ended too early. Returns -1; `f` says that it could not be read or, if it
 * could, what `otherwise` says. */
int frames_cut(const frames *s, const char *otherwise, fail *f);

/* Reads all of a file, for pictures. The bytes are the caller's to free. */
unsigned char *frames_read_all(frames *s, size_t *bytes, fail *f);

#endif

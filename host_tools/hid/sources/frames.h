/* frames - a source of pictures: a file, a film, a pipe, a scene
 *
 * The first bytes of a file, not its name, decide what it is.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_FRAMES_H
#define HID_FRAMES_H

#include "host_tools/app/args.h"
#include "host_tools/base/fail.h"
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
};

/* Opens a file or, as "-", standard input: Y4M, PPM, PGM, PNG, or a packed scene, which
 * is rendered live, `width` x `height`, as the flags say. `s` is zero but for from.tick
 * and its context. */
int frames_open(frames *s, args *a, const char *path, unsigned width, unsigned height, fail *f);
void frames_close(frames *s); /* also after a failed open */

/* The kinds; each is handed an open stream at its first byte. */
int frames_y4m(frames *s, fail *f);
int frames_pnm(frames *s, fail *f);
int frames_png(frames *s, fail *f);
int frames_scene(frames *s, args *a, unsigned width, unsigned height, fail *f);

#define FRAMES_SCENE_FLAGS                                                                         \
    {"--shader", "eyelight|normal|triangle", "a scene's colours"}, {                               \
        "--turn", "SECONDS", "time of an orbit around a scene; 0: no motion (default 12)"          \
    }

/* The stream ended too early. Returns -1; `f` says that it could not be read or, if it
 * could, what `otherwise` says. */
int frames_cut(const frames *s, const char *otherwise, fail *f);

/* Reads all of a file, for pictures. The bytes are the caller's to free. */
unsigned char *frames_read_all(frames *s, size_t *bytes, fail *f);

#endif

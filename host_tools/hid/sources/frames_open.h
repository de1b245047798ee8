/* frames_open - a file, a film, a pipe or a scene as a source of pictures
 *
 * The first bytes of a file, not its name, decide what it is.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_FRAMES_OPEN_H
#define HID_FRAMES_OPEN_H

#include "host_tools/app/args.h"
#include "host_tools/hid/sources/frames.h"

/* Opens a file or, as "-", standard input: Y4M, PPM, PGM, PNG, or a packed scene, which
 * is rendered live, `width` x `height`, as the flags say. `s` is zero but for from.tick
 * and its context, keys and steer. */
int frames_open(frames *s, args *a, const char *path, unsigned width, unsigned height, fail *f);
void frames_close(frames *s); /* also after a failed open */

#endif

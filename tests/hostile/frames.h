/* frames - shows all frames of an untrusted image, and traces some
 *
 * SPDX-License-Identifier: MIT */
#ifndef HOSTILE_FRAMES_H
#define HOSTILE_FRAMES_H

#include "tests/hostile/images.h"

enum { HOSTILE_FRAMES_MOST = 64, HOSTILE_AT_FRAMES = 192 };

typedef struct hostile_frames {
    uint32_t shown, refused; /* frames */
} hostile_frames;

static hostile_frames hostile_frames_all;

/* Each frame shows, or is refused by `rule` or the one behind it; what is shown then can be
 * traced. NULL: so it is. */
static inline const char *hostile_show_frames(plt_engine *e, unsigned rule,
                                              const char *(*trace)(plt_engine *e)) {
    const uint32_t frames = plt_engine_info(e)->frames;
    for (uint32_t i = 0; i < frames && i < HOSTILE_FRAMES_MOST; i++) {
        plt_fault fault;
        const int status = plt_sequence_show(e, i * 7 % frames, &fault);
        hostile_frames_all.shown += status == PLT_OK;
        hostile_frames_all.refused += status != PLT_OK;
        if (status != PLT_OK && !(status == PLT_ERR_IMAGE && fault.kind == 'I' &&
                                  (fault.rule == rule || fault.rule == rule + 1))) {
            return "a frame is refused without a rule";
        }
        const char *sentence = i % 4 == 0 ? trace(e) : NULL;
        if (sentence != NULL) {
            return sentence;
        }
    }
    return trace(e);
}

#endif

/* serve - the host of a device that renders: scene and views out, frames in
 *
 * SPDX-License-Identifier: MIT */
#ifndef SERVE_H
#define SERVE_H
#include <stdint.h>

#include "host_tools/base/fail.h"
#include "host_tools/link/link.h"
#include "host_tools/picture/picture.h"
#include "platform/wire/wire.h"

typedef struct serve_job {
    const void *image; /* of the scene */
    uint32_t image_bytes;
    unsigned width, height, format; /* enum wire_format */
    unsigned report_bytes;          /* in both directions */
    unsigned frames;                /* to receive; 0: without end */
    uint32_t patience_ms;           /* with nothing of a frame, nor a request; 0: for ever */
    /* Fill the view of frame `number`; receive that frame (nonzero ends the run). */
    void (*view)(void *context, unsigned number, wire_view *view);
    int (*frame)(void *context, unsigned number, const picture *p, fail *f);
    void *context;
    int verbose; /* prints events on standard error */
} serve_job;

typedef struct serve_result {
    wire_stats host;
    uint64_t block_bytes; /* of the image, that a device which streams it asked for; else 0 */
    uint32_t blocks;      /* requests for them */
    unsigned frames;
    uint32_t ms;
} serve_result;

/* Runs until `frames` have been received: 0; or -1 with a reason. */
int serve_run(const serve_job *job, const transport *t, serve_result *result, fail *f);

#endif

/* statistics - frames, reports and times of a session: for a person, and as JSON
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_STATISTICS_H
#define HID_STATISTICS_H

#include "host_tools/base/output.h"
#include "host_tools/hid/device/session.h"

typedef struct statistics {
    double first_shown, last_shown; /* clock */
    uint64_t first_reports, last_reports, left_out;
} statistics;

/* A frame was shown. */
void statistics_mark(statistics *a, const session *s);

void statistics_print(const statistics *a, const session *s, double seconds);
/* Writes and closes `o`, also on failure. */
int statistics_write(const statistics *a, const session *s, output *o, double seconds, fail *f);

#endif

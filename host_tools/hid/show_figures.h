/* show_figures - what a showing took: for a person, and as JSON
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_SHOW_FIGURES_H
#define HID_SHOW_FIGURES_H

#include "host_tools/hid/device/session.h"

typedef struct show_figures {
    double first_shown, last_shown; /* clock */
    uint64_t first_reports, last_reports, left_out;
} show_figures;

/* A frame was shown. */
void show_figures_mark(show_figures *a, const session *s);

void show_figures_print(const show_figures *a, const session *s, double seconds);
int show_figures_write(const show_figures *a, const session *s, const char *path, double seconds,
                       fail *f);

#endif

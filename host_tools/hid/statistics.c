/* statistics - see statistics.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/statistics.h"

#include <stdio.h>

#include "host_tools/base/clock.h"

/* The steady rate is measured from the first frame to the last: all of the first is
 * new, and after the last the display may still be refining it. */
void statistics_mark(statistics *a, const session *s) {
    port_statistics p;
    session_statistics(s, &p);
    a->last_shown = clock_seconds();
    a->last_reports = p.reports;
    if (s->shown == 1) {
        a->first_shown = a->last_shown;
        a->first_reports = a->last_reports;
    }
}

static double steady_rate(const statistics *a, const session *s) {
    const double seconds = a->last_shown - a->first_shown;
    return seconds > 0.0 ? (s->shown - 1) / seconds : 0.0;
}

static double steady_reports(const statistics *a, const session *s) {
    return (double)(a->last_reports - a->first_reports) / (s->shown > 1 ? s->shown - 1 : 1);
}

int statistics_write(const statistics *a, const session *s, output *o, double seconds, fail *f) {
    port_statistics p;
    session_statistics(s, &p);
    if (output_print(o, f,
                     "{\n  \"driver\": \"%s\",\n  \"width\": %u,\n  \"height\": %u,\n"
                     "  \"frames\": %u,\n  \"left_out\": %llu,\n  \"seconds\": %.6f,\n"
                     "  \"frames_per_s\": %.3f,\n  \"steady_frames_per_s\": %.3f,\n"
                     "  \"steady_reports_per_frame\": %.2f,\n"
                     "  \"reports\": %llu,\n  \"bytes\": %llu,\n"
                     "  \"reconnects\": %u,\n  \"longest_gap_s\": %.3f,\n"
                     "  \"steered\": %llu\n}\n",
                     s->display.by->name, s->panel.width, s->panel.height, s->shown,
                     (unsigned long long)a->left_out, seconds,
                     seconds > 0.0 ? s->shown / seconds : 0.0, steady_rate(a, s),
                     steady_reports(a, s), (unsigned long long)p.reports,
                     (unsigned long long)p.bytes, s->reconnects, s->longest_gap,
                     (unsigned long long)s->steered) != 0) {
        output_abandon(o);
        return -1;
    }
    return output_commit(o, f);
}

void statistics_print(const statistics *a, const session *s, double seconds) {
    port_statistics p;
    session_statistics(s, &p);
    fprintf(
        stderr,
        "%u frames in %.2f s, %.2f per second; %llu left out; %llu reports, %.1f KB per second; "
        "%u reconnects\n",
        s->shown, seconds, seconds > 0.0 ? s->shown / seconds : 0.0,
        (unsigned long long)a->left_out, (unsigned long long)p.reports,
        seconds > 0.0 ? 1e-3 * (double)p.bytes / seconds : 0.0, s->reconnects);
}

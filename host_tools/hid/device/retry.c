/* retry - see retry.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/retry.h"

#include <stddef.h>

#include "host_tools/base/clock.h"

static const double LOOK = 0.02; /* seconds between two looks at `stop` */

void retry_begin(retry *r, double seconds, const volatile sig_atomic_t *stop) {
    *r = (retry){.end = clock_seconds() + seconds, .stop = stop};
}

static int is_stopped(const retry *r) {
    return r->stop != NULL && *r->stop;
}

enum retry_status retry_next(retry *r, double pause) {
    const double until = clock_seconds() + (r->tries > 0 ? pause : 0.0);
    for (double left; !is_stopped(r) && (left = until - clock_seconds()) > 0.0;) {
        clock_sleep(left < LOOK ? left : LOOK);
    }
    if (is_stopped(r)) {
        return RETRY_STOPPED;
    }
    return r->tries++ == 0 || clock_seconds() < r->end ? RETRY_AGAIN : RETRY_OVER;
}

/* retry - the one place that tries again: pauses, a limit, an end from outside
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_RETRY_H
#define HID_RETRY_H

#include <signal.h>

#include "host_tools/base/fail.h"

enum retry_status { RETRY_AGAIN, RETRY_OVER, RETRY_STOPPED };

typedef struct retry {
    double end;                        /* clock */
    const volatile sig_atomic_t *stop; /* may be NULL */
    unsigned tries;                    /* that were allowed */
    fail why;                          /* of the last; kept by the caller */
} retry;

/* Tries may begin for so long from now. */
void retry_begin(retry *r, double seconds, const volatile sig_atomic_t *stop);

/* Whether one more try may begin: after a pause of so many seconds, which ends within 20 ms of
 * `stop` being set. The first begins at once, and in any case but RETRY_STOPPED. */
enum retry_status retry_next(retry *r, double pause);

#endif

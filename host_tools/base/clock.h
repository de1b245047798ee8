/* clock - time: since some fixed moment, of the processor, of day
 *
 * SPDX-License-Identifier: MIT */
#ifndef CLOCK_H
#define CLOCK_H
#include <stdint.h>

/* Monotonic: never set back, counts from a moment of the system's choice. */
double clock_seconds(void);
uint32_t clock_ms(void); /* wraps after 49.7 days, as the wire's clock does */

/* Sleeps so long, or less when a signal is caught meanwhile. */
void clock_sleep(double seconds);

/* What this process has used of all processors. */
double clock_processor_seconds(void);
/* What the calling thread has. */
double clock_thread_seconds(void);

/* How many processors run at once, at least 1. */
unsigned clock_processors(void);

/* Microseconds since 1970. May be set back: good for numbers that no earlier run
 * of the program has used, not for durations. */
uint64_t clock_day_us(void);

#endif

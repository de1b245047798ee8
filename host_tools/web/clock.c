/* clock - host_tools/base/clock.h for a page
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/base/clock.h"

#include "board/web/web.h"

__attribute__((import_module("page"), import_name("day"))) extern double page_day(void); /* ms */

double clock_seconds(void) {
    return 1e-3 * web_clock();
}

uint32_t clock_ms(void) {
    return (uint32_t)(uint64_t)web_clock();
}

uint64_t clock_day_us(void) {
    return (uint64_t)(1e3 * page_day());
}

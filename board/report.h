/* report - the lines that programs of a board have in common
 *
 * Each is a word and name=value items; an error is one line that begins with "error: ".
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BOARD_REPORT_H
#define PLT_BOARD_REPORT_H

#include "engine/planelet.h"

void report_name(void);
void report_scene(const plt_info *info);

/* Arena and C stack, as they are now. */
void report_memory(const plt_engine *engine, size_t arena_bytes);

/* Why a call gave `status`; returns FIRMWARE_FAILED. */
int report_fault(const plt_fault *fault, int status, size_t arena_bytes);

#endif

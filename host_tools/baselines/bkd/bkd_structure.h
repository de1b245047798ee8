/* bkd_structure - B-KD trees as a kind of structures
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BKD_STRUCTURE_H
#define BASELINES_BKD_STRUCTURE_H

#include "host_tools/baselines/base/kind.h"

extern const structure_kind structure_bkd;

#endif

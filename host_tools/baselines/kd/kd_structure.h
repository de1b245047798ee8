/* kd_structure - kd-trees, as kinds of structures
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_KD_STRUCTURE_H
#define BASELINES_KD_STRUCTURE_H

#include "host_tools/baselines/base/kind.h"

extern const structure_kind structure_kd, structure_kd_boxes, structure_kd_fast, structure_kd_lazy;

#endif

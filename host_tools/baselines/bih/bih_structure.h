/* bih_structure - bounding interval hierarchies as a kind of structures
 *
 * SPDX-License-Identifier: MIT */
#ifndef BASELINES_BIH_STRUCTURE_H
#define BASELINES_BIH_STRUCTURE_H

#include "host_tools/baselines/base/kind.h"

extern const structure_kind structure_bih;

#endif

/* linear - the light that an sRGB byte stands for
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_BASE_LINEAR_H
#define PLT_BASE_LINEAR_H

#include "engine/planelet.h"

/* Of each byte, 65,535 for the last: exact to half of that. */
extern const uint16_t plt_linear[256];

#endif

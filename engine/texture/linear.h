/* linear - the light of an sRGB byte, of 65,535
 *
 * SPDX-License-Identifier: MIT */
#ifndef PLT_TEXTURE_LINEAR_H
#define PLT_TEXTURE_LINEAR_H

#include "engine/planelet.h"

#if PLT_WITH_TEXTURE
extern const uint16_t plt_linear[256]; /* rises from 0 to 65535 */
#endif

#endif

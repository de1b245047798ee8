/* lanes_scalar_fma - the probe of engine/lanes/lanes_scalar.h, scalar compiled for AVX2 and FMA
 *
 * SPDX-License-Identifier: MIT */
#if defined(__x86_64__) || defined(__i386__)
#undef PLT_LANES
#define PROBE lanes_probe_scalar_fma
#define PROBE_NAME "scalar compiled for AVX2 and FMA"
#define PROBE_HEADER "engine/lanes/lanes_scalar.h"
#include "tests/reference/lanes_probe.h"
#else
typedef int lanes_scalar_fma_needs_x86;
#endif

/* lanes_sse_fma - the probe of platform/lanes_sse.h, SSE compiled for AVX2 and FMA
 *
 * SPDX-License-Identifier: MIT */
#if defined(__x86_64__) || defined(__i386__)
#undef PLT_LANES
#define PLT_LANES "platform/lanes_sse.h"
#define PROBE lanes_probe_sse_fma
#define PROBE_NAME "SSE compiled for AVX2 and FMA"
#define PROBE_HEADER "platform/lanes_sse.h"
#include "tests/reference/lanes_probe.h"
#else
typedef int lanes_sse_fma_needs_x86;
#endif

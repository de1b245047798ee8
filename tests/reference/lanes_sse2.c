/* lanes_sse2 - the probe of platform/lanes_sse.h, SSE2
 *
 * SPDX-License-Identifier: MIT */
#if defined(__x86_64__) || defined(__i386__)
#undef PLT_LANES
#define PLT_LANES "platform/lanes_sse.h"
#define PROBE lanes_probe_sse2
#define PROBE_NAME "SSE2"
#define PROBE_HEADER "platform/lanes_sse.h"
#include "tests/reference/lanes_probe.h"
#else
typedef int lanes_sse2_needs_x86;
#endif

/* lanes_sse41 - the probe of platform/lanes_sse.h, SSE4.1
 *
 * SPDX-License-Identifier: MIT */
#if defined(__x86_64__) || defined(__i386__)
#undef PLT_LANES
#define PLT_LANES "platform/lanes_sse.h"
#define PROBE lanes_probe_sse41
#define PROBE_NAME "SSE4.1"
#define PROBE_HEADER "platform/lanes_sse.h"
#include "tests/reference/lanes_probe.h"
#else
typedef int lanes_sse41_needs_x86;
#endif

/* lanes_scalar - the probe of engine/lanes/lanes_scalar.h, scalar
 *
 * SPDX-License-Identifier: MIT */
#undef PLT_LANES
#define PROBE lanes_probe_scalar
#define PROBE_NAME "scalar"
#define PROBE_HEADER "engine/lanes/lanes_scalar.h"
#include "tests/reference/lanes_probe.h"

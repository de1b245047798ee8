/* place_system - see place.h; apart, so that tests have a system of their own
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/place.h"

void place_of(const char *path, char place[PLACE_BYTES]) {
    place_in("/sys", path, place);
}

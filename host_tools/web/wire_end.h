/* wire_end - a Planelet display of a page: driver_planelet's work without waiting
 *
 * A page must not stand still, so opening only begins a session: the panel has a size when the
 * display has answered. All that moves, moves in driver.tick.
 *
 * SPDX-License-Identifier: MIT */
#ifndef WEB_WIRE_END_H
#define WEB_WIRE_END_H

#include "host_tools/hid/device/display.h"

extern const driver driver_wire_end;

/* Whether the display has confirmed every pixel of the last picture. */
int wire_end_is_done(void);
/* Whether it takes the next picture now. */
int wire_end_is_idle(void);

#endif

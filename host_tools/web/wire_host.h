/* wire_host - a Planelet display of a page: driver_planelet's work without waiting
 *
 * A page must not stand still, so opening only begins a session: the panel has a size when the
 * display has answered. All that moves, moves in driver.tick.
 *
 * SPDX-License-Identifier: MIT */
#ifndef WEB_WIRE_HOST_H
#define WEB_WIRE_HOST_H

#include "host_tools/hid/device/display.h"

extern const driver driver_wire_host;

/* What is wrong with a display that answers, or an empty text. */
const fail *wire_host_why(void);

/* Whether the display has confirmed every pixel of the last picture. */
int wire_host_is_done(void);
/* Whether it takes the next picture now. */
int wire_host_is_idle(void);

#endif

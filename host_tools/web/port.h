/* port - what comes from a display, on its way to the driver
 *
 * SPDX-License-Identifier: MIT */
#ifndef WEB_PORT_H
#define WEB_PORT_H

#include "host_tools/hid/device/report_size.h"

enum { PORT_INPUT_BYTES = 512 };

/* What the page says of the device before it is opened; drops what had come. */
void web_port_begin(report_sizes sizes);

/* Where the page puts the next input report; the number first, if reports have numbers. Of
 * PORT_INPUT_BYTES. */
uint8_t *web_port_room(void);
void web_port_came(unsigned bytes);

#endif

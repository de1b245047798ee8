/* shown - the viewer's frames on a USB display, whose keys turn the scene
 *
 * The page opens the device by WebHID, and calls these; it sends reports that `page.report` gets.
 *
 * SPDX-License-Identifier: MIT */
#ifndef WEB_SHOWN_H
#define WEB_SHOWN_H

#include <stdint.h>

#include "host_tools/web/exports.h"

/* Device `index` that there is a driver for: its vendor in the upper 16 bits, its product in the
 * lower; 0: there are no more. */
WEB_EXPORT(uint32_t, shown_device)(unsigned index);

/* A device is open whose longest reports have so many bytes, without their number. -1, and
 * shown_why says why, as it does of what fails below. */
WEB_EXPORT(int, shown_open)(unsigned vendor, unsigned id, unsigned out_bytes, unsigned in_bytes);
WEB_EXPORT(const char *, shown_why)(void);
WEB_EXPORT(const char *, shown_name)(void);

/* Of the panel; 0 until the display has said. */
WEB_EXPORT(unsigned, shown_width)(void);
WEB_EXPORT(unsigned, shown_height)(void);

/* Where an input report goes, its number first if it has one; then how many bytes have come. */
WEB_EXPORT(uint8_t *, shown_room)(void);
WEB_EXPORT(void, shown_came)(unsigned bytes);

/* Some 50 times per second, and when reports have come: hears keys, sends what may go. 1: a key has
 * turned the scene; 0; -1: the display is gone, or does not answer. */
WEB_EXPORT(int, shown_tick)(void);

/* When the page has sent all reports: hands over the last complete frame, if it is a new one. */
WEB_EXPORT(int, shown_show)(void);
/* Whether the display shows it; a display that cannot say so does. */
WEB_EXPORT(int, shown_is_done)(void);

WEB_EXPORT(void, shown_close)(void);

#endif

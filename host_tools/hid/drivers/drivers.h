/* drivers - the list of all drivers (../DISPLAYS.md: what they take, and why they are so)
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_DRIVERS_H
#define HID_DRIVERS_H

#include "host_tools/hid/device/display.h"

/* All drivers, ended by NULL; the best tested first. */
extern const driver *const drivers[];
extern const driver driver_planelet, driver_streamdeck_mini, driver_streamdeck_original,
    driver_streamdeck, driver_streamdeck_xl, driver_streamdeck_neo, driver_streamdeck_plus,
    driver_nova, driver_nova_elite, driver_apex, driver_apex_2023, driver_logitech, driver_picolcd,
    driver_nexus, driver_corsair_lcd;

const driver *driver_named(const char *name); /* NULL: there is none */

#endif

/* drivers - see drivers.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/drivers/drivers.h"

#include <string.h>

const driver *const drivers[] = {&driver_planelet,
                                 &driver_streamdeck_mini,
                                 &driver_streamdeck_original,
                                 &driver_streamdeck,
                                 &driver_streamdeck_xl,
                                 &driver_streamdeck_neo,
                                 &driver_streamdeck_plus,
                                 &driver_nova,
                                 &driver_nova_elite,
                                 &driver_apex,
                                 &driver_apex_2023,
                                 &driver_logitech,
                                 &driver_picolcd,
                                 &driver_nexus,
                                 &driver_corsair_lcd,
                                 NULL};

const driver *driver_named(const char *name) {
    for (unsigned i = 0; drivers[i] != NULL; i++) {
        if (strcmp(drivers[i]->name, name) == 0) {
            return drivers[i];
        }
    }
    return NULL;
}

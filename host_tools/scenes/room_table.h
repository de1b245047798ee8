/* room_table - where the table is: its top, and what hangs above it
 *
 * SPDX-License-Identifier: MIT */
#ifndef ROOM_TABLE_H
#define ROOM_TABLE_H
#include "host_tools/scenes/place.h"

#define TABLE_HIGH 0.75
#define TABLE_X 0.8 /* half the top */
#define TABLE_Z 0.45

/* The middle of the top's upper side. */
static const place room_table = {{{1.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, {0.0, 0.0, 1.0}},
                                 {0.35, TABLE_HIGH, 0.05}};

#endif

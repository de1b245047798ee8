/* keys - the keys of a display: which are pressed, held and released
 *
 * A driver counts the changes of each key; what is to be done is taken from the counts, so nothing
 * is lost while a picture is being sent. A key that is held acts again and again.
 *
 * SPDX-License-Identifier: MIT */
#ifndef HID_KEYS_H
#define HID_KEYS_H

#include <stdint.h>

#include "host_tools/app/steer.h"

enum { KEYS_MOST = 20 };

/* What a driver knows of a key. */
typedef struct display_key {
    const char *name; /* "top left" */
    enum steer_action action;
    uint16_t x, y; /* on the panel: upper left corner of its symbol; 0, 0: it has none */
} display_key;

/* Of the keys in the order of the driver's list. */
typedef struct keys_state {
    uint8_t changes[KEYS_MOST]; /* since the display was opened, modulo 256; odd: it is down */
} keys_state;

/* A report says that the key is down, or up. */
void keys_set(keys_state *s, unsigned key, int is_down);

/* What has steps, a dial or a finger that moves: the key was pressed so often, up to 8 times. */
void keys_step(keys_state *s, unsigned key, unsigned times);

typedef struct keys_track {
    keys_state seen;
    double due[KEYS_MOST]; /* clock: when a key that is held acts again */
    int is_reset;          /* the keys that are a reset together are both down */
} keys_track;

/* What to do since the last call, at most 8 times each: `count` of each action. A display without a
 * key for the first view again has it on the two for nearer and farther, pressed together. `keys`
 * ends with a name of NULL, and may be NULL. */
void keys_take(keys_track *t, const keys_state *now, const display_key *keys, double clock,
               unsigned count[STEER_ACTIONS]);

#endif

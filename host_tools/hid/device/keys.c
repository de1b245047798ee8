/* keys - see keys.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/hid/device/keys.h"

#include <stddef.h>
#include <string.h>

enum { PRESSES_MOST = 8, REPEATS_MOST = 4 };

static const double HOLD = 0.35, REPEAT = 0.1; /* seconds before a key that is held acts again */

void keys_set(keys_state *s, unsigned key, int is_down) {
    if (key < KEYS_MOST && (s->changes[key] & 1) != (is_down != 0)) {
        s->changes[key]++;
    }
}

void keys_step(keys_state *s, unsigned key, unsigned times) {
    for (unsigned i = 0; i < times && i < PRESSES_MOST; i++) {
        keys_set(s, key, 1);
        keys_set(s, key, 0);
    }
}

/* Of a key that has not changed. */
static unsigned repeats(keys_track *t, unsigned key, double clock) {
    if (clock < t->due[key]) {
        return 0;
    }
    const double late = (clock - t->due[key]) / REPEAT;
    if (late >= REPEATS_MOST) { /* nobody has looked for long: a picture was being sent */
        t->due[key] = clock + REPEAT;
        return REPEATS_MOST;
    }
    const unsigned times = 1 + (unsigned)late;
    t->due[key] += times * REPEAT;
    return times;
}

static unsigned take_key(keys_track *t, const keys_state *now, unsigned key, double clock) {
    const uint8_t was = t->seen.changes[key], is = now->changes[key];
    const unsigned changed = (uint8_t)(is - was);
    if (changed == 0) {
        return is & 1 ? repeats(t, key, clock) : 0;
    }
    const unsigned presses = was & 1 ? changed / 2 : (changed + 1) / 2;
    t->seen.changes[key] = is;
    t->due[key] = clock + HOLD;
    return presses < PRESSES_MOST ? presses : PRESSES_MOST;
}

static int is_down(const keys_state *now, const display_key *keys, enum steer_action action) {
    for (unsigned k = 0; k < KEYS_MOST && keys[k].name != NULL; k++) {
        if (keys[k].action == action && now->changes[k] & 1) {
            return 1;
        }
    }
    return 0;
}

static int has(const display_key *keys, enum steer_action action) {
    for (unsigned k = 0; k < KEYS_MOST && keys[k].name != NULL; k++) {
        if (keys[k].action == action) {
            return 1;
        }
    }
    return 0;
}

/* Both keys at once, until both are up: nearer and farther are not meant. */
static void take_reset(keys_track *t, const keys_state *now, const display_key *keys,
                       unsigned count[STEER_ACTIONS]) {
    const int nearer = is_down(now, keys, STEER_NEARER),
              farther = is_down(now, keys, STEER_FARTHER);
    if (nearer && farther && !t->is_reset) {
        t->is_reset = 1;
        count[STEER_RESET] = 1;
    }
    if (t->is_reset) {
        count[STEER_NEARER] = count[STEER_FARTHER] = 0;
    }
    t->is_reset = t->is_reset && (nearer || farther);
}

void keys_take(keys_track *t, const keys_state *now, const display_key *keys, double clock,
               unsigned count[STEER_ACTIONS]) {
    memset(count, 0, STEER_ACTIONS * sizeof count[0]);
    if (keys == NULL) {
        return;
    }
    for (unsigned k = 0; k < KEYS_MOST && keys[k].name != NULL; k++) {
        const unsigned times = count[keys[k].action] + take_key(t, now, k, clock);
        count[keys[k].action] = times < PRESSES_MOST ? times : PRESSES_MOST;
    }
    if (!has(keys, STEER_RESET)) {
        take_reset(t, now, keys, count);
    }
}

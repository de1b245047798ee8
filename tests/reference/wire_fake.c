/* wire_fake - see wire_fake.h
 *
 * SPDX-License-Identifier: MIT */
#include "tests/reference/wire_fake.h"

#include <string.h>

void fake_cable_open(fake_cable *c, wire_peer *host, wire_peer *device, uint64_t seed) {
    memset(c, 0, sizeof *c);
    c->host = host;
    c->device = device;
    c->random.at = seed;
    c->now_ms = (uint32_t)random_bits(&c->random); /* clocks begin anywhere, and wrap */
}

static int happens(fake_cable *c, uint32_t chance) {
    return chance > 0 && random_below(&c->random, 65536) < chance;
}

static void strike(const fake_cable *c, fake_report *r) {
    switch (c->strike.blow) {
    case FAKE_DAMAGES:
        r->data[r->bytes / 2] ^= 0x10;
        break;
    case FAKE_SHORTENS:
        r->bytes /= 2;
        break;
    case FAKE_DELAYS:
        r->due_ms += 3 * WIRE_BLOCK_AGAIN_MS / 2;
        break;
    case FAKE_SWAPS:
        r->due_ms += 3;
        break;
    default:
        break;
    }
}

static int is_struck(const fake_cable *c, int to_host) {
    return c->strike.blow != FAKE_NOTHING && to_host == c->strike.to_host &&
           c->carried[to_host] == c->strike.at;
}

/* Something ends or stops with this report. */
static void begin_outage(fake_cable *c, int to_host) {
    if (is_struck(c, to_host) && c->strike.blow >= FAKE_ENDS) {
        c->struck_ms = c->now_ms;
        c->is_dead |= c->strike.blow == FAKE_ENDS;
        c->stopped = c->strike.blow == FAKE_STOPS_HOST     ? c->host
                     : c->strike.blow == FAKE_STOPS_DEVICE ? c->device
                                                           : c->stopped;
    }
}

static void end_outage(fake_cable *c) {
    if ((c->is_dead || c->stopped != NULL) && c->strike.lasts_ms > 0 &&
        c->now_ms - c->struck_ms >= c->strike.lasts_ms) {
        c->is_dead = 0;
        c->stopped = NULL;
        c->strike.blow = FAKE_NOTHING;
    }
}

/* Whether this report is lost, or repeated, by the strike. */
static int is_lost(const fake_cable *c, int to_host) {
    return c->is_dead || (is_struck(c, to_host) && c->strike.blow == FAKE_LOSES);
}

static int is_repeated(const fake_cable *c, int to_host) {
    return is_struck(c, to_host) && c->strike.blow == FAKE_REPEATS;
}

static void launch(fake_cable *c, const uint8_t *data, size_t bytes, int to_host) {
    for (int i = 0; i < FAKE_IN_FLIGHT; i++) {
        fake_report *r = &c->flight[i];
        if (r->is_used) {
            continue;
        }
        const uint32_t delay =
            c->faults.delay_ms > 0 ? random_below(&c->random, c->faults.delay_ms + 1) : 0;
        const uint32_t back = happens(c, c->faults.reorder) ? 1 + random_below(&c->random, 20) : 0;
        *r = (fake_report){.due_ms = c->now_ms + 1 + delay + back,
                           .order = c->order++ + 4 * back,
                           .bytes = (uint16_t)bytes,
                           .is_used = 1,
                           .to_host = (uint8_t)to_host};
        memcpy(r->data, data, bytes);
        if (is_struck(c, to_host)) {
            strike(c, r);
        }
        if (happens(c, c->faults.truncate)) {
            r->bytes = (uint16_t)random_below(&c->random, (uint32_t)bytes);
        }
        for (int n = happens(c, c->faults.damage) ? 1 + (int)random_below(&c->random, 8) : 0; n > 0;
             n--) {
            r->data[random_below(&c->random, (uint32_t)bytes)] ^=
                (uint8_t)(1u << random_below(&c->random, 8));
        }
        return;
    }
}

static void carry(fake_cable *c, wire_peer *from, int to_host) {
    uint8_t report[WIRE_REPORT_BYTES_MAX];
    for (int sent = 0; sent < (c->paced ? 1 : 8) && from != c->stopped; sent++) {
        const size_t bytes = wire_next_report(from, report, c->now_ms);
        if (bytes == 0) {
            return;
        }
        c->carried[to_host]++;
        begin_outage(c, to_host);
        if (is_lost(c, to_host) || c->plugged_at_ms != 0 || happens(c, c->faults.lose)) {
            continue;
        }
        launch(c, report, bytes, to_host);
        if (is_repeated(c, to_host) || happens(c, c->faults.repeat)) {
            launch(c, report, bytes, to_host);
        }
    }
}

/* The next report that is due, in the order of sending. */
static fake_report *next_due(fake_cable *c) {
    fake_report *best = NULL;
    for (int i = 0; i < FAKE_IN_FLIGHT; i++) {
        fake_report *r = &c->flight[i];
        if (r->is_used && (int32_t)(c->now_ms - r->due_ms) >= 0 &&
            (r->to_host ? c->host : c->device) != c->stopped &&
            (best == NULL || r->order < best->order)) {
            best = r;
        }
    }
    return best;
}

void fake_cable_unplug(fake_cable *c, uint32_t ms) {
    c->unplugged++;
    c->plugged_at_ms = c->now_ms + ms + (c->now_ms + ms == 0);
    memset(c->flight, 0, sizeof c->flight);
    wire_on_link(c->host, 0, c->now_ms);
    wire_on_link(c->device, 0, c->now_ms);
}

static void step_plug(fake_cable *c) {
    if (c->plugged_at_ms != 0 && (int32_t)(c->now_ms - c->plugged_at_ms) >= 0) {
        c->plugged_at_ms = 0;
        wire_on_link(c->device, 1, c->now_ms);
        wire_on_link(c->host, 1, c->now_ms);
    } else if (c->plugged_at_ms == 0 && happens(c, c->faults.unplug)) {
        fake_cable_unplug(c, 1 + random_below(&c->random, 400));
    }
}

void fake_cable_step(fake_cable *c) {
    c->now_ms++;
    step_plug(c);
    end_outage(c);
    for (fake_report *r = next_due(c); r != NULL; r = next_due(c)) {
        /* In a block of just its size, so that sanitizers see a byte too many. */
        wire_on_report(r->to_host ? c->host : c->device, r->data, r->bytes, c->now_ms);
        r->is_used = 0;
    }
    if (c->stopped != c->host) {
        wire_poll(c->host, c->now_ms);
    }
    if (c->stopped != c->device) {
        wire_poll(c->device, c->now_ms);
    }
    carry(c, c->host, 0);
    carry(c, c->device, 1);
}

/* wire_fake - two peers and a cable between them that misbehaves on order
 *
 * A cable carries reports both ways, each with its own delay; when
 * `paced`, at most one report per step and direction. Faults come with the chances of
 * `faults`, in 1/65536 per report, from a seed, so that a run that fails once
 * fails always; or one report, the one of a `strike`, meets one. The clock is the cable's own.
 *
 * SPDX-License-Identifier: MIT */
#ifndef REFERENCE_WIRE_FAKE_H
#define REFERENCE_WIRE_FAKE_H

#include "platform/wire/wire.h"
#include "tests/reference/random.h"

enum { FAKE_IN_FLIGHT = 128 };

typedef struct fake_faults {
    uint32_t lose, repeat, reorder, truncate, damage; /* chances per report */
    uint32_t delay_ms;                                /* 0 .. this, at random */
    uint32_t unplug;                                  /* chance per millisecond */
} fake_faults;

/* What happens to the report that is the `at`-th (from 1) of its direction. */
enum fake_blow {
    FAKE_NOTHING,
    FAKE_LOSES,
    FAKE_DAMAGES,
    FAKE_SHORTENS,
    FAKE_REPEATS,
    FAKE_DELAYS,       /* by more than a repeated request waits */
    FAKE_SWAPS,        /* with those of the next milliseconds */
    FAKE_ENDS,         /* lost, and all behind it in both directions */
    FAKE_STOPS_HOST,   /* carried; but the host stands still, and what comes for it waits */
    FAKE_STOPS_DEVICE, /* likewise */
    FAKE_BLOWS
};

typedef struct fake_strike {
    uint32_t at;
    uint8_t blow, to_host;
    uint32_t lasts_ms; /* of those that end or stop something; 0: for ever */
} fake_strike;

typedef struct fake_report {
    uint32_t due_ms, order;
    uint16_t bytes;
    uint8_t is_used, to_host;
    uint8_t data[WIRE_REPORT_BYTES_MAX];
} fake_report;

typedef struct fake_cable {
    wire_peer *host, *device;
    fake_faults faults;
    fake_strike strike;
    int is_dead;              /* after FAKE_ENDS: cleared, the cable is whole again */
    const wire_peer *stopped; /* stands still; NULL: none does */
    uint32_t struck_ms;       /* when that began */
    random_state random;
    uint32_t now_ms, order, plugged_at_ms; /* 0: in; else the time it comes back */
    int paced; /* one report per millisecond and direction, as full-speed USB */
    uint32_t carried[2], unplugged; /* to device, to host */
    fake_report flight[FAKE_IN_FLIGHT];
} fake_cable;

void fake_cable_open(fake_cable *c, wire_peer *host, wire_peer *device, uint64_t seed);

/* A millisecond: what is due arrives, both peers are polled, reports leave. */
void fake_cable_step(fake_cable *c);

/* Pulls the cable out for `ms`. */
void fake_cable_unplug(fake_cable *c, uint32_t ms);

#endif

/* test_wire_faults - ten thousand bad cables, each from a seed
 *
 * A schedule shows frames for a second or two over a cable with faults of
 * every kind, peers that are reset and a plug that is pulled; then the cable is
 * good again, and the picture must be complete within RECOVERY_MS. Every frame
 * that is confirmed, on the bad cable too, is compared in every pixel (W4 of
 * platform/WIRE.md); what lies on the panel before that is promised by rows of
 * tiles alone (W3), and compared so.
 * PLANELET_SOAK=1 runs ten times as many, a sanitized build a fifth.
 *
 * SPDX-License-Identifier: MIT */
#include <stdlib.h>

#include "tests/reference/wire_rig.h"
#include "tests/test.h"

#ifdef __SANITIZE_ADDRESS__
enum { SCHEDULES = 2000 };
#else
enum { SCHEDULES = 10000 };
#endif
enum { RECOVERY_MS = 2500 };

static const unsigned sizes[] = {8, 16, 32, 63, 64, 512, 1023, 1024};

static uint32_t chance(random_state *r, uint32_t most) {
    return random_below(r, 3) == 0 ? random_below(r, most) : 0;
}

static fake_faults faults_of(random_state *r) {
    const fake_faults f = {.lose = chance(r, 9000),
                           .repeat = chance(r, 9000),
                           .reorder = chance(r, 9000),
                           .truncate = chance(r, 4000),
                           .damage = chance(r, 6000),
                           .delay_ms = chance(r, 12),
                           .unplug = chance(r, 300)};
    return f;
}

static rig_shape shape_of(random_state *r, uint32_t number) {
    const rig_shape shape = {.width = 17 + random_below(r, 32),
                             .height = 9 + random_below(r, 26),
                             .format = random_below(r, WIRE_FORMATS),
                             .out_bytes = sizes[number % 8],
                             .in_bytes = sizes[random_below(r, 5)],
                             .credits = 2 + random_below(r, WIRE_CREDITS_MAX - 1),
                             .reads = (int)random_below(r, 2)};
    return shape;
}

typedef struct totals {
    uint64_t ms, reports, lost, late, bad, unplugged, restarts, cut, slowest, confirmed;
} totals;

static void step_badly(wire_rig *rig, random_state *r, totals *sum) {
    fake_cable_step(&rig->cable);
    if (random_below(r, 40) == 0) {
        const int was_idle = wire_frames_out_idle(&rig->out);
        if (wire_is_up(&rig->host) && rig->frames + 1 < RIG_FRAMES) {
            wire_rig_draw(rig, (int)random_below(r, 3));
            sum->cut += wire_rig_show(rig) && !was_idle;
        }
    }
    if (random_below(r, 2500) == 0) {
        wire_rig_start_device(rig);
        sum->restarts++;
    }
    if (random_below(r, 4000) == 0) {
        wire_rig_start_host(rig);
        sum->restarts++;
    }
}

/* A frame that was confirmed just now; `checked` counts frames that were. */
static void check_confirmed(const wire_rig *rig, uint32_t number, uint32_t *checked, totals *sum) {
    if (rig->frames > *checked && wire_frames_out_done(&rig->out)) {
        *checked = rig->frames;
        sum->confirmed++;
        CHECK(wire_rig_differences(rig) == 0, "schedule %u, frame %u confirmed: %u bytes differ",
              number, rig->frames, wire_rig_differences(rig));
    }
}

static void count(const wire_rig *rig, totals *sum) {
    const wire_stats *h = &rig->host.stats, *d = &rig->device.stats;
    sum->reports += rig->cable.carried[0] + rig->cable.carried[1];
    sum->lost += h->reports_lost + d->reports_lost;
    sum->late += h->reports_late + d->reports_late;
    sum->bad += h->reports_bad + d->reports_bad;
    sum->unplugged += rig->cable.unplugged;
}

/* The cable is good, at most FAKE_IN_FLIGHT old reports come late. */
static void recover(wire_rig *rig, uint32_t number, totals *sum) {
    memset(&rig->cable.faults, 0, sizeof rig->cable.faults);
    uint32_t waited = 0;
    while (!wire_is_up(&rig->host) && waited < RECOVERY_MS) {
        fake_cable_step(&rig->cable);
        waited++;
    }
    wire_rig_draw(rig, 0);
    while (!wire_rig_show(rig) && waited < RECOVERY_MS) {
        fake_cable_step(&rig->cable);
        waited++;
    }
    const int more = wire_rig_wait(rig, RECOVERY_MS - waited);
    CHECK(more >= 0, "schedule %u: not complete after %d ms, host %s, device %s", number,
          RECOVERY_MS, wire_is_up(&rig->host) ? "up" : "down",
          wire_is_up(&rig->device) ? "up" : "down");
    CHECK(wire_rig_differences(rig) == 0, "schedule %u: %u bytes differ", number,
          wire_rig_differences(rig));
    sum->ms += waited + (uint32_t)more;
    sum->slowest = waited + (uint32_t)more > sum->slowest ? waited + (uint32_t)more : sum->slowest;
}

static void schedule(uint32_t number, totals *sum) {
    static wire_rig rig;
    random_state r = {number * UINT64_C(7919) + 1};
    wire_rig_open(&rig, shape_of(&r, number), random_bits(&r));
    rig.cable.faults = faults_of(&r);
    rig.cable.paced = (int)random_below(&r, 2);
    const uint32_t length = 300 + random_below(&r, 1200);
    uint32_t checked = 0;
    for (uint32_t i = 0; i < length; i++) {
        step_badly(&rig, &r, sum);
        check_confirmed(&rig, number, &checked, sum);
        if (i % 64 == 0 && rig.shape.reads && rig.frames > 0) {
            rig.wrong_rows += wire_rig_strangers(&rig);
        }
    }
    recover(&rig, number, sum);
    CHECK(rig.wrong_rows == 0, "schedule %u: %u rows of no frame", number, rig.wrong_rows);
    count(&rig, sum);
    wire_rig_close(&rig);
}

int main(void) {
    const char *soak = getenv("PLANELET_SOAK");
    const uint32_t schedules = SCHEDULES * (soak != NULL && soak[0] == '1' ? 10 : 1);
    totals sum = {0};
    test(
        "every frame confirmed amid faults is right in every pixel, no row was ever of no frame, "
        "and the picture is complete within 2.5 s of the last fault");
    for (uint32_t i = 0; i < schedules; i++) {
        schedule(i, &sum);
    }
    test("the schedules had faults of every kind, and many of each");
    CHECK(sum.lost > 10000 && sum.late > 10000 && sum.bad > 10000 && sum.unplugged > 100 &&
              sum.restarts > 100 && sum.cut > 1000 && sum.confirmed > 10000,
          "too few");
    printf(
        "    %u schedules, %llu reports; %llu numbers missed, %llu late, %llu bad, %llu times "
        "unplugged, %llu resets, %llu frames overtaken, %llu confirmed\n",
        schedules, (unsigned long long)sum.reports, (unsigned long long)sum.lost,
        (unsigned long long)sum.late, (unsigned long long)sum.bad,
        (unsigned long long)sum.unplugged, (unsigned long long)sum.restarts,
        (unsigned long long)sum.cut, (unsigned long long)sum.confirmed);
    printf("    recovered after %llu ms on average, %llu ms at most\n",
           (unsigned long long)(sum.ms / schedules), (unsigned long long)sum.slowest);
    return test_done();
}

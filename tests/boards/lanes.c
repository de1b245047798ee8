/* lanes - a board's lanes header beside the scalar reference, on its own CPU
 *
 * PROGRAM=lanes builds it for any board, without the engine, with the probes of its LANES and of
 * `scalar` (tests/lanes/probe.c). A line for each operation, and "differ=N" last.
 *
 * SPDX-License-Identifier: MIT */
#include "board/board.h"
#include "board/line.h"
#include "tests/lanes/compare.h"

/* With every third value, 64 of 192, all pairs take a minute in QEMU. */
enum { GOOD = 42, BAD = 1, STEP = 3 };

#define PROBE_OF(name) lanes_probe_##name
#define PROBE(name) PROBE_OF(name)
extern const lanes_probe lanes_probe_scalar, PROBE(BOARD_LANES);

static void say(const lanes_comparison *c, enum lanes_op op) {
    line l;
    line_start(&l);
    line_text(&l, c->probe->name);
    line_text(&l, ": ");
    line_text(&l, lanes_names[op]);
    line_item(&l, "compared", c->compared);
    line_item(&l, "flushed", c->flushed);
    line_item(&l, "differ", c->differ);
    if (c->differ != 0) {
        line_item(&l, "word", (unsigned)c->word);
        line_text(&l, " of");
        for (int row = 0; row < 3; row++) {
            line_text(&l, " ");
            line_hex(&l, c->in.row[row][c->word & 3], 8);
        }
        line_text(&l, ": ");
        line_hex(&l, c->got, 8);
        line_text(&l, ", scalar ");
        line_hex(&l, c->want, 8);
    }
    line_print(&l);
}

int firmware(const char *parameters) {
    static lanes_comparison c;
    unsigned long differ = 0;
    (void)parameters;
    c.probe = &PROBE(BOARD_LANES);
    c.scalar = &lanes_probe_scalar;
    c.step = STEP;
    lanes_make_values();
    for (int op = 0; op <= LANES_OP_COUNT; op++) {
        lanes_compare(&c, (enum lanes_op)op);
        say(&c, (enum lanes_op)op);
        differ += c.differ + (c.compared == 0);
    }
    return differ == 0 ? GOOD : BAD;
}

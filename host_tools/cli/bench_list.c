/* bench_list - see bench_list.h
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/cli/bench_list.h"

#include <string.h>

/* ---- the flag ------------------------------------------------------------------------ */

static int read_one(bench_wanted *w, const char *flag, const char *text, size_t length, fail *f) {
    if (length >= sizeof w->name) {
        return fail_set(f, flag, "a name of %zu characters; choose each switch once", length);
    }
    memcpy(w->name, text, length);
    w->name[length] = '\0';
    w->kind = structure_read(w->name, flag, &w->options, f);
    w->has_side = w->kind != NULL && w->options.choice[STRUCTURE_SIDE] != 0;
    return w->kind != NULL ? 0 : -1;
}

static int is_engine(const char *text, size_t length) {
    return length == strlen("engine") && memcmp(text, "engine", length) == 0;
}

void bench_list_read(bench_list *to, args *a, const char *flag, int takes_engine) {
    const char *at = args_text(a, flag, NULL);
    fail f = {""};
    if (at == NULL) {
        return;
    }
    for (;;) {
        at += strspn(at, " ");
        const size_t length = strcspn(at, " ");
        if (*at == '\0' && to->count + (unsigned)to->has_engine > 0) {
            return;
        }
        if (takes_engine && is_engine(at, length)) {
            to->has_engine = 1;
        } else if (to->count == BENCH_LIST_MOST) {
            args_complain(a, "%s takes %d structures at most", flag, BENCH_LIST_MOST);
            return;
        } else if (read_one(&to->wanted[to->count], flag, at, length, &f) != 0) {
            args_complain(a, "%s", f.text);
            return;
        } else {
            to->count++;
        }
        at += length;
    }
}

/* ---- packets --------------------------------------------------------------------------- */

int bench_wanted_has(const bench_wanted *w, unsigned side) {
    if (w->has_side) {
        return w->options.packet_side == side;
    }
    for (const structure_switch *s = structure_switches(w->kind); s->name != NULL; s++) {
        if (s->group == STRUCTURE_SIDE && s->value == side) {
            return 1;
        }
    }
    return 0;
}

structure_options bench_wanted_options(const bench_wanted *w, unsigned side) {
    structure_options o = w->options;
    if (!w->has_side) {
        o.packet_side = (uint8_t)side;
        o.one_by_one = 0;
    }
    return o;
}

/* Whether one of the packets is measured; a build may be without the larger ones. */
static int is_measured(const bench_wanted *w, unsigned packets, unsigned single) {
    int is = 0;
    if (bench_wanted_has(w, 0)) {
        return single == 0 || (packets >> (unsigned)__builtin_ctz(single / 2) & 1u) != 0;
    }
    for (unsigned i = 0; i < BENCH_SIDES && 2u << i <= PLT_PACKET_SIDE_MAX; i++) {
        is |= (packets >> i & 1u) && bench_wanted_has(w, 2u << i);
    }
    return is;
}

void bench_list_check(const bench_list *of, args *a, const char *flag, unsigned packets,
                      unsigned single) {
    for (unsigned i = 0; i < of->count; i++) {
        if (!is_measured(&of->wanted[i], packets, single)) {
            args_complain(a, "%s %s: none of its packets is in --packets; leave --packets out",
                          flag, of->wanted[i].name);
        }
    }
}

#!/bin/sh
# check_layers_see.sh - check_layers sees what it is for: one of each is planted
#
# A small tree in a folder of its own, with the same check: clean at first, then with
# one fault at a time, which must be found, with the name of its file.
# Beside builders: it builds nothing.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir -p "$tree/tests"
cp -r tests/check "$tree/tests"

# put FILE LINE...: a file of the small tree.
put() {
    mkdir -p "$tree/$(dirname "$1")"
    file=$1
    shift
    printf '%s\n' "$@" >"$tree/$file"
}

# look: builds the small tree anew and checks its layers.
look() {
    (
        cd "$tree" && rm -rf build
        find engine platform board host_tools -name '*.c' | while read -r source; do
            mkdir -p "build/host/$(dirname "$source")"
            $CC -std=c11 -I. -c -o "build/host/${source%.c}.o" "$source"
        done
        BUILD=build FIRMWARES='' sh tests/check/check_layers.sh
    ) >"$tree/said" 2>&1
}

# seen SENTENCE VERDICT TEXT: the check, whose sentence ends so, fails and prints the text.
seen() {
    look
    verdict "$1" "$(
        grep -q "^FAIL .*$2\$" "$tree/said" && grep -qF -- "$3" "$tree/said" || {
            echo "expected: $3"
            cat "$tree/said"
        })"
}

up='includes none is of a folder above or beside its own'
link_up='references none leads to a folder above or beside'

put engine/base/a.h 'int plt_a(void);'
put engine/base/a.c '#include "engine/base/a.h"' 'int plt_a(void) { return 1; }'
put engine/trace/b.h 'int plt_b(void);'
put engine/trace/b.c '#include "engine/trace/b.h"' '#include "engine/base/a.h"' \
    'int plt_b(void) { return plt_a(); }'
put engine/planelet_crc32.h ''
put platform/wire/w.c '#include "engine/planelet_crc32.h"' 'int w(void) { return 1; }'
put board/board.h 'void board_print(void);' 'int firmware(void);'
put board/firmware.c '#include "board/board.h"' 'int firmware(void) { board_print(); return 0; }'
put board/small/board.c '#include "board/board.h"' \
    'void board_print(void) {}' 'int start(void) { return firmware(); }'
put host_tools/base/h.c '#include "engine/trace/b.h"' 'int h(void) { return plt_b(); }'
cp -r "$tree" "$tree.clean"
trap 'rm -rf "$tree" "$tree.clean"' EXIT

# again: the small tree as it was.
again() {
    rm -rf "$tree"
    cp -r "$tree.clean" "$tree"
}

look
verdict "nothing is found in a clean tree, the board's contract included" \
    "$(tail -n 1 "$tree/said" | grep -q '^[1-9][0-9]* passed, 0 failed$' || cat "$tree/said")"

put platform/wire/w.c '#include "engine/base/a.h"' 'int w(void) { return 1; }'
seen "a platform that looks into the engine is seen" \
    "platform includes only the engine's public headers and itself" \
    'platform/wire/w.c:1: "engine/base/a.h"'
again
put engine/base/a.c '#include "engine/trace/b.h"' 'int plt_a(void) { return 1; }'
seen "an include that looks up is seen" "$up" \
    'engine/base/a.c:1: engine/trace/b.h: engine/trace is above engine/base'
again
put engine/tree/thesis/t.h '#include "engine/tree/compact/c.h"'
put engine/tree/compact/c.h ''
seen "an include of a format in the other is seen" "$up" \
    'engine/tree/thesis/t.h:1: engine/tree/compact/c.h: '
again
put engine/base/a.h '#include "engine/trace.h"' 'int plt_a(void);'
put engine/trace.h ''
seen "an include of the engine's own top is seen" "$up" \
    'engine/base/a.h:1: engine/trace.h: engine is above engine/base'
again
put board/other/o.c '#include "board/small/s.h"'
put board/small/s.h ''
seen "a board that includes a file of another is seen" "$up" 'board/other/o.c:1: board/small/s.h: '
again
put engine/rooms/r.h ''
seen "a folder that is not in the table is seen" 'every folder of the product is in the table' \
    'engine/rooms: no level of the table has this folder'
again
put engine/trace/c.c '#include "engine/trace/d.h"'
put engine/trace/c.h ''
put engine/trace/d.c '#include "engine/trace/e.h"'
put engine/trace/d.h ''
put engine/trace/e.h '#include "engine/trace/c.h"'
seen "a circle of includes is seen, with its files" 'no includes form a circle' \
    'engine/trace/c -> engine/trace/d (engine/trace/c.c:1) -> engine/trace/e (engine/trace/d.c:1)'
again
put engine/trace/p.c 'int plt_q(void);' 'int plt_p(void) { return plt_q(); }'
put engine/trace/q.c 'int plt_r(void);' 'int plt_q(void) { return plt_r(); }'
put engine/trace/r.c 'int plt_p(void);' 'int plt_r(void) { return plt_p(); }'
seen "a circle of references is seen, with its files" 'host: no references form a circle' \
    'engine/trace/p -> engine/trace/q (plt_q) -> engine/trace/r (plt_r) -> engine/trace/p (plt_p)'
again
put board/small/board.c 'void board_print(void) {}' 'int small(void) { return 1; }' \
    'int firmware(void);' 'int start(void) { return firmware(); }'
put board/firmware.c 'int small(void);' 'int firmware(void) { return small(); }'
seen "a circle through a board, but for its contract, is seen" 'host: no references form a circle' \
    'board/firmware -> board/small/board (small) -> board/firmware (firmware)'
again
put engine/base/a.c 'int plt_b(void);' 'int plt_a(void) { return plt_b(); }'
seen "a reference that looks up without an include is seen" "$link_up" \
    'engine/base/a.o: plt_b: engine/trace is above engine/base'
finish

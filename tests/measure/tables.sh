#!/bin/sh
# tables.sh [write] - tables of README.md and platform/PORTING.md, made of tests/golden/*.csv
#
# Below a line with "<!-- tests/golden/NAME.csv, by make tables -->" the next table is what NAME.csv
# says. Prints what differs, and ends in status 1 if anything does; `write` writes it. A board's
# CPU, RAM and parts are written by hand: these cells stay. GOLDEN is another folder of tables.
# SPDX-License-Identifier: MIT
golden=${GOLDEN:-tests/golden}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
status=0

# table NAME DOCUMENT PROGRAM: an awk program with `column`, `grouped`, `name` (what the first cell
# of NAME.csv says), and, of the table that is there, `by_hand` of the row that has `name` in it.
table() {
    name=$1 document=$2
    [ "$(wc -l 2>/dev/null <"$golden/$1.csv" || echo 0)" -gt 1 ] || {
        echo "$golden/$1.csv has no rows; run: make sizes"
        status=1
        return
    }
    mark="<!-- tests/golden/$name.csv, by make tables -->"
    awk -v mark="$mark" 'index($0, mark) { here = 1; next }
        here && /^\|/ { print; inside = 1; next }
        inside { exit }' "$document" >"$folder/was"
    awk -v q="'" '
        function grouped(n) {
            n = int(n) ""
            while (match(n, /[0-9][0-9][0-9][0-9](,|$)/)) {
                n = substr(n, 1, RSTART) "," substr(n, RSTART + 1)
            }
            return n
        }
        # Of a function that is not there, or refuses: nothing.
        function stack(name) { return $column[name] > 0 ? of(name) : "-" }
        function of(name) { return $column[name] == "" ? "-" : grouped($column[name]) }
        FILENAME ~ /was$/ {
            if (match($0, /`[a-z0-9_]*`/)) {
                by_hand[substr($0, RSTART + 1, RLENGTH - 2)] = $0
            }
            next
        }
        FNR == 1 {
            FS = ","
            n = split($0, head, ",")
            for (i = 1; i <= n; i++) { column[head[i]] = i }
            next
        }
        { name = $1 }
        '"$3" "$folder/was" "$golden/$name.csv" >"$folder/rows"
    awk -v mark="$mark" '
        NR == FNR { rows = rows $0 "\n"; next }
        index($0, mark) { print; here = found = 1; next }
        here && /^\|/ { if (!inside) { printf "%s", rows } inside = 1; next }
        inside { here = inside = 0 }
        { print }
        END { exit !found }' "$folder/rows" "$document" >"$folder/now" || {
        echo "$document: there is no line $mark"
        status=1
        return
    }
    if [ "$write" = write ]; then
        cmp -s "$folder/now" "$document" || cp "$folder/now" "$document"
    elif ! diff "$document" "$folder/now" >"$folder/diff"; then
        echo "$document is not what $name.csv says; run: make tables"
        sed -n '/^[<>]/p' "$folder/diff"
        status=1
    fi
}
write=$1

table parts README.md '
    BEGIN {
        print "| Cortex-M4F, -O2, rare code -Os | Code and constants | Data, bss |" \
            " Worst C stack below `plt_open`, `_render_step`, `_trace` |" \
            " Arena, 2,000 triangles |"
        print "|---|---|---|---|---|"
    }
    name ~ /^(all|render (thesis|compact)( frames)?|render thesis frames small)$/ {
        print "| " (name == "all" ? "the engine" : "`PARTS=" q name q "`") " | " \
            of("code_and_constants") " | " of("data") ", " of("bss") " | " \
            stack("stack_open") ", " stack("stack_render_step") ", " stack("stack_trace") " | " \
            of("arena_peak") " |"
    }'
table parts platform/PORTING.md '
    BEGIN {
        print "| `PARTS` | Code, constants | Worst stack, below | Firmware: worst, painted |" \
            " Arena | Longest step | Per ray |"
        print "|---|---|---|---|---|---|---|"
    }
    {
        print "| " (name == "all" ? "none: all" : name) " | " of("code") ", " of("constants") \
            " | " of("stack_worst") ", `" $column["stack_worst_below"] "` | " \
            of("firmware_stack_worst") ", " of("firmware_stack_painted") " | " of("arena_peak") \
            " | " of("longest_step") " | " of("instructions_per_ray") " |"
    }'
table boards platform/PORTING.md '
    BEGIN {
        print "| Board | CPU | RAM, arena | Parts | Code | Stack | Longest step, finest |" \
            " Per ray |"
        print "|---|---|---|---|---|---|---|---|"
    }
    {
        n = split(by_hand[name], cell, "|")
        for (i = 3; i <= 5; i++) {
            cell[i] = n < 5 ? " ? " : cell[i]
        }
        print "| `" name "` |" cell[3] "|" cell[4] "|" cell[5] "| " of("firmware_code") " | " \
            of("stack_worst") ", " of("stack_painted") " | " of("longest_step") ", " \
            of("longest_step_finest") " | " of("instructions_per_ray") " |"
    }'
table rays platform/PORTING.md '
    BEGIN {
        print "| Board | Bunny | Toasters | Arena used |"
        print "|---|---|---|---|"
    }
    function how(scene) { # streamed is said; what does not fit, too
        return $column[scene "_per_ray"] != "" ? of(scene "_per_ray") \
            ($column[scene] == "mapped" ? "" : ", " $column[scene]) : $column[scene]
    }
    function arena(scene) {
        return ($column[scene "_per_ray"] == "" ? "wants " : "") of(scene "_arena")
    }
    {
        print "| `" name "` | " how("bunny") " | " how("toasters") " | " arena("bunny") \
            (arena("bunny") == arena("toasters") ? "" : "; " arena("toasters")) " |"
    }'
table hashes platform/PORTING.md '
    BEGIN {
        print "| CPU or board | Byte order, bits | Lanes | Compiler, level |"
        print "|---|---|---|---|"
    }
    $7 ~ /not tried/ { next }
    {
        row = "| " name " | " $2 ", " $3 " | " $4 " | "
        with = row == last_row && $5 == last_by ? " " $6 : (row == last_row ? "; " : "") $5 " " $6
        if (row != last_row && last_row != "") {
            print line " |"
        }
        line = row == last_row ? line with : row with
        last_row = row
        last_by = $5
    }
    END { print line " |" }'
exit $status

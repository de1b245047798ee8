#!/bin/sh
# check_words.sh - words and names that must not come back
#
# Beside builders: it builds nothing.
#
# A row of the table: where (a pattern for paths), what (a pattern for whole words, small
# letters), what to write instead, and an example, in which the row must find it. It is
# looked for across the ends of lines too. All that is found is in build/check/words.txt.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
list=$BUILD/check/words.txt
mkdir -p "$BUILD/check"

# What is counted, and per what.
counted='bytes|bits?|instructions|cycles|rays|pixels|floats|operations|indices|words|slots'
counted="$counted|kb|mb|kib|mib|gib|ms|us|ns|sections|points|samples|messages|reports?|radii"
counted="$counted|radians|degrees|steps|triangles|nodes|groups|lists|chances?|frames|lines"
counted="$counted|records|numbers|hits|lookups|fetches|multiplications|additions|divisions"
number='[0-9.,]*[0-9]%?|%[0-9.]*[a-z]+|k|two|three|four|six|eight|ten|once|twice|none'
per='triangle|node|ray|list|unit|leaf|block|second|frame|pixel|packet|group|vertex|byte|corner'
per="$per|slot|side|axis|level|child|record|sample|channel|symbol|millisecond|tile"
per="$per|message|section|treelet|step|image|strip|bin|pair|report|sphere|microsecond|entry|visit"

table="
.* : ($counted) an? ($per) : per : 2.3 bytes a triangle
.* : ($number) an? ($per) : per : at most two a list
.* : visits an? (ray|packet|step|frame|second|triangle) : per : 19.1 node visits a packet
.* : [a-z0-9_]+_(a|an)_(second|frame|triangle|node|ray|byte) : per : frames_a_second
.* : plt_(unit|rim|survey|numbers|window|film)[a-z0-9_]* : leaf, frustum ... : plt_unit_read(
.* : (plt_)?walker[a-z0-9_]* : plt_traversal : a plt_walker
.* : (plt_)?walk_(unit|blocks|depth_first|two_stage|begin|nearer)[a-z0-9_]* : traverse : walk_unit.c
.* : (plt_)?open_blocks[a-z0-9_]* : what the function is called now : plt_open_blocks(
.* : [a-z0-9_]*unit_corners[a-z0-9_]* : leaf_corners : unit_corners.h
.* : wire_end[a-z0-9_]* : wire_peer : wire_end_open(
.* : [a-z0-9_]*survey[a-z0-9_]* : validate : the survey of a block
.* : soundness|blocks_sound|[a-z]+_sound : validation, valid : soundness is checked
.* : packing numbers? : primitive id : its packing number
engine/.* : [a-z0-9_]*film[a-z0-9_]* : tile buffer : the film
engine/.* : [a-z0-9_]*walk(s|ed|er|ers|ing)? : traverse, traversal : packets walk
engine/.* : rims? : frustum : the rim of a packet
engine/.* : sound : valid : the blocks are sound
engine/.* : believed?|believes|gathers?|gathered|settled?|settles : what happens : it is believed
engine/.* : units? : leaf : a unit of up to eight triangles
"
# Where the field itself says so.
allowed='units? in the last place|unit roundoff|unit vectors?|floating-point unit|unit cube'
allowed="$allowed|unit length|units are the scene|scene units|unit, range"

# words FILE...: "file:line: what: write ..." of every row that is found.
words() {
    awk -v table="$table" -v allowed="$allowed" '
        BEGIN {
            lines = split(table, line, "\n")
            for (i = 1; i <= lines; i++) {
                if (split(line[i], part, " : ") == 4) {
                    where[++rows] = "^(" part[1] ")$"
                    what[rows] = "[^a-z0-9_](" part[2] ")[^a-z0-9_]"
                    instead[rows] = part[3]
                }
            }
        }

        # The text of a line, without the mark of a comment in front.
        function text_of(raw) {
            raw = tolower(raw)
            sub(/^[ \t]*(\/\*|\*|#+|>|\/\/)?[ \t]*/, "", raw)
            sub(/[ \t]*(\\|\*\/)?[ \t]*$/, "", raw)
            gsub(allowed, "", raw)
            return raw
        }

        # What begins in the line before, and may end in `next_line`.
        function look(next_line,    i, both) {
            both = " " before " " next_line " "
            for (i = 1; i <= rows; i++) {
                if (path ~ where[i] && match(both, what[i]) && RSTART <= length(before)) {
                    print path ":" number ": " substr(both, RSTART + 1, RLENGTH - 2) \
                        ": write " instead[i]
                }
            }
        }

        {
            now = text_of($0)
            if (FNR > 1) { look(now) } else if (NR > 1) { look("") }
            before = now
            path = FILENAME
            number = FNR
        }
        END { look("") }' "$@"
}

examples=$(mktemp -d)
trap 'rm -rf "$examples"' EXIT
mkdir -p "$examples/engine"
printf '%s\n' "$table" | awk -F ' : ' 'NF == 4 { print "/* " $4; print ""; print "" }' \
    >"$examples/engine/old.h"
rows=$(printf '%s\n' "$table" | grep -c ' : ')
verdict "each of $rows rows finds its example" "$(
    cd "$examples" || exit
    found=$(words engine/old.h | sed 's/^[^:]*:\([0-9]*\):.*/\1/' | sort -u | grep -c .)
    [ "$found" -eq "$rows" ] || {
        echo "$found of $rows examples are found; those:"
        words engine/old.h
    })"
printf '%s\n' ' * 40 bytes' ' * a triangle' >"$examples/engine/old.h"
printf '%s\n' 'A node names a node, a ray tests a triangle.' \
    'Of ten rays, a second list, 10 times a second.' \
    'An error of one unit in the last place.' >"$examples/engine/new.h"
verdict "a phrase is found across two lines, and what is fine is not" "$(
    cd "$examples" || exit
    [ "$(words engine/old.h)" = "engine/old.h:1: bytes a triangle: write per" ] ||
        words engine/old.h
    words engine/new.h)"

files=$(find engine platform board host_tools tests Makefile ./*.md .ci -type f \
    \( -name '*.[chS]' -o -name '*.md' -o -name '*.sh' -o -name '*.awk' -o -name '*.ld' \
    -o -name '*.mk' -o -name '*.txt' -o -name Makefile -o -path .ci/run \) \
    ! -name check_words.sh | sort)
# shellcheck disable=SC2086
words $files >"$list"
verdict "no old word or name is in $(echo "$files" | wc -l) files ($(wc -l <"$list") found)" \
    "$(cat "$list")"
finish

#!/bin/sh
# check_profile.sh - `make profile` books each instruction on the function it is in
#
# Addresses that look like decimal numbers with an exponent are among them: to awk
# 00005e84 is larger than 00005f00, and a neighbour got what was not its own.
# Beside builders: it builds nothing.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

cat >"$folder/symbols" <<'S'
00000100 T first
00000100 t $t
00005e80 T before
00005e84 T exponent
00005f00 t local
0000e100 T digits
00010000 D data
20000000 B variable
S
cat >"$folder/counts" <<'S'
00000100 1
00000ffe 2
00005e80 4
00005e84 8
00005e86 16
00005efe 32
00005f00 64
00009000 128
0000e0fe 256
0000e100 512
S
cat >"$folder/expected" <<'S'
3 first
4 before
56 exponent
448 local
512 digits
S
booked() { # SYMBOLS COUNTS: the sums by function
    awk -f board/tools/profile.awk "$1" "$2" | awk '{ print $1, $4 }'
}
verdict "each function has the instructions between its address and the next" "$(
    booked "$folder/symbols" "$folder/counts" | diff "$folder/expected" -)"

# nm of a 64-bit program writes 16 digits, counters may write 0x or capitals.
sed 's/^/00000000/' "$folder/symbols" >"$folder/wide"
sed 's/^0*\([0-9a-f]\)/0x\1/' "$folder/counts" | tr a-f A-F | sed 's/0X/0x/' >"$folder/short"
verdict "addresses of another length, with 0x or in capitals are the same addresses" "$(
    booked "$folder/wide" "$folder/short" | diff "$folder/expected" -)"
: >"$folder/empty"
verdict "a profile without a count is an error" "$(
    ! awk -f board/tools/profile.awk "$folder/symbols" "$folder/empty" 2>/dev/null ||
        echo "it ended well")"
finish

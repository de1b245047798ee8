#!/bin/sh
# check_sizes.sh - firmware is within its budget, and PORTING.md says what boards cost
#
# Two boards are built here, one of the whole engine and one of the small; all of them,
# and what they take while they run, are for `make test-boards`. SPDX-License-Identifier: MIT
. tests/check/report.sh
budget=tests/golden/boards.csv
folder=$BUILD/check
mkdir -p "$folder"

code_of() { # OBJECT...
    arm-none-eabi-size "$@" | awk 'NR > 1 { code += $1 } END { print code + 0 }'
}

echo "board,engine_code,firmware_code,stack_worst" >"$folder/sizes.csv"
for board in mps2_an386 lm3s6965evb; do
    make_board "$board" || continue
    out=$BUILD/$board
    # shellcheck disable=SC2046
    echo "$board,$(code_of $(sed -n "s|^LOAD \\($out/engine/.*\\.o\\)\$|\\1|p" \
        "$out/firmware.map")),$(code_of "$out/firmware.elf"),$(
        sed -n 's/^worst \([0-9]*\).*/\1/p' "$out/stack.txt")" >>"$folder/sizes.csv"
done
compared=$(awk -f tests/boards/budget.awk "$budget" "$folder/sizes.csv")
echo "$compared" | sed -n '/^error/!s/^./    &/p'
verdict "code and worst stack of two boards are within their budget, 1 % more at most" "$(
    [ "$(wc -l <"$folder/sizes.csv")" -eq 3 ] || cat "$folder/sizes.csv"
    echo "$compared" | grep '^error')"
awk -F, -v OFS=, 'NR > 1 { $3 = int($3 * 1.02) } { print }' "$folder/sizes.csv" \
    >"$folder/larger.csv"
verdict "... and what is 2 % larger would not be" "$(
    [ "$(awk -f tests/boards/budget.awk "$budget" "$folder/larger.csv" |
        grep -c '^error: .*firmware_code is above')" -eq 2 ] || echo "it is not noticed")"
verdict "PORTING.md's table of boards is that of $budget" "$(
    awk -F, '
        function grouped(n) {
            return n >= 1000 ? sprintf("%d,%03d", n / 1000, n % 1000) : n ""
        }
        NR == FNR && FNR == 1 { for (i = 1; i <= NF; i++) { column[$i] = i } next }
        NR == FNR {
            wanted[$1] = grouped($column["firmware_code"]) " | " grouped($column["stack_worst"]) \
                ", " grouped($column["stack_painted"]) " | " \
                grouped(int($column["instructions_per_ray"])) " |"
            next
        }
        {
            line = $0
            for (board in wanted) {
                if (index(line, "| `" board "` |") == 1) {
                    seen[board]++
                    if (index(line, wanted[board]) == 0) {
                        print board ": it should end in " wanted[board]
                    }
                }
            }
        }
        END {
            for (board in wanted) {
                if (seen[board] != 1) {
                    print board ": no row of its own"
                }
            }
        }
    ' "$budget" platform/PORTING.md)"
finish

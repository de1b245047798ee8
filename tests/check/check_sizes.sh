#!/bin/sh
# check_sizes.sh - firmware is within its budget, and documents say what it costs
#
# Some boards are measured here as `make sizes` does, each family and the smallest among them; PARTS
# are for tests/qemu/test_parts.sh, and all of both for `make sizes` and `make test-boards`.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
folder=$BUILD/check
boards='lm3s6965evb microbit mps2_an386 mps3_an547 rv32_virt sifive_e stm32vldiscovery'
mkdir -p "$folder"
needs arm-none-eabi-gcc qemu-system-arm riscv64-unknown-elf-gcc qemu-system-riscv32 ||
    { finish; exit; }

said=$($MAKE -s sizes ON="$boards" OF=none 2>&1)
status=$?
echo "$said" | sed -n '/^beside/,/^$/s/^./    &/p'
rows=$BUILD/sizes
verdict "code, constants, RAM, arena, stack, steps and structures of $(echo "$boards" | wc -w) \
boards are within their budget, 1 % more at most" "$(
    [ "$status" -eq 0 ] || echo "$said" | grep -E 'error|\*\*\*' || echo "$said" | tail -n 5
    [ "$(wc -l <"$rows/boards.csv")" -eq "$(($(echo "$boards" | wc -w) + 1))" ] ||
        cat "$rows/boards.csv")"

# larger FILE COLUMN FACTOR PATTERN: errors of budget.awk about rows with a column that is larger.
larger() {
    awk -F, -v OFS=, -v c="$2" -v by="$3" 'NR == 1 { for (i = 1; i <= NF; i++) { at[$i] = i } }
        NR > 1 { $at[c] = int($at[c] * by) } { print }' "tests/golden/$1" >"$folder/larger.csv"
    awk -f tests/boards/budget.awk "tests/golden/$1" "$folder/larger.csv" | grep -c "^error: .*$4"
}
number() { # FILE: of rows
    sed 1d "tests/golden/$1" | wc -l
}
verdict "... and what is 2 % larger would not be, in these columns" "$(
    for column in engine_code engine_constants firmware_code arena_peak stack_worst stack_painted \
        longest_step longest_step_finest instructions_per_ray; do
        [ "$(larger boards.csv $column 1.02 "$column is above")" -eq "$(number boards.csv)" ] ||
            echo "$column of boards.csv"
    done
    for column in code constants stack_worst firmware_stack_painted arena_peak longest_step; do
        [ "$(larger parts.csv $column 1.02 "$column is above")" -eq "$(number parts.csv)" ] ||
            echo "$column of parts.csv"
    done
    [ "$(larger structures.csv bytes 1.02 'bytes is above')" -eq "$(number structures.csv)" ] ||
        echo "bytes of structures.csv")"
verdict "no row of parts.csv is without figures" "$(
    awk -F, 'NR > 1 && ($2 == 0 || $10 == 0 || $15 == 0)' tests/golden/parts.csv)"
verdict "... nor a byte more than PARTS may have of code or stack, whatever they had" "$(
    awk -F, -v OFS=, 'NR > 1 { $6 = $(NF - 1) + 1; $10 = $NF + 1 } { print }' \
        tests/golden/parts.csv >"$folder/larger.csv"
    for column in code_and_constants stack_worst; do
        [ "$(awk -f tests/boards/budget.awk slack=1000 tests/golden/parts.csv "$folder/larger.csv" |
            grep -c "^error: .*: $column is .*, and may be")" -eq "$(number parts.csv)" ] ||
            echo "$column"
    done)"
verdict "... nor another frame, data, or a row that nobody knows" "$(
    sed '2s/[^,]*$/0123456789abcdef/; 3s/,0,0,/,4,8,/; $s/^[^,]*/another/' tests/golden/boards.csv |
        awk -f tests/boards/budget.awk tests/golden/boards.csv - >"$folder/said"
    for what in 'frame_hash is not' '4 bytes of engine_data' '8 bytes of engine_bss' \
        'another has no row'; do
        grep -q "^error: .*$what" "$folder/said" || echo "not seen: $what"
    done)"

verdict "words of OF without a row are named, with those that have one, and nothing is built" "$(
    rm -f "$rows/parts.csv"
    said=$($MAKE -s sizes ON=none OF='render thesis, thesis rendr' 2>&1) && echo "status 0"
    echo "$said" | grep -q "^error: OF: .* no row 'thesis rendr'; it has all, render thesis, " ||
        echo "$said"
    [ ! -f "$rows/parts.csv" ] || echo "parts were built")"
verdict "tables of README.md and PORTING.md are those of tests/golden/*.csv" "$(
    sh tests/measure/tables.sh)"
verdict "... and those of others would not be" "$(
    rm -rf "$folder/golden" && mkdir "$folder/golden"
    for name in tests/golden/*.csv; do
        sed '2,$s/1/2/g' "$name" >"$folder/golden/${name##*/}"
    done
    said=$(GOLDEN=$folder/golden sh tests/measure/tables.sh) && echo "status 0"
    for table in 'README.md is not what parts.csv' 'PORTING.md is not what parts.csv' \
        'PORTING.md is not what boards.csv' 'PORTING.md is not what rays.csv' \
        'PORTING.md is not what hashes.csv'; do
        echo "$said" | grep -q "$table" || echo "not seen: $table says"
    done)"
finish

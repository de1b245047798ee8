# report - what every check and firmware test says, and how it counts
#
# Sourced. `verdict SENTENCE TROUBLE` passes when TROUBLE is empty; `needs TOOL`
# is a failed check with a remedy when the tool is not there; `finish` prints
# the sum and is the last command. SPDX-License-Identifier: MIT
BUILD=${BUILD:-build}
MAKE=${MAKE:-make}
CC=${CC:-cc}
passed=0 failed=0

verdict() {
    if [ -z "$2" ]; then
        echo "pass $1"
        passed=$((passed + 1))
    else
        printf '%s\n' "$2" | head -n 20 | sed 's/^/    /'
        echo "FAIL $1"
        failed=$((failed + 1))
    fi
}

needs() {
    for tool in "$@"; do
        if ! command -v "$tool" >/dev/null 2>&1; then
            verdict "$tool is installed" "there is no $tool here; run: make setup"
            return 1
        fi
    done
}

# objects_of FOLDER SUFFIX SOURCE_FOLDER...: the objects in FOLDER whose sources
# are still there.
objects_of() {
    folder=$1 suffix=$2
    shift 2
    find "$@" -name '*.c' | sort | while read -r source; do
        [ -e "$folder/${source%.c}.$suffix" ] && echo "$folder/${source%.c}.$suffix"
    done
}

# stack_of FOLDER "SOURCE_FOLDER..." [awk option ...]: stack.awk over the
# Cortex-M objects of these sources.
stack_of() {
    out=$1 sources=$2
    shift 2
    # shellcheck disable=SC2046,SC2086
    arm-none-eabi-objdump -d $(objects_of "$out" o $sources) |
        awk -v out="$out/" "$@" -f board/tools/stack.awk $(objects_of "$out" ci $sources) -
}

# All public functions, as declared in planelet.h, but those which firmware has
# only where PARTS says so.
public_functions() {
    awk '/^[a-z].*[ *]plt_(render_(tiles|seek)|batch_packets|trace_begin|task_.*)\(/ { next }
        /^[a-z].*[ *]plt_(move.*|motion_get|rebuild_.*|sequence_.*|place|instance_.*)\(/ { next }
        /^[a-z].*[ *]plt_(surface_at|lighting_set|texture_stats_get)\(/ { next }
        /^[a-z].*[ *]plt_[a-z_]+\(/ {
        sub(/\(.*/, ""); sub(/.*[ *]/, ""); printf "%s ", $0 }' engine/planelet.h
}

# make_board BOARD [VARIABLE=...]: builds its firmware; a failed check when that fails.
make_board() {
    board=$1
    shift
    needs "$(cross_of "$board")gcc" || return 1
    trouble=$($MAKE -s BOARD="$board" "$@" 2>&1 >/dev/null) && return 0
    verdict "the firmware of $board builds" "${trouble:-make BOARD=$board $* failed}"
    return 1
}

# boards: those which an emulator here runs, as their run.sh says, or those of ON alone. cross_of
# BOARD: the prefix of its compiler.
boards() {
    [ -z "$ON" ] || { echo "$ON"; return; }
    for file in $(grep -l '^\. board/tools/emulate.sh' board/*/run.sh); do
        board=${file#board/}
        echo "${board%/run.sh}"
    done
}
cross_of() {
    sed -n 's/^CROSS := //p' "board/$1/board.mk"
}

finish() {
    echo "$passed passed, $failed failed"
    [ "$failed" -eq 0 ]
}

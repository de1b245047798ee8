#!/bin/sh
# hashes.sh - one frame by every CPU, lanes header, compiler and level of optimisation: its hashes
#
# For each, the boards' firmware is compiled as a program of that CPU, and renders the scene and the
# frame of tests/boards/test_boards.sh; then every board does, with the lanes of its board.mk, as
# groups of rays, which have lanes, where it has room for these. ARCHS, COMPILERS, LEVELS and ON
# (boards) name fewer, `none` none; ROW is one row, which this script does for itself. The table:
# build/hashes.csv; build/hashes/rows.csv has its rows as they come. What cannot be tried has a row,
# too, that says why. tests/golden/hashes.csv has the rows that were tried before:
# one of them that is another now, or is not tried any more, is a failure. A browser's frame is
# compared by tests/web/test_web.sh. SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/boards/rows.sh
folder=$BUILD/hashes
parts='render thesis'
export BUILD

setting() { # ARCH NAME: what tests/cpus/ARCH.mk says
    sed -n "s/^$2 := //p" "tests/cpus/$1.mk" | tail -n 1
}

# Why a row cannot be tried; nothing: it can.
reason() { # ARCH LANES COMPILER LEVEL
    case $2,$3,$4 in
    rvv,gcc,*) echo "gcc 12 has no vectors for it" ;;
    rvv,*,-O0) echo "QEMU 7.2 ends by an assertion" ;;
    esac
}

try() { # ARCH LANES COMPILER LEVEL: prints its row
    program=$folder/$1-$2-$3$4
    why=$(reason "$@")
    if [ -n "$why" ]; then
        echo "$1,,,$2,$3,$4,not tried: $why"
        return
    fi
    settings=$($MAKE -s --no-print-directory ARCH="$1" LANES="$2" COMPILER="$3" OPTIMISE="$4" \
        engine-command 2>&1)
    emulator=$(echo "$settings" | head -n 1) command=$(echo "$settings" | tail -n 1)
    # shellcheck disable=SC2086
    if ! eval "$command $flags -o $program" tests/cpus/board.c platform/altivec.c \
        board/firmware.c board/job.c board/line.c board/number.c board/parameters.c \
        board/report.c $files -lm >"$program.log" 2>&1; then
        echo "$1,,,$2,$3,$4,not compiled: $(head -n 1 "$program.log")"
        return
    fi
    of=$(eval "$command -dM -E -x c /dev/null" | awk '
        $2 == "__BYTE_ORDER__" { order = $3 == "__ORDER_BIG_ENDIAN__" ? "big" : "little" }
        $2 == "__SIZEOF_POINTER__" { bits = 8 * $3 }
        END { print order "," bits }')
    # shellcheck disable=SC2086
    hash=$(timeout 120 $emulator "$program" "scene=$folder/knot.plt" size=80x60 $camera 2>&1 |
        tee "$program.log" | sed -n 's/^frame_hash=//p')
    echo "$1,$of,$2,$3,$4,${hash:-no frame: $(tail -n 1 "$program.log")}"
    rm -f "$program"
}

# try_board BOARD: prints its row; the level is that of firmware.mk.
try_board() {
    board=$1
    own=$(sed -n 's/^BOARD_PARTS := //p' "board/$board/board.mk")
    lanes=$(sed -n 's/^LANES := //p' "board/$board/board.mk")
    built=$BUILD/$board by=$(cross_of "$board")gcc,-O2
    [ -n "$own" ] || built=$built-render-thesis
    make_board "$board" PARTS="${own:-$parts}" >"$folder/$board.log" 2>&1 || {
        echo "$board,,,$lanes,$by,not built: $(head -n 1 "$folder/$board.log")"
        return
    }
    of=$("$(cross_of "$board")readelf" -h "$built/firmware.elf" | awk '
        $1 == "Class:" { bits = substr($2, 4) }
        $1 == "Data:" { order = /little/ ? "little" : "big" }
        END { print order "," bits }')
    run_frame "$folder/knot.plt"
    hash=$(value frame_hash)
    echo "$board,$of,$lanes,$by,${hash:-no frame: $(echo "$text" | tail -n 1)}"
}

if [ -n "$ROW" ]; then
    # shellcheck disable=SC2086
    try $ROW
    exit
fi

mkdir -p "$folder"
"$BUILD/host/planelet" make knot --triangles 600 -o "$folder/knot.ply" >/dev/null &&
    "$BUILD/host/planelet" pack "$folder/knot.ply" -o "$folder/knot.plt" >/dev/null ||
    verdict "the scene is made" "planelet failed"
view=$(sh board/tools/host_view.sh "$folder/knot.plt" 80x60 "$folder/host.ppm")
due=${view%% *} camera=${view#* }
part=$(make -s -f tests/cpus/engine_files.mk PARTS="$parts")
files=$(echo "$part" | head -n 1) flags=$(echo "$part" | tail -n 1)
export camera files flags

archs=${ARCHS:-$(sh tests/cpus/archs.sh)} devices=${ON:-$(boards)}
[ "$archs" != none ] || archs=
[ "$devices" != none ] || devices=
for arch in $archs; do
    for lanes in $(setting "$arch" HASHED); do
        for compiler in ${COMPILERS:-$(setting "$arch" HASHED_BY)}; do
            for level in ${LEVELS:--O0 -O1 -O2 -O3 -Os}; do
                echo "$arch $lanes $compiler $level"
            done
        done
    done
done >"$folder/rows"
table=$BUILD/hashes.csv before=tests/golden/hashes.csv
: >"$folder/rows.csv"
xargs -r -P "${JOBS:-$(getconf _NPROCESSORS_ONLN)}" -I '{}' env ROW='{}' sh tests/cpus/hashes.sh \
    <"$folder/rows" | tee -a "$folder/rows.csv"
for board in $devices; do
    try_board "$board" | tee -a "$folder/rows.csv"
done
{
    echo "cpu,byte_order,bits,lanes,compiler,level,frame_hash"
    LC_ALL=C sort "$folder/rows.csv"
} >"$table"
tried=$(grep -vc ',not tried: ' "$folder/rows.csv")
verdict "$tried rows have the frame of the host, $due" "$(
    [ "$tried" -gt 0 ] || echo "none was tried"
    grep -v ',not tried: ' "$folder/rows.csv" | grep -v ",$due\$")"
grep ',not tried: ' "$folder/rows.csv" | sed 's/^/    /'
verdict "$(wc -l <"$folder/rows.csv") rows, one for each that was asked for" "$(
    asked=$(($(wc -l <"$folder/rows") + $(echo "$devices" | wc -w)))
    [ "$(wc -l <"$folder/rows.csv")" -eq "$asked" ] || echo "asked for were $asked")"
verdict "a row of $before is as it was there, if it was asked for, and so is what is not tried" "$(
    awk -F, 'function key() { return $1 "," $4 "," $5 "," $6 }
        NR == FNR { was[key()] = $7; next }
        FNR > 1 && (key() in was) && was[key()] != $7 { print key() ": " $7 ", was " was[key()] }
        FNR > 1 && !(key() in was) && /,not tried: / { print key() ": " $7 }' "$before" "$table")"
# A board's compiler has the name of its CPU before it.
verdict "every row of $before that was asked for is in the table" "$(
    awk -F, -v archs="$ARCHS" -v compilers="$COMPILERS" -v levels="$LEVELS" -v on="$ON" '
        function key() { return $1 "," $4 "," $5 "," $6 }
        function asked(names, name) { return names == "" || index(" " names " ", " " name " ") }
        NR == FNR { now[key()]; next }
        FNR == 1 || (key() in now) { next }
        $5 ~ /-gcc$/ { wanted = asked(on, $1) }
        $5 !~ /-gcc$/ { wanted = asked(archs, $1) && asked(compilers, $5) && asked(levels, $6) }
        wanted { print key() " is not tried any more; list it again, or take its line out" }
        ' "$table" "$before")"
echo "new in the table: $(awk -F, 'function key() { return $1 "," $4 "," $5 "," $6 }
    NR == FNR { was[key()]; next } !(key() in was) { n++ } END { print n + 0 }' "$before" "$table")"
finish

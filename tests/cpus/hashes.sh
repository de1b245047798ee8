#!/bin/sh
# hashes.sh - one frame by every CPU, lanes header, compiler and level of optimisation: its hashes
#
# For each, the boards' firmware is compiled as a program of that CPU, and renders the scene and the
# frame of tests/boards/test_boards.sh. ARCHS, COMPILERS and LEVELS name fewer; ROW is one row,
# which this script does for itself. The table: build/hashes.csv. What is not tried has a row, too,
# that says why.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
folder=$BUILD/hashes
parts='render thesis'
export BUILD

setting() { # ARCH NAME: what tests/cpus/ARCH.mk says
    sed -n "s/^$2 := //p" "tests/cpus/$1.mk" | tail -n 1
}

# Why a row is not tried; nothing: it is.
reason() { # ARCH LANES COMPILER LEVEL
    case $2,$3,$4 in
    rvv,gcc,*) echo "gcc 12 has no vectors for it" ;;
    rvv,*,-O0) echo "QEMU 7.2 ends by an assertion" ;;
    *,clang-14,*) [ "$1" = x86_64 ] || echo "clang-16 is" ;;
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

for arch in ${ARCHS:-$(sh tests/cpus/archs.sh)}; do
    for lanes in $(setting "$arch" HASHED); do
        for compiler in ${COMPILERS:-gcc clang-14 clang-16}; do
            for level in ${LEVELS:--O0 -O1 -O2 -O3 -Os}; do
                echo "$arch $lanes $compiler $level"
            done
        done
    done
done >"$folder/rows"
echo "cpu,byte_order,bits,lanes,compiler,level,frame_hash" >"$BUILD/hashes.csv"
xargs -P "${JOBS:-$(getconf _NPROCESSORS_ONLN)}" -I '{}' env ROW='{}' sh tests/cpus/hashes.sh \
    <"$folder/rows" | sort >>"$BUILD/hashes.csv"
tr ',' ' ' <"$BUILD/hashes.csv"
tried=$(grep -vc ',not tried: ' "$BUILD/hashes.csv")
verdict "$((tried - 1)) rows have the frame of the host, $due" "$(
    [ "$tried" -gt 1 ] || echo "none was tried"
    sed 1d "$BUILD/hashes.csv" | grep -v ',not tried: ' | grep -v ",$due\$")"
verdict "$(wc -l <"$folder/rows") rows are in the table" "$(
    [ "$(wc -l <"$folder/rows")" -eq "$(sed 1d "$BUILD/hashes.csv" | wc -l)" ] || echo "others")"
finish

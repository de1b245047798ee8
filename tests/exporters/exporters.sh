#!/bin/sh
# exporters.sh - what real programs write, read by planelet and by a parser of our own
#
# Installs the exporters of table.txt, lets each write the seven meshes of shapes.py, and compares
# (compare.py); then lets readers count what `planelet make` writes (readers.sh). An exporter that
# cannot be had is named and left out. Exit status 1 when files are read differently, a
# writer fails, or there is no exporter at all. The meshes stay in $BUILD/exporters/files.
# `exporters.sh NAME...` takes only those. SPDX-License-Identifier: MIT
BUILD=$(realpath "${BUILD:-build}")
PLANELET=$(realpath "${PLANELET:-$BUILD/host/planelet}")
here=$(cd "$(dirname "$0")" && pwd)
work=$BUILD/exporters
export BUILD PLANELET PYTHONDONTWRITEBYTECODE=1
rm -rf "$work/files" "$work/log"
mkdir -p "$work/files" "$work/log"
broken=0

wanted() {
    [ $# -eq 1 ] && return 0
    name=$1
    shift
    case " $* " in *" $name "*) return 0 ;; esac
    return 1
}

# write NAME: its files, or what went wrong.
write() {
    out=$work/files/$1
    mkdir -p "$out"
    script=$(ls "$here/write/write_$1".*)
    timeout 300 sh "$here/run.sh" "$script" "$work/shapes" "$out" >"$work/log/$1" 2>&1 </dev/null
    status=$?
    if [ $status -ne 0 ]; then
        echo "FAIL $1: its writer ended with status $status; see $work/log/$1"
        broken=$((broken + 1))
    fi
}

python3 "$here/test_compare.py" && python3 "$here/shapes.py" "$work/shapes" || exit 1
echo "-- exporters"
sed -n 's/ *: */:/gp' "$here/table.txt" | grep -v '^#' >"$work/rows"
while IFS=: read -r name from packages _ _; do
    wanted "$name" "$@" || continue
    # shellcheck disable=SC2086
    sh "$here/install.sh" "$name" "$from" $packages </dev/null && write "$name"
done <"$work/rows"
if [ $# -eq 0 ]; then
    echo "-- readers of what planelet makes"
    sh "$here/readers.sh" "$work" || broken=$((broken + 1))
fi
echo "-- files"
python3 "$here/compare.py" "$PLANELET" "$work/files"
status=$?
[ $status -eq 0 ] && [ $broken -eq 0 ]

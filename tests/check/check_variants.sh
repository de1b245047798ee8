#!/bin/sh
# check_variants.sh - the other builds of the engine: scalar lanes, tiny limits
#
# Beside builders: its builds have folders of their own.
#
# The scalar build must give every golden frame; with every limit as small as it
# may be, every test program must still pass. SPDX-License-Identifier: MIT
. tests/check/report.sh
log=$BUILD/check
mkdir -p "$log"

# programs_pass SENTENCE LOG COMMAND...: its sum counts no failure.
programs_pass() {
    sentence=$1 file=$log/$2
    shift 2
    "$@" >"$file" 2>&1
    verdict "$sentence ($(tail -n 1 "$file"))" "$(
        tail -n 1 "$file" | grep -q '^[1-9][0-9]* passed, 0 failed$' ||
            grep -E '^FAIL|error|[1-9][0-9]* failed' "$file" | head -n 12)"
}

tests=$BUILD/host-scalar/tests/engine
programs_pass "scalar lanes give the same frames and hits" scalar.txt sh -c "
    $MAKE -s LANES=scalar $tests/test_render $tests/test_trace_brute &&
    sh tests/run.sh $tests/test_render $tests/test_trace_brute"
jobs=$(getconf _NPROCESSORS_ONLN)
programs_pass "every program passes with tiny limits" tiny.txt $MAKE -s -j "$jobs" tiny
# They run beside those of the usual build: tests/run.sh.
out=${OUT:-$BUILD/host}
verdict "test programs write to the folder of their build" "$(
    grep -rn '"build/test-tmp' tests --include='*.[ch]' | grep -v '^tests/test.h:'
    strings -a "$out/tests/host_tools/test_mesh_ply" | grep -q "^$out/test-tmp/mesh/" ||
        echo "test_mesh_ply writes elsewhere")"
finish

#!/bin/sh
# test_cpus.sh - other CPUs render the host's frame, and a build with wider floats is refused
#
# And Altivec keeps subnormals, as platform/altivec.c says.
# Those with IN_CI in tests/cpus: of 32 and 64 bits, of both byte orders, with vectors and without.
# `make cpus` and `make hashes` have the others, other compilers, and the tests of the engine.
# Beside builders: it writes build/hashes and build/subnormals alone, and builds no board.
# SPDX-License-Identifier: MIT
. tests/check/report.sh

archs=$(sh tests/cpus/archs.sh ci)
for arch in $archs; do
    needs "$(sed -n 's/^TRIPLE := //p' "tests/cpus/$arch.mk")-gcc" \
        "$(sed -n 's/^EMULATOR := \([^ ]*\).*/\1/p' "tests/cpus/$arch.mk")"
done

refused() { # COMPILER FLAG...: what it says to lanes.h
    echo '#include "engine/lanes/lanes.h"' |
        "$@" -std=c11 -I. -x c -fsyntax-only - 2>&1 | sed -n 's/.*#error //p'
}
said=$(refused i686-linux-gnu-gcc -mfpmath=387)
verdict "floats in an x87 are refused, and the flags that help are named" "$(
    case $said in *-mfpmath=sse*) ;; *) echo "${said:-it compiles}" ;; esac)"
verdict "with them it compiles" "$(refused i686-linux-gnu-gcc -msse2 -mfpmath=sse)"
said=$(refused s390x-linux-gnu-gcc)
verdict "floats as doubles are refused, and the flag that helps is named" "$(
    case $said in *-fexcess-precision=fast*) ;; *) echo "${said:-it compiles}" ;; esac)"
verdict "which the build gives" "$(
    $MAKE -s --no-print-directory ARCH=s390x engine-command |
        grep -q -e -fexcess-precision=fast || echo "it does not")"

# The hashes below are of some files; vectors of GNU C are those of three CPUs.
compiles() { # ARCH
    command=$($MAKE -s --no-print-directory ARCH="$1" engine-command | tail -n 1)
    find engine -name '*.c' | sort |
        xargs -P "$(getconf _NPROCESSORS_ONLN)" -n 16 sh -c \
            "$(echo "$command" | tr '\n' ' ') -w -fsyntax-only \"\$@\"" sh 2>&1
}
for arch in s390x aarch64; do
    verdict "the whole engine compiles for $arch" "$(compiles $arch)"
done

# Of 64 sums by a plain loop, in main and in a thread.
flushed() { # [SOURCE]
    command=$($MAKE -s --no-print-directory ARCH=powerpc LANES=scalar OPTIMISE=-O2 engine-command)
    eval "$(echo "$command" | tail -n 1) -o $BUILD/subnormals tests/cpus/subnormals.c $1" \
        2>"$BUILD/subnormals.log" || head -n 3 "$BUILD/subnormals.log"
    $(echo "$command" | head -n 1) "$BUILD/subnormals"
    rm -f "$BUILD/subnormals" "$BUILD/subnormals.log"
}
said=$(flushed)
verdict "Altivec flushes subnormals as a program starts, in plain loops, too: $said of 64" "$(
    [ "$said" = "64 64" ] || echo "it does not, and platform/altivec.c is for nothing")"
said=$(flushed platform/altivec.c)
verdict "with platform/altivec.c it does not, nor in a thread: $said" "$(
    [ "$said" = "0 0" ] || echo "it does")"

text=$(ON=none ARCHS=$archs COMPILERS=gcc LEVELS=-O2 sh tests/cpus/hashes.sh)
echo "$text" | sed '$d'
counts=$(echo "$text" | tail -n 1)
passed=$((passed + ${counts%% *}))
counts=${counts#*, }
failed=$((failed + ${counts%% *}))
finish

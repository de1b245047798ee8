#!/bin/sh
# check_warnings.sh - compilers had nothing to say (the Makefile keeps what they say)
# SPDX-License-Identifier: MIT
. tests/check/report.sh

# said FOLDER: what was said of sources that are still there.
said() {
    find "$1" -name '*.log' -size +0 2>/dev/null | while read -r log; do
        source=${log#"$1"/}
        [ -e "${source%.log}.c" ] && cat "$log"
    done
}

verdict "gcc compiles host program and tests without a warning" "$(said "$BUILD/host")"
if make_board mps2_an386; then
    verdict "gcc compiles the firmware of mps2_an386 without a warning" \
        "$(said "$BUILD/mps2_an386")"
fi
if needs cppcheck; then
    # comparePointers: symbols of a linker script are no objects of C.
    # shiftTooManyBits: cppcheck overlooks the b-- between 32 and the shift.
    # ctuuninitvar: it takes the address of a member array for a read of it.
    verdict "cppcheck finds nothing in engine, platform and board" "$(
        cppcheck --quiet --std=c11 --enable=warning,portability --inline-suppr -I. \
            --suppress=missingInclude --suppress=comparePointers --suppress=ctuuninitvar \
            --suppress=shiftTooManyBits:engine/tree/thesis/treelets.c \
            -DPLT_BOARD_ARENA_BYTES=65536u -DPLT_CLOCK_HERTZ=1000000u \
            -DPLT_FPGAIO=0x40028000u engine platform board 2>&1)"
fi
finish

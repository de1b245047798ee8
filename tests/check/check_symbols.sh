#!/bin/sh
# check_symbols.sh - what engine objects refer to, and that they hold no data
#
# A list of what is allowed is stronger than one of what is not: there is no
# malloc, printf, abort, libm or double-precision helper in it.
# SPDX-License-Identifier: MIT
. tests/check/report.sh

# The four functions a compiler may call on its own; integer helpers of GCC;
# stack protector and position-independent code where the system wants them.
allowed='plt_[a-z0-9_]*|memcpy|memmove|memset|memcmp'
allowed="$allowed|__(ctz|clz|popcount)[sd]i2|__aeabi_u?ldivmod|__aeabi_(u?l)?(lsl|lsr|asr|mul)"
allowed="$allowed|__stack_chk_fail(_local)?|_GLOBAL_OFFSET_TABLE_"

# symbols_of NAME FOLDER NM
symbols_of() {
    objects=$(objects_of "$2" o engine)
    if [ -z "$objects" ]; then
        verdict "$1: there are engine objects" "none in $2/engine"
        return
    fi
    # shellcheck disable=SC2086
    list=$("$3" -A $objects)
    verdict "$1: engine objects refer to nothing but themselves and memcpy's family" "$(
        printf '%s\n' "$list" | awk -v allowed="^($allowed)\$" '
            $(NF - 1) == "U" && $NF !~ allowed { print $1 " refers to " $NF }')"
    verdict "$1: the engine has no writable data" "$(
        printf '%s\n' "$list" | awk '$(NF - 1) ~ /^[bBdDCsSgG]$/ { print $1 " holds " $NF }')"
    verdict "$1: every global name of the engine begins with plt_" "$(
        printf '%s\n' "$list" | awk '$(NF - 1) ~ /^[TRDBC]$/ && $NF !~ /^plt_/ {
            print $1 " exports " $NF }')"
}

symbols_of host "$BUILD/host" nm
if make_board mps2_an386; then
    symbols_of mps2_an386 "$BUILD/mps2_an386" arm-none-eabi-nm
    verdict "mps2_an386: the firmware links no library" "$(
        awk '/^(LOAD|Archive member)/ && /\.a$/ { print }' "$BUILD/mps2_an386/firmware.map")"
    verdict "mps2_an386: no double-precision helper is in the firmware" "$(
        arm-none-eabi-nm "$BUILD/mps2_an386/firmware.elf" | grep -E ' __aeabi_(d|f2d|cd)')"
fi
finish

#!/bin/sh
# check_const.sh - no cast in the engine drops a const
#
# Beside builders: it builds nothing.
#
# A scene is read by several workers at once, and an image may lie in flash: what is
# const stays const. A compiler reports a missing const without being asked, but not
# that a cast took it away. SPDX-License-Identifier: MIT
. tests/check/report.sh
planted=$(mktemp -d)
trap 'rm -rf "$planted"' EXIT

# casts LANES SOURCE...: what the compiler says of these sources with these lanes.
casts() {
    lanes=$1
    shift
    for source in "$@"; do
        "$CC" -std=c11 -ffreestanding -fsyntax-only -I. -Wcast-qual -Werror \
            ${lanes:+-DPLT_LANES="\"platform/$lanes\""} "$source" 2>&1 ||
            echo "$source does not compile"
    done
}

printf '%s\n' '#include "engine/scene/scene.h"' '#include "engine/lanes/lanes.h"' \
    'plt_info *plt_drops(const plt_scene *s);' \
    'plt_info *plt_drops(const plt_scene *s) { return (plt_info *)&s->info; }' \
    >"$planted/drops.c"
printf '%s\n' '#include "engine/scene/scene.h"' '#include "engine/lanes/lanes.h"' \
    'const plt_info *plt_keeps(const plt_scene *s);' \
    'const plt_info *plt_keeps(const plt_scene *s) { return (const plt_info *)&s->info; }' \
    >"$planted/keeps.c"

engine=$(find engine -name '*.c' | sort)
# Headers once each; those that want flags are sources of the same.
all_lanes=$(sh platform/lanes.sh offered "$CC" | awk '$3 == "" { print $1 }')
for kind in $all_lanes; do
    lanes=lanes_$kind.h
    [ "$kind" != scalar ] || lanes=
    # shellcheck disable=SC2086
    verdict "no cast in $(echo "$engine" | grep -c .) sources drops a const (lanes: $kind)" \
        "$(casts "$lanes" $engine
        [ -n "$engine" ] || echo "there are no sources to look at")"
    verdict "a cast that drops one is seen, one that keeps it is not (lanes: $kind)" "$(
        casts "$lanes" "$planted/drops.c" | grep -q 'drops\.c:4:.*cast-qual' ||
            echo "the cast of drops.c is not seen"
        casts "$lanes" "$planted/keeps.c")"
done
finish

#!/bin/sh
# check_branches.sh - steps of the wave have no jump that depends on a ray
#
# The compiler may turn arithmetic into jumps. One in a step costs more than all that the
# wave gains, and no test sees it: so the jumps are counted, in the machine code of the loops
# over nodes to visit, and over blocks whose edges are tested.
# SPDX-License-Identifier: MIT
. tests/check/report.sh

# inside OBJECT FUNCTION: "LOOPS loops, JUMPS jumps inside": a loop is what lies between the
# target of a jump back and that jump; calls count as jumps. Nothing if there is none. A
# compiler may add to the name of a function whose arguments it changed (visit_all.isra.0).
inside() {
    objdump -d --no-show-raw-insn "$1" | awk -v name="<$2" '
        NF == 2 && $2 ~ /^</ { here = $2 == name ">:" || index($2, name ".") == 1; next }
        here {
            sub(/:$/, "", $1)
            line[$1] = ++n
            jumps[n] = jumps[n - 1]
            if ($2 ~ /^j/ && $3 in line) {
                loops++
                within += jumps[n - 1] - jumps[line[$3] - 1]
            }
            jumps[n] += $2 ~ /^(j|call|loop)/
        }
        END { if (loops) { print loops, "loops,", within + 0, "jumps inside" } }'
}

case $("$CC" -dumpmachine) in
x86_64-* | amd64-* | i?86-*) x86=1 ;;
*) x86= ;;
esac
if [ -n "$x86" ] && needs objdump; then
    for tree in bvh4 thesis compact; do
        count=$(inside "$BUILD/host/engine/trace/wave_$tree.o" visit_all)
        verdict "a visit of a node of the wave over $tree has no branch" "$(
            case $count in
            *' loops, 0 jumps inside') ;;
            *) echo "visit_all has '$count'" ;;
            esac)"
    done

    count=$(inside "$BUILD/host/engine/trace/wave_bvh4.o" visit_all_any)
    verdict "nor has a visit for any hit" "$(
        case $count in
        *' loops, 0 jumps inside') ;;
        *) echo "visit_all_any has '$count'" ;;
        esac)"

    count=$(inside "$BUILD/host/engine/trace/wave_bvh4.o" test_edges)
    verdict "a test of a leaf block's edges has no branch either" "$(
        case $count in
        *' loops, 0 jumps inside') ;;
        *) echo "test_edges has '$count'" ;;
        esac)"

    # The count must see what it is for.
    planted=$(mktemp -d)
    trap 'rm -rf "$planted"' EXIT
    cat >"$planted/bad.c" <<'C'
void used(int *p);
void visit_all(int *p, int n);
void visit_all(int *p, int n) {
    for (int i = 0; i < n; i++) {
        if (p[i] & 1) {
            used(p + i);
        }
    }
}
C
    "$CC" -O2 -c -o "$planted/bad.o" "$planted/bad.c"
    count=$(inside "$planted/bad.o" visit_all)
    verdict "a branch and a call in such a loop are counted" "$(
        case $count in
        *' loops, 0 '* | '') echo "only '$count'" ;;
        esac)"
    verdict "a function without a loop is not taken for one without branches" "$(
        [ -z "$(inside "$planted/bad.o" visit_none)" ] || echo "it is")"
fi
finish

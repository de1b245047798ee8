# streamed_scene.sh - what the measurements of streamed scenes share
#
# Sourced; $planelet, $scenes and $work are set. SPDX-License-Identifier: MIT

# pack MESH NODES: as $work/scene.plt, compact blocks or thesis nodes in treelets of so many.
pack() {
    case $2 in
    compact) set -- "$1" --nodes compact --geometry lattice:14 --leaf 2 ;;
    *) set -- "$1" --treelet "$2" ;;
    esac
    mesh=$1
    shift
    "$planelet" pack "$scenes/$mesh.ply" -o "$work/scene.plt" "$@" 2>"$work/said" || {
        cat "$work/said" >&2
        return 1
    }
}

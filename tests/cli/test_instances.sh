#!/bin/sh
# test_instances.sh - pack --instances, and what shows it: bodies that matrices place
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin instances
view='--size 61x47 --eye 9,17,30 --look 0,-1.5,0.5 --fov 33'

works "marbles as instances" make marbles --instances --frames 6 --frame 3 --triangles 1600 \
    -o marbles.txt
verdict "... are a text and two meshes" "$(
    ls marbles.txt marbles_tray.ply marbles_ball.ply 2>&1 >/dev/null)"
works "they are packed" pack --instances marbles.txt -o marbles.plt
works "... told" info marbles.plt --json
verdict "... with their counts" "$(
    for due in bodies=2 instances=20 placed_triangles=1600 triangles=160 frames=6 \
        frame_bytes=5784 frame_rate=25; do
        [ "$(number "${due%=*}" <out)" = "${due#*=}" ] || echo "$due: $(number "${due%=*}" <out)"
    done)"
works "... and for people" info marbles.plt
verdict "... likewise" "$(grep -q '^instances  *20, of 1600 triangles in all$' out || cat out)"

# ---- the same pictures, whatever renders them, as meshes that are packed frame by frame -------

works "a film" render marbles.plt -o all.y4m --frames 0:6 $view
# shellcheck disable=SC2086
for kind in '--source read' '--workers 3' '--walk two-stage' '--packet 2' '--arena 60000'; do
    works "... $kind" render marbles.plt -o other.y4m --frames 0:6 $view $kind
    same all.y4m other.y4m "... is the same"
done
works "marbles as meshes" make marbles --frames 6 --frame 3 --triangles 1600 -o 'm_{}.ply'
works "... as a sequence" pack --sequence m_00?.ply --geometry float -o moved.plt
works "... shown" render moved.plt -o moved.y4m --frames 0:6 $view
verdict "... are the same picture but for rounding" "$(
    differing=$(cmp -l all.y4m moved.y4m | awk '
        function of(octal) { return int(octal / 100) * 64 + int(octal / 10) % 10 * 8 + octal % 10 }
        { d = of($2) - of($3); if (d > 1 || d < -1) n++ } END { print n + 0 }')
    [ "$differing" -le 40 ] || echo "$differing bytes differ by more than 1")"
works "without --frames" render marbles.plt -o first.ppm $view
works "... it is the first" render marbles.plt -o 'f_{}.ppm' --frames 0:1 $view
same first.ppm f_000.ppm "... it is frame 0"

# ---- hits name instance by instance ------------------------------------------------------------

cat >two.txt <<'END'
body ground ground.ply
instance low ground      # stays where its mesh is
instance high ground
frame 0 high  1 0 0 0  0 1 0 10  0 0 1 0
END
works "a slab" make ground -o ground.ply
works "... twice" pack --instances two.txt -o two.plt
printf '%s\n' '0 50 0 0 0 -1 0 1e30' '15 50 0 0 0 -1 0 1e30' '0 5 0 0 0 -1 0 1e30' | rays from.rays
works "rays from above" trace two.plt from.rays to.hits
verdict "... hit the higher one first, with ids behind those of the lower" "$(
    # shellcheck disable=SC2046
    set -- $(hits to.hits | awk '{ print $1, $4 }')
    { [ "$1" = 40 ] && [ "$2" -ge 12 ] && [ "$2" -lt 24 ] && [ "$4" = 4294967295 ] &&
        [ "$5" = 5 ] && [ "$6" -lt 12 ]; } || echo "$*")"
finish

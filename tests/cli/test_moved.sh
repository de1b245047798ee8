#!/bin/sh
# test_moved.sh - render --moved: a sequence of meshes as a film, by one tree that is refitted
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/wave.sh
begin moved

waves 6
echo 'wave_{}.ply*6 1 0 0 0' >wave.txt
view='--size 61x47 --eye 1,1.5,3 --look 0.2,0,0.2'
run pack wave.txt -o wave.plt # says what is open
film() { # FILE: of pictures of the frames, each packed anew
    : >frames
    for frame in 1 2 3 4 5; do
        "$PLANELET" pack wave.txt --frame $frame -o fresh.plt 2>/dev/null
        # shellcheck disable=SC2086
        "$PLANELET" render fresh.plt -o fresh.y4m $view "$@" 2>/dev/null
        tail -n +2 fresh.y4m >>frames
    done
}
for kind in '' '--packet 2' '--walk two-stage' '--shader triangle' '--source read' '--workers 3' \
    '--structure grid'; do
    # shellcheck disable=SC2086
    works "frames 1 to 5 of a sequence $kind" render wave.plt -o moved.y4m $view --moved wave.txt \
        --frames 1:6 $kind --json moved.json
    # shellcheck disable=SC2086
    film $kind
    tail -n +2 moved.y4m >moved.frames
    same frames moved.frames "... are those of scenes that are packed anew"
    verdict "... what moving took is told apart" "$(
        flat_json moved.json frames seconds move_seconds mesh_seconds
        [ "$(number frames <moved.json)" -eq 5 ] || echo "not five frames"
        for part in move_ rebuild_ ''; do
            sed -n "s/^  \"frame_${part}seconds\": \[\(.*\)\],$/\1/p" moved.json |
                awk -F ', ' -v sum="$(number ${part}seconds <moved.json)" '
                    NF != 5 { print "not five frames: " $0 }
                    { off = $1 + $2 + $3 + $4 + $5 - sum }
                    off > 5e-8 || off < -5e-8 { print $0 " is not " sum }
                    END { if (NR != 1) print "no such list" }'
        done)"
done
# shellcheck disable=SC2086
works "one frame is a picture" render wave.plt -o moved.ppm $view --moved wave.txt --frames 3:4
"$PLANELET" pack wave.txt --frame 3 -o fresh.plt 2>/dev/null
# shellcheck disable=SC2086
run render fresh.plt -o fresh.ppm $view
same fresh.ppm moved.ppm "... that of the scene packed anew"
# shellcheck disable=SC2086
works "without --frames the first frame moves to itself" render wave.plt -o moved.ppm $view \
    --moved wave.txt
# shellcheck disable=SC2086
run render wave.plt -o fresh.ppm $view
same fresh.ppm moved.ppm "... and is the scene's picture"
# shellcheck disable=SC2086
works "frames by the files' names" render wave.plt -o moved.y4m $view --moved 'wave_{}.ply' \
    --frames 2:4
for frame in 2 3; do
    run pack wave_00$frame.ply -o fresh.plt
    # shellcheck disable=SC2086
    run render fresh.plt -o fresh.y4m $view
    tail -n +2 fresh.y4m
done >fresh.frames
tail -n +2 moved.y4m >moved.frames
same fresh.frames moved.frames "... are those of the files"
# shellcheck disable=SC2086
works "all of it twice" render wave.plt -o moved.y4m $view --moved wave.txt --frames 1:6 --repeat 2
tail -n +2 moved.y4m >moved.frames
film
same frames moved.frames "... is the same film"
"$PLANELET" pack wave_000.ply --build device -o device.plt 2>/dev/null
# shellcheck disable=SC2086
works "a tree that the engine builds is refitted, too" render device.plt -o device.ppm $view \
    --moved wave_002.ply
"$PLANELET" pack wave_002.ply -o fresh.plt 2>/dev/null
# shellcheck disable=SC2086
run render fresh.plt -o fresh.ppm $view
same fresh.ppm device.ppm "... and gives the picture of the scene packed anew"

# ---- trees that are built anew ----

film
for rebuild in never always threshold:1 threshold:1000 cost 'always --rebuild-step 100' \
    'always --workers 3' 'always --walk two-stage' 'always --source read' \
    'always --rebuild-most 40' 'cost --rebuild-most 32 --workers 2' \
    'always --rebuild-most 64 --rebuild-step 50' 'always --rebuild-most 1000'; do
    # shellcheck disable=SC2086
    works "--rebuild $rebuild" render wave.plt -o moved.y4m $view --moved wave.txt --frames 1:6 \
        --rebuild $rebuild --json moved.json
    tail -n +2 moved.y4m >moved.frames
    same frames moved.frames "... is the same film"
    number rebuilds <moved.json >"rebuilds_${rebuild%% *}${rebuild#* }"
done
verdict "rebuilds are counted: none, one per frame, fewer in steps, some" "$(
    [ "$(cat rebuilds_nevernever)" -eq 0 ] || echo "never: $(cat rebuilds_nevernever)"
    [ "$(cat rebuilds_alwaysalways)" -eq 5 ] || echo "always: $(cat rebuilds_alwaysalways)"
    [ "$(cat rebuilds_threshold:1000threshold:1000)" -eq 0 ] || echo "beyond 1000 %"
    [ "$(cat rebuilds_always--rebuild-step\ 100)" -lt 5 ] || echo "in steps")"
# shellcheck disable=SC2086
works "degradation and work are told" render wave.plt -o moved.y4m $view --moved wave.txt \
    --frames 1:6 --rebuild cost --json moved.json
flat_json moved.json rebuilds rebuilds_given_up rebuild_seconds degradation \
    degradation_most growth excess_work build_work subtrees rebuilt_triangles
# shellcheck disable=SC2086
works "... of subtrees, too" render wave.plt -o moved.y4m $view --moved wave.txt --frames 1:6 \
    --rebuild always --rebuild-most 32 --json parts.json
verdict "... which are some, of at most so many triangles each" "$(
    [ "$(number subtrees <parts.json)" -ge 3 ] || echo "$(number subtrees <parts.json) subtrees"
    [ "$(number rebuilt_triangles <parts.json)" -le $((5 * 32)) ] || echo "more triangles"
    [ "$(number rebuilds <parts.json)" -eq 5 ] || echo "not one per frame")"
verdict "... and take less of an arena than a second tree" "$(
    [ "$(number arena_peak_bytes <parts.json)" -lt "$(number arena_peak_bytes <moved.json)" ] ||
        echo "$(number arena_peak_bytes <parts.json), $(number arena_peak_bytes <moved.json)")"
verdict "... what a tree costs is its triangles'" "$(
    [ "$(number build_work <moved.json)" -eq $((128 * 24)) ] || echo "not 24 each")"

# ---- what goes wrong --------------------------------------------------------------------

none_left() {
    verdict "... and leaves no file" "$(ls x.y4m x.json 2>/dev/null; left_behind)"
}
mv wave_003.ply hidden.ply
refused "a file that is missing" "frame 3" "wave_003.ply" \
    render wave.plt -o x.y4m --moved 'wave_{}.ply' --frames 1:6 --size 8x8
none_left
refused "a frame that is missing" "frame 3" "wave_003.ply" \
    render wave.plt -o x.y4m --moved wave.txt --frames 1:6 --size 8x8
none_left
timeout 60 "$PLANELET" render wave.plt -o x.y4m --moved wave.txt --frames 1:6 --size 8x8 \
    --rebuild always >out 2>err
status=$?
verdict "... between rebuilds" "$(refusal "frame 3" "wave_003.ply")"
none_left
wave 3 8 >wave_003.ply
refused "a frame of other triangles" wave.txt "frame 3: has 98 triangles, the scene 128" \
    render wave.plt -o x.y4m --moved wave.txt --frames 1:6 --size 8x8 --json x.json
none_left
sed '12s/^[^ ]*/nan/' hidden.ply >wave_003.ply
refused "a frame with a corner that is no number" "frame 3" "line 12" \
    render wave.plt -o x.y4m --moved wave.txt --frames 1:6 --size 8x8
none_left
mv hidden.ply wave_003.ply
"$PLANELET" pack wave.txt --nodes compact -o compact.plt 2>/dev/null
refused "compact blocks" compact.plt "cannot be moved; pack it with --nodes thesis" \
    render compact.plt -o x.y4m --moved wave.txt --frames 0:2 --size 8x8
none_left
for frames in 1 5:5 6:5 0:100001 -1:3 1:2:3 a:b ''; do
    misused "--frames '$frames' is wrong usage" "--frames takes A:B" \
        render wave.plt -o x.y4m --moved wave.txt --frames "$frames" --size 8x8
done
for rebuild in sometimes threshold threshold: threshold:0 threshold:1001 threshold:3x \
    threshold:-3 cost:3 ''; do
    misused "--rebuild '$rebuild' is wrong usage" "--rebuild takes never, always, threshold:" \
        render wave.plt -o x.y4m --moved wave.txt --frames 0:2 --rebuild "$rebuild" --size 8x8
done
misused "--rebuild without --moved" "--rebuild is for --moved" \
    render wave.plt -o x.ppm --rebuild cost --size 8x8
misused "--rebuild-step without --rebuild" "--rebuild-step is for --rebuild" \
    render wave.plt -o x.y4m --moved wave.txt --frames 0:2 --rebuild-step 5 --size 8x8
refused "an arena without room for a second tree" wave.plt "bytes" \
    render wave.plt -o x.y4m --moved wave.txt --frames 0:2 --rebuild cost --size 8x8 --arena 20000
none_left
refused "--frames without --moved, of an image without frames" wave.plt "has no frames" \
    render wave.plt -o x.y4m --frames 0:2 --size 8x8
misused "two films at once" "--moved and --orbit" \
    render wave.plt -o x.y4m --moved wave.txt --orbit 3 --size 8x8
misused "a film in a picture" "--frames makes a film: give -o a name that ends in .y4m" \
    render wave.plt -o x.png --moved wave.txt --frames 0:2 --size 8x8
misused "a streamed scene" "--moved is for --residency resident" \
    render wave.plt -o x.ppm --moved wave.txt --residency streamed --size 8x8
finish

#!/bin/sh
# test_trace_frames.sh - planelet trace of scenes in motion: each frame's hits are a fresh pack's
#
# Frames of the image and of meshes, refitted, rebuilt and by a grid; what `make moving` does
# with larger sequences and a judge. SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/wave.sh
begin trace_frames

waves 6
run make marbles --triangles 1600 --frames 6 -o 'roll_{}.ply'

# Down onto the sheet and the tray, and from below at random.
for rays in wave:1.1:0 roll:16:-8; do
    name=${rays%%:*} size=${rays#*:}
    awk -v size="${size%:*}" -v from="${rays##*:}" 'BEGIN {
        srand(5)
        for (i = 0; i < 1200; i++)
            if (i < 900)
                print from + i % 30 / 30 * size, 20, from + int(i / 30) / 30 * size, 0, 0, -1, 0, 99
            else
                print rand() * size + from, 0.1, rand() * size + from, 0, rand() - 0.5, \
                    rand() - 0.5, rand() - 0.5, 99
    }' | rays "$name.rays"
done

# fresh NAME [--any]: NAME_due_K are the hits of frame K packed alone.
fresh() {
    for frame in 0 1 2 3 4 5; do
        "$PLANELET" pack "$1_00$frame.ply" -o fresh.plt 2>/dev/null
        # shellcheck disable=SC2086
        "$PLANELET" trace fresh.plt "$1.rays" "$1_due_$frame" $2 2>&1
    done
}

# unlike NAME FIRST END: trouble, unless found_00K are NAME_due_K, and there are no others.
unlike() {
    for frame in 0 1 2 3 4 5; do
        if [ "$frame" -ge "$2" ] && [ "$frame" -lt "$3" ]; then
            cmp "found_00$frame" "$1_due_$frame" 2>&1
        elif [ -e "found_00$frame" ]; then
            echo "found_00$frame is there"
        fi
    done
    rm -f found_00?
}

for name in wave roll; do
    verdict "$name: frames packed alone" "$(fresh $name)"
    verdict "... some rays hit, some do not, and frames differ" "$(
        hits ${name}_due_1 | awk '$4 == 4294967295 { misses++ }
            END { if (misses < 50 || misses > NR - 50) print misses " misses of " NR }'
        differ ${name}_due_1 ${name}_due_2)"
    run pack --sequence "${name}_{}.ply" --frames 0:6 --geometry float --key 4 -o $name.plt
    run pack ${name}_000.ply -o first.plt
    for flags in '' '--rebuild always' '--rebuild cost' '--rebuild always --rebuild-step 100' \
        '--structure grid' '--walk two-stage' '--rays coherent --packet 2' '--source read' \
        '--rays incoherent' '--order sorted' '--workers 3' '--repeat 2'; do
        # shellcheck disable=SC2086
        works "$name, the image's frames $flags" \
            trace $name.plt $name.rays 'found_{}' --frames 0:6 $flags
        verdict "... hits are a fresh pack's, bit for bit" "$(unlike $name 0 6)"
        # shellcheck disable=SC2086
        works "$name, frames of meshes $flags" \
            trace first.plt $name.rays 'found_{}' --moved "${name}_{}.ply" --frames 0:6 $flags
        verdict "... hits are a fresh pack's, bit for bit" "$(unlike $name 0 6)"
    done
    verdict "$name: any hits of frames packed alone" "$(fresh $name --any)"
    works "... of the image's frames" trace $name.plt $name.rays 'found_{}' --frames 2:5 --any
    verdict "... are the same" "$(unlike $name 2 5)"
done

# ---- one frame, and rays of each -----------------------------------------------------

fresh wave
works "one frame may have any name" trace wave.plt wave.rays hit --frames 4:5
same wave_due_4 hit "... and is frame 4"
works "a mesh without --frames" trace wave.plt wave.rays hit --moved wave_003.ply
same wave_due_3 hit "... is where its triangles are"
"$PLANELET" trace wave.plt - - --frames 4:5 <wave.rays >piped 2>err
same wave_due_4 piped "... from standard input to standard output, too"
for frame in 2 3; do
    head -c $((frame * 3200)) wave.rays >own_00$frame
    head -c $((frame * 1600)) wave_due_$frame >own_due_$frame
done
works "a file of rays per frame" trace wave.plt 'own_{}' 'found_{}' --frames 2:4 --json json \
    --order sorted
verdict "... has hits of its own" "$(
    cmp found_002 own_due_2 2>&1
    cmp found_003 own_due_3 2>&1
    rm found_00?)"
verdict "... which are counted together, and timed one by one" "$(
    flat_json json frames rays seconds move_seconds rebuild_seconds
    equal <<END
rays|$(number rays <json)|500
frames|$(number frames <json)|2
END
    for part in move:move rebuild:rebuild '':''; do
        name=${part#*:}
        sed -n "s/^  \"frame_${name:+${name}_}seconds\": \[\(.*\)\],$/\1/p" json |
            awk -F ', ' -v sum="$(number "${name:+${name}_}seconds" <json)" '
                NF != 2 { print "not two frames: " $0 }
                { off = $1 + $2 - sum; if (off > 2e-8 || off < -2e-8) print $0 " is not " sum }
                END { if (NR != 1) print "no such list" }'
    done)"

# ---- what is refused --------------------------------------------------------------------

misused "frames that would be one file" "several frames need a '{}' in HITS, as in hits_{}" \
    trace wave.plt wave.rays hit --frames 0:2
misused "... or standard output" "'{}' in HITS" trace wave.plt wave.rays - --frames 0:2
misused "--frames of no range" "--frames takes A:B" trace wave.plt wave.rays 'x_{}' --frames 3
misused "--rebuild of what does not move" "--rebuild is for --moved" \
    trace wave.plt wave.rays x --rebuild cost
refused "frames that are not there" wave.plt "use --frames 0:6 or less" \
    trace wave.plt wave.rays 'x_{}' --frames 4:7
refused "an image without frames" first.plt "has no frames" \
    trace first.plt wave.rays 'x_{}' --frames 0:2
refused "rays of a frame that are not there" own_004 "No such file" \
    trace wave.plt 'own_{}' 'x_{}' --frames 4:6
refused "a mesh of another number" roll_000.ply "pack the scene from frame 0 of the same mesh" \
    trace wave.plt wave.rays 'x_{}' --moved roll_000.ply
refused "hits that cannot be written" "missing/found_001" "create" \
    trace wave.plt wave.rays 'missing/found_{}' --frames 1:3
refused "a streamed scene" wave.plt "stills of compact blocks move alone; pack frames with" \
    trace wave.plt wave.rays 'x_{}' --frames 0:2 --residency streamed
verdict "nothing is left of what failed" "$(ls x x_* 2>/dev/null; left_behind)"
finish

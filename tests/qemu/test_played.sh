#!/bin/sh
# test_played.sh - a Cortex-M4F plays rolling marbles in 256 KiB, in QEMU
#
# 29 of them, 2,400 triangles, by a refitted tree, by trees that are built anew, and by a grid:
# every frame is the host's, the arena stays what it was when the scene was opened, and calls end
# where their bounds say. Then all 109, 8,800 triangles, whose records would not fit. A few frames
# of the 500 that `make BOARD=mps2_an386 play` is for.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
planelet=$BUILD/host/planelet
out=$BUILD/mps2_an386-played
mkdir -p "$out"
needs arm-none-eabi-gcc qemu-system-arm || { finish; exit; }

# sequence TRIANGLES FRAMES: in $out/marbles_TRIANGLES.plt.
sequence() {
    "$planelet" make marbles --triangles "$1" --frames "$2" -o "$out/{}.ply" >/dev/null 2>&1
    trouble=$("$planelet" pack --sequence "$out/{}.ply" --frames 0:"$2" --leaf 4 --key 8 \
        -o "$out/marbles_$1.plt" 2>&1 >/dev/null) || verdict "marbles are packed" "$trouble"
    rm -f "$out"/[0-9]*.ply
}

# play TRIANGLES VARIABLE=...: sets text and status.
play() {
    scene=$out/marbles_$1.plt
    shift
    text=$($MAKE -s BOARD=mps2_an386 play SCENE="$scene" "$@" 2>&1)
    status=$?
}

# most TEXT: the longest call of it.
most() {
    echo "$text" | awk -v name="$1" '/^the longest call/ { of = 1 }
        of && index($0, name) == 1 { print $(NF > 1 && name ~ /,/ ? 3 : 2); exit }'
}

# median TEXT: of the row that begins so.
median() {
    echo "$text" | awk -v name="$1" 'index($0, name) == 1 { print $(NF - 1); exit }'
}

# plays SENTENCE FRAMES: what holds for every run.
plays() {
    verdict "$1: $2 frames are the host's, bit for bit" "$(
        [ "$status" -eq 0 ] && echo "$text" | grep -q "^$2 of $2 frames are the host's" ||
            echo "status $status: $text")"
    verdict "... the arena is the same after each of them, and its spare bytes untouched" "$(
        echo "$text" | awk -v n="$2" '
            /^arena: / {
                same = index($0, "the same after " n " of " n " frames") > 0
                touched = $0; sub(/.*touched up to /, "", touched); sub(/;.*/, "", touched)
                most = $0; sub(/.*at most /, "", most); sub(/ ever.*/, "", most)
                good = same && touched + 0 > 0 && touched + 0 <= most + 0 && most + 0 <= 262144
            }
            END { if (!good) { print "not so:" } }'
        echo "$text" | grep -q '^arena: ' || echo "no line: $text")"
    verdict "... the stack stays below its bound" "$(
        echo "$text" | awk '/^stack painted=.* worst=/ {
            split($2, p, "="); split($3, s, "="); split($4, w, "=")
            good = p[2] > 0 && p[2] <= w[2] && s[2] > 0 && s[2] <= w[2] }
            END { if (!good) { print "it does not" } }')"
    echo "$text" | sed -n 's/^[a-z].* [0-9][0-9]*  *[0-9][0-9]*  *[0-9][0-9]*$/    &/p'
}

sequence 2400 40
play 2400 FRAMES=0:20 MOST=2500000
plays "29 marbles, a tree that is refitted" 20
tree=$BUILD/mps2_an386-played-frames-motion-render-sequence-thesis-vertices
verdict "... a frame takes what its calls do" "$(
    awk 'NR > 1 { rows++; if ($2 < 1 || $3 < 1 || $4 < 1 || $5 || $6 || $7 < 1) print "row " $0 }
        END { if (rows != 20) print rows + 0 " rows" }' "$tree/frames.txt"
    awk '$1 == "chapter" && ++n > 1 {
            for (i = 2; i <= NF; i++) { split($i, item, "="); v[item[1]] = item[2] }
            part = v["records"] + v["refit"]
            if (part > v["show"] || part < 0.99 * v["show"]) print "of " v["show"] " parts " part
            if (v["read"] + v["show"] + v["render"] > v["total"]) print "more than " v["total"]
        }' "$tree/marks.txt")"
read_8=$(most plt_sequence_step) tile=$(most plt_render_step) refit=$(median "show: refit")
trace=$(median "trace: plt_render_step")

play 2400 FRAMES=13:16 SOURCE=file PARAMETERS='blocks=1 visits=1'
plays "frames 13 to 15 alone, of an image that is fetched, in the least steps" 3
verdict "... with a bound of an eighth a call that reads takes less than a third" "$(
    [ "$(most plt_sequence_step)" -gt 0 ] && [ $((3 * $(most plt_sequence_step))) -lt "$read_8" ] ||
        echo "$(most plt_sequence_step), 8 blocks took $read_8")"
verdict "... and a call that renders less than half of a tile" "$(
    [ "$(most plt_render_step)" -gt 0 ] && [ $((2 * $(most plt_render_step))) -lt "$tile" ] ||
        echo "$(most plt_render_step), a tile took $tile")"

play 2400 FRAMES=0:24 REBUILD=always SIZE=80x60 PARAMETERS=triangles=4000
plays "trees that are built anew" 24
verdict "... at least two of them, none for want of room" "$(
    echo "$text" | grep -q '^trees built anew: [2-9][0-9]*, given up for want of room: 0$' ||
        echo "$text")"

whole=$(most plt_rebuild_step)

play 2400 FRAMES=0:40 REBUILD=always REBUILD_MOST=600 SIZE=80x60 PARAMETERS=triangles=250
plays "subtrees that are built anew in their slots, in short steps" 40
verdict "... at least two of them, none for want of room" "$(
    echo "$text" | grep -q '^trees built anew: [2-9][0-9]*, given up for want of room: 0$' ||
        echo "$text")"
verdict "... a step takes less than a quarter of the longest when steps are of all" "$(
    [ "$(most plt_rebuild_step)" -gt 0 ] && [ $((4 * $(most plt_rebuild_step))) -lt "$whole" ] ||
        echo "$(most plt_rebuild_step), $whole")"

play 2400 FRAMES=0:5 STRUCTURE=grid
plays "a grid that is made anew" 5
grid=$(median "show: grid")
verdict "... takes longer to make than a refit, but not half as long again" "$(
    [ "$grid" -gt "$refit" ] && [ $((2 * grid)) -lt $((3 * refit)) ] ||
        echo "$grid instructions, a refit $refit")"
grid=$(median "trace: plt_render_step")
verdict "... is traced in a quarter more than the instructions of a tree, at most" "$(
    [ $((4 * grid)) -lt $((5 * trace)) ] || echo "$grid instructions, a tree $trace")"

# ---- what fits 256 KiB, and what does not ------------------------------------------

sequence 4880 2
play 4880 SIZE=16x12
plays "60 marbles, 4,880 triangles, fit" 2
sequence 8800 18
play 8800 SIZE=16x12 FRAMES=0:1 RECORDS=always
verdict "all 109 do not: the bytes they need are said" "$(
    [ "$status" -ne 0 ] && echo "$text" | grep -q '^error: the arena.* need_bytes=4[0-9]\{5\} ' ||
        echo "status $status: $text")"
play 8800 FRAMES=0:4 MOST=3000000
plays "... but without records all 109, 8,800 triangles, do" 4
verdict "... of which a frame takes its reading, a refit of all, and rays" "$(
    awk 'NR > 2 && ($2 < 1 || $3 || $4 < 1000000 || $5 || $6 || $7 < 1) { print "row " $0 }' \
        "$tree/frames.txt"
    [ "$(most plt_sequence_show)" -gt 1000000 ] || echo "$text")"
render=$(median "trace: plt_render_step")
play 8800 FRAMES=0:4 BESIDE=1 MOST=600000
plays "... and with nodes beside, each call below 600,000 instructions" 4
verdict "... the refit is in the calls that read, and showing is an exchange" "$(
    [ "$(most plt_sequence_show)" -gt 0 ] && [ "$(most plt_sequence_show)" -lt 1000 ] &&
        [ "$(median "read: refit beside")" -gt 1000000 ] || echo "$text")"
verdict "... and rays take what they took" "$(
    [ "$(median "trace: plt_render_step")" -eq "$render" ] || echo "$text, not $render")"
play 8800 FRAMES=14:18 BESIDE=1 SIZE=80x60 SOURCE=file PARAMETERS=blocks=1
plays "... and of an image that is fetched, whose nodes fit once" 4
verdict "... a step of one block takes less than a tenth of showing" "$(
    [ "$(most plt_sequence_step)" -gt 0 ] &&
        [ $((10 * $(most plt_sequence_step))) -lt "$(most plt_sequence_show)" ] || echo "$text")"
play 2400 ARENA=100000 RECORDS=always
verdict "nor 29 an arena of 100,000 bytes" "$(
    [ "$status" -ne 0 ] && echo "$text" | grep -q '^error: .* need_bytes=1[0-9]\{5\} ' ||
        echo "status $status: $text")"

# ---- a run that is not right fails -----------------------------------------------

play 2400 FRAMES=0:1 SIZE=16x12 MOST=1000000
verdict "a call above MOST is an error that names it" "$(
    [ "$status" -ne 0 ] && echo "$text" | grep -q '^error: a call of plt_sequence_show .*1000000' ||
        echo "status $status: $text")"
play 2400 FRAMES=39:41 SIZE=16x12
verdict "frames that the image does not have are refused" "$(
    [ "$status" -ne 0 ] && echo "$text" | grep -q 'has 40 frames; use --frames 0:40' ||
        echo "status $status: $text")"
"$planelet" make knot --triangles 100 -o "$out/still.ply" >/dev/null 2>&1
"$planelet" pack "$out/still.ply" -o "$out/marbles_0.plt" >/dev/null 2>&1
play 0
verdict "an image without frames is refused" "$(
    [ "$status" -ne 0 ] && echo "$text" | grep -q '^play: .* has no frames; planelet pack --seq' ||
        echo "status $status: $text")"
text=$($MAKE -s BOARD=mps2_an386 PROGRAM=played 2>&1)
verdict "and parts that have none" "$(
    echo "$text" | grep -q "error: .*PROGRAM=played shows sequences: make PROGRAM=played PARTS='" ||
        echo "$text")"
firmware() { # PARAMETER ...: without the host's word on it
    text=$(FIRMWARE=$tree sh board/mps2_an386/run.sh "$out/marbles_2400.plt" "$@" 2>&1)
    status=$?
}
firmware size=16x12 frames=39:41
verdict "... by the firmware, too" "$(
    [ "$status" -eq 1 ] && echo "$text" | grep -q '^error: the image has no such frame' ||
        echo "status $status: $text")"
for wrong in frames=3 frames=4:4 frames=a:b blocks=0 rebuild=cost structure=grid colour=red \
    records=some beside=2; do
    firmware "$wrong"
    verdict "$wrong is wrong usage here" "$(
        [ "$status" -eq 2 ] && echo "$text" | grep -q '^error: ' || echo "status $status: $text")"
done

# judged SENTENCE PATTERN FILE SED: the last right run with one file changed.
play 2400 FRAMES=0:3 SIZE=16x12
judged() {
    for file in host.json marks.txt played.txt; do
        if [ "$file" = "$3" ]; then sed "$4" "$tree/$file"; else cat "$tree/$file"; fi \
            >"$out/$file"
    done
    text=$(awk -v table="$out/frames.txt" -v most=0 -f board/tools/play.awk "$out/host.json" \
        "$out/marks.txt" "$out/played.txt")
    status=$?
    verdict "$1" "$([ "$status" -eq "$5" ] && echo "$text" | grep -q "$2" ||
        echo "status $status: $text")"
}
judged "the run as it is passes" '^3 of 3 frames are' played.txt '' 0
judged "a frame of another hash does not" '^error: frame 1 is ' played.txt \
    '/frame=1 /s/frame_hash=..../frame_hash=0000/' 1
judged "nor an arena of which more is in use" '^error: frame 2: the arena has used=' played.txt \
    '/frame=2 /s/used=/used=1/' 1
judged "nor a higher mark" '^error: frame 0: the arena has used=.* peak=1' played.txt \
    '/frame=0 /s/peak=/peak=1/' 1
judged "nor a spare byte that changed" '^error: frame 1: .* touched=2' played.txt \
    '/frame=1 /s/touched=./touched=2/' 1
judged "nor one far above" '^error: frame 1: .* touched=1' played.txt \
    '/frame=1 /s/touched=/touched=1/' 1
judged "nor a mark that is missing" '^error: frame 1: .* touched=0' played.txt \
    '/frame=1 /s/touched=[0-9]*//' 1
judged "nor a frame that was not counted" '^error: 3 frames were played, 2 counted' marks.txt '2d' 1
judged "nor one that was not played" '^error: 2 frames were played, 3 counted' played.txt \
    '/frame=1 /d' 1
finish

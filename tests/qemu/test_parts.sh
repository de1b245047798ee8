#!/bin/sh
# test_parts.sh - firmware with parts of the engine left out (engine/engine.mk)
#
# A render-only engine of one format gives the whole engine's frame in less code, and
# refuses, in a sentence, what needs a part that it does not have. It has groups alone, for frames
# beams alone, the whole engine both: the frames are the same. What each costs is a row of
# tests/golden/parts.csv, which is the budget; the new ones are in build/parts.csv.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
export BUILD
. tests/boards/rows.sh
. tests/cli/wave.sh
out=$BUILD/mps2_an386/tests
mkdir -p "$out"
needs arm-none-eabi-gcc qemu-system-arm && make_board mps2_an386 || { finish; exit; }

# scene NAME [pack option ...]
scene() {
    name=$1
    shift
    "$planelet" pack "$out/parts.ply" "$@" -o "$out/$name.plt" >/dev/null 2>&1 ||
        verdict "the scene $name is packed" "planelet failed"
}

firmware() { # FOLDER SCENE [parameter ...]: sets text and status
    folder=$1
    shift
    text=$(FIRMWARE=$folder sh board/mps2_an386/run.sh "$@" 2>&1)
    status=$?
}

renders() { # FOLDER NAME [parameter]
    view=$(sh board/tools/host_view.sh "$out/$2.plt" 80x60 "$out/host.ppm" --view box)
    # shellcheck disable=SC2086
    firmware "$1" "$out/$2.plt" size=80x60 ${view#* } $3
    verdict "${1##*/}, $2${3:+, $3}: the frame of the whole engine" "$(
        [ "$status" -eq 0 ] || echo "status $status: $text"
        [ -n "$(value frame_hash)" ] && [ "$(value frame_hash)" = "${view%% *}" ] ||
            echo "$(value frame_hash) on the device, ${view%% *} on the host")"
}

refuses() { # FOLDER NAME WORD [parameter]
    # shellcheck disable=SC2086
    firmware "$1" "$out/$2.plt" size=80x60 $4
    verdict "${1##*/}, $2${4:+, $4}: refused, and $3 is named" "$(
        [ "$status" -eq 1 ] || echo "status $status: $text"
        echo "$text" | grep -q "^error: .*$3" || echo "printed '$text'")"
}

# part WORDS: built; it renders the frame of the whole engine, and is within its budget.
table=$BUILD/parts.csv
echo "$parts_header" >"$table"
part() {
    built=$(folder_of "$1")
    rm -f "$built/firmware.elf" "$built/stack.txt" # what was linked before may have other files
    make_board mps2_an386 PARTS="$([ "$1" = all ] || echo "$1")" || return 1
    echo "$parts_header" >"$out/row.csv"
    parts_row "$1" >>"$out/row.csv"
    sed 1d "$out/row.csv" >>"$table"
    verdict "PARTS='$1': the frame of the whole engine" "$(
        [ "$status" -eq 0 ] || echo "status $status: $text")"
    compared=$(awk -f tests/boards/budget.awk tests/golden/parts.csv "$out/row.csv" ||
        echo "error: not compared")
    echo "$compared" | sed -n '/^error/!s/^./    &/p'
    verdict "... $(awk -F, 'NR > 1 { print $6 " bytes of engine, at most " $(NF - 1) ", and " $10 \
        " of stack below " $11 ", at most " $NF }' "$out/row.csv")" "$(
        echo "$compared" | grep '^error'
        echo "$depths" | grep '^error')"
}

"$planelet" make knot --triangles 2000 -o "$out/parts.ply" >/dev/null
scene thesis
scene list --build none
scene compact --nodes compact --geometry lattice:14
scene floats --nodes compact --geometry float
scene device --build device
scene compact_device --nodes compact --geometry lattice:14 --build device

thesis=$BUILD/mps2_an386-render-thesis compact=$BUILD/mps2_an386-compact-render
if part "render thesis"; then
    renders "$thesis" list
    refuses "$thesis" compact PLT_WITH_COMPACT
    refuses "$thesis" device PLT_WITH_BUILDER
fi
if part "render compact"; then
    refuses "$compact" thesis PLT_WITH_THESIS
    refuses "$compact" list PLT_WITH_THESIS
    refuses "$compact" compact_device PLT_WITH_BUILDER
fi
if part thesis; then
    renders "$BUILD/mps2_an386-thesis" device
fi
if part compact; then
    renders "$BUILD/mps2_an386-compact" compact_device
fi
frames=$BUILD/mps2_an386-frames-render-thesis
if part "render thesis frames"; then
    renders "$frames" list
    refuses "$frames" compact PLT_WITH_COMPACT
    refuses "$frames" device PLT_WITH_BUILDER
fi
small=$BUILD/mps2_an386-frames-render-small-thesis
if part "render thesis frames small"; then
    renders "$small" list
fi
small=$BUILD/mps2_an386-frames-small-thesis
if part "thesis frames small"; then
    renders "$small" device
fi
samples=$BUILD/mps2_an386-diagrams-frames-render-samples-thesis
if part "render thesis frames samples diagrams"; then
    for how in 'samples=4' 'samples=16' 'samples=adaptive' 'shader=depth' \
        'shader=depth samples=4' 'shader=heat'; do
        flags=$(echo "--$how" | sed 's/ / --/g; s/=/ /g')
        # shellcheck disable=SC2086
        view=$(sh board/tools/host_view.sh "$out/thesis.plt" 80x60 "$out/host.ppm" $flags)
        # shellcheck disable=SC2086
        firmware "$samples" "$out/thesis.plt" size=80x60 ${view#* } $how
        case $how in
        *heat) wanted='' ;; # of beams, not of groups
        *) wanted=${view%% *} ;;
        esac
        verdict "... $how: the host's picture" "$(
            [ "$status" -eq 0 ] && echo "$text" | grep -q "^frame_hash=$wanted" ||
            echo "status $status, not $wanted: $text")"
    done
fi
frames=$BUILD/mps2_an386-compact-frames-render
if part "render compact frames"; then
    renders "$frames" floats
    refuses "$frames" thesis PLT_WITH_THESIS
    refuses "$frames" compact_device PLT_WITH_BUILDER
fi
frames=$BUILD/mps2_an386-compact-frames-render-stream
if part "render compact frames stream"; then
    firmware "$frames" "$out/compact.plt" size=80x60 residency=streamed
    verdict "... streamed, too" "$([ "$status" -eq 0 ] && echo "$text" | grep -q '^streamed ' ||
        echo "status $status: $text")"
fi
for parts in 'render frames' 'render compact frames wave' 'render thesis frames stream'; do
    trouble=$($MAKE -s BOARD=mps2_an386 PARTS="$parts" 2>&1)
    verdict "PARTS='$parts' is refused, with what it may be" "$(
        echo "$trouble" | grep -q "PARTS with frames .*has .*: make PARTS='" || echo "$trouble")"
done
motion=$BUILD/mps2_an386-motion-render-thesis
part "render thesis motion"
sequence=$BUILD/mps2_an386-motion-render-sequence-thesis
# shows GEOMETRY SOURCE NODES [PARAMETER]: frames of a sequence, which come by semihosting (`file`)
# or are mapped.
shows() {
    "$planelet" pack --sequence "$out"/wave_00?.ply --geometry "$1" --nodes "${3:-thesis}" --key 4 \
        -o "$out/wave.plt" >/dev/null 2>&1
    for frame in 0 3 5; do
        view=$(sh board/tools/host_view.sh "$out/wave.plt" 80x60 "$out/host.ppm" --view box \
            --frames $frame:$((frame + 1)))
        # shellcheck disable=SC2086
        text=$(FIRMWARE=$sequence SOURCE=$2 sh board/mps2_an386/run.sh "$out/wave.plt" size=80x60 \
            show=$frame ${view#* } ${4:-} 2>&1)
        verdict "frame $frame of a sequence, $1 $2 $3: that of the host" "$(
            [ -n "$(value frame_hash)" ] && [ "$(value frame_hash)" = "${view%% *}" ] ||
                echo "$text")"
    done
}
if part "render thesis motion sequence"; then
    for k in 0 1 2 3 4 5; do
        wave $k >"$out/wave_00$k.ply"
    done
    shows lattice:14
    shows float file
    firmware "$sequence" "$out/wave.plt" size=80x60 show=6
    verdict "... a frame that is not there is refused" "$(
        echo "$text" | grep -q '^error: the image has no such frame' || echo "$text")"
    firmware "$motion" "$out/wave.plt" size=80x60
    verdict "... and the image where there is no part for it" "$(
        echo "$text" | grep -q '^error: .*number of sections' || echo "$text")"
fi
sequence=$BUILD/mps2_an386-compact-motion-render-sequence
if part "render compact motion sequence"; then
    for k in 0 1 2 3 4 5; do
        wave $k >"$out/wave_00$k.ply"
    done
    shows lattice:14 "" compact
    shows lattice:19 file compact
    firmware "$BUILD/mps2_an386-compact-render" "$out/wave.plt" size=80x60
    verdict "... and the image where there is no part for it" "$(
        echo "$text" | grep -q '^error: .*a format that this version does not know' ||
            echo "$text")"
fi
sequence=$BUILD/mps2_an386-compact-frames-motion-render-sequence
if part "render compact frames motion sequence"; then
    shows lattice:16 "" compact
fi
sequence=$BUILD/mps2_an386-compact-motion-render-sequence-stream
if part "render compact motion sequence stream"; then
    "$planelet" pack --sequence "$out"/wave_00?.ply --geometry lattice:14 --nodes compact --stills \
        -o "$out/stills.plt" >/dev/null 2>&1
    for frame in 0 3 5; do
        view=$(sh board/tools/host_view.sh "$out/stills.plt" 80x60 "$out/host.ppm" --view box \
            --residency streamed --frames $frame:$((frame + 1)))
        # shellcheck disable=SC2086
        text=$(FIRMWARE=$sequence SOURCE=file sh board/mps2_an386/run.sh "$out/stills.plt" \
            size=80x60 residency=streamed show=$frame ${view#* } 2>&1)
        verdict "frame $frame of stills, streamed: that of the host" "$(
            [ -n "$(value frame_hash)" ] && [ "$(value frame_hash)" = "${view%% *}" ] ||
                echo "$text")"
    done
fi
sequence=$BUILD/mps2_an386-motion-render-sequence-thesis-vertices
if part "render thesis motion sequence vertices"; then
    shows lattice:14 '' thesis records=never
    shows float file thesis records=never
    shows float ''
    firmware "$sequence" "$out/wave.plt" size=80x60 records=never
    verdict "... without records there is nothing but frames" "$(
        echo "$text" | grep -q '^error: without records there are only the frames' || echo "$text")"
fi
trouble=$($MAKE -s BOARD=mps2_an386 PARTS='render thesis motion vertices' 2>&1)
verdict "PARTS with vertices and without sequence is refused, with what it may be" "$(
    echo "$trouble" | grep -q "PARTS with vertices has .*: make PARTS='" || echo "$trouble")"
trouble=$($MAKE -s BOARD=mps2_an386 PARTS='render thesis sequence' 2>&1)
verdict "PARTS with sequence and without motion is refused, with what it may be" "$(
    echo "$trouble" | grep -q "PARTS with sequence has .*: make PARTS='" || echo "$trouble")"
part "render thesis motion some"
motion=$BUILD/mps2_an386-motion-thesis
if part "thesis motion"; then
    renders "$motion" device
    verdict "... with rebuilds, and without them where there is no builder" "$(
        [ -e "$motion/engine/motion/rebuild.o" ] || echo "no rebuild.o"
        ls "$BUILD/mps2_an386-motion-render-thesis/engine/motion/rebuild.o" 2>/dev/null)"
fi
motion=$BUILD/mps2_an386-motion-subtree-thesis
if part "thesis motion subtree"; then
    renders "$motion" device
    verdict "... with subtrees, and without them where nobody asks" "$(
        [ -e "$motion/engine/motion/subtrees.o" ] || echo "no subtrees.o"
        ls "$BUILD/mps2_an386-motion-thesis/engine/motion/subtrees.o" 2>/dev/null)"
fi
for parts in 'thesis subtree' 'render thesis motion subtree'; do
    trouble=$($MAKE -s BOARD=mps2_an386 PARTS="$parts" 2>&1)
    verdict "PARTS='$parts' is refused, with what it may be" "$(
        echo "$trouble" | grep -q "PARTS with subtree has .*: make PARTS='" || echo "$trouble")"
done
trouble=$($MAKE -s BOARD=mps2_an386 PARTS='render thesis some' 2>&1)
verdict "PARTS with some and without motion is refused, with what it may be" "$(
    echo "$trouble" | grep -q "PARTS with some has .*: make PARTS='" || echo "$trouble")"
grid=$BUILD/mps2_an386-grid-render-thesis
if part "render thesis grid"; then
    renders "$grid" thesis structure=grid
fi
grid=$BUILD/mps2_an386-frames-grid-render-thesis
if part "render thesis grid frames"; then
    renders "$grid" thesis structure=grid
    renders "$grid" list structure=grid
fi
for parts in 'render compact grid' 'grid compact'; do
    trouble=$($MAKE -s BOARD=mps2_an386 PARTS="$parts" 2>&1)
    verdict "PARTS='$parts' is refused, with what it may be" "$(
        echo "$trouble" | grep -q "PARTS with grid has .*: make PARTS='" || echo "$trouble")"
done
# smooth FOLDER NAME [parameter]: by normals and colours of corners.
smooth() {
    view=$(sh board/tools/host_view.sh "$out/$2.plt" 80x60 "$out/host.ppm" --shader smooth)
    # shellcheck disable=SC2086
    firmware "$1" "$out/$2.plt" size=80x60 shader=smooth ${view#* } $3
    verdict "${1##*/}, $2, smooth${3:+, $3}: the frame of the host" "$(
        [ -n "$(value frame_hash)" ] && [ "$(value frame_hash)" = "${view%% *}" ] ||
            echo "status $status: $text")"
}
scene smooth --smooth 40
scene smooth_compact --nodes compact --geometry lattice:14 --smooth 40
scene smooth_device --build device --smooth 40
surface=$BUILD/mps2_an386-frames-render-surface-thesis
if part "render thesis frames surface"; then
    renders "$surface" smooth
    smooth "$surface" smooth
    smooth "$surface" thesis
fi
surface=$BUILD/mps2_an386-compact-frames-render-surface
if part "render compact frames surface"; then
    smooth "$surface" smooth_compact packet=4
fi
surface=$BUILD/mps2_an386-surface-thesis
if part "thesis surface"; then
    smooth "$surface" smooth
    SOURCE=file smooth "$surface" smooth
    smooth "$surface" smooth_device
fi
surface=$BUILD/mps2_an386-compact-render-surface
if part "render compact surface"; then
    smooth "$surface" smooth_compact
fi
# Page by page, of scenes that stay in their source; and of one that is resident.
scene pages --smooth 40 --surface pages
scene pages_compact --nodes compact --geometry lattice:14 --smooth 40 --surface pages
for words in 'render compact frames stream surface' 'render compact stream surface' \
    'render thesis stream surface'; do
    pages=$(folder_of "$words")
    name=pages_compact
    [ "${words#*thesis}" = "$words" ] || name=pages
    if part "$words"; then
        smooth "$pages" $name packet=4
        SOURCE=file smooth "$pages" $name "residency=streamed packet=8"
        SOURCE=file smooth "$pages" $name "residency=streamed packet=4 arena=65536"
    fi
done
# Without streamed scenes pages are of no use, and in nobody's way.
renders "$BUILD/mps2_an386-surface-thesis" pages
refuses "$BUILD/mps2_an386-surface-thesis" pages PLT_WITH_STREAMED shader=smooth
refuses "$thesis" smooth sections
# lit FOLDER NAME: a frame with lights, mirrors and glass in 256 KiB.
lit() {
    view=$(sh board/tools/host_view.sh "$out/$2.plt" 80x60 "$out/host.ppm" --shader whitted \
        --light sun:0.5,1,0.75,0.75,0.0625,4 --sky 0.5,0.5,0.75 --ground 0.25,0.25,0.125 --depth 4)
    # shellcheck disable=SC2086
    firmware "$1" "$out/$2.plt" size=80x60 arena=262144 shader=whitted \
        sun=0.5,1,0.75,0.75,0.0625,4 sky=0.5,0.5,0.75 ground=0.25,0.25,0.125 depth=4 ${view#* } $3
    echo "$text" | tr ' ' '\n' | grep '^render_longest='
    verdict "${1##*/}, $2, lit${3:+, $3}: the frame of the host" "$(
        [ -n "$(value frame_hash)" ] && [ "$(value frame_hash)" = "${view%% *}" ] ||
            echo "status $status: $text")"
}
"$planelet" make marbles --triangles 1680 -o "$out/marbles.obj" >/dev/null 2>&1
for smooth in "" "--smooth 40"; do
    # shellcheck disable=SC2086
    "$planelet" pack "$out/marbles.obj" --materials keep $smooth --leaf 2 \
        -o "$out/marbles${smooth:+_smooth}.plt" >/dev/null 2>&1
done
if part "render thesis whitted"; then
    lit "$BUILD/mps2_an386-render-thesis-whitted" marbles
fi
# What surfaces send out by the wave; its leaves, of blocks of four, want more of the stack.
wave=$BUILD/mps2_an386-render-thesis-wave-whitted
if part "render thesis whitted wave"; then
    lit "$wave" marbles "flight=32 rays=incoherent"
    by_wave=$(value total)
    lit "$wave" marbles "flight=32 rays=coherent"
    verdict "... by another way: $by_wave instructions, and $(value total) in packets" "$(
        [ "${by_wave:-0}" -gt 0 ] && [ "$by_wave" != "$(value total)" ] || echo "$text")"
fi
whitted=$BUILD/mps2_an386-render-surface-thesis-whitted
if part "render thesis surface whitted"; then
    lit "$whitted" marbles_smooth
fi
PLANELET=$planelet sh tests/measure/unwrap.sh "$out/parts.ply" "$out/textured.obj"
"$planelet" pack "$out/textured.obj" --smooth 40 --colours keep --texcoords keep --leaf 2 \
    -o "$out/textured.plt" >/dev/null 2>&1
smooth "$whitted" textured
textured=$BUILD/mps2_an386-render-surface-texcoords-thesis
if part "render thesis surface texcoords"; then
    smooth "$textured" textured
    SOURCE=file smooth "$textured" textured
fi
trouble=$($MAKE -s BOARD=mps2_an386 PARTS='render thesis texcoords' 2>&1)
verdict "PARTS with texcoords and without surface is refused, with what it may be" "$(
    echo "$trouble" | grep -q "PARTS with texcoords has .*: make PARTS='" || echo "$trouble")"
# A frame with textures of both filters, mapped and fetched.
printf 'P6 40 24 255 ' >"$out/checks.ppm"
awk 'BEGIN { for (i = 0; i < 2880; i++) printf "%c", 33 + (i * 7 + int(i / 120) * 31) % 90 }' \
    >>"$out/checks.ppm"
printf 'newmtl a\nKd 0.9 1 0.8\nmap_Kd -s 2 3 checks.ppm\n' >"$out/checks.mtl"
{
    printf 'mtllib checks.mtl\nusemtl a\n'
    printf 'v -4 0 4\nv 4 0 4\nv 4 0 -4\nv -4 0 -4\nv 0 3 0\nvt 0 0\nvt 2 0\nvt 2 2\nvt 0 2\n'
    printf 'f 1/1 2/2 3/3 4/4\nf 1/1 2/2 5/3\nf 3/1 4/2 5/4\n'
} >"$out/checks.obj"
"$planelet" pack "$out/checks.obj" --materials keep -o "$out/checks.plt" >/dev/null 2>&1
texture=$BUILD/mps2_an386-render-surface-texcoords-texture-thesis-whitted
if part "render thesis surface texcoords whitted texture"; then
    for filter in nearest bilinear; do
        view=$(sh board/tools/host_view.sh "$out/checks.plt" 80x60 "$out/host.ppm" \
            --shader whitted --light sun:0.5,1,0.75,0.75,0.0625,4 --sky 0.5,0.5,0.75 \
            --ground 0.25,0.25,0.125 --depth 1 --textures $filter)
        for source in '' file; do
            text=$(FIRMWARE=$texture SOURCE=$source sh board/mps2_an386/run.sh "$out/checks.plt" \
                size=80x60 shader=whitted sun=0.5,1,0.75,0.75,0.0625,4 sky=0.5,0.5,0.75 \
                ground=0.25,0.25,0.125 depth=1 textures=$filter ${view#* } 2>&1)
            verdict "textures=$filter${source:+, from a file}: the frame of the host" "$(
                [ -n "$(value frame_hash)" ] && [ "$(value frame_hash)" = "${view%% *}" ] ||
                    echo "$text")"
        done
    done
fi
# ... and without lights, by groups and by beams.
smooth_texture() { # FOLDER
    for filter in nearest bilinear; do
        view=$(sh board/tools/host_view.sh "$out/checks.plt" 80x60 "$out/host.ppm" \
            --shader smooth --textures $filter)
        for source in '' file; do
            # shellcheck disable=SC2086
            text=$(FIRMWARE=$1 SOURCE=$source sh board/mps2_an386/run.sh "$out/checks.plt" \
                size=80x60 shader=smooth textures=$filter ${view#* } 2>&1)
            verdict "${1##*/}, smooth, textures=$filter${source:+, from a file}: the frame of the \
host" "$(
                [ -n "$(value frame_hash)" ] && [ "$(value frame_hash)" = "${view%% *}" ] ||
                    echo "$text")"
        done
    done
}
smooth_texture "$texture"
texture=$BUILD/mps2_an386-frames-render-surface-texcoords-texture-thesis
if part "render thesis frames surface texcoords texture"; then
    smooth_texture "$texture"
fi
# ... of a scene that stays in its source, and is mapped.
words='render compact frames stream surface texcoords texture'
texture=$(folder_of "$words")
"$planelet" pack "$out/checks.obj" --materials keep --nodes compact --surface pages \
    -o "$out/checks_pages.plt" >/dev/null 2>&1
if part "$words"; then
    view=$(sh board/tools/host_view.sh "$out/checks_pages.plt" 80x60 "$out/host.ppm" \
        --shader smooth)
    for way in "" "file residency=streamed" "file residency=streamed arena=65536"; do
        source=${way%% *}
        [ -n "$way" ] || source=
        # shellcheck disable=SC2086
        text=$(FIRMWARE=$texture SOURCE=$source sh board/mps2_an386/run.sh \
            "$out/checks_pages.plt" size=80x60 shader=smooth packet=4 ${way#"$source"} \
            ${view#* } 2>&1)
        verdict "textures by pages, ${way:-resident}: the frame of the host" "$(
            [ -n "$(value frame_hash)" ] && [ "$(value frame_hash)" = "${view%% *}" ] ||
                echo "$text")"
    done
fi
trouble=$($MAKE -s BOARD=mps2_an386 PARTS='render thesis surface texture' 2>&1)
verdict "PARTS with texture and without texcoords is refused, with what it may be" "$(
    echo "$trouble" | grep -q "PARTS with texture has .*: make PARTS='" || echo "$trouble")"
instances=$BUILD/mps2_an386-instances-render-thesis
# shows_instances [SOURCE=file]: frames of marbles that are instances; of the last one the host's
# program says how long it takes.
shows_instances() {
    for frame in 0 7 3; do
        view=$(sh board/tools/host_view.sh "$out/instances.plt" 80x60 "$out/host.ppm" --view box \
            --frames $frame:$((frame + 1)))
        # shellcheck disable=SC2086
        text=$(FIRMWARE=$instances SOURCE=$1 sh board/mps2_an386/run.sh "$out/instances.plt" \
            size=80x60 show=$frame ${view#* } 2>&1)
        verdict "frame $frame of instances $1: that of the host" "$(
            [ -n "$(value frame_hash)" ] && [ "$(value frame_hash)" = "${view%% *}" ] ||
                echo "$text")"
    done
}
if part "render thesis instances"; then
    "$planelet" make marbles --instances --frames 8 --triangles 2000 -o "$out/instances.txt" \
        >/dev/null 2>&1
    "$planelet" pack --instances "$out/instances.txt" -o "$out/instances.plt" >/dev/null 2>&1
    shows_instances
    shows_instances file
    firmware "$instances" "$out/instances.plt" size=80x60 show=8
    verdict "... a frame that is not there is refused" "$(
        echo "$text" | grep -q '^error: the image has no such frame' || echo "$text")"
    firmware "$thesis" "$out/instances.plt" size=80x60
    verdict "... and the image where there is no part for it" "$(
        echo "$text" | grep -q '^error: .*number of sections' || echo "$text")"
fi
for parts in 'render compact instances' 'instances compact'; do
    trouble=$($MAKE -s BOARD=mps2_an386 PARTS="$parts" 2>&1)
    verdict "PARTS='$parts' is refused, with what it may be" "$(
        echo "$trouble" | grep -q "PARTS with instances has .*: make PARTS='" || echo "$trouble")"
done
for parts in 'render compact motion' 'motion compact'; do
    trouble=$($MAKE -s BOARD=mps2_an386 PARTS="$parts" 2>&1)
    verdict "PARTS='$parts' is refused, with what it may be" "$(
        echo "$trouble" | grep -q "PARTS with motion has .*: make PARTS='" || echo "$trouble")"
done
if part "render thesis wave"; then
    verdict "... the whole engine is without a wave" "$(
        find "$BUILD/mps2_an386/engine" -name 'wave*.o' | grep .)"
fi
part "render compact stream batch"
tasks=$BUILD/mps2_an386-batch-compact-render-stream-task
if part "render compact stream batch task"; then
    view=$(sh board/tools/host_view.sh "$out/compact.plt" 80x60 "$out/host.ppm" --view box)
    # shellcheck disable=SC2086
    firmware "$tasks" "$out/compact.plt" size=80x60 residency=streamed schedule=task batch=3 \
        packet=4 ${view#* }
    verdict "... by tasks, on one core: the same frame" "$(
        [ "$status" -eq 0 ] && [ "$(value frame_hash)" = "${view%% *}" ] || echo "$text")"
fi
trouble=$($MAKE -s BOARD=mps2_an386 PARTS='render compact stream task' 2>&1)
verdict "PARTS with task and without batch is refused, with what it may be" "$(
    echo "$trouble" | grep -q "PARTS with task has .*: make PARTS='" || echo "$trouble")"
part "render compact wave"
part all
part "wave stream batch task seek prefetch motion some subtree sequence vertices background grid \
instances surface texcoords texture whitted samples diagrams"
verdict "every row of tests/golden/parts.csv was built" "$(
    sed 's/,.*//' "$table" | sort >"$out/built.txt"
    sed 's/,.*//' tests/golden/parts.csv | sort | diff - "$out/built.txt")"
echo "to change the budget: cp $table tests/golden/parts.csv; make tables"
trouble=$($MAKE -s BOARD=mps2_an386 PARTS=rendr 2>&1)
verdict "a part that is not there is refused, and those that are named" "$(
    echo "$trouble" | grep -q 'PARTS is a list of render, thesis and compact' || echo "$trouble")"
finish

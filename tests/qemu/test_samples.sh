#!/bin/sh
# test_samples.sh - samples of lit and smooth frames on the firmware are those of the host
#
# By groups and by beams, whose frames of samples come about in different ways.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/wave.sh
planelet=$BUILD/host/planelet
out=$BUILD/mps2_an386/tests
mkdir -p "$out"
needs arm-none-eabi-gcc qemu-system-arm && make_board mps2_an386 || { finish; exit; }

lights='sun=0.5,1,0.75,0.75,0.0625,4 sky=0.5,0.5,0.75 ground=0.25,0.25,0.125 depth=4'
flags='--light sun:0.5,1,0.75,0.75,0.0625,4 --sky 0.5,0.5,0.75 --ground 0.25,0.25,0.125 --depth 4'

value() { # NAME: of the first NAME=value in the text
    echo "$text" | tr ' ' '\n' | sed -n "s/^$1=//p" | head -n 1
}

# same "WORDS" MOST SCENE PARAMETERS FLAGS: the firmware with these parts has the host's picture,
# and is not larger than it may be.
same() {
    folder=$BUILD/mps2_an386-$(echo "$1" | tr ' ' '\n' | sort | paste -sd-)
    make_board mps2_an386 PARTS="$1" || return 1
    bytes=$(find "$folder/engine" -name '*.o' | xargs arm-none-eabi-size |
        awk 'NR > 1 { s += $1 } END { print s }')
    verdict "PARTS='$1': $bytes bytes of engine, at most $2" "$(
        [ "${bytes:-0}" -gt 0 ] && [ "$bytes" -le "$2" ] || echo "$bytes bytes")"
    for samples in 4 16 adaptive; do
        # shellcheck disable=SC2086
        view=$(sh board/tools/host_view.sh "$out/$3.plt" 32x24 "$out/host.ppm" $5 \
            --samples $samples)
        # shellcheck disable=SC2086
        text=$(FIRMWARE=$folder sh board/mps2_an386/run.sh "$out/$3.plt" size=32x24 arena=262144 \
            $4 samples=$samples ${view#* } 2>&1)
        verdict "... $3, $samples samples: the frame of the host" "$(
            [ -n "$(value frame_hash)" ] && [ "$(value frame_hash)" = "${view%% *}" ] ||
                echo "$text")"
    done
}

"$planelet" make marbles --triangles 1680 -o "$out/marbles.obj" >/dev/null 2>&1
for smooth in "" "--smooth 40"; do
    # shellcheck disable=SC2086
    "$planelet" pack "$out/marbles.obj" --materials keep $smooth --leaf 2 \
        -o "$out/lit${smooth:+_smooth}.plt" >/dev/null 2>&1
done
"$planelet" make knot --triangles 2000 -o "$out/samples.ply" >/dev/null
"$planelet" pack "$out/samples.ply" --smooth 40 -o "$out/samples.plt" >/dev/null 2>&1
same "render thesis whitted samples" 56832 lit "shader=whitted $lights" "--shader whitted $flags"
same "render thesis surface whitted samples" 61696 lit_smooth "shader=whitted $lights" \
    "--shader whitted $flags"
same "render thesis surface whitted samples" 61696 samples "shader=smooth" "--shader smooth"
same "render thesis frames surface samples" 42496 samples "shader=smooth" "--shader smooth"
verdict "make run compares frames of samples with the host's" "$(
    text=$(FIRMWARE=$folder sh board/tools/run_like_host.sh mps2_an386 "$out/samples.plt" 32x24 \
        shader=smooth samples=4 2>&1) || echo "status $?"
    echo "$text" | grep -q '^the host renders the same frame$' || echo "$text" | tail -n 3)"
finish

#!/bin/sh
# test_usage.sh - help, versions, and words that no command understands
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin usage
quad quad.ply
run pack quad.ply -o quad.plt

works "planelet --help" --help
verdict "... names every command" "$(
    for command in make pack info render trace serve bench tables; do
        grep -q "^  planelet $command " out || echo "not a word about $command"
    done)"
cp out overview
works "planelet help" help
same out overview "... is planelet --help"
works "planelet --version" --version
verdict "... is one line with a number" "$(
    [ "$(wc -l <out)" -eq 1 ] && grep -q '^planelet [0-9][0-9]*\.[0-9][0-9]*$' out || cat out)"
run
verdict "planelet alone gives the overview on standard error and ends with 2" "$(
    [ "$status" -eq 2 ] || echo "status $status"
    cmp err overview
    cat out)"

# flags COMMAND FLAG...: --help names all of them, and nothing else.
flags() {
    command=$1
    shift
    works "planelet $command --help" "$command" --help
    verdict "... names its flags and no other" "$(
        sed -n 's/^  \(-[-a-z]*\).*/\1/p' out | sort >named
        for flag in "$@" --help; do
            echo "$flag"
        done | sort | diff - named)"
    verdict "... fits in 80 columns" "$(awk 'length > 80' out)"
    cp out help
    works "planelet help $command" help "$command"
    same out help "... is planelet $command --help"
    run "$command" -h
    same out help "... and planelet $command -h"
    misused "planelet $command without files is wrong usage" "use it as: planelet $command" \
        "$command"
    misused "planelet $command refuses a flag that it does not have" --frobnicate \
        "$command" quad.ply --frobnicate
}
scene_flags='--packet --walk --structure --residency --store --schedule --batch --prefetch'
scene_flags="$scene_flags --source --arena"
one_flags=$scene_flags
scene_flags="$scene_flags --workers --turns"
view_flags='--view --eye --look --up --fov'
flags make -o --triangles --seed --frame --frames --instances
flags pack -o --build --splits --quality --quality-time --leaf --nodes --treelet --fill --slots \
    --geometry --tolerance --step --checks --numbers --reduce --frame --sequence --frames \
    --stills --tree-for --rate --key --instances --centre --origin --normals --smooth \
    --colours --texcoords --surface --materials --textures --strict --weld --repair --memory --json
flags info --json --packet --walk
# shellcheck disable=SC2086
flags render -o --show --size --shader --samples --light --sky --ground --shadows --depth \
    --rays --textures --texture-room --orbit --moved \
    --frames --rebuild --rebuild-step --rebuild-most --records --beside --baseline --repeat \
    --chroma --json --counts $view_flags --background $scene_flags
# shellcheck disable=SC2086
flags trace --any --rays --order --baseline --moved --frames --rebuild --rebuild-step \
    --rebuild-most --repeat --json --counts $scene_flags
# shellcheck disable=SC2086
flags bench --kinds --hits --nodes --packets --walks --repeat --size --structures --against --json \
    $view_flags

# shellcheck disable=SC2086
flags view --graphics --shader --background $view_flags $one_flags

# Without files it makes all tables, as test_tables does.
works "planelet tables --help" tables --help
verdict "... names its flags and no other" "$(
    sed -n 's/^  \(-[-a-z]*\).*/\1/p' out | sort >named
    for flag in --scenes -o --rows --size --views --frames --rounds --json --help; do
        echo "$flag"
    done | sort | diff - named)"
verdict "... fits in 80 columns" "$(awk 'length > 80' out)"
misused "planelet tables refuses a flag that it does not have" --frobnicate tables --frobnicate

misused "an unknown command is wrong usage" "'frob'" frob
misused "help of an unknown command is wrong usage" "'frob'" help frob
misused "a command with control characters stays on one line" "'a?b??[31m'" \
    "$(printf 'a\nb\r\033[31m')"
misused "a flag with control characters stays on one line" "?" info quad.plt "$(printf -- '--a\nb')"
misused "an overlong word stays on one line" "there is no flag" info quad.plt \
    "--$(awk 'BEGIN { while (i++ < 5000) printf "x" }')"

misused "pack wants -o" "-o" pack quad.ply
misused "a flag at the end wants its value" "-o takes a value" pack quad.ply -o
misused "a flag is no value" "-o takes a value" render quad.plt -o --show
misused "an empty value is none of the words" "''" pack quad.ply -o x --build ''
misused "a switch takes no value" "--repair" pack quad.ply -o x --repair=yes
works "a value may follow =" pack quad.ply -o equals.plt --leaf=4
verdict "... and counts" "$(run info equals.plt --json
    [ "$(number leaf_triangles <out)" = 4 ] || cat out)"
cp quad.ply ./-odd.ply
works "after -- all words are files" pack -o odd.plt -- -odd.ply
works "flags may stand anywhere" pack --leaf 4 quad.ply -o anywhere.plt

for pair in --geometry=double --geometry=lattice:11 --geometry=lattice:22 --geometry=lattice: \
    --tolerance=1e-9 --tolerance=x; do
    misused "pack --nodes compact refuses $pair" "${pair%=*}" \
        pack quad.ply -o x --nodes compact "$pair"
done
works "pack --nodes compact takes --geometry float" \
    pack quad.ply -o float.plt --nodes compact --geometry float
run pack quad.ply -o tolerance.plt --nodes compact --tolerance 0.001
verdict "pack --nodes compact --tolerance 0.001 chooses the coarsest lattice, 12 bits" "$(
    [ "$status" -eq 0 ] || echo "status $status"
    [ "$(grep -c '^quad.ply: lattice of 12 bits: ' err)" -eq 1 ] || cat err)"
misused "pack refuses two lattices" --tolerance \
    pack quad.ply -o x --nodes compact --geometry lattice:14 --tolerance 0.001
misused "pack refuses --numbers beside float geometry" --numbers \
    pack quad.ply -o x --nodes compact --geometry float --numbers keep
misused "pack refuses to keep numbers for a device" --numbers \
    pack quad.ply -o x --nodes compact --build device --numbers keep
misused "pack --nodes compact refuses --build none" compact \
    pack quad.ply -o x --nodes compact --build none

# Every value that is a word or a number, just out of its range.
for pair in --build=thing --splits=middle --quality=best --quality-time=0 --tree-for=last \
    --leaf=3 --leaf=0 --nodes=small --treelet=0 \
    --treelet=1000001 --treelet=-1 --treelet=6x --treelet=99999999999999999999 --fill=volume \
    --slots=oldest --geometry=lattice --geometry=double --checks=some --numbers=some \
    --numbers=none --tolerance=0.1 --reduce=0 --frame=-1 --smooth=181 --normals=all \
    --colours=8 --texcoords=all --materials=all --surface=both --textures=4; do
    misused "pack refuses $pair" "${pair%=*}" pack quad.ply -o x "${pair%=*}" "${pair#*=}"
done
for pair in --packet=3 --walk=wide --structure=kd --residency=cached --store=64K --store=28671 \
    --schedule=tasks \
    --batch=0 --workers=65 --prefetch=9 --source=net --source=dma --source=dma:1 \
    --source=dma:1,20,0 \
    --arena=0 --arena=64K --arena=1073741825; do
    misused "render refuses $pair" "${pair%=*}" render quad.plt -o x.png "$pair"
    misused "trace refuses $pair" "${pair%=*}" trace quad.plt rays x "$pair"
done
for pair in --size=512 --size=0x5 --size=5x0 --size=5x5x5 --size=70000x5 --size=-5x5 --size=x \
    --chroma=422 --chroma= \
    --view=above --view=1 --view=361,0 --view=0,91 --view=1,2,3 --view=a,b \
    --background=red --background=12345 --background=#123456 --background= \
    --eye=1,2 --eye=1,2,3,4 --eye=a,b,c --eye=1,2,nan --look=1,,2 --up=inf,0,0 --fov=0 --fov=180 \
    --fov=-5 --fov=x --shader=toon --samples=2 --samples=0 --samples=all --depth=9 --light=lamp:1 \
    --sky=1 --orbit=0 --repeat=0; do
    misused "render refuses $pair" "${pair%=*}" render quad.plt -o x.png "$pair"
done
misused "trace refuses --repeat 0" --repeat trace quad.plt rays x --repeat 0
misused "info refuses --packet 5" --packet info quad.plt --packet 5

misused "render wants somewhere to go" "--show" render quad.plt
misused "render knows formats by their endings" ".y4m" render quad.plt -o x.jpg
misused "several frames are a film" ".y4m" render quad.plt -o x.png --orbit 2
misused "a picture has no chroma to choose" --chroma render quad.plt -o x.png --chroma 444
misused "picture and statistics do not share a file" "two different files" \
    render quad.plt -o - --json -
misused "hits and statistics do not share a file" "two different files" trace quad.plt r h --json h
misused "a picture for a program is not drawn over" "--show" render quad.plt -o - --show
misused "make knows its scenes" "'cube'" make cube -o x.ply
misused "make wants -o" "-o" make knot
misused "frames need names" "'{}'" make marbles --frames 2 -o x.ply
misused "a knot has no frames" "frames" make knot --frame 2 -o x.ply
misused "a knot has no seed" "seed" make knot --seed 2 -o x.ply
misused "a city has its triangles" "--triangles" make city --triangles 5 -o x.ply
misused "make refuses more triangles than it can" "10000000" make knot --triangles 10000001 -o x.ply
verdict "wrong usage wrote no file" "$(ls x x.* 2>/dev/null)"
finish

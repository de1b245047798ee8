#!/bin/sh
# test_compact.sh - compact nodes on the command line: flags, losses, statistics, errors
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin compact

run make knot --triangles 4000 -o knot.ply
quad quad.ply

# packs SENTENCE ARGUMENT...: status 0; the one line on standard error is what the
# lattice cost.
packs() {
    sentence=$1
    shift
    run pack "$@"
    verdict "$sentence" "$(
        [ "$status" -eq 0 ] || echo "status $status"
        trouble >said
        one_line said
        grep -q ': lattice of [0-9]* bits: vertices moved by up to .* of the longest side, ' err ||
            cat err)"
}

word() { # NAME: of the JSON on standard input
    sed -n "s/^  \"$1\": \"\(.*\)\",*\$/\1/p"
}

# ---- formats and statistics ------------------------------------------------------

for bits in 12 14 16 17 21; do
    for leaf in 1 2 4; do
        packs "pack --geometry lattice:$bits --leaf $leaf" knot.ply -o knot.plt --nodes compact \
            --geometry lattice:$bits --leaf $leaf
        run info knot.plt --json
        verdict "... info: format, bits, and parts that add up" "$(
            [ "$(word node_format <out) $(word geometry_format <out)" = "compact lattice" ] ||
                cat out
            [ "$(number lattice_bits <out)" = $bits ] || echo "$(number lattice_bits <out) bits"
            [ "$(number leaf_triangles <out)" = $leaf ] || cat out
            [ "$(number image_bytes <out)" -eq "$(wc -c <knot.plt)" ] || echo "image_bytes"
            n=$(number triangles <out)
            nodes=$(number nodes <out) units=$(($(number leaf_lists <out) + \
                $(number intermediate_lists <out)))
            blocks=$(number treelets <out)
            [ "$units" -eq $((nodes + 1)) ] || echo "$units units below $nodes nodes"
            [ $((64 * blocks)) -ge "$nodes" ] || echo "$nodes nodes in $blocks blocks"
            tree=$(number tree_bytes <out) geometry=$(number geometry_bytes <out)
            sed -n '/bytes_per_triangle": {/,/}/s/^    "\([a-z_]*\)": \([0-9.]*\),*$/\1 \2/p' out |
                awk -v n="$n" -v tree="$tree" -v geometry="$geometry" '
                $1 != "numbers" { sum += $2 }
                END {
                    off = sum * n - tree - geometry
                    if (NR != 15 || off * off > 9) { print NR " parts, off by " off }
                }')"
    done
done
verdict "info without --json says the same" "$(
    run info knot.plt
    grep -q '^lattice  *21 bits; ' out || cat out
    for part in planes owners kinds links frames headers padding positions references strips; do
        grep -q "^  $part .* per triangle" out || echo "not a word of $part"
    done)"
run pack knot.ply -o bits.plt --nodes compact
run info bits.plt --json
verdict "a lattice has 16 bits unless said otherwise" "$(
    [ "$(number lattice_bits <out)" = 16 ] || cat out)"

for pair in 3e-4:12 1e-4:14 1e-5:17 1e-6:20 5.3e-7:21; do
    packs "pack --tolerance ${pair%:*}" knot.ply -o knot.plt --nodes compact \
        --tolerance "${pair%:*}"
    verdict "... chooses the bits for it, and reports moves within it" "$(
        moved=$(sed -n 's/.*moved by up to \([-+0-9.e]*\) of.*/\1/p' err)
        awk "BEGIN { exit !($moved <= ${pair%:*}) }" || echo "moved by $moved"
        run info knot.plt --json
        [ "$(number lattice_bits <out)" -ge "${pair#*:}" ] || number lattice_bits <out)"
done

packs "pack --numbers none" knot.ply -o none.plt --nodes compact --numbers none
run info none.plt --json
verdict "... leaves the numbers out" "$([ "$(number number_bytes <out)" = 0 ] || cat out)"
packs "pack --numbers keep" knot.ply -o keep.plt --nodes compact --numbers keep
same keep.plt bits.plt "... is what is done unless said otherwise"
verdict "... and costs what info says" "$(
    run pack knot.ply -o keep.plt --nodes compact --checks off
    run info keep.plt --json
    [ $((($(wc -c <keep.plt) - $(wc -c <none.plt)))) -eq "$(number number_bytes <out)" ] ||
        cat out)"

for most in 2 100 1500 1000000; do
    packs "pack --reduce $most" knot.ply -o small.plt --nodes compact --reduce $most
    run info small.plt --json
    verdict "... leaves at most so many triangles" "$(
        n=$(number triangles <out)
        [ "$n" -le $most ] && [ "$n" -gt 0 ] || echo "$n"
        [ $most -ne 1500 ] || [ "$n" -gt $((most / 2)) ] || echo "only $n")"
done
refused "pack --reduce 1 of a closed mesh, which would leave nothing" knot.ply \
    '--reduce 1 leaves none of its [0-9]* triangles' \
    pack knot.ply -o none.plt --nodes compact --reduce 1
least=$(sed -n 's/.*; use --reduce \([0-9]*\) or more$/\1/p' err)
run pack knot.ply -o small.plt --nodes compact --reduce "$least"
run info small.plt --json
verdict "... and the number that it proposes leaves something" "$(
    n=$(number triangles <out)
    [ "${n:-0}" -ge 1 ] && [ "$n" -le "$least" ] || cat err out)"
run pack knot.ply -o reduced.plt --reduce 1500
verdict "--reduce goes with thesis nodes, too" "$(
    [ "$status" -eq 0 ] || cat err
    run info reduced.plt --json
    [ "$(number triangles <out)" -le 1500 ] || cat out)"

run pack knot.ply -o float.plt --nodes compact --geometry float
verdict "compact nodes with float geometry: nothing is lost, and nothing said" "$(
    [ "$status" -eq 0 ] || echo "status $status"
    cat err
    run info float.plt --json
    [ "$(word node_format <out) $(word geometry_format <out)" = "compact float" ] || cat out
    [ "$(number source_triangles <out)" = "$(number triangles <out)" ] || cat out)"

# ---- what the lattice cost --------------------------------------------------------

# sliver HEIGHT: a square, and a sliver whose middle corner a coarse lattice moves
# onto the long edge.
sliver() {
    sed "s/vertex 4/vertex 7/; s/face 2/face 3/; s/^0 1 0\$/0 1 0\n0 0 1\n0.5 $1 1\n1 0 1/" quad.ply
    echo '3 4 5 6'
}

sliver 0.00002 >mended.ply
packs "a sliver on a lattice of 14 bits" mended.ply -o sliver.plt --nodes compact \
    --geometry lattice:14
verdict "... is mended: its corner moves to the next number" "$(
    grep -q ' 0 triangles lost their area (0 had none).* 0 T-junctions (1 mended)' err || cat err)"
sliver 0.000001 >sliver.ply
packs "a sliver that is too thin to be mended" sliver.ply -o sliver.plt --nodes compact \
    --geometry lattice:14
verdict "... is lost, reported as a T-junction, and a finer lattice is proposed" "$(
    grep -q ' 1 triangle lost its area (0 had none)' err &&
        grep -q ' 1 T-junction ' err &&
            grep -q '; --geometry lattice:21 keeps more of them, --geometry float all$' err ||
            cat err
    run info sliver.plt --json
    [ "$(number triangles <out) $(number source_triangles <out)" = "2 3" ] || cat out)"
packs "a sliver on a lattice of 21 bits" mended.ply -o sliver.plt --nodes compact \
    --geometry lattice:21
verdict "... is kept" "$(grep -q ' 0 triangles lost their area' err || cat err)"

# ---- where vertices stay ---------------------------------------------------------------

packs "a square of whole corners" quad.ply -o quad.plt --nodes compact
verdict "... moves by nothing, with a step of a power of two" "$(
    grep -q ' moved by up to 0 of .*; step 1, 4 of 4 vertices stayed exactly where they were' err ||
        cat err)"
sed 's/^1 1 0$/1 0.7 0/' quad.ply >odd.ply
packs "one with a corner between" odd.ply -o odd.plt --nodes compact
verdict "... has any step, and keeps the corners that lie at 0" "$(
    grep -q '; step 1.5[0-9]*e-05, [0-3] of 4 vertices stayed' err || cat err)"
packs "... with --step power" odd.ply -o odd.plt --nodes compact --step power
verdict "... has one of a power of two, and keeps all of its round corners" "$(
    grep -q '; step 3.05175781e-05, 3 of 4 vertices stayed exactly where they were' err || cat err)"
for pair in 3e-4 1e-4 3e-5 1e-6; do
    packs "... and --tolerance $pair" odd.ply -o odd.plt --nodes compact --step power \
        --tolerance $pair
    verdict "... moves no farther" "$(
        moved=$(sed -n 's/.*moved by up to \([-+0-9.e]*\) of.*/\1/p' err)
        awk "BEGIN { exit !($moved <= $pair && $moved > 0) }" || echo "moved by $moved")"
done
printf 'v 0 0 0\nv 1 0 0\nv 0.5001 1e-9 0\nf 1 2 3\n' >line.obj
run pack line.obj -o line.plt --nodes compact --geometry lattice:12
verdict "a sliver alone that is lost has moved by a part of its own length" "$(
    moved=$(sed -n 's/.*moved by up to \([-+0-9.e]*\) of.*/\1/p' err)
    awk "BEGIN { exit !(${moved:-1} >= 0.9e-4 && ${moved:-1} <= 2.1e-4) }" || cat err)"

# ---- wrong values -------------------------------------------------------------------

for value in lattice:11 lattice:22 lattice: lattice:x lattice:14x lattice:-14 lattices double; do
    misused "pack refuses --geometry $value" --geometry \
        pack quad.ply -o x --nodes compact --geometry $value
done
for pair in --tolerance=0 --tolerance=-1 --tolerance=1e-8 --tolerance=x --tolerance=nan \
    --numbers=some --step=two --reduce=0 --reduce=-5 --reduce=x --nodes=bvh --leaf=3; do
    misused "pack refuses $pair" "${pair%=*}" \
        pack quad.ply -o x --nodes compact "${pair%=*}" "${pair#*=}"
done
misused "pack refuses --treelet with compact nodes" compact \
    pack quad.ply -o x --nodes compact --treelet 64
misused "pack refuses --build none with compact nodes" compact \
    pack quad.ply -o x --nodes compact --build none
misused "pack refuses float geometry for a device to build blocks over" --build \
    pack quad.ply -o x --nodes compact --geometry float --build device
misused "pack refuses a tolerance for float geometry" --tolerance \
    pack quad.ply -o x --nodes compact --geometry float --tolerance 1e-3
for pair in --geometry=lattice:14 --tolerance=1e-3 --numbers=none --step=power; do
    misused "pack refuses $pair with thesis nodes" "${pair%=*}" \
        pack quad.ply -o x "${pair%=*}" "${pair#*=}"
done
verdict "... and no image is left behind" "$(ls x 2>/dev/null; left_behind)"

sed 's/^0 /1000 /; s/^1 /1001 /; s/^\([0-9]* \)1 0$/\10.7 0/' quad.ply >far.ply
refused "a mesh too far from the origin for its lattice" far.ply \
    'a lattice of 21 bits is finer than floats are that far from the origin; use --centre, ' \
    pack far.ply -o far.plt --nodes compact --geometry lattice:21
fewer=$(sed -n 's/.*fewer bits (--geometry \(lattice:[0-9]*\))$/\1/p' err)
packs "... is packed on a coarser one, as proposed" far.ply -o far.plt --nodes compact \
    --geometry "$fewer"
sed 's/^0 /100000 /; s/^1 /100001 /; s/^\([0-9]* \)1 0$/\10.7 0/' quad.ply >far.ply
refused "a mesh too far from the origin for any lattice" far.ply \
    'a lattice of 16 bits is finer than .* origin; use --centre or --nodes thesis$' \
    pack far.ply -o far.plt --nodes compact
sed 's/^0 /100000 /; s/^1 /100001 /' quad.ply >far.ply
packs "... but not where its corners lie on one" far.ply -o far.plt --nodes compact
verdict "... exactly" "$(grep -q ' moved by up to 0 of .* step 1, 4 of 4' err || cat err)"
sed 's/^0 /0e-36 /; s/^1 1/1e-36 1e-36/; s/^1 /1e-36 /; s/^0e-36 1/0 1e-36/' quad.ply >tiny.ply
refused "a mesh too small for a lattice" tiny.ply \
    'too small for a lattice; scale it up: pack a text file, .*, with the line FILE 1 0 0 0' \
    pack tiny.ply -o tiny.plt --nodes compact
echo 'tiny.ply 1 0 0 0' >scene.txt
packs "... is packed by way of that file" scene.txt -o tiny.plt --nodes compact

# ---- render and trace ------------------------------------------------------------------

frame_hash() { # IMAGE RENDER-OPTION...
    name=$1
    shift
    run render "$name" -o frame.ppm --size 96x64 --json - "$@"
    sed -n 's/^  "frame_hash": "\(.*\)",*$/\1/p' out
}

for leaf in 1 2 4; do
    flags="--nodes compact --geometry lattice:14 --leaf $leaf"
    # shellcheck disable=SC2086
    run pack knot.ply -o host.plt $flags
    # shellcheck disable=SC2086
    run pack knot.ply -o device.plt $flags --build device
    verdict "$flags: one picture, whoever builds and from wherever it is read" "$(
        wanted=$(frame_hash host.plt)
        [ -n "$wanted" ] || cat err
        for run in "host.plt --packet 2" "host.plt --packet 16" "host.plt --source read" \
            "device.plt" "device.plt --source read" "device.plt --packet 4"; do
            # shellcheck disable=SC2086
            [ "$(frame_hash $run)" = "$wanted" ] || echo "another with $run: $(cat err)"
        done)"
    verdict "... shaded by normals, too" "$(
        wanted=$(frame_hash host.plt --shader normal)
        [ "$(frame_hash device.plt --shader normal)" = "$wanted" ] || echo "another")"
done

# A square on a lattice: whole corners stay what they are, so do its hits.
run pack quad.ply -o thesis.plt
run pack quad.ply -o quad.plt --nodes compact --geometry lattice:12
run pack quad.ply -o position.plt --nodes compact --geometry lattice:12 --numbers none
printf '0.75 0.25 5 0 0 0 -1 100\n0.2 0.7 5 0 0 0 -1 100\n4 4 5 0 0 0 -1 100\n' | rays ray
for name in thesis quad position; do
    run trace $name.plt ray $name.hit
    hits $name.hit >$name.txt
done
verdict "hits of a square on a lattice: distance and primitive id" "$(
    awk '{ print ($4 < 4294967295) ? $1 " " $4 : "miss" }' quad.txt >found
    printf '5 0\n5 1\nmiss\n' | diff - found)"
verdict "... with positions as primitive ids, the same distances" "$(
    awk '{ print $1 }' quad.txt >wanted
    awk '{ print $1 }' position.txt | diff wanted -)"

run pack knot.ply -o knot.plt --nodes compact
for command in "render knot.plt -o x.png" "trace knot.plt ray hit"; do
    # shellcheck disable=SC2086
    run $command --walk two-stage
    verdict "${command%% *} refuses the two-stage order for compact blocks in one line" "$(
        [ "$status" -eq 1 ] || echo "status $status"
        one_line
        grep -q '^knot.plt: compact blocks and streamed scenes are traversed depth first' err ||
            cat err
        ls x.png hit 2>/dev/null)"
done

# ---- coordinates at the limit ------------------------------------------------------------

printf 'v 1099511627776 0 0\nv -1099511627776 0 0\nv 0 10 1099511627776\nf 1 2 3\n' >limit.obj
for bits in 12 13 14 15 16 17 18 19 20 21; do
    for step in auto power; do
        run pack limit.obj -o limit.plt --nodes compact --geometry lattice:$bits --step $step
        works "corners at 2^40 stay within it on $bits bits, step $step" info limit.plt
    done
done

# ---- the smallest scenes, determinism -------------------------------------------------

sed '/^3 0 2/d; s/face 2/face 1/' quad.ply >one.ply
echo '0.75 0.25 5 0 0 0 -1 100' | rays ray
for build in host device; do
    for leaf in 1 2 4; do
        for count in one:0 quad:0; do
            name=${count%%:*}
            verdict "pack, info, render and trace $name with --build $build --leaf $leaf" "$(
                run pack "$name.ply" -o tiny.plt --build "$build" --leaf "$leaf" --nodes compact
                [ "$status" -eq 0 ] || cat err
                run info tiny.plt
                cat err
                run render tiny.plt -o tiny.png --size 32x32
                cat err
                run trace tiny.plt ray hit
                cat err
                [ "$(hits hit | awk '{ print $4 }')" = "${count#*:}" ] || hits hit)"
        done
    done
    rm -f once.plt twice.plt
    run pack knot.ply -o once.plt --build $build --nodes compact
    run pack knot.ply -o twice.plt --build $build --nodes compact
    same once.plt twice.plt "packing with --build $build twice gives the same bytes"
done
finish

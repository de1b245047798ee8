#!/bin/sh
# test_pack.sh - make, pack and info: every flag, every field, the smallest scenes
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin pack

# ---- make ------------------------------------------------------------------

header() {
    awk '/^end_header/ { exit } { print }' "$1" | tr -d '\r'
}
triangles() {
    header "$1" | awk '$1 == "element" && $2 == "face" { print $3 }'
}

for scene in ground:12:12 marbles:8800:8800 city:44844:44844 \
    terrain:90000:110000 knot:90000:110000; do
    name=${scene%%:*} range=${scene#*:}
    works "make $name" make "$name" -o "$name.ply"
    run make "$name" -o -
    same out "$name.ply" "... writes the same bytes to standard output"
    verdict "... has the triangles it should" "$(
        count=$(triangles "$name.ply")
        [ "$count" -ge "${range%:*}" ] && [ "$count" -le "${range#*:}" ] || echo "$count")"
done
works "make knot --triangles 2000" make knot --triangles 2000 -o small.ply
verdict "... makes about so many" "$(
    count=$(triangles small.ply)
    [ "$count" -gt 1600 ] && [ "$count" -le 2400 ] || echo "$count")"
works "make marbles --frames 3 --frame 8" make marbles --frames 3 --frame 8 -o 'roll_{}.ply'
verdict "... writes frames 8 to 10" "$(
    [ "$(ls roll_*.ply | tr '\n' ' ')" = "roll_008.ply roll_009.ply roll_010.ply " ] || ls)"
works "make marbles --triangles 2400 --frame 8" make marbles --triangles 2400 --frame 8 -o few.ply
verdict "... makes 29 of them, and the tray" "$(
    [ "$(triangles few.ply)" -eq 2400 ] || triangles few.ply)"
works "make marbles --frame 9" make marbles --frame 9 -o nine.ply
same nine.ply roll_009.ply "... is that frame"
verdict "marbles roll" "$(differ roll_008.ply roll_009.ply)"

# ---- pack and info ---------------------------------------------------------

fields='triangles nodes leaf_lists intermediate_lists treelets treelet_nodes tree_bytes
    tree_bytes_per_triangle geometry_bytes geometry_bytes_per_triangle slot_overhead_bytes
    local_stack_entries global_stack_entries arena_bytes_needed node_slots leaf_triangles
    image_bytes depth_stack_entries arena_bytes_needed_fetched'

# info_of IMAGE: every number of its JSON as a variable of that name.
info_of() {
    run info "$1" --json
    cp out info.json
    eval "$(sed -n 's/^  "\([a-z_]*\)": \([-+.e0-9]*\),*$/\1=\2/p' info.json)"
}

# check_info MESH IMAGE K N: the JSON's values against arithmetic on each other.
check_info() {
    info_of "$2"
    # shellcheck disable=SC2086
    flat_json info.json $fields
    equal <<END
triangles of the mesh|$triangles|$(triangles "$1")
K|$leaf_triangles|$3
N|$treelet_nodes|$4
size of the file|$image_bytes|$(wc -c <"$2")
tree: 32 bytes per slot|$tree_bytes|$((32 * node_slots))
geometry: 40 bytes per triangle|$geometry_bytes|$((40 * triangles))
children of n nodes|$((leaf_lists + intermediate_lists))|$((nodes + 1))
free slots|$slot_overhead_bytes|$((32 * (node_slots - nodes)))
whole slots of N nodes|$((node_slots % treelet_nodes))|0
tree per triangle|$tree_bytes_per_triangle|$(
    awk "BEGIN { printf \"%.3f\", $tree_bytes / $triangles }")
geometry per triangle|$geometry_bytes_per_triangle|40
END
    lists=$((leaf_lists + 2 * intermediate_lists))
    [ $((lists * $3)) -ge "$triangles" ] || echo "$lists lists of $3 do not hold $triangles"
    [ "$lists" -le "$triangles" ] || echo "there are empty lists"
    [ "$depth_stack_entries" -le 65 ] || echo "$depth_stack_entries levels"
    [ "$arena_bytes_needed_fetched" -ge $((arena_bytes_needed + tree_bytes + geometry_bytes)) ] ||
        echo "a fetched scene does not fit"
}

for leaf in 1 2 4; do
    for splits in sah median; do
        for treelet in 1 7 64 10000; do
            flags="--leaf $leaf --splits $splits --treelet $treelet"
            # shellcheck disable=SC2086
            run pack small.ply -o small.plt $flags
            verdict "pack $flags: the values of info fit together" "$(
                cat err
                check_info small.ply small.plt "$leaf" "$treelet"
                grep -q "\"splits\": \"$splits\"" info.json || echo "splits are not $splits"
                grep -q '"build": "host"' info.json || echo "not built by the host")"
        done
    done
done

# of_treelets FIELD FILE: of the first size that pack --json has.
of_treelets() {
    sed -n "s/.*\"$1\": \([0-9]*\).*/\1/p" "$2" | head -n 1
}
for fill in bfs area full; do
    for slots in thesis newest none; do
        for treelet in 1 7 64 10000; do
            flags="--fill $fill --slots $slots --treelet $treelet"
            # shellcheck disable=SC2086
            run pack small.ply -o small.plt $flags --json pack.json
            verdict "pack $flags: the values of info fit together" "$(
                cat err
                check_info small.ply small.plt 2 "$treelet"
                free=$(of_treelets free_slots pack.json)
                [ "$fill $slots" = "bfs thesis" ] || [ "${free:-x}" = $((node_slots - nodes)) ] ||
                    echo "$free slots are free")"
        done
    done
done
run pack small.ply -o auto.plt --treelet auto --json pack.json
verdict "pack --treelet auto: one of the sizes that can be streamed" "$(
    cat err
    size=$(of_treelets size pack.json)
    case $size in
        8 | 16 | 32 | 64 | 128 | 256) check_info small.ply auto.plt 2 "$size" ;;
        *) echo "it is $size" ;;
    esac)"
run pack small.ply -o full.plt --treelet 16 --fill full --json full.json
run pack small.ply -o area.plt --treelet 16 --fill area --json area.json
verdict "treelets that are filled up are mostly complete" "$(
    full=$(of_treelets incomplete full.json) area=$(of_treelets incomplete area.json)
    [ "$full" -gt 0 ] && [ "$((2 * full))" -lt "$area" ] || echo "$full and $area are incomplete")"

run pack small.ply -o default.plt
run pack small.ply -o said.plt --build host --splits sah --leaf 2 --nodes thesis --treelet 64 \
    --fill bfs --slots thesis --geometry float --frame 0
same default.plt said.plt "the defaults are what the help says"
run pack small.ply -o -
same default.plt out "pack -o - writes the image to standard output"
"$PLANELET" pack - -o piped.plt <small.ply
same default.plt piped.plt "pack - reads the mesh from standard input"

run pack small.ply -o device.plt --build device
info_of device.plt
cp info.json device.json
verdict "info builds a device's tree to count it: the host's tree" "$(
    run info default.plt --json
    for name in triangles nodes node_slots leaf_lists intermediate_lists treelets \
        local_stack_entries global_stack_entries depth_stack_entries tree_bytes; do
        here=$(number "$name" <out) there=$(number "$name" <device.json)
        [ "$here" = "$there" ] || echo "$name: $here and $there"
    done
    grep -q '"build": "device"' device.json || echo "not built by the device")"
run pack small.ply -o none.plt --build none
info_of none.plt
verdict "an image without tree has one list" "$(
    grep -q '"build": "none"' info.json || cat info.json
    [ "$nodes $leaf_lists $intermediate_lists $treelets" = "0 1 0 0" ] || cat info.json)"

verdict "info without --json says the same" "$(
    info_of default.plt
    run info default.plt
    cat err
    for value in $triangles $nodes $node_slots $leaf_lists $intermediate_lists $treelets \
        $tree_bytes $geometry_bytes $slot_overhead_bytes $image_bytes $arena_bytes_needed \
        $arena_bytes_needed_fetched $depth_stack_entries $global_stack_entries; do
        grep -q "[^0-9.]$value\([^0-9]\|$\)" out || echo "not a word of $value"
    done)"

# ---- the parts of the arena --------------------------------------------------

# parts: "LIFETIME BYTES NAME" of every part in the JSON of info, file `info.json`.
parts() {
    sed -n 's/^    {"name": "\(.*\)", "bytes": \([0-9]*\), "lifetime": "\(.*\)"},*$/\3 \2 \1/p' \
        info.json
}

# check_parts IMAGE LEAST "LIFETIME..." [FLAG...]: trouble, unless there are so many parts of
# these lifetimes, which make up the need as planelet.h says, and the text has all of them.
check_parts() {
    image=$1 least=$2 lifetimes=$3
    shift 3
    run info "$image" --json "$@"
    cat err
    cp out info.json
    parts >parts
    [ "$(wc -l <parts)" -ge "$least" ] || cat parts
    [ "$(cut -d ' ' -f 1 parts | sort -u | tr '\n' ' ')" = "$lifetimes " ] || cat parts
    awk -v need="$(number arena_bytes_needed <info.json)" '
        $2 == 0 { print "of 0 bytes: " $0 }
        { sum[$1] += $2; name = $0; sub(/^[a-z]* [0-9]* /, "", name) }
        seen[name]++ { print "twice: " name }
        END {
            most = sum["runs"] + 0
            if (sum["builds"] > most) most = sum["builds"]
            if (sum["validates"] > most) most = sum["validates"]
            if (sum["stays"] + most != need) print sum["stays"] + most " is not " need
        }' parts
    run info "$image" "$@"
    sed -n '/^arena needed/,/^arena if/p' out | grep '^  ' >lines
    [ "$(wc -l <lines)" -eq "$(wc -l <parts)" ] || cat lines
    [ "$(grep -c 'given back$' lines)" -eq "$(grep -c '^[vb]' parts)" ] || cat lines
    while read -r lifetime bytes name; do
        grep -q "^  $name  *$bytes bytes" lines || echo "the text has no $name of $bytes bytes"
    done <parts
}

run pack small.ply -o compact.plt --nodes compact --geometry lattice:14
run pack small.ply -o compact_device.plt --nodes compact --geometry lattice:14 --build device
run pack small.ply -o roomy_device.plt --build device --leaf 1 --treelet 10000
for packet in 2 16; do
    flags="--packet $packet"
    # shellcheck disable=SC2086
    verdict "info $flags: the parts of an arena add up to what is needed" "$(
        check_parts default.plt 5 'runs stays validates' $flags
        check_parts default.plt 6 'runs stays validates' $flags --walk two-stage
        check_parts none.plt 5 'runs stays validates' $flags
        check_parts compact.plt 6 'runs stays validates' $flags
        check_parts device.plt 8 'builds runs stays validates' $flags
        check_parts roomy_device.plt 8 'builds runs stays validates' $flags
        check_parts compact_device.plt 7 'builds runs stays' $flags)"
done
verdict "larger packets need larger arenas" "$(
    before=0
    for packet in 2 4 8 16; do
        run info default.plt --json --packet "$packet"
        now=$(number arena_bytes_needed <out)
        [ "$now" -ge "$before" ] || echo "packet $packet: $now after $before"
        [ "$packet" -lt 8 ] || [ "$now" -gt "$before" ] || echo "packet $packet: still $now"
        before=$now
    done)"
verdict "the two-stage order needs another arena" "$(
    run info default.plt --json --walk two-stage
    [ "$(number arena_bytes_needed <out)" -gt 0 ] || cat out)"
verdict "info gives the box of the mesh" "$(
    quad quad.ply
    run pack quad.ply -o quad.plt
    run info quad.plt --json
    grep -q '"lo": \[0, 0, 0\],' out && grep -q '"hi": \[1, 1, 0\]' out || cat out)"

# ---- several meshes, recipes, repair ---------------------------------------

works "two meshes are one scene" pack small.ply quad.ply -o both.plt
info_of both.plt
verdict "... of all their triangles" "$(
    [ "$triangles" -eq $(($(triangles small.ply) + 2)) ] || echo "$triangles")"
cp roll_008.ply roll_000.ply
cp roll_009.ply roll_001.ply
cp roll_010.ply roll_002.ply
echo 'roll_{}.ply*3 1 0 0 0' >rolling.txt
for frame in 0 1 2; do
    works "a recipe of a sequence, frame $frame" pack rolling.txt -o "frame$frame.plt" \
        --frame "$frame"
done
echo 'roll_000.ply 1 0 0 0' >standing.txt
run pack standing.txt -o standing.plt
same frame0.plt standing.plt "... frame 0 is the first file of the sequence"
verdict "... and the frames differ" "$(
    differ frame0.plt frame1.plt
    differ frame1.plt frame2.plt)"
# The recipe in the help, with a floor of 4 x 3 at y = 7 and three statues, taller each.
run pack --help
sed -n '/^A recipe/,/^FILE/s/^  //p' out >shown.txt
awk '/^end_header/ { on = 1; print; next } on && NF == 3 { print 4 * $1, 7, 3 * $2; next } 1' \
    quad.ply >floor.ply
cp small.ply knot.ply
for i in 0 1 2; do
    awk -v i=$i '/^end_header/ { on = 1; print; next } on && NF == 3 { $2 *= i + 2 } 1' \
        quad.ply >walk_00$i.ply
done
verdict "the help of pack shows a recipe of three meshes" "$(
    [ "$(grep -c '^[a-z]' shown.txt)" -eq 3 ] || cat shown.txt)"
for frame in 0 1 2 5; do
    number=$(((frame + 1) % 3))
    sed "s/walk_.*+1 /walk_00$number.ply /" shown.txt >named.txt
    run pack named.txt -o named.plt
    works "... --frame $frame packs it" pack shown.txt -o shown.plt --frame $frame
    same shown.plt named.plt "... with walk_00$number.ply"
done
verdict "... the floor is 20 x 15 about the origin, at y = 0, and the knot 4 long on it" "$(
    echo 'floor.ply 20 0 0 0' >floor.txt
    grep '^knot' shown.txt >lies.txt
    for name in floor lies; do
        run pack $name.txt -o $name.plt
        run info $name.plt --json
        cat err
        sed -n 's/^  "\(lo\|hi\)": \[\(.*\)\].*/\2/p' out | tr -d , | tr '\n' ' ' >$name.box
    done
    [ "$(cat floor.box)" = "-10 0 -7.5 10 0 7.5 " ] || cat floor.box
    awk '{ x = $4 - $1; y = $5 - $2; z = $6 - $3; most = x > y ? x : y; most = most > z ? most : z
        if (most < 3.9999 || most > 4.0001 || $2 < -1e-5 || $2 > 1e-5 ||
            ($3 + $6) / 2 < -3.0001 || ($3 + $6) / 2 > -2.9999) { print } }' lies.box)"
sed 's/^1 1 0$/1 nan 0/' quad.ply >nan.ply
run pack nan.ply small.ply -o repaired.plt --repair
verdict "pack --repair says what it dropped, and that nothing is left of a file" "$(
    [ "$status" -eq 0 ] || echo "status $status"
    equal <<END
lines|$(wc -l <err)|2
what was dropped|$(sed -n 1p err)|nan.ply: dropped 2 faces that cannot be traced, 1 vertex that \
is not finite or is beyond +-2^40
what is left|$(sed -n 2p err)|nan.ply: 4 vertices, no faces: nothing to trace; mend them in the \
program that wrote them
END
)"
run pack small.ply -o clean.plt --repair
same clean.plt default.plt "pack --repair changes nothing in a clean mesh"
verdict "... and has nothing to say" "$(cat err)"

# ---- zero, one, two triangles ------------------------------------------------

sed '/^3 /d; s/face 2/face 0/' quad.ply >zero.ply
refused "pack: vertices without faces" zero.ply "4 vertices, no faces: nothing to trace" \
    pack zero.ply -o zero.plt
verdict "... and no image" "$(ls zero.plt 2>/dev/null)"
sed '/^3 0 2/d; s/face 2/face 1/' quad.ply >one.ply
echo '0.75 0.25 5 0 0 0 -1 100' | rays ray
for build in host device none; do
    for leaf in 1 2 4; do
        for count in one:1:0 quad:2:0; do
            name=${count%%:*} rest=${count#*:}
            verdict "pack, info, render and trace $name with --build $build --leaf $leaf" "$(
                run pack "$name.ply" -o tiny.plt --build "$build" --leaf "$leaf"
                trouble
                info_of tiny.plt
                # shellcheck disable=SC2086
                flat_json info.json $fields
                [ "$triangles" = "${rest%:*}" ] || echo "$triangles triangles"
                run info tiny.plt
                cat err
                run render tiny.plt -o tiny.png --size 32x32
                cat err
                [ -s tiny.png ] || echo "no picture"
                run trace tiny.plt ray hit
                cat err
                [ "$(hits hit | awk '{ print $4 }')" = "${rest#*:}" ] || hits hit)"
        done
    done
done

# ---- determinism -------------------------------------------------------------

for build in host device none; do
    rm -f once.plt twice.plt
    run pack terrain.ply -o once.plt --build "$build"
    run pack terrain.ply -o twice.plt --build "$build"
    same once.plt twice.plt "packing with --build $build twice gives the same bytes"
done
finish

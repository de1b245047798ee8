#!/bin/sh
# test_bench.sh - planelet bench: every scene, kind of ray, structure and mode, counted right
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin bench
run make knot --triangles 2000 -o knot.ply
run pack knot.ply -o knot.plt
run pack knot.ply -o compact.plt --nodes compact

# rows FILE: "KEY=VALUE ..." of each row of bench's JSON.
rows() {
    sed -n 's/^    {\(.*\)},*$/\1/p' "$1" | sed 's/"\([a-z_]*\)": "*\([^",]*\)"*/\1=\2/g
        s/, / /g'
}

# combinations FILE: what differs between rows, a line each.
combinations() {
    rows "$1" | awk '{
        line = ""
        for (i = 1; i <= NF; i++)
            if ($i ~ /^(nodes|kind|hit|packet|walk)=/) { sub(/.*=/, "", $i); line = line " " $i }
        print line }' | sort
}

# counts WHICH: of those rows what the processor has no part in.
counts() {
    grep "$1" | sed 's/scene=[^ ]*//; s/[a-z]*_rays_per_s=[0-9]*//g
        s/\(instructions\|cycles\|branch_misses\)=[0-9]*//g'
}

small='--size 37x50 --repeat 2'
# shellcheck disable=SC2086
works "bench MESH --json FILE" bench knot.ply $small --json stats
cp out table
verdict "... JSON of flat objects" "$(flat_json stats repeat width height)"
verdict "... every kind, hit, structure, packet and order once" "$(
    for kind in primary shadow light bounce random outside inside; do
        for hit in closest any; do
            for packet in 2 4 8 16; do
                echo " thesis $kind $hit $packet depth"
                echo " thesis $kind $hit $packet two-stage"
                echo " compact $kind $hit $packet depth"
            done
            echo " thesis $kind $hit 0 wave"
            echo " thesis $kind $hit 0 wide"
            echo " compact $kind $hit 0 wave"
            echo " compact $kind $hit 0 wide"
        done
    done | sort >wanted
    combinations stats | diff wanted -)"
verdict "... as many rays as their kind has, of the same hits in every mode" "$(
    rows stats | awk '
        {
            for (i = 1; i <= NF; i++) { split($i, part, "="); v[part[1]] = part[2] }
            if (v["triangles"] != 1980 && v["triangles"] != 2000) print "triangles: " $0
            hits = v["hits_hash"] " " v["hits"] " " v["rays"]
            key = v["nodes"] " " v["kind"] " " v["hit"]
            if (key in seen && seen[key] != hits) print key ": " hits ", before " seen[key]
            seen[key] = hits
            rays[v["kind"]] = v["rays"]
            hit[v["nodes"] v["kind"] v["hit"]] = v["hits"]
        }
        END {
            if (rays["primary"] != 37 * 50 || rays["random"] != 37 * 50 ||
                rays["outside"] != 37 * 50 || rays["inside"] != 37 * 50)
                print "not a ray per pixel"
            if (rays["shadow"] != hit["thesisprimaryclosest"]) print "not a shadow ray per hit"
            if (rays["bounce"] != rays["shadow"]) print "not a bounce ray per hit"
            if (rays["light"] != rays["shadow"]) print "not a ray of the light per hit"
            off = hit["thesislightany"] - hit["thesisshadowany"]
            if (off * off > 4) print off " more in the shade, seen from the light"
            for (key in hit) if (hit[key] < 20) print key " hits " hit[key]
            for (kind in rays)
                for (i = 1; i <= 2; i++) {
                    nodes = i == 1 ? "thesis" : "compact"
                    if (hit[nodes kind "any"] != hit[nodes kind "closest"])
                        print kind ": any finds " hit[nodes kind "any"] ", not " \
                            hit[nodes kind "closest"]
                }
        }')"
verdict "... figures that fit together" "$(
    rows stats | awk '{
        for (i = 1; i <= NF; i++) { split($i, part, "="); v[part[1]] = part[2] }
        if (v["least_rays_per_s"] + 0 > v["median_rays_per_s"] + 0 ||
            v["median_rays_per_s"] + 0 > v["most_rays_per_s"] + 0 || v["least_rays_per_s"] < 1000)
            print "rates: " $0
        if (v["node_visits"] < 10 || v["group_tests"] < v["node_visits"] ||
            v["triangle_tests"] < 100) print "tests: " $0
        if ("instructions" in v && v["instructions"] < 100 * v["rays"]) print "counted: " $0 }')"
for packet in 2 16; do
    run info knot.plt --json --packet $packet --walk two-stage
    need=$(number arena_bytes_needed <out)
    verdict "... the arena that info says, packets of $packet" "$(
        rows stats | grep "nodes=thesis .*packet=$packet walk=two-stage" |
            grep -v "arena_bytes_needed=$need\$")"
done
verdict "the table has a row for each, titles, and a star for the best of each structure" "$(
    rays='^(primary|shadow|light|bounce|random|outside|inside) '
    [ "$(grep -cE "$rays" table)" -eq 224 ] || cat table
    grep -q '^rays  *hits  *nodes  *packet  *walk  *Mray/s  *least  *spread ' table || cat table
    [ "$(grep -c '\*' table)" -ge 28 ] && [ "$(grep -c '\*' table)" -lt 70 ] || cat table)"
verdict "what the system does not count is said in one line" "$(
    if grep -q '^rays .*instr  *cycles  *misses' table; then
        grep 'not granted' table
    else
        [ "$(tail -n 1 table | grep -c '^not granted by the system: .*(.*)$')" -eq 1 ] ||
            tail -n 2 table
    fi)"
verdict "no figure of the table is wider than its column" "$(
    awk '/^(primary|shadow|light|bounce|random|outside|inside) / {
        if (width && length != width) print
        width = length }' table)"

# ---- the same visits as trace counts, and the same rays every time ------------------------------

# shellcheck disable=SC2086
{
    works "bench two images --json -" bench knot.plt compact.plt $small --json - \
        --kinds primary,bounce
    cp out again
    verdict "... no table beside it" "$(flat_json again repeat)"
    verdict "... an image is measured as the mesh was: the same rays, visits and hits" "$(
        for kind in primary bounce; do
            rows stats | counts "nodes=thesis kind=$kind " >one
            rows again | counts "nodes=thesis kind=$kind " | diff one -
        done)"
    verdict "... and each under its name" "$(
        [ "$(grep -c '"scene": "knot.plt"' again)" -eq 40 ] || grep -c knot.plt again
        [ "$(grep -c '"scene": "compact.plt"' again)" -eq 24 ] || grep -c compact.plt again)"
    "$PLANELET" bench - $small --packets 8 --kinds primary --json - <compact.plt >piped 2>err
    verdict "an image may come from standard input" "$(
        cat err
        combinations piped | sort -u | wc -l | grep -qx 6 || cat piped
        grep -q '"scene": "standard input"' piped || cat piped)"
    works "lists choose what is measured" bench knot.ply $small --json - --kinds random,shadow \
        --hits any --nodes compact --packets 16,2 --walks depth
    verdict "... the same rays as among all kinds" "$(
        for kind in random shadow; do
            for figures in stats out; do
                rows $figures | grep "nodes=compact kind=$kind hit=any packet=16 " |
                    sed 's/.*\( rays=[0-9]* hits=[0-9]* hits_hash=[0-9a-f]*\).*/\1/' >one.$figures
            done
            [ -s one.out ] && diff one.stats one.out
        done)"
    verdict "... that and nothing else" "$(
        for kind in random shadow; do
            for packet in 2 16; do
                echo " compact $kind any $packet depth"
            done
        done | sort >wanted
        combinations out | diff wanted -)"
    works "the device's image is built and measured" bench knot.ply $small --packets 8
    run pack knot.ply -o device.plt --build device
    works "... as the host's" bench device.plt $small --packets 8 --walks depth,two-stage \
        --kinds primary --json -
    verdict "... with the same visits" "$(
        rows out | sed 's/.*\(node_visits=[0-9]*\).*/\1/' >device
        rows stats | grep 'nodes=thesis kind=primary .* packet=8' |
            sed 's/.*\(node_visits=[0-9]*\).*/\1/' | diff device -)"
}

# ---- a closed room, from inside -----------------------------------------------------------------

run make room --triangles 24000 -o room.ply
works "bench of a closed room, from inside" bench room.ply --size 40x40 --repeat 1 --json - \
    --packets 8 --eye 2.7,1.6,2.1 --look -0.9,0.72,-0.7 --fov 60
verdict "... every ray hits but those from outside in random directions" "$(
    rows out | awk '
        {
            for (i = 1; i <= NF; i++) { split($i, part, "="); v[part[1]] = part[2] }
            if (v["kind"] == "outside") outside++
            if (v["kind"] == "outside" ? v["hits"] == v["rays"] || v["hits"] < v["rays"] / 10 \
                : v["hits"] != v["rays"]) print v["kind"] ": " v["hits"] " of " v["rays"]
        }
        END { if (outside != 14) print outside " rows of rays from outside" }')"

# ---- other structures, as rows of the same table ------------------------------------------------

# shellcheck disable=SC2086
{
    works "bench MESH --structures" bench knot.ply $small --kinds primary,shadow --json listed \
        --structures '  wbvh:bits  engine kd:single bvh:4x4 tree '
    cp out table
    verdict "... rows of the engine are as without them" "$(
        for kind in primary shadow; do
            rows stats | counts "nodes=thesis kind=$kind " >one
            rows listed | counts "nodes=thesis kind=$kind " | diff one -
        done
        rows listed | grep -c 'structure=engine ' | grep -qx 40 || grep -c engine listed)"
    verdict "... each structure has its packets, kinds and questions, and its own counts" "$(
        rows listed | awk '
            {
                split("", v)
                for (i = 1; i <= NF; i++) { split($i, part, "="); v[part[1]] = part[2] }
                hits = v["hits_hash"] " " v["hits"] " " v["rays"]
                key = v["kind"] " " v["hit"]
                if (key in seen && seen[key] != hits) print $0 ": before " seen[key]
                seen[key] = hits
            }
            v["structure"] != "engine" {
                count[v["structure"] " " v["packet"]]++
                if ("nodes" in v || "walk" in v || "arena_bytes_needed" in v) print "engine: " $0
                if (v["node_visits"] < 10 || v["group_tests"] < 10 || v["triangle_tests"] < 10 ||
                    v["structure_bytes"] < 1000 || v["build_seconds"] <= 0) print "counts: " $0
            }
            END {
                due = "wbvh:bits 2,wbvh:bits 4,wbvh:bits 8,wbvh:bits 16,kd:single 0,bvh:4x4 4,"
                due = due "tree 2,tree 4,tree 8,tree 16"
                n = split(due, row, ",")
                for (i = 1; i <= n; i++) {
                    if (count[row[i]] != 4) print row[i] ": " count[row[i]] " rows"
                    delete count[row[i]]
                }
                for (key in count) print key ": not asked for"
            }')"
    verdict "... in columns as wide as their names" "$(
        awk '/^(primary|shadow) / {
            if (width && length != width) print
            width = length
            if ($3 == "kd:single" && ($4 != "-" || $5 != "-")) print
            if ($3 == "bvh:4x4" && ($4 != "4x4" || $5 != "-")) print
            star[$1 $2 $3] += /\*/
        }
        END { for (key in star) if (star[key] < 1) print key ": no star" }' table)"
    echo 0 0 9 0 0 0 -1 1e30 | rays one
    run trace knot.plt one one.hits --baseline wbvh --json one.json
    verdict "... its bytes are those of trace --baseline" "$(
        rows listed | grep 'structure=wbvh:bits .*packet=8' | head -n 1 |
            grep -q " structure_bytes=$(number structure_bytes <one.json) " || grep wbvh listed)"
    works "structures alone" bench knot.plt $small --kinds random --hits any --packets 8,2 \
        --structures 'bih kd:single' --json -
    verdict "... and nothing of the engine's" "$(
        rows out | sed 's/.* structure=\([^ ]*\) .* packet=\([0-9]*\) .*/\1 \2/' | tr '\n' ' ' |
            grep -qx 'bih 2 bih 8 kd:single 0 ' || cat out)"
    misused "no structure" "no structure is called ''; choose" bench knot.plt --structures ' '
    misused "another structure" "'bwvh'; choose" bench knot.plt --structures 'engine bwvh'
    misused "packets that it does not have" "none of its packets is in --packets" \
        bench knot.plt --structures wbvh:4x4 --packets 16
    misused "walks without the engine" "add engine to --structures" \
        bench knot.plt --structures wbvh --walks depth
    misused "nodes that have no float triangles" "leave out --nodes" \
        bench knot.ply --structures 'engine wbvh' --nodes compact
    misused "two tables" "give one of them" bench knot.plt --structures wbvh --against wbvh
    refused "lattice triangles" compact.plt "pack it with --nodes thesis" bench compact.plt \
        $small --structures wbvh
}

# ---- what cannot be measured -------------------------------------------------------------------

# shellcheck disable=SC2086
{
    misused "a list with a wrong word" "several with commas between" bench knot.ply --kinds a
    misused "an empty word of a list" "several with commas between" bench knot.ply --kinds primary,
    refused "a mesh that is none" bad.ply "." bench bad.ply $small
    head -c 3000 knot.plt >short.plt
    refused "an image that is damaged" short.plt "byte" bench short.plt $small
    refused "no ray hits" knot.plt "no primary ray hits it" bench knot.plt $small --eye 0,0,50 \
        --look 0,0,99
    works "... but rays through the box need none" bench knot.plt $small --eye 0,0,50 \
        --look 0,0,99 --kinds random,inside --packets 8
    verdict "... and only they are made" "$(
        grep -q '^knot.plt: [0-9]* triangles; 1850 random, 1850 inside rays$' out || cat out)"
    refused "no such mode" compact.plt "no such mode" bench compact.plt $small --walks two-stage
    cp knot.plt kept.plt
    refused "an output that is a scene" kept.plt "same file" bench kept.plt $small --json kept.plt
    same knot.plt kept.plt "... which is as it was"
    verdict "nothing is left behind" "$(left_behind)"
}
finish

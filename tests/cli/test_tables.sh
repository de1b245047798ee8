#!/bin/sh
# test_tables.sh - planelet tables: the thesis's tables beside ours, small
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin tables

small='--size 32 --views 2 --frames 2 --rounds 1'
# tables ROWS ARGUMENT...: small ones.
small_tables() {
    rows=$1
    shift
    # shellcheck disable=SC2086
    run tables --rows "$rows" $small "$@"
}
# table NUMBER: of the text in `out`, without its notes.
table() {
    awk -v name="Table 5.$1:" '
        index($0, name) == 1 { on = 1; next }
        /^Table / || /^\* / { on = 0 }
        on && NF > 0' out
}
# widest [FILE]: trouble, unless no line has more than 100 columns.
widest() {
    awk 'length > 100 { print "line " NR " has " length " columns: " $0 }' "${1:-out}"
}
# finished: trouble, unless the last run was.
finished() {
    [ "$status" -eq 0 ] || echo "status $status"
    [ ! -s err ] || cat err
}

small_tables ground,shuttle,marbles
verdict "all tables come without a folder of meshes" "$(
    finished
    sed -n 's/^Table 5.\(.\):.*/\1/p' out | tr '\n' ' ' | grep -qx '1 2 3 4 5 6 ' ||
        grep '^Table' out)"
verdict "... in 100 columns" "$(widest)"
verdict "... and no structure is missing, but where there is nothing to count" "$(
    for number in 1 4 6; do
        table $number | awk -v t="$number" '
            (/ours/ || t == 6) && !/SAH|mean %|% more|ratio/ && / - .* -( |$)/ {
                print "Table 5." t ": " $0
            }'
    done)"
verdict "the ground has the thesis's own nodes: 6 of 32 bytes, 140 saved, and its treelets" "$(
    table 1 | awk '/^ground/ { on = 1 } on && $1 == "ours" { print $2, $6; exit }' |
        grep -qx '12 0.2K' || table 1 | head -5
    table 2 | awk '/^ground/ { on = 1 } on && $1 == "ours" { print $2, $3, $4; exit }' |
        grep -qx '71.4 140 42.2' || table 2 | head -5
    table 5 | awk '/^ground/ { on = 1 } on && $1 == "ours" { print $2, $4, $6, $8; exit }' |
        grep -qx '0(0) 32(1) 320(1) 8K(1)' || table 5 | head -5)"
verdict "what stands in is marked, and a note says what it is" "$(
    for scene in ground shuttle marbles; do
        [ "$(grep -c "^$scene\* " out)" -eq 6 ] || echo "$scene: no star in every table"
        grep -q "^\* $scene\*: .* that planelet makes" out || echo "$scene: no note"
    done
    grep -q '^\* shuttle\*: a knot .*(6.. triangles)' out || grep '^\* shuttle' out)"
verdict "the wBVH is as fast as itself" "$(
    table 3 | awk '/^ground/ { on = 1 } on && /ours, x wBVH/ { print $4, $5, $6; exit }' |
        grep -qx '1.00 1.00 1.00' || table 3 | head -8)"

for number in 1 2 3 4 5 6; do
    small_tables ground $number
    verdict "table $number comes alone" "$(
        finished
        grep -c '^Table 5' out | grep -qx 1 || grep '^Table' out
        [ "$(table $number | grep -c '^ground\*')" -eq 1 ] || echo "no ground"
        table $number | grep -q '  printed\|printed, fps' || echo "nothing printed")"
done
small_tables bunny,ben 2
verdict "rows are those that are asked for, in the thesis's order" "$(
    finished
    table 2 | sed -n 's/^\([a-z]*\)\*.*/\1/p' | tr '\n' ' ' | grep -qx 'bunny ben ' || table 2
    grep -q '^\* Printed means are of the thesis' out || echo "no word of the means")"

# ---- the output folder ------------------------------------------------------
small_tables ground,shuttle -o to --json first.json
cp out first
verdict "-o writes a page, figures and the cache, and nothing else" "$(
    finished
    ls -A to | tr '\n' ' ' | grep -qx "figure_5_3.png figure_5_3.svg figure_5_4.png \
figure_5_4.svg figure_5_5.png figure_5_5.svg tables.cache tables.html " || ls -A to)"
verdict "... the page needs nothing from elsewhere, and is closed" "$(
    # A name space is no address that is asked for.
    sed 's|xmlns="[^"]*"||g' to/tables.html | grep -o 'https\{0,1\}:[^ "]*\|src="[^d][^"]*\|href='
    grep -c '<img ' to/tables.html | grep -qx 2 || echo "no two pictures"
    [ "$(grep -c '<h2>Table 5' to/tables.html)" -eq 6 ] || echo "no six tables"
    [ "$(grep -c '^<svg ' to/tables.html)" -eq 3 ] || echo "no three figures"
    tail -n 1 to/tables.html | grep -qx '</html>' || echo "no end"
    for tag in table tr td th svg ul li figure div; do
        [ "$(grep -o "<$tag[ >]" to/tables.html | wc -l)" -eq \
            "$(grep -o "</$tag>" to/tables.html | wc -l)" ] || echo "$tag is not closed"
    done)"
verdict "... its pictures are PNG files" "$(
    grep -o 'base64,[A-Za-z0-9+/=]*' to/tables.html | cut -c 8-18 | while read -r start; do
        [ "$start" = iVBORw0KGgo ] || echo "begins with $start"
    done)"
verdict "... and the same as in the files" "$(
    for i in 3 4 5; do
        head -c 8 to/figure_5_$i.png | od -An -c | grep -q 'P   N   G' || echo "figure $i: no PNG"
        head -c 4 to/figure_5_$i.svg | grep -qx '<svg' || echo "figure $i: no SVG"
        head -n 3 to/figure_5_$i.svg | grep -qF "$(sed -n 2p to/figure_5_$i.svg)" || echo "$i"
    done)"
verdict "--json has all lines and columns" "$(
    awk -f "$CLI_TESTS/json.awk" first.json >first.flat || echo "no JSON"
    grep -q '^\.tables\[5\]\.rows\[0\]\.values\[0\]' first.flat || tail -n 3 first.flat
    [ "$(grep -c '"name": "Table 5' first.json)" -eq 6 ] || echo "not six tables"
    grep -q '"scene": "ground\*", "line": "ours", "values": \[12, ' first.json ||
        grep -m 3 ground first.json)"

verdict "... of Table 5.4 shares are per cent, and ratios those of the lines above them" "$(
    sed -n '/"name": "Table 5.4/,/"name": "Table 5.5/p' first.json | tr -d '[]{}"' |
        awk -F'line: |, values: ' '
            /line: ours, median/ { n = split($3, median, ", ") }
            /line: ours, SAH/ { split($3, sah, ", ") }
            /line: SAH : median/ {
                split($3, ratio, ", ")
                for (i = 1; i <= 9; i++) {
                    apart = ratio[i] * median[i] - sah[i]
                    if (apart > 0.1 || apart < -0.1) print i ": " $0
                }
                if (!(median[9] > 1 && median[9] < 100)) print "masked: " median[9]
                seen++
            }
            END { if (seen < 2) print seen + 0 " scenes" }')"

verdict "... and so are those of Table 5.6, over the first column" "$(
    sed -n '/"name": "Table 5.6/,$p' first.json | tr -d '[]{}"' |
        awk -F'line: |, values: ' '
            /line: (Figure 4.2|text of 4.2|mirrored|sorted|depth first)/ { split($3, at, ", ") }
            /line: ... % more/ && at[1] > 0 {
                split($3, more, ", ")
                for (i = 2; i <= 10; i++) {
                    apart = at[i] - at[1] * (1 + more[i] / 100)
                    if (apart > 0.1 || apart < -0.1) print i ": " $0
                    largest = more[i] > largest ? more[i] : largest
                }
                at[1] = 0
                seen++
            }
            END { if (seen < 10 || largest < 20) print seen + 0 " lines, " largest }')"

small_tables ground,shuttle -o to --json again.json
verdict "a second run measures nothing, and says the same" "$(
    finished
    cmp first out
    cmp first.json again.json)"
lines=$(wc -l <to/tables.cache)
verdict "... nor does it add to the cache" "$(
    cp to/tables.cache kept
    small_tables ground,shuttle -o to
    cmp kept to/tables.cache)"
small_tables ground,shuttle -o to --json - 1 2
verdict "--json - is on standard output alone" "$(
    finished
    awk -f "$CLI_TESTS/json.awk" out >out.flat || echo "no JSON"
    grep -q '^\.tables\[1\]\.rows\[0\]\.values\[0\]' out.flat || tail -n 3 out.flat
    grep '^Table' out)"
# Another size is another measurement; what needs no rays is the same.
run tables --rows ground --size 16 --views 2 -o to 4
verdict "rays of another size are measured" "$(
    finished
    [ "$(wc -l <to/tables.cache)" -eq $((lines + 6)) ] || wc -l to/tables.cache)"
run tables --rows ground --size 16 --views 2 -o to 1 5
verdict "... what has no rays is taken as it is" "$(
    finished
    [ "$(wc -l <to/tables.cache)" -eq $((lines + 6)) ] || wc -l to/tables.cache)"

# A damaged cache: one line of figures is another one, one is cut.
sed -e '3s/ \([0-9]\)/ 7\1/2' -e '5s/..........$//' kept >to/tables.cache
cmp -s kept to/tables.cache && echo "    nothing was damaged"
small_tables ground,shuttle -o to
verdict "damaged lines of the cache are measured again" "$(
    finished
    [ "$(wc -l <to/tables.cache)" -ge $((lines + 2)) ] || wc -l to/tables.cache
    # All but times are as before.
    sed '/x wBVH/d; /ns\/ray/d; /cycles\/ray/d; /ratio of those/d' first >first.counts
    sed '/x wBVH/d; /ns\/ray/d; /cycles\/ray/d; /ratio of those/d' out | cmp - first.counts)"
head -c 700 kept >to/tables.cache
small_tables ground,shuttle -o to 1
verdict "... and so is what was cut off" "$(finished)"
echo 'a letter to somebody' >to/tables.cache
refused "a file of that name that is no cache is refused" to/tables.cache "is not a cache" \
    tables --rows ground -o to 1
verdict "... and stays as it is" "$(
    grep -qx 'a letter to somebody' to/tables.cache || cat to/tables.cache)"
rm -f to/tables.cache
mkdir to/tables.cache
refused "... nor is a folder one" to/tables.cache "cannot open" tables --rows ground -o to 1
rmdir to/tables.cache

if [ -c /dev/full ]; then
    mkdir full
    ln -s /dev/full full/tables.cache
    refused "... nor is a device" full/tables.cache "no regular file" tables --rows ground -o full 1
fi

small_tables ground figures -o only
verdict "figures alone are written to a folder that is made, with nothing on standard output" "$(
    finished
    [ ! -s out ] || cat out
    [ -s only/figure_5_5.svg ] && [ -s only/tables.html ] || ls only)"

# ---- folders of meshes -----------------------------------------------------------
mkdir meshes
printf '%s\n' ply 'format ascii 1.0' 'element vertex 3' 'property float x' 'property float y' \
    'property float z' 'element face 1' 'property list uchar int vertex_indices' end_header \
    '0 0 0' '1 0 0' '0 1 0' '3 0 1 2' >meshes/bunny.ply
small_tables bunny,ground --scenes meshes -o made --json made/tables.json
verdict "a triangle, which has no nodes, has tables and figures, too; JSON may go to the folder" "$(
    finished
    [ -s made/tables.html ] && [ -s made/tables.json ] || ls made)"
run make knot --triangles 900 -o meshes/bunny.ply
small_tables shuttle,bunny --scenes meshes 1
verdict "of a folder of meshes those are taken that are there" "$(
    finished
    grep -q '^bunny  *printed' out || echo "bunny has a star"
    grep -q '^shuttle\*' out || echo "shuttle has none"
    table 1 | awk '/^bunny/ { on = 1 } on && $1 == "ours" { print $2; exit }' | grep -qx 900 ||
        table 1)"
ln -s meshes '<i>&"x'
run tables --rows ground --size 16 --views 1 --scenes '<i>&"x' -o marked 1
verdict "a name that is markup is a text of the page" "$(
    finished
    grep -qF 'Meshes are from &#60;i&#62;&#38;&#34;x. ' marked/tables.html ||
        grep -o 'Meshes are.*' marked/tables.html
    ! grep -F '<i>' marked/tables.html)"
mkdir -p meshes/wooddoll meshes/horse_poses
for i in 000 003 028; do
    cp meshes/bunny.ply meshes/wooddoll/wooddoll_$i.ply
done
run make marbles --triangles 800 --frames 11 -o 'meshes/horse_poses/horse_poses_{}.ply'
small_tables wooddoll,hand --scenes meshes 3
verdict "animations are read, or come from poses, or are twisted" "$(
    finished
    grep -q '^wood-doll(29)  *printed' out || echo "wood-doll has a star"
    grep -q '^\* hand(44)\*: horse_poses' out || echo "no note of poses")"
small_tables hand --scenes meshes -o moved 3
lines=$(wc -l <moved/tables.cache)
run make marbles --triangles 800 --frames 13 -o 'later_{}.ply'
cp later_012.ply meshes/horse_poses/horse_poses_010.ply
small_tables hand --scenes meshes -o moved 3
verdict "an animation of which a later frame has changed is measured again, its still is not" "$(
    finished
    [ "$(wc -l <moved/tables.cache)" -eq $((lines + 9)) ] || wc -l moved/tables.cache)"
refused "a folder that is not there is refused" nowhere "no such folder" tables --scenes nowhere 1
mkdir empty
refused "... so is one without any of the meshes" empty "none of the meshes" tables --scenes empty 1
echo 'no mesh at all' >meshes/dragon.ply
refused "a mesh that cannot be read is refused by its name" meshes/dragon.ply . \
    tables --rows dragon --scenes meshes 1
rm meshes/dragon.ply
mkdir failed
echo 'no mesh at all' >meshes/ben.ply
# shellcheck disable=SC2086
run tables --rows bunny,ben --scenes meshes $small -o failed --json failed.json
verdict "a failed run leaves no page, figure or JSON" "$(
    [ "$status" -eq 1 ] || echo "status $status"
    ls -A failed | grep -v '^tables.cache$'
    [ ! -e failed.json ] || echo "failed.json is there"
    left_behind)"
rm meshes/ben.ply

# ---- usage ------------------------------------------------------------------------
misused "a table that there is not" "there is no table '7': 1 to 6, or figures" tables 7
misused "a word that is no table" "no table 'one'" tables one
misused "tables are single digits" "no table '12'" tables 12
misused "another scene" "not 'cow'" tables --rows cow 1
misused "rays that make no whole packets" "multiples of 16" tables --size 100 1
misused "figures without a folder" "figures need -o DIR" tables figures
works "planelet tables --help" tables --help
verdict "... fits in 80 columns" "$(awk 'length > 80' out)"
finish

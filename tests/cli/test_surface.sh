#!/bin/sh
# test_surface.sh - normals and colours, from meshes to pictures
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin surface
run make knot --triangles 4000 -o knot.ply
works "an image without normals" pack knot.ply -o flat.plt
works "... with those that --smooth makes" pack knot.ply -o smooth.plt --smooth 60
works "... none of which are split" pack knot.ply -o round.plt --smooth 180

# number KEY IMAGE
number() {
    "$PLANELET" info "$2" --json | sed -n "s/^ *\"$1\": \([0-9.]*\).*/\1/p"
}

verdict "... takes at most 1.5 bytes per triangle more, which info prints" "$(
    each=$(number normal_bytes_per_triangle round.plt)
    awk -v each="$each" 'BEGIN { exit !(each > 1 && each <= 1.5) }' || echo "$each bytes"
    more=$(($(wc -c <round.plt) - $(wc -c <flat.plt)))
    [ "$more" -eq $(($(number normal_bytes round.plt) + 64)) ] || echo "$more bytes more"
    "$PLANELET" info round.plt | grep -q '^normal bytes .* per triangle$' || echo "not printed"
    [ "$(number normal_bytes flat.plt)" = 0 ] || echo "an image without has some")"

# All but sizes and checks of the header, and what is behind.
cut_header() {
    dd if="$1" bs=1 skip=24 count=204 2>/dev/null
    dd if="$1" bs=1 skip=232 count=$(($(wc -c <flat.plt) - 232)) 2>/dev/null
}
cut_header flat.plt >flat.cut
cut_header smooth.plt >smooth.cut
same flat.cut smooth.cut "... tree and triangles are the same"

for image in flat smooth; do
    works "$image: eye light" render $image.plt -o $image.ppm --size 64x48
    works "$image: the shader smooth" render $image.plt -o $image.smooth.ppm --size 64x48 \
        --shader smooth
done
same flat.ppm smooth.ppm "eye light does not look at normals"
verdict "smooth does" "$(differ smooth.ppm smooth.smooth.ppm)"
for how in "--packet 2" "--packet 16" "--walk two-stage" "--structure grid" "--source read" \
    "--workers 2"; do
    # shellcheck disable=SC2086
    run render smooth.plt -o other.ppm --size 64x48 --shader smooth $how
    same smooth.smooth.ppm other.ppm "smooth, $how: the same picture"
done
run pack knot.ply -o device.plt --build device --smooth 60
run render device.plt -o other.ppm --size 64x48 --shader smooth
same smooth.smooth.ppm other.ppm "smooth, --build device: the same picture"

# ---- page by page ------------------------------------------------------------------------------

run make marbles -o marbles.obj
for nodes in thesis compact; do
    run pack marbles.obj -o tables.plt --nodes $nodes --smooth 40 --materials keep
    run pack marbles.obj -o pages.plt --nodes $nodes --smooth 40 --materials keep --surface pages
    verdict "$nodes: pages of normals, whose bytes info prints, and no others" "$(
        [ "$(number page_bytes pages.plt)" -gt 0 ] || echo "no pages"
        [ "$(number normal_bytes pages.plt)" = 0 ] || echo "tables, too"
        [ "$(number page_bytes tables.plt)" = 0 ] || echo "pages, unasked"
        "$PLANELET" info pages.plt | grep -q '^page bytes .* per triangle$' || echo "not printed")"
    for shader in smooth "whitted --light sun:0.5,1,0.75,0.75,0.0625,4"; do
        # shellcheck disable=SC2086
        run render tables.plt -o due.ppm --size 40x30 --shader $shader
        for how in "" "--residency streamed" "--residency streamed --store 28672" \
            "--residency streamed --source read --prefetch 4" \
            "--residency streamed --workers 2 --packet 8"; do
            # shellcheck disable=SC2086
            run render pages.plt -o other.ppm --size 40x30 --shader $shader $how
            same due.ppm other.ppm "$nodes, ${shader%% *} by pages, $how: the same picture"
        done
    done
done

# ---- of meshes ---------------------------------------------------------------------------------

cat >square.obj <<'EOF'
v -1 -1 0 1 0 0
v 1 -1 0 0 1 0
v 1 1 0 0 0 1
v -1 1 0 1 1 1
vn 0 0 1
vt 0 0
vt 3 0
vt 3 -1.5
vt 0 -1.5
f 1/1/1 2/2/1 3/3/1 4/4/1
EOF
run pack square.obj -o plain.plt
verdict "what a mesh has and the image does not is said in one line" "$(
    grep -qx 'square.obj: left out 4 colours, 1 normal, 4 texture coordinates' err || cat err)"
works "normals, colours and texture coordinates of a mesh" pack square.obj -o square.plt \
    --normals keep --colours keep --texcoords keep --json square.json
verdict "... are in the image" "$(
    for what in colour_bytes normal_bytes texcoord_bytes; do
        [ "$(number $what square.plt)" -gt 0 ] || echo "no $what"
    done
    grep -q 'left out' err && cat err)"
verdict "... info prints what they take, and pack how far they are off" "$(
    [ "$(number texcoord_bytes_per_triangle square.plt)" = 64.000 ] || "$PLANELET" info square.plt
    "$PLANELET" info square.plt | grep -q '^texcoord bytes     128, 64.00 per triangle$' ||
        echo "not printed"
    off=$(sed -n 's/^ *"texture_coordinates_off": \([0-9.e-]*\),$/\1/p' square.json)
    awk -v off="$off" 'BEGIN { exit !(off < 1e-6) }' || echo "off by $off in corners"
    [ "$(sed -n 's/^ *"colours_off": \(.*\),$/\1/p' square.json)" = 0 ] || cat square.json)"
works "... page by page" pack square.obj -o paged.plt --normals keep --colours keep \
    --texcoords keep --surface pages --json square.json
verdict "... in no table, as far off" "$(
    [ "$(number page_bytes paged.plt)" -gt 0 ] || echo "no pages"
    [ "$(number texcoord_bytes paged.plt)" = 0 ] || echo "a table"
    grep -q '^  "texture_coordinates_off": ' square.json || cat square.json)"
works "... finer ones" pack square.obj -o fine.plt --normals keep --colours keep --texcoords fine
verdict "... take more" "$([ "$(number texcoord_bytes fine.plt)" -gt 128 ] ||
    "$PLANELET" info fine.plt)"
run pack square.obj -o without.plt --normals keep --colours keep
run render without.plt -o without.ppm --size 64x64 --shader smooth --eye 0,0,4 --look 0,0,0 \
    --up 0,1,0 --fov 30
works "their picture" render square.plt -o square.ppm --size 64x64 --shader smooth \
    --eye 0,0,4 --look 0,0,0 --up 0,1,0 --fov 30
same without.ppm square.ppm "... to which texture coordinates make no difference"
# colour X Y: red, green and blue of a pixel of square.ppm.
colour() {
    tail -c "+$((14 + 3 * (64 * $2 + $1)))" square.ppm | od -An -v -t u1 -N 3 | tr -s ' '
}
verdict "... is red, green, blue and white in its corners" "$(
    for corner in "5 58 red" "58 58 green" "58 5 blue" "5 5 white"; do
        # shellcheck disable=SC2086
        set -- $corner
        # shellcheck disable=SC2046
        set -- "$3" $(colour "$1" "$2")
        case $1 in
        red) [ "$2" -gt 180 ] && [ "$3" -lt 60 ] && [ "$4" -lt 60 ] ;;
        green) [ "$2" -lt 60 ] && [ "$3" -gt 180 ] && [ "$4" -lt 60 ] ;;
        blue) [ "$2" -lt 60 ] && [ "$3" -lt 60 ] && [ "$4" -gt 180 ] ;;
        white) [ "$2" -gt 180 ] && [ "$3" -gt 180 ] && [ "$4" -gt 180 ] ;;
        esac || echo "$*"
    done)"
PLANELET=$PLANELET sh "$CLI_TESTS/../measure/unwrap.sh" knot.ply knot.obj
works "a mesh of more colours than 255, and texture coordinates" \
    pack knot.obj -o knot.plt --colours keep --texcoords keep --json knot.json
verdict "... has them within 2 of 255" "$(
    awk -F '[:,]' '/"colours_kept"/ { kept = $2 } /"colours_off"/ { off = $2 }
        END { exit !(kept > 255 && kept <= 2047 && off <= 2) }' knot.json || cat knot.json)"
works "... its picture" render knot.plt -o knot.ppm --size 64x48 --shader smooth
works "... read from its file" render knot.plt -o read.ppm --size 64x48 --shader smooth \
    --source read
same knot.ppm read.ppm "... the same picture"
printf 'newmtl a\nmap_Kd not-there.png\n' >lost.mtl
{
    printf 'mtllib lost.mtl\nusemtl a\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n'
    printf 'f 1/1 2/2 3/3\n'
} >lost.obj
for pages in tables pages; do
    run pack lost.obj -o lost.plt --materials keep --smooth 40 --surface $pages
    verdict "where a picture is lost, coordinates are said to be left out, and are ($pages)" "$(
        [ "$status" -eq 0 ] || echo "status $status"
        grep -q 'left out its texture coordinates, as it has no picture' err || cat err
        number texcoord_bytes lost.plt | grep -qx 0 || "$PLANELET" info lost.plt)"
done
printf "v 0 0 0\nvn nan 0 0\n" >bad.obj
refused "a normal that is none, with its line" bad.obj "line 2: the normal" \
    pack bad.obj -o x.plt --normals keep
finish

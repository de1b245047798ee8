# seeds - the first inputs of the targets that read files
#
# Sourced by fuzz.sh. `seeds TARGET FOLDER` writes a few small files there: each keyword of
# the format is in one of them. SPDX-License-Identifier: MIT

# floats NUMBER...: each as a little-endian float.
floats() {
    # shellcheck disable=SC2059
    printf "$(echo "$*" | awk -f tests/cli/float32.awk)"
}

big32() { # NUMBER
    # shellcheck disable=SC2059
    printf "$(printf '\\%03o' $(($1 >> 24 & 255)) $(($1 >> 16 & 255)) $(($1 >> 8 & 255)) \
        $(($1 & 255)))"
}

seeds_ply() { # FOLDER
    "$PLANELET" make ground -o "$1/ground.ply"
    "$PLANELET" make knot --triangles 24 -o "$1/knot.ply"
    cat >"$1/ascii.ply" <<'END'
ply
format ascii 1.0
comment four corners and two strips
obj_info none
element vertex 5
property float x
property double y
property float32 z
property list uchar float64 weights
element face 2
property list uint8 int32 vertex_indices
element edge 1
property short a
property ushort b
property int8 c
property uint16 d
property int16 e
property char f
element tristrips 1
property list uint uint32 vertex_index
end_header
0 0 0 0
1.5 -2e3 0 1 9
0 1 0 2 8 8
0 0 1 0
nan 2 inf 0
4 0 1 2 3
3 2 1 0
1 2 3 4 5 6
7 0 1 2 -1 3 2 1
END
    { # two triangles of one quad, big-endian, of doubles and shorts
        printf 'ply\nformat binary_big_endian 1.0\nelement vertex 4\nproperty double x\n'
        printf 'property short y\nproperty uchar z\nelement face 2\n'
        printf 'property list uchar ushort vertex_indices\nend_header\n'
        printf '\0\0\0\0\0\0\0\0\0\0\0\077\360\0\0\0\0\0\0\0\0\0'
        printf '\077\360\0\0\0\0\0\0\0\1\0\0\0\0\0\0\0\0\0\0\1\1'
        printf '\3\0\0\0\1\0\2\3\0\0\0\2\0\3'
    } >"$1/big.ply"
    { # faces of one to six corners, numbers of 64 bits, a line that is no keyword
        printf 'ply\nformat binary_little_endian 1.0\nmade by hand\nelement vertex 6\n'
        printf 'property float x\nproperty float y\nproperty float z\nproperty uchar red\n'
        printf 'element face 5\nproperty list int64 uint64 vertex_index\nend_header\n'
        for corner in '0 0' '4 0' '4 4' '2 1' '0 4' '-1 2'; do
            # shellcheck disable=SC2086
            floats $corner 0.5
            printf '\377'
        done
        for face in '0' '0 1' '0 1 2' '0 1 2 3' '0 1 2 3 4 5'; do
            # shellcheck disable=SC2086
            set -- "$1" $face
            printf "\\$(($# - 1))\0\0\0\0\0\0\0"
            for vertex in $face; do
                printf "\\$vertex\0\0\0\0\0\0\0"
            done
            set -- "$1"
        done
        printf 'loose'
    } >"$1/small_faces.ply"
    cat >"$1/concave.ply" <<'END'
ply
format ascii 1.0
element vertex 7
property double x
property double y
property double z
property float nx
property float texture_u
element face 3
property list uchar int64 vertex_indices
property int material_index
element line 1
property int vertex1
property int vertex2
element camera 1
property float view
end_header
1000000.1 0 0 0 0
1000000.4 0 0 0 0
1000000.4 0.3 0 0 0
1000000.2 0.1 0 0 0
1000000.1 0.3 0 0 0
0.1 16777217.1 1e-7 0 0
1000000.1 1e-5 0 0 0
5 0 1 2 3 4 7
4 2 1 0 5 7
6 0 1 2 3 4 3 7
0 1
2
END
}

seeds_obj() { # FOLDER
    cat >"$1/all.obj" <<'END'
# a pyramid
mtllib a.mtl
o pyramid
g sides
v 0 0 0
v 1 0 0 0.5
v 1 1 0 1 0 0
v 0 1 -0
vt 0 0
vn 0 0 1
vp 1
usemtl red
s off
f 1 2 3 4
f 1/1 2/1/1 5//1
f -1 -2 \
  -3
l 1 2
p 1
v .5 5e-1 1e0
f 4 5 1 # closed
END
    printf 'v 0 0 nan\r\nv 1 -inf 0\r\nv 0 1 1e30\rv 1 1 1\rf 1 2\nf 9 1 2\nf 0 1 2\n' \
        >"$1/bad.obj"
    printf 'v 0 0 0\nv 9 0 0 \\ \t\n\nv 9 9 .1\\\r\n\r\nv 0 9 0\nv 3 3 0\nv 3 6 0\nv 6 6 0\n' \
        >"$1/habits.obj"
    printf 'v 6 3 0 1 1 1\nf 1 2 3 4 1 5 6 7 \\  \n 8 5\nf 1 2 6 4\nf 1 3 2 4\nf 1\nf 1 2\n' \
        >>"$1/habits.obj"
    printf 'p 1 2\nl 1/1 2/2\ncstype bezier\ndeg 3\ncurv 0 1 1 2 3 4\nparm u 0 1\nend\n' \
        >>"$1/habits.obj"
    printf 'surf 0 1 0 1 1 2 3 4\ncurv2 1 2\n# C:\\\nusemap none\nf -8 -7 1\\\n' >>"$1/habits.obj"
}

seeds_stl() { # FOLDER
    cat >"$1/ascii.stl" <<'END'
solid two facets
facet normal 0 0 1
 outer loop
  vertex 0 0 0
  vertex 1 0 0
  vertex 0 1 0
 endloop
endfacet
facet normal nan nan nan
 outer loop
  vertex 1 0 0
  vertex 1.5e0 1 -0
  vertex 0 1 0
  vertex 0 0 inf
 endloop
endfacet
endsolid two facets
solid
endsolid
END
    {
        head -c 80 /dev/zero
        printf '\2\0\0\0'
        floats 0 0 1 0 0 0 1 0 0 0 1 0
        printf '\0\0'
        floats 0 0 1 1 0 0 1 1 0 0 1 nan
        printf '\0\0'
    } >"$1/binary.stl"
    tr '[:lower:]' '[:upper:]' <"$1/ascii.stl" | sed 's/END/END /' >"$1/capitals.stl"
    {
        printf '\0\0# comments\r\n; of all\r\n// kinds\r\nsolid\r\n'
        printf 'facet normal 0 0 1\router loop\rvertex 0.1 0 0\rvertex 1 0 0\rvertex 0 1 0\r'
        printf 'end loop\nendfacet\nsolid open\nfacet normal x y z outer loop\n'
        printf 'vertex 0.1000001 0 0 vertex 0 1 0 vertex -1 0 0 endloop end facet\n\32\0\0'
    } >"$1/old.stl"
    { # one triangle, and a header that says three
        printf 'COLOR=1234%070d' 0
        printf '\3\0\0\0'
        floats 0 0 1 0 0 0 1 0 0 0 1 0
        printf '\1\200'
    } >"$1/miscounted.stl"
    { # big-endian: 0, 1 and 2 as coordinates
        head -c 80 /dev/zero
        printf '\0\0\0\1'
        for number in 0 0 1 0 0 0 1 0 0 0 2 0; do
            big32 $((number == 0 ? 0 : 1056964608 + 8388608 * number))
        done
        printf '\0\0'
    } >"$1/big_endian.stl"
    { cat "$1/binary.stl"; printf 'loose'; } >"$1/loose.stl"
}

seeds_recipe() { # FOLDER
    cat >"$1/all.txt" <<'END'
# what each file of the target's folder is for
a.ply 1 0 0 0
b.obj 2.5 -1 2 3e1 90   # it needs repair
c.stl 1 0 0 0 45 -30
f_{}.obj*9+3 1 0 0 0
END
    printf 'flat.obj 1 0 0 0\nnone.ply 1 0 0 0\n' >"$1/none.txt"
    printf 'r.txt 1 0 0 0\n- 1 0 0 0\n/etc/it 1e30 1 1 1 1 1\n' >"$1/refused.txt"
    {
        printf 'it.ply 1 0 0 0\nit.obj 3 1e12 0 0\n==\n'
        printf 'v 0 0 0\nv 1 0 0\nv 0 1 nan\nf 1 2 3\n'
    } >"$1/member.txt"
}

# crc_of: that of standard input, the greatest byte first; gzip has it in front of the size.
crc_of() {
    # shellcheck disable=SC2046
    set -- $(gzip -nc | tail -c 8 | od -An -tu1 -N4)
    # shellcheck disable=SC2059
    printf "$(printf '\\%03o\\%03o\\%03o\\%03o' "$4" "$3" "$2" "$1")"
}

chunk() { # KIND: what is on standard input
    { printf '%s' "$1"; cat; } >"$work/chunk"
    big32 $(($(wc -c <"$work/chunk") - 4))
    cat "$work/chunk"
    crc_of <"$work/chunk"
}

# picture COLOUR ROWS: 4 pixels wide, 3 high, of this colour type; ROWS is for printf.
picture() {
    printf '\211PNG\r\n\032\n'
    # shellcheck disable=SC2059
    { big32 4; big32 3; printf "\\010\\00$1\\0\\0\\0"; } | chunk IHDR
    printf '\377\0\0\0\377\0\0\0\377' | chunk PLTE
    # shellcheck disable=SC2059
    { printf '\170\001'; printf "$2" | gzip -nc | tail -c +11 | head -c -8; big32 0; } | chunk IDAT
    printf '' | chunk IEND
}

seeds_png() { # FOLDER
    "$PLANELET" make ground -o "$work/ground.ply"
    "$PLANELET" pack "$work/ground.ply" -o "$work/ground.plt"
    "$PLANELET" render "$work/ground.plt" --size 16x16 --shader normal -o "$1/ground.png"
    picture 0 '\0abcd\1abcd\2abcd' >"$1/grey.png"
    picture 2 '\3abcdabcdabcd\4abcdabcdabcd\0abcdabcdabcd' >"$1/colour.png"
    picture 3 '\0\0\1\2\0\0\2\2\2\3\1\1\1\1\0' >"$1/palette.png"
    picture 4 '\0abcdabcd\4abcdabcd\1abcdabcd' >"$1/grey_alpha.png"
    picture 6 '\4abcdabcdabcdabcd\0abcdabcdabcdabcd\2abcdabcdabcdabcd' >"$1/colour_alpha.png"
    printf 'abcabcabcabcabcdefabcdefabc' | gzip -nc | tail -c +11 >"$1/stream"
}

# The first byte asks for right checksums.
seeds_sequence() { # FOLDER
    for k in 0 1 2; do
        printf 'v %s\n' "0 0 0.$k" "1 0.$k 0" "0 1 0" "1 1 0.$k" >"$work/frame_$k.obj"
        printf 'f 1 2 3\nf 2 4 3\n' >>"$work/frame_$k.obj"
    done
    for geometry in float lattice:12 lattice:21; do
        "$PLANELET" pack --sequence "$work"/frame_?.obj --geometry $geometry --key 2 \
            -o "$work/frames.plt" 2>/dev/null
        { printf '\020'; cat "$work/frames.plt"; } >"$1/$geometry"
    done
}

seeds_instances() { # FOLDER
    printf 'v %s\n' '0 0 0' '1 0 0' '0 1 0' '1 1 0.5' >"$work/body.obj"
    printf 'f 1 2 3\nf 2 4 3\n' >>"$work/body.obj"
    printf '%s\n' 'body b body.obj' 'instance i b' 'instance j b' \
        'frame 0 j 2 0 0 1 0 2 0 0 0 0 2 0' 'frame 1 i 0 -1 0 3 1 0 0 0 0 0 1 0' >"$work/list.txt"
    for leaf in 1 4; do
        "$PLANELET" pack --instances "$work/list.txt" --leaf $leaf -o "$work/list.plt" 2>/dev/null
        { printf '\020'; cat "$work/list.plt"; } >"$1/leaf_$leaf"
    done
}

seeds_surface() { # FOLDER
    printf 'v %s\n' '0 0 0 1 0 0' '1 0 0 0 1 0' '0 1 0 0 0 1' '1 1 0.5 1 1 1' >"$work/body.obj"
    printf 'f 1 2 3\nf 2 4 3\n' >>"$work/body.obj"
    for flags in '--smooth 10' '--smooth 90 --colours keep' '--nodes compact --smooth 90'; do
        # shellcheck disable=SC2086
        "$PLANELET" pack "$work/body.obj" $flags -o "$work/body.plt" 2>/dev/null
        { printf '\020'; cat "$work/body.plt"; } >"$1/$(echo "$flags" | tr -d ' -')"
    done
}

seeds() { # TARGET FOLDER
    case $1 in
    ply | obj | stl | recipe | png | sequence | instances | surface) "seeds_$1" "$2" ;;
    esac
}

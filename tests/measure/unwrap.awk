# unwrap.awk - the numbers of a mesh, as an OBJ with texture coordinates and colours
#
# Lines of three numbers are vertices, of five (a 3 and three corners behind a line's first word)
# triangles: what unwrap.sh makes of a PLY file. Coordinates are those of a globe around the mesh's
# middle, u by longitude and v by latitude; a triangle across the meridian on which u is 0 and 1
# goes on beyond 1. Colours differ from vertex to vertex: where each is in the mesh's box.
# SPDX-License-Identifier: MIT
BEGIN { vertices = 0 }
function turn(y, x) { return atan2(y, x) / 6.283185307179586 + 0.5 }
function rounded(x) { return sprintf("%.6f", x) + 0 }

# The number of a vertex's coordinates, or of those once around.
function numbered(i, is_beyond) {
    if (!is_beyond) { return i + 1 }
    if (!(i in beyond)) {
        printf "vt %.6f %.6f\n", longitude[i] + 1, latitude[i]
        beyond[i] = vertices + ++extras
    }
    return beyond[i]
}

function end_vertices(   i, a, part, d) {
    for (i = 0; i < vertices; i++) {
        for (a = 1; a <= 3; a++) {
            part[a] = high[a] > low[a] ? (at[i, a] - low[a]) / (high[a] - low[a]) : 0
            d[a] = at[i, a] - (low[a] + high[a]) / 2
        }
        printf "v %s %s %s", at[i, 1], at[i, 2], at[i, 3]
        printf " %.4f %.4f %.4f\n", part[1], part[2], part[3]
        longitude[i] = rounded(turn(d[3], d[1]))
        latitude[i] = rounded(turn(d[2], sqrt(d[1] * d[1] + d[3] * d[3])) * 2 - 0.5)
    }
    for (i = 0; i < vertices; i++) { printf "vt %.6f %.6f\n", longitude[i], latitude[i] }
    is_ended = 1
}

NF == 3 {
    for (a = 1; a <= 3; a++) {
        at[vertices, a] = $a
        if (vertices == 0 || $a + 0 < low[a]) { low[a] = $a + 0 }
        if (vertices == 0 || $a + 0 > high[a]) { high[a] = $a + 0 }
    }
    vertices++
}
NF == 5 {
    if (!is_ended) { end_vertices() }
    most = 0
    for (k = 3; k <= 5; k++) { most = longitude[$k] > most ? longitude[$k] : most }
    line = "f"
    for (k = 3; k <= 5; k++) {
        i = $k
        line = line " " (i + 1) "/" numbered(i, most > 0.75 && longitude[i] < 0.25)
    }
    print line
}

# wave - frames of a sheet that ripples
#
# Sourced. SPDX-License-Identifier: MIT

# wave FRAME [SIDE]: a sheet of two triangles per square, as PLY.
wave() {
    awk -v frame="$1" -v side="${2:-9}" 'BEGIN {
        print "ply\nformat ascii 1.0\nelement vertex " side * side
        print "property float x\nproperty float y\nproperty float z"
        print "element face " 2 * (side - 1) * (side - 1)
        print "property list uchar int vertex_indices\nend_header"
        for (y = 0; y < side; y++) for (x = 0; x < side; x++)
            print x / side, 0.2 * sin(1.3 * x + frame), y / side + 0.05 * frame
        for (y = 0; y + 1 < side; y++) for (x = 0; x + 1 < side; x++) {
            at = y * side + x
            print 3, at, at + 1, at + side
            print 3, at + 1, at + side + 1, at + side
        } }'
}

# waves COUNT: frames 0 and on, of fewer than ten, as wave_000.ply ...
waves() {
    count=0
    while [ "$count" -lt "$1" ]; do
        wave "$count" >"wave_00$count.ply"
        count=$((count + 1))
    done
}

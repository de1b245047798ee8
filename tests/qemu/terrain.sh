# terrain.sh - a scene that is larger than a board's memory, for tests that read it
#
# In $out: terrain.plt, of compact blocks, `image` bytes long; on request a copy with wrong bytes.
# SPDX-License-Identifier: MIT

"$planelet" make terrain --triangles 400000 -o "$out/terrain.ply" >/dev/null 2>&1
"$planelet" pack "$out/terrain.ply" -o "$out/terrain.plt" --nodes compact \
    --geometry lattice:14 --leaf 2 >/dev/null 2>&1
image=$(wc -c <"$out/terrain.plt" | tr -d ' ')
verdict "an image of $image bytes, eight times 256 KiB or more, is there" "$(
    [ "$image" -ge 2097152 ] || echo "$image bytes")"

# damage COPY: a byte in every so many is wrong; the header and the first blocks are right.
damage() {
    cp "$out/terrain.plt" "$1"
    at=1000
    while [ "$at" -lt "$image" ]; do
        printf '\377\000' | dd of="$1" bs=1 seek="$at" conv=notrunc 2>/dev/null
        at=$((at + 9001))
    done
}

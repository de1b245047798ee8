#!/bin/sh
# libsixel_no_white.sh - img2sixel draws no white, whatever its palette has room for
#
# Software: Debian's libsixel-bin 1.10.3-3, img2sixel. Input: a PPM that is white all over, and one
# of all greys from 0 to 255.
# Behaviour: sixel's colours are numbers from 0 to 100, so white is 100 100 100. The white picture's
# one palette entry is 97 97 97, though 256 are free: before colours are counted, the lower three
# bits of each channel are cut off, never put back, and 248 of 255 is 97 %. Of 256 greys, 32 remain,
# all rounded down, without dithering (-d none) and with the best quality (-q full), too. The mode
# for 15 bits a colour, -I, which should be coarser, has 100 for white. One would guess that a
# picture of no more colours than the palette holds is drawn in its own, as near as percents allow.
# Output seen: "white: 97 97 97, with -I 100 100 100", "256 greys: 32 colours, 0 to 97".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
version=1.10.3-3
mkdir -p "$folder/archives/partial" "$folder/tree"
apt-get install -y -qq --no-install-recommends --download-only \
    -o "Dir::Cache::archives=$folder/archives" "libsixel-bin=$version" >/dev/null 2>&1 ||
    { echo "cannot get libsixel-bin $version"; exit 2; }
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
PATH=$folder/tree/usr/bin:$PATH
LD_LIBRARY_PATH=$folder/tree/usr/lib/$(uname -m)-linux-gnu
export PATH LD_LIBRARY_PATH
{
    printf 'P6\n12 12\n255\n'
    head -c 432 /dev/zero | LC_ALL=C tr '\000' '\377'
} >"$folder/white.ppm"
{
    printf 'P6\n16 16\n255\n'
    grey=0
    while [ $grey -lt 256 ]; do
        byte=$(printf '\\0%03o' $grey)
        printf '%b' "$byte$byte$byte"
        grey=$((grey + 1))
    done
} >"$folder/greys.ppm"
# colours FILE OPTION... - the palette's entries as three numbers each, the darkest first
colours() {
    img2sixel "$@" >"$folder/out.sixel" || exit 2
    LC_ALL=C grep -ao '#[0-9]*;2;[0-9;]*' "$folder/out.sixel" | cut -d';' -f3- | tr ';' ' ' |
        sort -nu
}
greys=$(colours "$folder/greys.ppm" -q full -d none) || exit 2
white=$(colours "$folder/white.ppm" -q full) || exit 2
coarse=$(colours "$folder/white.ppm" -I) || exit 2
ends=$(echo "$greys" | cut -d' ' -f1 | sed -n '1p;$p' | paste -s -d' ' - | sed 's/ / to /')
seen="white: $white, with -I $(echo "$coarse" | tail -n 1)
256 greys: $(echo "$greys" | wc -l) colours, $ends"
echo "$seen"
[ "$seen" = "white: 97 97 97, with -I 100 100 100
256 greys: 32 colours, 0 to 97" ]

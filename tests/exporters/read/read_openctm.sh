#!/bin/sh
# read_openctm.sh FILE... - OpenCTM's ctmconv
#
# SPDX-License-Identifier: MIT
made=$(mktemp -d)
for mesh in "$@"; do
    ctmconv "$mesh" "$made/out.obj" >/dev/null && awk -v name="$(basename "$mesh")" '
        $1 == "v" { vertices++ }
        $1 == "f" { faces++ }
        END { print name, faces, vertices }' "$made/out.obj"
done
rm -r "$made"

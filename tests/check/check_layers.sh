#!/bin/sh
# check_layers.sh - who includes whom (DESIGN.md, "The house")
# SPDX-License-Identifier: MIT
. tests/check/report.sh

# includes FOLDER ALLOWED: "file:line: header" of every header not allowed.
includes() {
    find "$1" -name '*.[chS]' | sort | xargs awk -v allowed="$2" '
        /^[ \t]*#[ \t]*include/ {
            header = $0
            sub(/^[^"<A-Z]*/, "", header)
            sub(/[ \t].*$/, "", header)
            if (header !~ "^(" allowed ")$") {
                print FILENAME ":" FNR ": " header
            }
        }'
}

freestanding='<(stddef|stdint|stdbool|limits|float|string)\.h>'
verdict "engine includes only itself, freestanding headers and string.h" \
    "$(includes engine "\"engine/.*\"|$freestanding|PLT_LANES")"
verdict "PLT_LANES is named in one place" \
    "$(grep -rln 'include PLT_LANES' engine | grep -v '^engine/lanes/lanes.h$')"
verdict "platform includes only the engine's public headers and itself" \
    "$(includes platform '"engine/planelet[a-z0-9_]*\.h"|"platform/.*"|<.*>')"
verdict "board includes only the engine's public headers, platform and itself" \
    "$(includes board '"engine/planelet[a-z0-9_]*\.h"|"platform/.*"|"board/.*"|<.*>')"
verdict "host_tools includes nothing of tests" \
    "$(includes host_tools '"(engine|platform|board|host_tools)/.*"|<.*>')"
verdict "only host_tools and tests allocate" \
    "$(grep -rnE '\b(malloc|calloc|realloc|free|alloca|strdup)[[:space:]]*\(' \
        --include='*.[ch]' engine platform board)"
finish

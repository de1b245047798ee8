#!/bin/sh
# page.sh WEB_FOLDER LANES... - prints the page: all of it in one file, which needs no server
#
# The programs and the first scene are in it as base64.
# SPDX-License-Identifier: MIT
here=${0%/*}
web=$1
shift

data() { # ID FILE
    echo "<script type=\"application/octet-stream\" id=\"$1\">"
    base64 "$2"
    echo "</script>"
}

part() { # NAME
    case $1 in
    style) cat "$here/page.css" ;;
    script) cat "$here/engine.js" "$here/viewer.js" "$here/display.js" "$here/page.js" ;;
    data)
        echo '<script type="application/json" id="view">'
        cat "$here/marbles.json"
        echo '</script>'
        data marbles "$web/marbles.plt"
        for lanes in $lanes_all; do
            data "$lanes" "$web/$lanes.wasm"
        done
        ;;
    esac
}

lanes_all=$*
while IFS= read -r line; do
    case $line in
    @*@)
        line=${line#@}
        part "${line%@}"
        ;;
    *) printf '%s\n' "$line" ;;
    esac
done <"$here/page.html"

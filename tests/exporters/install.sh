#!/bin/sh
# install.sh NAME apt|npm PACKAGE... - one exporter, and a line with its versions
#
# Debian's packages are installed on the machine, npm's into $BUILD/exporters/npm/NAME. Exit
# status 1, with one line that says why, when it cannot. SPDX-License-Identifier: MIT
name=$1 from=$2
shift 2

not_there() {
    echo "not there: $name ($1)"
    exit 1
}

versions() {
    if [ "$from" = npm ]; then
        echo "$name: $*"
    else
        # shellcheck disable=SC2016
        echo "$name: $(dpkg-query -W -f '${Package} ${Version}, ' "$@" | sed 's/, $//')"
    fi
}

all_installed() {
    [ "$(dpkg-query -W -f '${db:Status-Abbrev}\n' "$@" 2>/dev/null | grep -c '^ii')" -eq $# ]
}

if [ "$from" = npm ]; then
    command -v npm >/dev/null 2>&1 || not_there "no npm"
    folder=$BUILD/exporters/npm/$name
    mkdir -p "$folder"
    if [ "$(cat "$folder/done" 2>/dev/null)" != "$*" ]; then
        npm install --silent --no-audit --no-fund --ignore-scripts --prefix "$folder" "$@" \
            >/dev/null 2>&1 || not_there "npm cannot fetch $*"
        echo "$*" >"$folder/done"
    fi
    versions "$@"
    exit 0
fi
command -v apt-get >/dev/null 2>&1 || not_there "no apt-get"
if ! all_installed "$@"; then
    root=
    [ "$(id -u)" -eq 0 ] || root=sudo
    export DEBIAN_FRONTEND=noninteractive
    $root apt-get install -y --no-install-recommends "$@" >/dev/null 2>&1 ||
        { $root apt-get update && $root apt-get install -y --no-install-recommends "$@"; } \
            >/dev/null 2>&1 || not_there "apt-get cannot install $*"
fi
versions "$@"

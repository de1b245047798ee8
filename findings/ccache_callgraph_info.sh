#!/bin/sh
# ccache_callgraph_info.sh - a ccache hit brings an object's stack usage, but not its call graph
#
# Software: Debian's ccache 4.8+really4.7.5-1 and gcc-12 12.2.0-14+deb12u1, x86-64.
# Input: a C file of two functions, compiled twice with -fstack-usage and -fcallgraph-info=su, as
# those do who bound a firmware's stack by its call graph; what the first run wrote is removed in
# between.
# Behaviour: the second run is a hit. It has a.o and a.su again, and no a.ci, without a warning and
# with status 0, though -fcallgraph-info makes gcc write that file beside the object, too. One would
# guess that both side files of one compilation are kept, or that a run that writes an unknown one
# is not cached. Tools that read the graph find objects without it, or leave their functions out.
# Output seen: "compiled: a.ci a.o a.su, from the cache: a.o a.su (1 hit)".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/archives/partial" "$folder/tree" "$folder/work"
for package in ccache=4.8+really4.7.5-1 gcc-12=12.2.0-14+deb12u1; do
    have=$(dpkg-query -W -f '${Package}=${Version}' "${package%%=*}" 2>/dev/null)
    if [ "$have" != "$package" ]; then
        apt-get install -y -qq --no-install-recommends --download-only \
            -o "Dir::Cache::archives=$folder/archives" "$package" >/dev/null 2>&1 ||
            { echo "cannot get $package"; exit 2; }
    fi
done
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
PATH=$folder/tree/usr/bin:$PATH
LD_LIBRARY_PATH=$folder/tree/usr/lib/$(uname -m)-linux-gnu
CCACHE_DIR=$folder/cache
export PATH LD_LIBRARY_PATH CCACHE_DIR
cd "$folder/work" || exit 2
cat >a.c <<'END'
int inner(int x) { return x + 1; }
int outer(int x) { return 2 * inner(x); }
END
compile() { # the files that a run leaves, in a row
    rm -f a.o a.su a.ci
    ccache gcc-12 -O1 -c -fstack-usage -fcallgraph-info=su a.c -o a.o || exit 2
    for file in a.ci a.o a.su; do
        [ ! -s "$file" ] || printf ' %s' "$file"
    done
}
first=$(compile)
second=$(compile)
hits=$(ccache --print-stats | awk '
    $1 == "direct_cache_hit" || $1 == "preprocessed_cache_hit" { n += $2 }
    END { print n + 0 }')
said="compiled:$first, from the cache:$second ($hits hit)"
echo "$said"
[ "$said" = "compiled: a.ci a.o a.su, from the cache: a.o a.su (1 hit)" ]

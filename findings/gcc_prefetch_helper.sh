#!/bin/sh
# gcc_prefetch_helper.sh - gcc 12 drops prefetches that stand in an inline function of their own
#
# Software: Debian's gcc-12 12.2.0-14+deb12u1, x86-64.
# Input: a traversal of a binary tree in C. A static inline function asks for a child before it is
# known whether it is visited: one line of a node, or two lines of a leaf, by __builtin_prefetch.
# Behaviour: -O2 has no prefetch at all in the machine code, without a warning: a function that
# does nothing but prefetch is taken for one without effects, and calls to it are removed before
# they are inlined. With the attribute always_inline, or with the same lines written out, all are
# there. One would guess that a prefetch, which has no other use than its effect, survives inlining.
# Output seen: "inline: 0 prefetches, always inline: 6".
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
version=12.2.0-14+deb12u1
mkdir -p "$folder/archives/partial" "$folder/tree"
apt-get install -y -qq --no-install-recommends --download-only \
    -o "Dir::Cache::archives=$folder/archives" "gcc-12=$version" >/dev/null 2>&1 ||
    { echo "cannot get gcc-12 $version"; exit 2; }
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
PATH=$folder/tree/usr/bin:$PATH
LD_LIBRARY_PATH=$folder/tree/usr/lib/$(uname -m)-linux-gnu
export PATH LD_LIBRARY_PATH
cat >"$folder/tree.c" <<'END'
struct node { float key; unsigned next[2]; };
struct leaf { float all[16]; };
HELPER void ask_child(const struct node *n, const struct leaf *l, unsigned link) {
    if (link & 1) {
        const char *leaf = (const char *)&l[link >> 1];
        __builtin_prefetch(leaf);
        __builtin_prefetch(leaf + 64);
    } else {
        __builtin_prefetch(&n[link >> 1]);
    }
}
float visit(const struct node *n, const struct leaf *l, unsigned at, int steps) {
    float sum = 0;
    for (int i = 0; i < steps; i++) {
        ask_child(n, l, n[at].next[0]);
        ask_child(n, l, n[at].next[1]);
        sum += n[at].key;
        at = n[at].next[sum > 1.0f] >> 1;
    }
    return sum;
}
END
count() { # HELPER
    gcc-12 -O2 "-DHELPER=$1" -S -o - "$folder/tree.c" | grep -c prefetch
}
said="inline: $(count 'static inline') prefetches, always inline: $(
    count 'static inline __attribute__((always_inline))')"
echo "$said"
[ "$said" = "inline: 0 prefetches, always inline: 6" ]

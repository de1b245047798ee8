#!/bin/sh
# clang_freestanding_builtin.sh - in clang -fbuiltin takes back -fno-builtin, not -ffreestanding
#
# Software: Debian's clang-14 1:14.0.6-12 and gcc-arm-none-eabi 15:12.2.rel1-1 (gcc 12.2).
# Input: a C function that reads a word at any address by memcpy of 4 bytes, for a Cortex-M4, which
# has an instruction for that, with -O2.
# Behaviour: -ffreestanding implies -fno-builtin in both compilers, so memcpy is called. -fbuiltin
# behind it brings the load back in gcc, as the last of two contrary options wins. In clang it
# brings the load back behind -fno-builtin, and does nothing behind -ffreestanding, without a
# warning: firmware built by both has a call for each such load in one of them. __builtin_memcpy is
# a load in both, always. One would guess that what an option implies is undone as the option is.
# Output seen: "gcc: load, call, load, load", "clang: load, call, call, load", for no option,
# -ffreestanding, -ffreestanding -fbuiltin and -fno-builtin -fbuiltin.
# Exit status 1 when that changes, 2 when the packages cannot be had: what is not installed is
# unpacked into a temporary folder. SPDX-License-Identifier: MIT
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
mkdir -p "$folder/archives/partial" "$folder/tree"
apt-get install -y -qq --no-install-recommends --download-only \
    -o "Dir::Cache::archives=$folder/archives" clang-14=1:14.0.6-12 \
    gcc-arm-none-eabi=15:12.2.rel1-1 >/dev/null 2>&1 ||
    { echo "cannot get clang-14 14.0.6 or gcc-arm-none-eabi 12.2"; exit 2; }
for package in "$folder"/archives/*.deb; do
    [ ! -e "$package" ] || dpkg-deb -x "$package" "$folder/tree" || exit 2
done
PATH=$folder/tree/usr/bin:$PATH
LD_LIBRARY_PATH=$folder/tree/usr/lib/$(uname -m)-linux-gnu:$folder/tree/usr/lib/llvm-14/lib
export PATH LD_LIBRARY_PATH
cat >"$folder/load.c" <<'END'
void *memcpy(void *to, const void *from, unsigned size);
unsigned load(const unsigned char *from) {
    unsigned word;
    memcpy(&word, from, sizeof word);
    return word;
}
END
try() { # COMMAND ...
    "$@" -O2 -S -o "$folder/load.s" "$folder/load.c" || { echo "no output"; return; }
    if grep -q '[[:space:]]bl*[[:space:]][[:space:]]*memcpy' "$folder/load.s"; then
        echo call
    else
        echo load
    fi
}
all() { # COMMAND ...
    echo "$(try "$@"), $(try "$@" -ffreestanding), $(try "$@" -ffreestanding -fbuiltin), $(
        try "$@" -fno-builtin -fbuiltin)"
}
said="gcc: $(all arm-none-eabi-gcc -mcpu=cortex-m4 -mthumb)
clang: $(all clang-14 --target=thumbv7em-none-eabi -mcpu=cortex-m4)"
echo "$said"
[ "$said" = "gcc: load, call, load, load
clang: load, call, call, load" ]

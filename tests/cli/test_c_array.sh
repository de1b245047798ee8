#!/bin/sh
# test_c_array.sh - scenes as C source: what compilers and the engine make of them
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
top=$PWD
library=$(absolute "${OUT:-$BUILD/host}/libplanelet.a")
begin c_array
quad quad.ply
run make knot --triangles 1000 -o knot.ply
strict="-Wall -Wextra -Wshadow -Werror -pedantic -I$top -I."
c="${CC:-cc} -std=c11 $strict"
cxx="c++ -std=c++11 $strict"
needs c++ || cxx=false

# use.h: `use` writes the image of a scene, or the hits of the rays on standard input.
cat >use.h <<'END'
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include "engine/planelet.h"

static int use(const plt_source *source, void *arena, size_t arena_bytes, const char *what) {
    plt_options options;
    plt_engine *engine;
    plt_fault fault;
    plt_ray ray[256];
    plt_hit hit[256];
    memset(&options, 0, sizeof options);
    options.packet_side = 8;
    if ((uintptr_t)source->mapped % PLT_ALIGN != 0) {
        return 2;
    }
    if (what[0] == 'i') {
        return fwrite(source->mapped, 1, source->bytes, stdout) != source->bytes;
    }
    if (plt_open(&engine, arena, arena_bytes, source, &options, &fault) != PLT_OK) {
        printf("%s\n", fault.message);
        return 3;
    }
    for (unsigned i = 0; i < 256; i++) {
        float f[8];
        if (fread(f, 4, 8, stdin) != 8) {
            return 4;
        }
        memcpy(ray[i].org, f, 12);
        ray[i].tmin = f[3];
        memcpy(ray[i].dir, f + 4, 12);
        ray[i].tmax = f[7];
    }
    plt_trace(engine, ray, hit, 256, 0);
    for (unsigned i = 0; i < 256; i++) {
        fwrite(&hit[i].t, 4, 1, stdout);
        fwrite(&hit[i].u, 4, 1, stdout);
        fwrite(&hit[i].v, 4, 1, stdout);
        fwrite(&hit[i].triangle, 4, 1, stdout);
    }
    return 0;
}
END

# program NAME FILE: NAME.c, which takes the scene of the header FILE.
program() {
    upper=$(echo "$1" | tr '[:lower:]' '[:upper:]')
    cat >"$1.main.c" <<END
#include "$2"
#include "$2" /* twice is once */
#include "use.h"

static uint64_t arena[(${upper}_ARENA_BYTES + 7) / 8 + 2];

int main(int count, char **word) {
    const plt_source source = ${upper}_SOURCE;
    char *aligned = (char *)arena + (PLT_ALIGN - (uintptr_t)arena % PLT_ALIGN) % PLT_ALIGN;
    if (source.bytes != sizeof $1 || source.bytes != ${upper}_BYTES || ${upper}_TRIANGLES == 0) {
        return 5;
    }
    return use(&source, aligned, ${upper}_ARENA_BYTES, count > 1 ? word[1] : "image");
}
END
}

# what PROGRAM says of knot.plt: its image, and the hits of 256 rays.
expect_knot() {
    "./$1" image >got </dev/null || echo "status $?"
    cmp got knot.plt 2>&1
    "./$1" hits >got <ray || { echo "status $?"; head -c 200 got; }
    cmp got knot.hits 2>&1
}

# A ray through each of 16 x 16 points.
awk 'BEGIN { for (i = 0; i < 256; i++) {
    print (i % 16 - 7.5) / 2.5, (int(i / 16) - 7.5) / 4, 9, 0, 0.01, 0.02, -1, 100 } }' | rays ray

# ---- one scene ---------------------------------------------------------------------

for flags in "--leaf 4" "--build device" "--nodes compact" \
    "--nodes compact --build device --geometry lattice:14"; do
    # shellcheck disable=SC2086
    run pack knot.ply -o knot.plt $flags
    # shellcheck disable=SC2086
    run pack knot.ply -o knot.h $flags
    verdict "pack $flags -o knot.h" "$([ "$status" -eq 0 ] || echo "status $status")"
    run trace knot.plt ray knot.hits
    verdict "... rays that hit and miss" "$(
        [ "$(hits knot.hits | grep -c 4294967295)" -gt 20 ] || echo "no misses"
        [ "$(hits knot.hits | grep -vc 4294967295)" -gt 20 ] || echo "no hits")"
    program knot_plt knot.h
    verdict "... C takes it: the image and its hits, bit for bit, in the arena that it names" "$(
        $c knot_plt.main.c "$library" -o knot_c 2>&1 && expect_knot knot_c)"
    verdict "... so does C++" "$(
        $cxx -c -x c++ knot_plt.main.c -o knot_cxx.o 2>&1 &&
            $cxx knot_cxx.o "$library" -o knot_cxx 2>&1 && expect_knot knot_cxx)"
done
verdict "... its text is ASCII in lines of 100 columns at most" "$(
    awk 'length > 100' knot.h | head -n 3
    LC_ALL=C grep -n '[^ -~]' knot.h | head -n 3)"
verdict "... says triangles, arenas, what made it, and that it is not to be edited" "$(
    sed '/\*\//q' knot.h >head
    run pack knot.ply -o host.h --leaf 4
    sed '/\*\//q' host.h >>head
    run pack knot.ply -o host.plt --leaf 4
    run info host.plt --json
    for word in 'do not edit' "$(number triangles <out) triangles" \
        "$(number image_bytes <out) bytes" \
        "$(number arena_bytes_needed <out) for packets of 8x8" 'licence' 'for the worst tree' \
        'planelet pack knot.ply -o host.h --leaf 4' \
        'planelet pack knot.ply -o knot.h --build device --nodes compact --geometry lattice:14'; do
        tr '\n' ' ' <head | sed 's/ \*  */ /g' | grep -qF "$word" || echo "not there: $word"
    done)"
cp quad.ply "it's a.ply"
run pack "it's a.ply" -o quoted.h --leaf=1 --repair
verdict "... quotes names as a shell wants them" "$(
    line=$(sed -n 's/^ \*     \(planelet pack .*\)/\1/p' quoted.h)
    [ "$line" = "planelet pack 'it'\\''s a.ply' -o quoted.h --leaf 1 --repair" ] || echo "$line")"
run pack quad.ply quad.ply quad.ply quad.ply quad.ply quad.ply quad.ply quad.ply quad.ply \
    quad.ply -o many.h
verdict "... and names eight of many meshes" "$(
    [ "$(sed '/triangles/q' many.h | grep -o quad.ply | wc -l)" -eq 8 ] || sed -n 1,6p many.h
    grep -q '(and 2 more)' many.h || echo "not a word about the others")"
cp knot.h before.h
# shellcheck disable=SC2086
run pack knot.ply -o knot.h $flags
same knot.h before.h "packing twice gives the same text"

run pack knot.ply -o knot.c
run pack knot.ply -o knot.plt
run trace knot.plt ray knot.hits
{ # the three lines that its head says
    echo '#include "use.h"'
    echo 'static _Alignas(PLT_ALIGN) unsigned char arena[65536];'
    sed -n 's/^ \*     \(extern .*;\)$/\1/p' knot.c
    echo 'int main(int count, char **word) {'
    sed -n 's/^ \*     \(plt_source .*;\)$/\1/p' knot.c
    echo 'return use(&source, arena, sizeof arena, count > 1 ? word[1] : "image"); }'
} >linked.c
verdict "pack -o knot.c: a file of its own, declared as its head says" "$(
    $c -c knot.c -o knot.o 2>&1 && $c linked.c knot.o "$library" -o linked 2>&1 &&
        expect_knot linked)"
verdict "... so when it is compiled as C++" "$(
    $cxx -c -x c++ knot.c -o knot.o 2>&1 && $c linked.c knot.o "$library" -o linked 2>&1 &&
        expect_knot linked)"
run pack knot.ply -o KNOT.C
verdict "an ending may be in capitals" "$(grep -q 'KNOT_plt\[' KNOT.C || head -n 5 KNOT.C)"
if needs arm-none-eabi-gcc; then
    for flags in '-x c' '-x c++'; do
        # Without an alignment of its own an array of bytes gets 1 or 4 here.
        # shellcheck disable=SC2086
        verdict "a Cortex-M has it in flash, aligned to 16 bytes ($flags)" "$(
            arm-none-eabi-gcc -mthumb -mcpu=cortex-m4 -Os -Wall -Wextra -Werror -fdata-sections \
                -ffreestanding $flags -c knot.c -o knot_arm.o 2>&1
            arm-none-eabi-objdump -h knot_arm.o >sections
            grep -A 1 'rodata.knot_plt ' sections | tr '\n' ' ' |
                grep -q '2\*\*[4-9] .*READONLY' || cat sections)"
    done
fi

# ---- names -------------------------------------------------------------------------

mkdir 'a*' 'dir.h'
cp quad.ply 'a*/q.ply'
long=$(awk 'BEGIN { while (i++ < 220) printf "x" }')
for pair in 'scene.h|scene_plt' '3d-model v2.h|scene_3d_model_v2_plt' 'häuser.h|h_user_plt' \
    '日本.h|scene_plt' 'int.h|int_plt' 'class.h|class_plt' 'time.h|time_plt' 'unix.h|unix_plt' \
    '_x.h|x_plt' '-dash.h|dash_plt' '.h|scene_plt' 'UPPER.H|UPPER_plt' 'a__b.h|a_b_plt' \
    'a.b.c.h|a_b_c_plt' 'tail_.h|tail_plt' 'dir.h/in.h|in_plt' \
    "$(printf 'new\nline\033.h')|new_line_plt" 'x"*?.h|x_plt' \
    "$long.h|$(echo "$long" | cut -c 1-28)_plt" \
    "3$long.h|scene_3$(echo "$long" | cut -c 1-27)_plt"; do
    file=${pair%|*} name=${pair#*|}
    # A mesh that is not there: nothing is written.
    run pack ./a\*/q.ply ./"$file" -o ./"$file"
    verdict "$(echo "$file" | tr -cd ' -~' | cut -c 1-30): nothing is there after a failure" "$(
        [ "$status" -eq 1 ] || echo "status $status"
        ls "$file" 2>/dev/null
        left_behind)"
    run pack ./a\*/q.ply -o "./$file"
    cp "./$file" copy.h
    program "$name" copy.h
    verdict "... is a $name, in C and C++" "$(
        trouble
        $c "$name.main.c" "$library" -o named 2>&1 && ./named >got || echo "status $?"
        run pack quad.ply -o quad.plt
        cmp got quad.plt 2>&1
        $cxx -fsyntax-only -x c++ "$name.main.c" 2>&1
        awk 'length > 100' copy.h
        LC_ALL=C grep '[^ -~]' copy.h)"
done

# ---- refusals ----------------------------------------------------------------------

for file in knot.h KNOT.C; do
    refused "info $file" "$file" "is a C array written by planelet pack; .*\.plt" info "$file"
    refused "render $file" "$file" "is a C array" render "$file" -o x.png
    refused "pack $file" "$file" "is a packed scene as a C array; .*\.plt" pack "$file" -o x.plt
done
cp knot.h old.h
(ulimit -f 8 && exec "$PLANELET" pack knot.ply -o old.h 2>err)
status=$?
verdict "when the disk fills up, the old file is there and no other" "$(
    refusal old.h "cannot write"
    cmp old.h knot.h 2>&1
    left_behind)"
ln -s /dev/full full.h
refused "a full disk" full.h "No space left" pack knot.ply -o full.h
refused "a folder" dir.h "is a directory" pack knot.ply -o dir.h
run pack quad.ply -o -
run pack quad.ply -o quad.plt
cp quad.plt again.plt
run pack quad.ply -o -
same out again.plt "standard output gets the image itself"
finish

#!/bin/sh
# test_remedies_files.sh - what messages about files, devices and limits advise, helps
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/remedies.sh
begin remedies_files
quad quad.ply
run pack quad.ply -o quad.plt
echo '0 0 5 0 0 0 -1 100' | rays ray
run make knot --triangles 3000 -o knot.ply
run pack knot.ply -o knot.plt
mkdir folder
cp quad.ply quad.plt ray folder
run pack quad.ply -o quad.h

# ---- inputs: host_tools/base/input.c ----------------------------------------------

says "check the spelling and the directory you are in" pack qaud.ply -o x.plt
packs 2 quad.ply
says "check the spelling and the directory you are in" pack folder/quad.ply/quad.ply -o x.plt
packs 2 folder/quad.ply
ln -s loop loop
says "check the path" pack loop -o x.plt
packs 2 quad.ply
says "is a directory; name a file in it" pack folder -o x.plt
packs 2 folder/quad.ply
says "is a device; name a file, or - for standard input" pack /dev/null -o x.plt
packs 2 quad.ply
says "is a device; name a file, or - for standard input" pack /dev/null -o x.plt
cured_by sh -c "\"$PLANELET\" pack - -o cured.plt <quad.ply"
: >empty.ply
says "is empty; write the file again" pack empty.ply -o x.plt
quad empty.ply
packs 2 empty.ply
says "the input has no name; give one, or - for standard input" pack '' -o x.plt
packs 2 quad.ply
says "the input has no name; give one, or - for standard input" pack '' -o x.plt
cured_by sh -c "\"$PLANELET\" pack - -o cured.plt <quad.ply"
says_by "the stream is closed: redirect a file to it" sh -c "\"$PLANELET\" pack - -o x.plt <&-"
cured_by sh -c "\"$PLANELET\" pack - -o cured.plt <quad.ply"
# With one descriptor left: the scene takes it, the rays get none.
says_by "too many files are open: raise the limit with ulimit -n" \
    limited n 4 "$PLANELET" trace quad.plt ray x.hits
cured_by limited n 16 "$PLANELET" trace quad.plt ray x.hits

# Of 100,000 KiB for all; the rays come before the arena, which is no larger than there is room.
truncate -s 120000000 large.ray
says_by "%llu bytes do not fit into memory; split the file or use a larger machine" \
    limited v 100000 "$PLANELET" trace quad.plt large.ray x.hits
head -c 320000 large.ray >part.ray
cured_by limited v 100000 "$PLANELET" trace quad.plt part.ray x.hits
truncate -s 64000000 large.ray
says_by "out of memory for %u rays; split the file" \
    limited v 100000 "$PLANELET" trace quad.plt large.ray x.hits
cured_by limited v 100000 "$PLANELET" trace quad.plt part.ray x.hits
truncate -s 35200000 large.ray
says_by "out of memory to sort %u rays; leave out --order sorted" \
    limited v 100000 "$PLANELET" trace quad.plt large.ray x.hits --order sorted
cured_by limited v 100000 "$PLANELET" trace quad.plt large.ray x.hits
rm large.ray

# ---- outputs: host_tools/base/output.c -----------------------------------------------

says "is a directory; name a file in it" pack quad.ply -o folder
cured pack quad.ply -o folder/x.plt
says "create the directory first, or correct the path" pack quad.ply -o new/x.plt
cured pack quad.ply -o folder/x.plt
says "create the directory first, or correct the path" pack quad.ply -o new/x.plt
mkdir new
cured pack quad.ply -o new/x.plt
says "there is no such directory; create it and name a file in it" pack quad.ply -o newer/
mkdir newer
cured pack quad.ply -o newer/x.plt
if [ -e /dev/fd/0 ] && [ -d /proc/self/fd ]; then
    for remedy in x.plt -; do
        exec 5>gone
        rm gone
        says "is a file without a name; name another one, or - for standard output" \
            pack quad.ply -o /dev/fd/5
        exec 5>&-
        cured pack quad.ply -o $remedy
    done
fi
$CC -std=c11 -Wall -Wextra "$CLI_TESTS/pty.c" -o pty 2>&1
for remedy in '-o x.plt' '-o - >x.plt' '-o - | cat >x.plt'; do
    ./pty both "$PLANELET" pack quad.ply -o - >seen 2>out </dev/null
    status=$?
    tr -d '\r' <seen >err
    message="is a terminal, on which these bytes are no text; name a file, or redirect it to a \
file or a program"
    said=$(unlike "$message")
    rm -f x.plt
    ./pty both sh -c "\"$PLANELET\" pack quad.ply $remedy 2>err" >seen 2>out </dev/null
    status=$?
    helped "$(cmp quad.plt x.plt 2>&1)"
done

for name in /dev/stdout /dev/stderr /dev/tty; do
    [ -e $name ] || continue
    rm -f err
    ./pty 1000000 sh -c "\"$PLANELET\" pack quad.ply -o $name; echo \$? >ended" >seen 2>out \
        </dev/null
    status=$(cat ended)
    tr -d '\r' <seen >err
    message="is your terminal, on which these bytes are no text; name a file"
    said=$(unlike "$message")
    rm -f x.plt
    ./pty 1000000 "$PLANELET" pack quad.ply -o x.plt >seen 2>out </dev/null
    status=$?
    helped "$(cmp quad.plt x.plt 2>&1)"
done

# ---- inputs that are outputs: host_tools/base/files.c --------------------------------------------

says "is the same %s as the %s %s; write to another one" pack quad.ply -o ./quad.ply
cured pack quad.ply -o x.plt
says "is the same %s as the %s %s; write to another one" \
    trace quad.plt ray x.hits --json ./x.hits
cured trace quad.plt ray x.hits --json x.json
# A program opens its scene before its outputs: only a stream is there before.
says_by "is the same %s as the %s %s; write to another one" \
    sh -c "\"$PLANELET\" pack quad.ply -o - >>quad.ply"
cured_by sh -c "\"$PLANELET\" pack quad.ply -o - >x.plt"
# redirected FILE COMMAND...: with standard error appended to it.
redirected() {
    file=$1
    shift
    sh -c 'file=$1; shift; exec "$@" 2>>"$file"' sh "$file" "$@"
}
# What was said went where nothing was harmed.
message="is the %s that standard error goes to; redirect that to another"
cp quad.ply kept.ply
for name in quad.ply ./x.plt; do # an input, and an output
    rm -f ./x.plt
    redirected $name "$PLANELET" pack quad.ply -o ./x.plt >out </dev/null
    status=$?
    [ $name = quad.ply ] && mv out err || tail -n 1 $name >err
    said=$(unlike "$message"; cmp quad.ply kept.ply 2>&1)
    cured_by redirected errors "$PLANELET" pack quad.ply -o ./x.plt
done
says "choose a shorter name" pack quad.ply -o "$(awk 'BEGIN { while (i++ < 300) printf "x" }')"
cured pack quad.ply -o x.plt
says "check the path and the disk" pack quad.ply -o loop
cured pack quad.ply -o x.plt
says "the output has no name; give one, or - for standard output" pack quad.ply -o ''
cured pack quad.ply -o x.plt
says "the output has no name; give one, or - for standard output" pack quad.ply -o ''
cured pack quad.ply -o -
says "free some space or write to another disk" pack quad.ply -o /dev/full
cured pack quad.ply -o x.plt
says_by "the file size limit is reached: raise it with ulimit -f" \
    limited f 8 "$PLANELET" pack knot.ply -o x.plt
cured_by limited f 1000 "$PLANELET" pack knot.ply -o x.plt
says_by "the stream is closed: redirect it to a file" sh -c "\"$PLANELET\" pack quad.ply -o - >&-"
cured_by sh -c "\"$PLANELET\" pack quad.ply -o - >x.plt"
# The scene and the hits take the two that there are, the statistics get none.
says_by "too many files are open: raise the limit with ulimit -n" \
    limited n 5 "$PLANELET" trace quad.plt ray x.hits --json x.json
cured_by limited n 16 "$PLANELET" trace quad.plt ray x.hits --json x.json
# mounted COMMAND...: with a disk that is read-only in `fixed`, which nobody else sees.
mkdir fixed
mounted() { unshare -rm sh -c 'mount -t tmpfs -o ro tmpfs fixed && "$@"' sh "$@"; }
if mounted true 2>/dev/null; then
    says_by "the disk is read-only: write to another one" \
        mounted "$PLANELET" pack quad.ply -o fixed/x.plt
    cured_by mounted "$PLANELET" pack quad.ply -o x.plt
else
    echo "    not tried without mounts of its own: a disk that is read-only"
fi
# into READER: pack into a pipe, and its status; SIGPIPE does not end it.
into() {
    { trap '' PIPE; sleep 0.2; "$PLANELET" pack quad.ply -o -; echo $? >ended; } | "$@" >/dev/null
    return "$(cat ended)"
}
says_by "the reader went away: keep it running" into true
cured_by into cat
if [ -n "$has_common" ]; then
    mkdir shut
    cp quad.ply mine.ply
    cp quad.plt shut.plt
    chmod 777 .
    chmod 555 shut
    chmod 000 mine.ply
    [ "$(id -u)" -ne 0 ] || chown 65534 shut mine.ply shut.plt
    says_by "make it readable with chmod +r, or run as its owner" \
        common "$PLANELET" pack mine.ply -o x9.plt
    chmod +r mine.ply
    cured_by common "$PLANELET" pack mine.ply -o x9.plt
    says_by "write to a directory you own, or change its permissions" \
        common "$PLANELET" pack quad.ply -o shut/x.plt
    common chmod u+w shut
    cured_by common "$PLANELET" pack quad.ply -o shut/x.plt
    chmod 444 shut.plt
    says_by "is write-protected; choose another name or chmod u+w it" \
        common "$PLANELET" pack quad.ply -o shut.plt
    cured_by common "$PLANELET" pack quad.ply -o other.plt
    says_by "is write-protected; choose another name or chmod u+w it" \
        common "$PLANELET" pack quad.ply -o shut.plt
    common chmod u+w shut.plt
    cured_by common "$PLANELET" pack quad.ply -o shut.plt
    chmod 755 .
else
    echo "    not tried as root without setpriv: three remedies of missing permission"
fi

# ---- scenes: board/host/scene.c, host_tools/app/scene.c -----------------------------------

says "name the .plt file itself" render folder -o x.png
cured render folder/quad.plt -o x.png
mkfifo pipe
says "store the scene in a file first" render pipe -o x.png
cat quad.plt >stored.plt
cured render stored.plt -o x.png
: >empty.plt
says "pack the scene again" render empty.plt -o x.png
run pack quad.ply -o empty.plt
cured render empty.plt -o x.png
truncate -s 4294967296 large.plt
says "a scene image is smaller; is it one?" render large.plt -o x.png
cured render quad.plt -o x.png
says "is 4 GiB or larger; a scene image is smaller, is it one?" \
    serve large.plt -o x.png --size 8x8 --emulate 600000
rm large.plt
cured serve quad.plt -o x.png --size 8x8 --emulate 600000
says "is a C array written by planelet pack; pack the meshes with -o SCENE.plt to look at them" \
    render quad.h -o x.png
run pack quad.ply -o SCENE.plt
cured render SCENE.plt -o x.png
says "check its name and permissions" render qaud.plt -o x.png
cured render quad.plt -o x.png
says "the scene has no name; give the file that planelet pack wrote" render '' -o x.png
cured render quad.plt -o x.png
says "is it one? planelet pack makes them from meshes" render quad.ply -o x.png
run pack quad.ply -o packed.plt
cured render packed.plt -o x.png
{ head -c 300 quad.plt; printf 'damage'; tail -c +307 quad.plt; } >damaged.plt
says "pack the scene again" render damaged.plt -o x.png
run pack quad.ply -o damaged.plt
cured render damaged.plt -o x.png
for command in 'render knot.plt -o x.png' 'render knot.plt -o x.png --source read' \
    'trace knot.plt ray x.hits --json x.json'; do
    # shellcheck disable=SC2086
    says "needs an arena of %zu bytes and has %zu; use --arena %zu" $command --arena 1000
    # shellcheck disable=SC2046,SC2086
    cured $command $(sed 's/.*use //' err)
done
# A file of /sys says that it has a page, and ends before.
page=/sys/kernel/mm/transparent_hugepage/enabled
if [ -r $page ]; then
    says "byte %u: %s; is the file still whole?" render $page -o x.png --source read
    cured render quad.plt -o x.png --source read
fi
run make terrain --triangles 400000 -o big.ply
run pack big.ply -o big.plt
run pack big.ply -o worst.plt --build device
# A scene of 19 MiB, mapped or read, where there are 20 for all.
says_by "no room for it; raise the limit with ulimit -v, or close other programs" \
    limited v 20000 "$PLANELET" render big.plt -o x.png --size 64x64
cured_by limited v unlimited "$PLANELET" render big.plt -o x.png --size 64x64
says_by "this machine has no room for an arena of %zu bytes; raise the limit with ulimit -v, or \
close other programs" limited v 20000 "$PLANELET" render big.plt -o x.png --size 64x64 \
    --source read
cured_by limited v unlimited "$PLANELET" render big.plt -o x.png --size 64x64 --source read
says_by "this machine has no room for an arena of %zu bytes; use --arena %zu" \
    limited v 800000 "$PLANELET" render quad.plt -o x.png --size 8x8 --arena 1073741824
cured_by limited v 800000 "$PLANELET" render quad.plt -o x.png --size 8x8 \
    --arena "$(sed 's/.*use --arena //' err)"
says_by "this machine has no room for %u arenas of %zu bytes, one per worker; use --workers 1" \
    limited v 1500000 "$PLANELET" render quad.plt -o x.png --size 8x8 --arena 1073741824 \
    --workers 2
cured_by limited v 1500000 "$PLANELET" render quad.plt --size 8x8 --workers 1 \
    --arena 1073741824 -o x.png
# An image of 15 MiB that asks for 41 of arena, where there are 58 for all.
for remedy in 'unlimited' '60000 --arena 30000000'; do
    message="this machine has no room for an arena of %zu bytes; raise the limit with ulimit -v, \
close other programs, or try --arena BYTES with fewer"
    says_by "$message" limited v 60000 "$PLANELET" render worst.plt -o x.png --size 64x64
    # shellcheck disable=SC2086
    cured_by limited v ${remedy%% *} "$PLANELET" render worst.plt -o x.png --size 64x64 \
        $(echo "$remedy" | cut -s -d ' ' -f 2-)
done
# Not a full disk, but what a full disk says.
if mounted sh -c 'mount -t tmpfs tmpfs /dev && exec <&-' 2>/dev/null; then
    mounted sh -c 'mount -t tmpfs tmpfs /dev && exec "$0" --version <&-' "$PLANELET" >out 2>err
    status=$?
    verdict "no /dev/null is needed where a standard stream is closed" "$(
        [ $status -eq 0 ] || cat err)"
fi
says_by "it is closed: redirect it to a file" sh -c "\"$PLANELET\" --help >&-"
cured_by sh -c "\"$PLANELET\" --help >help"
says_by "is the disk full?" \
    sh -c "\"$PLANELET\" --help >/dev/full"
cured_by sh -c "\"$PLANELET\" --help >help"
says_by "the picture cannot be drawn; is the disk full?" \
    sh -c "\"$PLANELET\" render quad.plt --show >/dev/full"
cured_by sh -c "\"$PLANELET\" render quad.plt --show >shown"
finish

#!/bin/sh
# test_serve.sh - planelet serve: what it refuses before it waits, and frames that are render's
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin serve
run make knot --triangles 500 -o knot.ply
run pack knot.ply -o knot.plt

# at_once WORD ARGUMENT...: wrong usage that names WORD, not after --timeout seconds.
at_once() {
    began=$(date +%s)
    word=$1
    shift
    misused "serve $* is wrong usage" "$word" serve knot.plt --timeout 20 "$@"
    verdict "... and is so at once" "$([ $(($(date +%s) - began)) -lt 10 ] || echo "it waited")"
}
for port in 0 65536 99999 x; do
    at_once --listen --listen $port -o x.png
done
for link in "--listen 40123" --pty "--socket x.socket" "--emulate 600000"; do
    # shellcheck disable=SC2086
    {
        at_once ".y4m" $link -o x.png --orbit 3
        at_once ".y4m" $link -o x.jpg
        at_once --show $link -o - --show
        at_once "--show" $link
        at_once --size $link -o x.png --size 512x272
        at_once --size $link -o x.png --size 0x16
        at_once --fov $link -o x.png --fov 180
        at_once --eye $link -o x.png --eye 1,2
        at_once --shader $link -o x.png --shader toon
        at_once --shader $link -o x.png --shader smooth
        at_once --samples $link -o x.png --samples 2
        at_once --background $link -o x.png --background 12345
        at_once --report $link -o x.png --report 7
        at_once --format $link -o x.png --format rgb
    }
done
at_once --emulate --emulate 1023 -o x.png
at_once "one of --pty" -o x.png
at_once "one of --pty" -o x.png --pty --emulate 600000
# soon NAME WHERE ARGUMENT...: refused before it waits for a device.
soon() {
    began=$(date +%s)
    name=$1 where=$2
    shift 2
    refused "serve $* is refused" "$name" "$where" serve knot.plt --timeout 20 --pty "$@"
    verdict "... before it waits" "$([ $(($(date +%s) - began)) -lt 10 ] || echo "it waited")"
}
soon camera "coincide" -o x.png --eye 1,1,1 --look 1,1,1
soon camera "up runs along" -o x.png --eye 0,5,0 --look 0,0,0
soon camera "its orbit" -o x.y4m --orbit 7 --eye 1e12,0,1e12 --up 0,1,0
soon missing/x.png "create the directory" -o missing/x.png
verdict "nothing was written" "$(
    ls x.* 2>/dev/null
    left_behind)"

works "serve to a file" serve knot.plt --emulate 600000 -o served.ppm --size 48x32
run render knot.plt -o rendered.ppm --size 48x32
same served.ppm rendered.ppm "... gives the picture of render"
for samples in 4 16 adaptive; do
    works "serve --samples $samples --background" serve knot.plt --emulate 600000 -o served.ppm \
        --size 48x32 --samples $samples --background ff8000
    run render knot.plt -o more.ppm --size 48x32 --samples $samples --background ff8000
    same served.ppm more.ppm "... gives the picture of render"
    verdict "... which is another than without" "$(
        cmp -s more.ppm rendered.ppm && echo "it is not")"
done
"$PLANELET" serve - --emulate 600000 -o piped.ppm --size 48x32 <knot.plt 2>err
same piped.ppm rendered.ppm "... also of a scene on standard input"
works "serve --orbit" serve knot.plt --emulate 600000 -o served.y4m --orbit 3 --size 48x32
run render knot.plt -o rendered.y4m --orbit 3 --size 48x32
same served.y4m rendered.y4m "... gives the film of render"
run make knot --triangles 20000 -o blocks.ply
run pack blocks.ply -o blocks.plt --nodes compact --geometry lattice:14
run render blocks.plt -o rendered.ppm --size 48x32
image=$(wc -c <blocks.plt | tr -d ' ')
run serve blocks.plt --emulate 60000 -o served.ppm --size 48x32
verdict "serve of a scene that the device has no room for says how much of it was streamed" "$(
    [ "$status" -eq 0 ] || echo "status $status"
    grep -qx "serve: streamed [0-9]* bytes for [0-9]* requests (the image has $image)" err ||
        cat err
    [ "$image" -gt 60000 ] || echo "$image bytes have room")"
same served.ppm rendered.ppm "... and gives the picture of render"
run render knot.plt -o rendered.ppm --size 48x32
run serve knot.plt --emulate 600000 -o - --size 48x32
same out rendered.ppm "... and -o - the picture on standard output"
at_once "two different files" --socket x.png -o x.png
at_once --socket --socket '' -o x.png
: >x.png
at_once "two different files" --socket x.png -o x.png
refused "an output that is there already cannot be the socket" x.png "is a file, not a socket" \
    serve knot.plt --socket x.png -o y.png --timeout 1
rm x.png
run serve knot.plt --socket ./x.png -o x.png --timeout 1
verdict "an output that is the socket under another name is refused" "$(
    refusal x.png "cannot open"
    ls x.png 2>/dev/null)"
# gone SIGNAL: it ends serve, which has removed its socket.
gone() {
    : >waiting
    # A shell's own background commands ignore some signals.
    ./pty err sh -c 'echo $$ >pid; exec "$@" 2>waiting' sh "$PLANELET" serve knot.plt \
        --socket here -o x.ppm --size 16x16 >seen 2>out </dev/null &
    terminal=$!
    for i in $(seq 200); do [ -s waiting ] || sleep 0.05; done
    there=$([ -S here ] || echo "there was no socket")
    kill -s "$1" "$(cat pid)"
    wait $terminal
    verdict "SIG$1 ends serve, which leaves no socket and no output" "$(
        echo "$there" | grep .
        ls here x.ppm 2>/dev/null
        left_behind)"
    rm -f here
}
$CC -std=c11 -Wall -Wextra "$CLI_TESTS/pty.c" -o pty 2>trouble ||
    verdict "the terminal of the tests builds" "$(cat trouble)"
for signal in INT TERM HUP; do
    gone $signal
done
# Its size modulo 4 GiB is that of the scene.
cp knot.plt large.plt
dd if=/dev/zero of=large.plt bs=1 count=0 seek=$((4294967296 + $(wc -c <knot.plt))) 2>trouble
refused "a scene with 4 GiB behind it" large.plt "4 GiB" \
    serve large.plt --emulate 600000 -o x.png --size 16x16
rm -f large.plt
# A PPM may be several pictures in a row; a PNG is one.
run serve knot.plt --emulate 600000 -o two.ppm --orbit 2 --size 16x16
verdict "two frames go into one PPM, one after another" "$(
    [ "$status" -eq 0 ] || cat err
    [ "$(wc -c <two.ppm)" -eq $((2 * (13 + 768))) ] || wc -c <two.ppm)"
misused "... but not into one PNG" "--orbit" serve knot.plt --emulate 600000 -o two.png --orbit 2

finish

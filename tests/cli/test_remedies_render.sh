#!/bin/sh
# test_remedies_render.sh - what messages about cameras, rays and links advise, helps
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/remedies.sh
top=$PWD
begin remedies_render
TERM=xterm
export TERM
run make ground -o ground.ply
run pack ground.ply -o ground.plt
run make knot --triangles 3000 -o knot.ply
run pack knot.ply -o knot.plt
echo '0 5 0 0 0 -1 0 100' | rays ray

# ---- hints at a terminal: following them leads from a mesh to a picture ------------------------

$CC -std=c11 -Wall -Wextra "$CLI_TESTS/pty.c" -o pty 2>&1
planelet() { "$PLANELET" "$@"; }
message="next: planelet pack %s -o %s.plt"
./pty err "$PLANELET" make marbles -o marbles.ply >seen </dev/null
said=$(grep -q -- "$(pattern "$message")" seen || cat seen)
eval "$(tr -d '\r' <seen | sed -n 's/^next: //p')" >out 2>err
status=$?
helped "$([ -s marbles.plt ] || echo "no marbles.plt")"
message="next: planelet pack --materials keep --smooth 40 %s -o %s.plt"
rm marbles.plt
./pty err "$PLANELET" make marbles -o marbles.obj >seen </dev/null
said=$(grep -q -- "$(pattern "$message")" seen || cat seen)
eval "$(tr -d '\r' <seen | sed -n 's/^next: //p')" >out 2>err
status=$?
helped "$([ -s marbles.plt ] || echo "no marbles.plt")"
message="next: planelet pack --instances %s -o %s.plt"
./pty err "$PLANELET" make marbles --instances -o marbles.txt >seen </dev/null
said=$(grep -q -- "$(pattern "$message")" seen || cat seen)
eval "$(tr -d '\r' <seen | sed -n 's/^next: //p')" >out 2>err
status=$?
helped "$([ -s marbles.plt ] || echo "no marbles.plt")"
./pty err "$PLANELET" make room --triangles 24000 -o room.ply >seen </dev/null
run pack room.ply -o room.plt
eval "$(tr -d '\r' <seen | sed -n 's/^then, from inside: //p')" >out 2>err
verdict "a room's second hint shows it from inside" "$([ "$(wc -l <out)" -gt 10 ] || cat seen err)"
message="; next: planelet render "
./pty err "$PLANELET" pack marbles.ply -o marbles.plt >seen </dev/null
said=$(grep -q -- "$(pattern "$message")" seen || cat seen)
eval "$(tr -d '\r' <seen | sed -n 's/.*; next: //p')" >out 2>err
status=$?
helped "$([ "$(wc -l <out)" -gt 10 ] || echo "no picture")"
message="%s: %u triangle%s, %u bytes, %.1f s; next: compile it, its head says how to use it"
./pty err "$PLANELET" pack marbles.ply -o marbles.h >seen </dev/null
said=$(grep -q -- "$(pattern "$message")" seen || cat seen)
{
    echo '#include "engine/planelet.h"'
    echo '#include "marbles.h"'
    sed -n 's/^ \*  *\(plt_source source = .*;\)$/\1/p' marbles.h
} >marbles.c
cured_by $CC -std=c11 -Wall -Wextra -I "$top" -c marbles.c

# ---- pictures: cmd_render.c, host_tools/picture --------------------------------------------------

look='--eye 0,9,20 --look 0,0,0'
# sees ARGUMENT...: with them the scene is rendered.
sees() {
    cured render ground.plt -o x.png --size 64x48 "$@"
}
same='--eye 0,1,0 --look 0,1,0'
# shellcheck disable=SC2086
{
    for remedy in '--eye 0,9,20 --look 0,1,0' '--eye 0,1,0 --look 9,0,0'; do
        says "eye and look coincide; change --eye or --look" render ground.plt -o x.png $same
        sees $remedy
    done
    says "up has no direction; change --up" render ground.plt -o x.png $look --up 0,0,0
    sees $look --up 0,1,0
    for remedy in '--eye 9,9,20 --look 0,0,0' '--eye 0,9,20 --look 5,0,0' "$look --up 0,1,0"; do
        says "up runs along the view; change --eye, --look or --up" \
            render ground.plt -o x.png $look --up 0,9,20
        case $remedy in
        *--up*) sees $remedy ;;
        *) sees $remedy --up 0,9,20 ;;
        esac
    done
    says "its orbit goes beyond 2^40; move --eye nearer to --look" \
        render ground.plt -o x.y4m --size 8x8 --orbit 8 --eye 1e12,0,1e12
    cured render ground.plt -o x.y4m --size 8x8 --orbit 8 --eye 1e11,0,1e11
}
printf 'v 0 0 0\nv 1e12 0 0\nv 1e12 1e12 0\nf 1 2 3\n' >huge.obj
run pack huge.obj -o huge.plt
for remedy in '--eye 5e11,5e11,1e12' '--fov 150'; do
    says "all is seen only from beyond 2^40; choose a nearer --eye, or a wider --fov" \
        render huge.plt -o x.png --size 64x48
    # shellcheck disable=SC2086
    cured render huge.plt -o x.png --size 64x48 $remedy
done

run pack knot.ply -o thesis.plt --treelet 257
says "%s; pack it with --nodes compact, or use --residency resident" \
    render thesis.plt -o x.png --residency streamed
cured render thesis.plt -o x.png --residency resident
run pack knot.ply -o compact.plt --nodes compact --geometry lattice:14
cured render compact.plt -o x.png --residency streamed
run pack knot.ply -o thesis.plt
says "%s; leave out --walk two-stage" \
    render thesis.plt -o x.png --residency streamed --walk two-stage
cured render thesis.plt -o x.png --residency streamed
says "--store is for --residency streamed" render compact.plt -o x.png --store 65536
for schedule in batch task; do
    says "--schedule %s is for --residency streamed" \
        render compact.plt -o x.png --schedule $schedule
done
says "--batch is for --schedule batch or task" \
    render compact.plt -o x.png --residency streamed --batch 2
cured render compact.plt -o x.png --residency streamed --store 65536
for flags in '--samples adaptive' '--shader heat'; do
    # shellcheck disable=SC2086
    case $flags in
    *heat) says "--shader heat is for --schedule branch; leave out --schedule" \
        render compact.plt -o x.png --residency streamed --schedule batch $flags ;;
    *) says "--samples adaptive is for --schedule branch; leave out --schedule" \
        render compact.plt -o x.png --residency streamed --schedule task $flags ;;
    esac
    # shellcheck disable=SC2086
    cured render compact.plt -o x.png --residency streamed $flags
done
says "--shader depth and heat are for the engine; leave out --baseline" \
    render knot.plt -o x.png --shader depth --baseline kd
cured render knot.plt -o x.png --shader depth
says "packets of 2x2 rays have no room for 16 samples; use --samples 4 or --packet 4" \
    render knot.plt -o x.png --packet 2 --samples 16
cured render knot.plt -o x.png --packet 2 --samples 4
cured render knot.plt -o x.png --packet 4 --samples 16
cured render knot.plt -o x.png --shader whitted --samples adaptive --depth 1
says "--prefetch is for --residency streamed" render compact.plt -o x.png --prefetch 4
cured render compact.plt -o x.png --residency streamed --prefetch 4
says "--source dma is for --residency streamed" render compact.plt -o x.png --source dma:1,20
says "--source dma is for one worker; leave out --workers" render compact.plt -o x.png \
    --residency streamed --source dma:1,20 --workers 2
cured render compact.plt -o x.png --residency streamed --source dma:1,20
says "--source dma:LATENCY_US,MB_PER_S[,OUTSTANDING] takes 0 to 1000, 0.1 to 10000 and 1 to %d, \
not 'dma:%s'" render compact.plt -o x.png --residency streamed --source dma:1
cured render compact.plt -o x.png --residency streamed --source dma:1000,0.1,64
says "--moved is for --residency resident" \
    render compact.plt -o x.png --residency streamed --moved knot.ply
says "%s; pack frames with --nodes compact --stills, or use --residency resident" \
    render compact.plt -o x.y4m --residency streamed --frames 0:1
says "%s; pack it with --nodes thesis, or leave out --moved and --frames" \
    render compact.plt -o x.png --moved knot.ply
run pack knot.ply -o thesis.plt --nodes thesis
cured render thesis.plt -o x.png --moved knot.ply
cured render compact.plt -o x.png
says "%s; pack it with --nodes thesis, or leave out --structure" \
    render compact.plt -o x.png --structure grid
cured render thesis.plt -o x.png --structure grid
says "--structure grid is for --residency resident" \
    render thesis.plt -o x.png --structure grid --residency streamed
cured render thesis.plt -o x.png --structure grid --residency resident
says "--structure grid is for --walk depth" \
    render thesis.plt -o x.png --structure grid --walk two-stage
cured render thesis.plt -o x.png --structure grid --walk depth
says "--frames takes A:B, 0 to %d, A below B, not '%s'" \
    render thesis.plt -o x.png --moved knot.ply --frames 2
cured render thesis.plt -o x.png --moved knot.ply --frames 2:3
says "has no frames; pack it with --sequence, or give --moved MESH" \
    render thesis.plt -o x.png --frames 0:1
cured render thesis.plt -o x.png --moved knot.ply --frames 0:1
says "--rebuild takes never, always, threshold:PERCENT (1 to %d) or cost, not '%s'" \
    render thesis.plt -o x.png --moved knot.ply --rebuild threshold
cured render thesis.plt -o x.png --moved knot.ply --rebuild threshold:1
says "--rebuild is for --moved MESH or --frames A:B" render thesis.plt -o x.png --rebuild cost
cured render thesis.plt -o x.png --moved knot.ply --rebuild cost
says "--rebuild is for --structure tree: a grid is made anew in any case" \
    render thesis.plt -o x.png --moved knot.ply --rebuild cost --structure grid
cured render thesis.plt -o x.png --moved knot.ply --structure grid
says "--rebuild-most is for --rebuild always, threshold:PERCENT or cost" \
    render thesis.plt -o x.png --moved knot.ply --rebuild-most 99
cured render thesis.plt -o x.png --moved knot.ply --rebuild cost --rebuild-most 99
says "--rebuild-most is for --walk depth" \
    render thesis.plt -o x.png --moved knot.ply --rebuild cost --rebuild-most 99 --walk two-stage
cured render thesis.plt -o x.png --moved knot.ply --rebuild cost --rebuild-most 99
says "--rebuild-step is for --rebuild always, threshold:PERCENT or cost" \
    render thesis.plt -o x.png --moved knot.ply --rebuild-step 9
cured render thesis.plt -o x.png --moved knot.ply --rebuild cost --rebuild-step 9
says "%s and --orbit are two films; leave out one of them" \
    render thesis.plt -o x.y4m --moved knot.ply --orbit 2
cured render thesis.plt -o x.y4m --orbit 2
run make knot -o other.ply --triangles 100
says "frame %u: has %zu triangles, the scene %u; pack the scene from frame 0 of the same mesh" \
    render thesis.plt -o x.png --moved other.ply
run pack other.ply --frame 0 -o other.plt
cured render other.plt -o x.png --moved other.ply
run pack knot.ply -o compact.plt --nodes compact
says "%s; leave out --walk two-stage" render compact.plt -o x.png --walk two-stage
cured render compact.plt -o x.png

# ---- films: host_tools/app/destination.c -----------------------------------------------------

message="%s: H.264 wants an even width and height; choose another --size for ffmpeg, or --chroma \
444"
# film ARGUMENT...: as a person at a terminal makes one; what was noted is in `err`.
film() {
    ./pty err "$PLANELET" "$@" >seen 2>out </dev/null
    status=$?
    tr -d '\r' <seen >err
}
# encodes: trouble, unless H.264 takes x.y4m, or nobody can try it here.
if ffmpeg -hide_banner -encoders 2>/dev/null | grep -q libx264; then
    encodes() { ffmpeg -nostdin -v error -y -i x.y4m x.mp4 2>&1; }
else
    echo "    not tried without ffmpeg and libx264: films of odd sizes"
    encodes() { :; }
fi
for command in 'render ground.plt' 'serve ground.plt --emulate 400000'; do
    for odd in 33x32 32x33; do
        for remedy in '34x34' "$odd --chroma 444"; do
            # shellcheck disable=SC2086
            {
                film $command -o x.y4m --orbit 2 --size $odd
                said=$(grep -q -- "$(pattern "$message")" err || cat err)
                film $command -o x.y4m --orbit 2 --size $remedy
            }
            helped "$(
                grep -- "$(pattern "$message")" err
                encodes)"
        done
    done
done

# ---- rays: cmd_trace.c ----------------------------------------------------------------------

head -c 31 ray >short
says "byte %zu: the last ray is cut short (a ray has 32 bytes); write it again" \
    trace ground.plt short x.hits
cp ray short
cured trace ground.plt short x.hits

# ---- counts of packets: counted.c, baselines/counted --------------------------------------------

say='render ground.plt -o counted.ppm --size 9x9 --counts'
# shellcheck disable=SC2086
{
    says "--counts are written to --json; add that" $say
    cured $say --json counted.json
    says "--baseline counts packets by itself; leave out --counts" \
        $say --json counted.json --baseline bph
    cured render ground.plt -o counted.ppm --size 9x9 --json counted.json --baseline bph
    says "--counts are of packets; leave out --rays incoherent" \
        trace ground.plt ray x.hits --counts --json counted.json --rays incoherent
    cured trace ground.plt ray x.hits --counts --json counted.json
    for flag in '--residency streamed' '--structure grid'; do
        says "--counts are of resident thesis nodes; leave it out, or pack with --nodes thesis and \
render without --residency or --structure" $say --json counted.json $flag
        cured $say --json counted.json
    done
}

# ---- measuring: cmd_bench.c, host_tools/app/ray_kinds.c -----------------------------------------

for remedy in '--eye 0,1,8 --look 0,0,0' '--eye 0,1,9 --look 0,0,0'; do
    says "no primary ray hits it; choose another --eye or --look" \
        bench ground.plt --size 9x9 --repeat 1 --eye 0,1,9 --look 0,1,99
    # shellcheck disable=SC2086
    cured bench ground.plt --size 9x9 --repeat 1 $remedy
done
says "no such mode is for its nodes; add --walks depth" \
    bench compact.plt --size 9x9 --repeat 1 --walks two-stage
cured bench compact.plt --size 9x9 --repeat 1 --walks two-stage,depth
against='bench ground.plt --size 9x9 --repeat 1 --kinds primary --packets 8 --against'
# shellcheck disable=SC2086
{
    says "--against has one walk and thesis nodes; leave out --walks and --nodes" \
        $against kd --nodes thesis
    cured $against kd
    says "%s takes %d structures at most" \
        $against 'kd kd kd kd kd kd kd kd kd kd kd kd kd kd kd kd kd'
    cured $against 'kd kd kd kd kd kd kd kd kd kd kd kd kd kd kd kd'
    says "a name of %zu characters; choose each switch once" \
        $against "wbvh:$(awk 'BEGIN { while (i++ < 20) printf "sah,sah," }')"
    cured $against wbvh:sah
    says "%s %s: none of its packets is in --packets; leave --packets out" \
        $against wbvh:4x4
    cured bench ground.plt --size 9x9 --repeat 1 --kinds primary --against wbvh:4x4
    says "--structures and --against are two tables; give one of them" \
        $against wbvh --structures kd
    cured $against wbvh
}
rows='bench ground.plt --size 9x9 --repeat 1 --kinds primary --packets 8 --structures'
# shellcheck disable=SC2086
{
    says "--walks are the engine's; add engine to --structures" $rows wbvh --walks depth
    cured $rows 'engine wbvh' --walks depth
    says "--structures are beside thesis nodes; leave out --nodes" $rows wbvh --nodes thesis
    cured $rows wbvh
}

# ---- links: cmd_serve.c, host_tools/link ----------------------------------------------------

small='-o x.ppm --size 64x48'
# shellcheck disable=SC2086
{
    head -c 300 ground.ply >bad.plt
    says "%s; pack the mesh again" serve bad.plt $small --emulate 400000
    run pack ground.ply -o bad.plt
    cured serve bad.plt $small --emulate 400000
    { head -c 300 knot.plt; printf 'damage'; tail -c +307 knot.plt; } >bad.plt
    says "the scene was refused: rule %c%u at byte %u; pack it again" \
        serve bad.plt $small --emulate 4000000
    run pack knot.ply -o bad.plt
    cured serve bad.plt $small --emulate 4000000
    run pack knot.ply -o smaller.plt --nodes compact --leaf 4
    run pack knot.ply -o blocks.plt --nodes compact --geometry lattice:14
    run pack knot.ply -o device.plt --build device # is not streamed
    says "the image of %u bytes does not fit in its %u; pack it %s" \
        serve device.plt $small --emulate 60000
    cured serve smaller.plt $small --emulate 60000
    cured serve blocks.plt $small --emulate 60000
    says "the scene needs %u bytes there, it has %u; pack it smaller" \
        serve knot.plt $small --emulate 20000
    cured serve smaller.plt $small --emulate "$(wc -c <knot.plt)"
    says "up has no direction; change --up" serve ground.plt $small --emulate 400000 --up 0,0,0
    cured serve ground.plt $small --emulate 400000 --up 0,1,0
    says "--size %ux%u has more than %d tiles of 16x16, which is the most" \
        serve ground.plt -o x.ppm --size 9000x9000 --emulate 400000
    cured serve ground.plt -o x.ppm --emulate 400000 --size "$(
        sed 's/.* more than \([0-9]*\) tiles of \([0-9]*\)x.*/\1 \2/' err |
            awk '{ print $2 "x" $2 }')"
    says_by "no room for its %zu bytes; give it fewer with --emulate" \
        limited v 300000 "$PLANELET" serve ground.plt $small --emulate 1073741824
    cured_by limited v 300000 "$PLANELET" serve ground.plt $small --emulate 400000
    says_by "too many files are open: raise the limit with ulimit -n" \
        limited n 4 "$PLANELET" serve ground.plt $small --emulate 400000
    cured_by limited n 16 "$PLANELET" serve ground.plt $small --emulate 400000
    says "%s; is it connected, and does it render?" \
        serve ground.plt $small --socket nobody --timeout 1
    cured serve ground.plt $small --emulate 400000 --timeout 60
}

# waits ARGUMENT...: serve gets as far as waiting for a device; nobody connects.
waits() {
    "$PLANELET" serve ground.plt -o x.ppm --timeout 1 "$@" >out 2>err </dev/null
    [ $? -eq 1 ] && head -n 1 err | grep '^serve: waiting for a device at' >waiting
}
long=$(awk 'BEGIN { while (i++ < 120) printf "x" }')
says "the path is too long for a socket; choose a shorter one" \
    serve ground.plt -o x.ppm --socket "$long"
cured_by waits --socket short.socket
# A socket that is left behind when nobody gets to remove it.
"$PLANELET" serve ground.plt -o y.ppm --socket left >/dev/null 2>first &
for i in $(seq 200); do [ -s first ] || sleep 0.05; done
kill -9 $!
wait $! 2>/dev/null
rm -f .planelet-*
says "remove it if nobody serves there" serve ground.plt -o x.ppm --socket left
rm left
cured_by waits --socket left
cp ground.plt mine.plt
mkdir folder
ln -s nowhere dangling
for other in mine.plt folder dangling; do
    says "is a file, not a socket; choose another path" serve mine.plt -o x.ppm --socket $other
    cured_by waits --socket another.socket
done
same ground.plt mine.plt "... the file is as it was"
says "--socket takes a path, not ''" serve ground.plt -o x.ppm --socket ''
cured_by waits --socket another.socket
says "create the directory first, or correct the path" serve ground.plt -o x.ppm --socket new/it
mkdir new
cured_by waits --socket new/it
# listens PORT: serve waits there, in the background.
listens() {
    : >first
    "$PLANELET" serve ground.plt -o y.ppm --listen "$1" --timeout 20 >/dev/null 2>first &
    server=$!
    for i in $(seq 200); do [ -s first ] || sleep 0.05; done
    grep -q '^serve: waiting' first
}
# Below those that systems give to whoever asks for any; others may have some of them.
port=$((10000 + $$ % 20000))
last=$((port + 20))
until listens $port || [ $port -eq $last ]; do port=$((port + 1)); done
says "%s; choose another port" serve ground.plt -o x.ppm --listen $port
# elsewhere: one of the next ports is free.
elsewhere() {
    for i in $(seq 20); do
        port=$((port + 1))
        ! waits --listen $port || return 0
    done
    return 1
}
cured_by elsewhere
kill $server
wait $server 2>/dev/null
if [ -n "$has_common" ]; then
    mkdir mine shut
    chmod 777 mine
    says_by "choose another path" common "$PLANELET" serve ground.plt -o mine/x.ppm --socket shut/it
    cured_by common sh -c "\"$PLANELET\" serve ground.plt -o mine/x.ppm --socket mine/it \
        --timeout 1 2>&1 | grep -q '^serve: waiting'"
fi
if [ -n "$has_common" ] && command -v prlimit >/dev/null; then # sh may not know ulimit -u
    says_by "no process for it: %s; close other programs or raise the limit with ulimit -u" \
        common prlimit --nproc=1: "$PLANELET" serve ground.plt -o mine/x.ppm --emulate 400000 \
        --size 64x48
    cured_by common prlimit --nproc=10000: "$PLANELET" serve ground.plt -o mine/x.ppm \
        --emulate 400000 --size 64x48
fi
finish

#!/bin/sh
# test_remedies_instances.sh - what the tools say of bodies and instances helps
#
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/remedies.sh
begin remedies_instances
"$PLANELET" make ground -o ground.ply 2>/dev/null
identity='1 0 0 0  0 1 0 0  0 0 1 0'

# list LINE...: a text with a body g, an instance a of it, and those lines.
list() {
    printf '%s\n' 'body g ground.ply' 'instance a g' "$@" >list.txt
}
# tells MESSAGE LINE...: such a text is refused with the message.
tells() {
    message=$1
    shift
    list "$@"
    says "$message" pack --instances list.txt -o x.plt
}
# better LINE...: and another one is packed.
better() {
    list "$@"
    cured pack --instances list.txt -o x.plt
}

# ---- how it is asked for: pack_instances.c, cmd_pack.c --------------------------------------

list
for flag in '--frame 1' --centre '--origin 1,2,3' '--reduce 5' '--memory 2000000' \
    '--json stats.json' '--checks on' '--smooth 40' '--normals keep' '--colours keep'; do
    # shellcheck disable=SC2086
    says "%s is not for --instances" pack --instances list.txt $flag -o x.plt
    cured pack --instances list.txt -o x.plt
done
says "--instances takes one text, which names the meshes" \
    pack --instances list.txt ground.ply -o x.plt
cured pack --instances list.txt -o x.plt
for flag in '--nodes compact' '--build device' '--build none'; do
    # shellcheck disable=SC2086
    says "--instances takes --nodes thesis and --build host" \
        pack --instances list.txt $flag -o x.plt
    cured pack --instances list.txt --nodes thesis --build host -o x.plt
done

# ---- lines of the text: instance_list.c ------------------------------------------------------

tells "'%.*s' begins no line; write body, instance or frame" "mesh b ground.ply"
better "body b ground.ply"
tells "a body has a name and a mesh; write body NAME MESH" "body b"
better "body b ground.ply"
tells "there is a body '%.*s' already; choose another name" "body g ground.ply"
better "body h ground.ply"
tells "an instance has a name and a body; write instance NAME BODY" "instance b"
better "instance b g"
tells "there is no body '%.*s' above; write body NAME MESH first" "instance b h"
better "body h ground.ply" "instance b h"
tells "there is an instance '%.*s' already; choose another name" "instance a g"
better "instance b g"
tells "'%.*s' is too much on this line; leave it out" "instance b g twice"
better "instance b g # twice"
tells "'%.*s' is no frame; write a whole number, 0 to 999999" "frame one a $identity"
better "frame 0 a $identity"
tells "'%.*s' is no frame; write a whole number, 0 to 999999" "frame 1000000 a $identity"
tells "frame %.*s does not follow the one before; count from 0 without gaps" "frame 0" "frame 2"
better "frame 0" "frame 1" "frame 2"
tells "frame %.*s does not follow the one before; count from 0 without gaps" \
    "frame 0" "frame 1" "frame 0 a $identity"
better "frame 0 a $identity" "frame 1"
tells "there is no instance '%.*s' above; write instance NAME BODY first" "frame 0 b $identity"
better "instance b g" "frame 0 b $identity"
for matrix in '1 0 0 0  0 1 0 0  0 0 1' "1 0 0 0  0 1 0 0  0 0 1 # 0" '1 0 0 x  0 1 0 0  0 0 1 0' \
    'nan 0 0 0  0 1 0 0  0 0 1 0' '1e60 0 0 0  0 1 0 0  0 0 1 0'; do
    tells "the matrix of '%.*s' is not 12 numbers; write three rows of four" "frame 0 a $matrix"
    better "frame 0 a $identity"
done
tells "'%.*s' is too much on this line; leave it out" "frame 0 a $identity 1"
better "frame 0 a $identity"
for matrix in '1 0 0 0  0 1 0 0  0 0 0 0' '1 0 0 0  1 0 0 0  0 0 1 0' \
    '1 0 0 2e12  0 1 0 0  0 0 1 0' '1 0 0 0  0 1e-5 0 0  0 0 1 0'; do
    tells "line %zu: frame %u: the matrix of '%.*s' cannot be inverted, or places its body \
beyond 2^40; write one that turns, moves and scales" "frame 0" "frame 1 a $matrix"
    better "frame 0" "frame 1 a 0 -1 0 3  1 0 0 0  0 0 2 0"
done
far=1099511627776 step=1073741824
printf 'v %s\n' "$far 0 0" "$far $step 0" "$far 0 $step" "$((far - step)) 0 0" >far.obj
printf 'f %s\n' '1 2 3' '1 4 2' '2 4 3' '3 4 1' >>far.obj
printf '%s\n' 'body g far.obj' 'instance a g' >list.txt
says "line %zu: where it is, the body of '%.*s' is not within 2^40; write a frame 0 that moves it \
closer" pack --instances list.txt -o x.plt
echo 'frame 0 a 0.5 0 0 0  0 0.5 0 0  0 0 0.5 0' >>list.txt
cured pack --instances list.txt -o x.plt
"$PLANELET" render x.plt -o x.ppm --size 2x2 2>err
verdict "... and is opened" "$(grep . err)"
echo '# nothing' >list.txt
says "places nothing; write body NAME MESH and instance NAME BODY" \
    pack --instances list.txt -o x.plt
list
cured pack --instances list.txt -o x.plt
awk 'BEGIN { for (i = 0; i < 65536; i++) print "body b" i " ground.ply" }' >many.txt
{ cat many.txt; echo 'body g ground.ply'; } >list.txt
says "more than 65536 bodies; make them fewer" pack --instances list.txt -o x.plt
list
cured pack --instances list.txt -o x.plt
awk 'BEGIN { print "body g ground.ply"; for (i = 0; i < 65537; i++) print "instance i" i " g" }' \
    >list.txt
says "more than 65536 instances; make them fewer" pack --instances list.txt -o x.plt
sed '$d' list.txt >fewer.txt
cured pack --instances fewer.txt -o x.plt
printf '%s\n' 'body g -' 'instance a g' >list.txt
says "is standard input; name a file" pack --instances list.txt -o x.plt
list
cured pack --instances list.txt -o x.plt
printf '%s\n' 'body g gone.ply' 'instance a g' >list.txt
"$PLANELET" pack --instances list.txt -o x.plt 2>err
verdict "a mesh that is not there is told with its line" "$(
    grep -q '^list.txt: line 1: gone.ply: ' err || cat err)"

# ---- how they are made and moved: make_instances.c, cmd_make.c, moved.c -----------------------

says "only marbles are made as --instances" make city --instances -o city.txt
cured make marbles --instances -o marbles.txt
says "--instances needs a name that ends in .txt, as in marbles.txt" \
    make marbles --instances -o marbles.ply
cured make marbles --instances -o marbles.txt
for name in 'two words.txt' '#.txt'; do
    says "the text of --instances names meshes after itself: no blanks in its name, nor # first, \
as in marbles.txt" make marbles --instances -o "$name"
    cured make marbles --instances -o marbles.txt
done
run pack --instances marbles.txt -o marbles.plt
says "the scene has instances, which no mesh moves; use --frames" \
    render marbles.plt --moved ground.ply -o x.ppm --size 8x8
cured render marbles.plt --frames 0:1 -o x.ppm --size 8x8
says "%s; leave out --rebuild" \
    render marbles.plt --frames 0:1 --rebuild always -o x.ppm --size 8x8
cured render marbles.plt --frames 0:1 -o x.ppm --size 8x8
says "%s; pack it with --nodes compact, or use --residency resident" \
    render marbles.plt --residency streamed -o x.ppm --size 8x8
verdict "... and that is said of instances" "$(grep -q 'bodies of instances are' err || cat err)"
cured render marbles.plt --residency resident -o x.ppm --size 8x8
says "%s; pack it with --nodes thesis, or leave out --structure" \
    render marbles.plt --structure grid -o x.ppm --size 8x8
cured render marbles.plt --structure tree -o x.ppm --size 8x8
says "%s; leave out --rebuild" render marbles.plt --frames 0:1 --rebuild always -o x.ppm --size 8x8
cured render marbles.plt --frames 0:1 -o x.ppm --size 8x8
head -c 32 /dev/zero >ray
says "baselines are for one mesh; pack it without --instances" \
    trace marbles.plt ray hit --baseline kd
run pack ground.ply -o ground.plt
cured trace ground.plt ray hit --baseline kd
finish

#!/bin/sh
# test_terminal.sh - what a person at a terminal sees, and a script does not
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin terminal
TERM=xterm
export TERM

$CC -std=c11 -Wall -Wextra "$CLI_TESTS/pty.c" -o pty 2>trouble || {
    verdict "the terminal of the tests builds" "$(cat trouble)"
    finish
    exit 1
}
./pty both true
if [ $? -eq 125 ]; then
    verdict "there are pseudo terminals here" "none; is /dev/pts mounted?"
    finish
    exit 1
fi

# seen WHERE ARGUMENT...: planelet with standard error (WHERE err) or both outputs
# (WHERE both) on a terminal: files `seen` and `out`, variable `status`.
seen() {
    ./pty "$1" "$PLANELET" $(shift && echo "$@") >seen 2>out </dev/null
    status=$?
}

# progressed WORD: trouble, unless progress with WORD was shown and then wiped.
progressed() {
    [ "$status" -eq 0 ] || echo "status $status"
    tr '\r\033' '\n~' <seen >lines
    grep -q "^~\[K$1" lines || { echo "no progress '$1'"; cat lines; }
    grep '^~' lines | tail -n 1 | grep -q '^~\[K\(slow[^ ]*: .*\|hit: .*\)*$' ||
        echo "the progress was not wiped"
}

quad quad.ply
run make knot --triangles 3000 -o knot.ply
run pack knot.ply -o knot.plt
run pack knot.ply -o none.plt --build none
echo '0 0 5 0 0 0 -1 100' | rays ray

# ---- summaries and hints ---------------------------------------------------------

seen err make ground -o ground.ply
verdict "make says what to do next" "$(
    [ "$status" -eq 0 ] || echo "status $status"
    grep -q '^next: planelet pack ground.ply -o ground.plt' seen || cat -v seen)"
seen err pack ground.ply -o ground.plt
verdict "pack says triangles, bytes, seconds and what to do next" "$(
    bytes=$(wc -c <ground.plt)
    grep -q "^ground.plt: 12 triangles, $bytes bytes, [0-9.]* s; next: planelet render ground.plt" \
        seen || cat -v seen
    [ "$(wc -l <seen)" -eq 1 ] || cat -v seen)"
seen err render ground.plt -o ground.png --size 64x48
verdict "render says frames, pixels and seconds" "$(
    grep -q '^ground.png: 1 frame of 64 x 48, [0-9.e-]* s' seen || cat -v seen)"
seen err tables --rows ground,bunny --size 48 --views 2 --frames 2 --rounds 1 1 3
verdict "tables says rays and memory before it measures, and keeps to it" "$(
    tr '\r\033' '\n~' <seen | grep -a . >lines
    head -n 1 lines | grep -q '^2 pictures of 48 x 48: 4608 rays for each structure, 65536 of' ||
        cat lines
    said=$(sed -n '2s/^\([0-9]*\) MB of memory at most, with meshes as large .*/\1/p' lines)
    had=$(sed -n 's/^\(.*[^0-9]\)*\([0-9]*\) MB of memory were in use at most.*/\2/p' lines)
    [ "${had:-0}" -gt 10 ] && [ "$had" -le "${said:-0}" ] && [ "$said" -le $((2 * had)) ] ||
        cat lines)"
seen err trace knot.plt ray hit
verdict "trace says rays and seconds" "$(grep -q '^hit: 1 ray, [0-9.e-]* s' seen || cat -v seen)"

# Hints are copied: the shell must read each name back as it is.
# hinted SENTENCE NAME [SHELL]: make and pack write NAME.ply and NAME.plt, with the hints of each.
hinted() {
    hint_shell=${3:-sh}
    rm -f marbles.plt
    ./pty err "$PLANELET" make ground -o "$2.ply" >seen 2>out </dev/null
    sed -n 's/^next: planelet \(.*\)\r$/"$PLANELET" \1/p' seen >hint
    verdict "$1: make's hint packs it" "$(
        rm -f ground.plt
        PLANELET=$PLANELET $hint_shell ./hint </dev/null 2>&1
        [ -f ground.plt ] || cat -v seen)"
    ./pty err "$PLANELET" pack ground.ply -o "$2.plt" >seen 2>out </dev/null
    sed -n 's/^.*; next: planelet \(.*\)\r$/"$PLANELET" \1/p' seen >hint
    verdict "... and pack's hint renders it" "$(
        PLANELET=$PLANELET $hint_shell ./hint </dev/null >drawn 2>&1
        [ "$(wc -l <drawn)" -gt 9 ] || cat -v seen drawn)"
    rm -f -- "$2.ply" "$2.plt" 2>/dev/null || rm -f -- "./$2.ply" "./$2.plt"
}
hinted "a name with blanks" "two words  and more"
hinted "a name with a quote" "it's"
hinted "a name with all that a shell takes for something else" \
    "a\"b\$(echo x)\`echo y\`\\c*?[d]{e,f}<g>|h&i;j#k~l!m=n(o)"
hinted "a name that begins with ~" "~root"
hinted "a name with other letters" "größe"
if command -v bash >/dev/null; then
    hinted "a name with control characters" "$(printf 'a\tb\033[31mc\001d')" bash
fi
# A name that begins with a dash is a flag, unless it is the value of one.
./pty err "$PLANELET" make ground -o -dash.ply >seen 2>out </dev/null
verdict "a name that begins with a dash gets its folder" "$(
    grep -q '^next: planelet pack ./-dash.ply -o ground.plt' seen || cat -v seen)"
long=$(awk 'BEGIN { while (i++ < 240) printf "x" }')
./pty err "$PLANELET" make ground -o "$long.ply" >seen 2>out </dev/null
verdict "a name that is too long for the line gets no hint" "$(cat -v seen)"
rm -f ./-dash.ply "$long.ply"

seen err pack missing -o x.plt
verdict "an error is one line here too" "$(
    [ "$status" -eq 1 ] || echo "status $status"
    [ "$(wc -l <seen)" -eq 1 ] || cat -v seen)"
seen err pack ground.ply -o -
verdict "an image for a program comes without a hint" "$(
    cat -v seen
    cmp out ground.plt 2>&1)"
for arguments in "make ground -o x.ply" "pack ground.ply -o x.plt" "render ground.plt -o x.png" \
    "trace knot.plt ray x.hits" "bench knot.plt --size 9x9" "info ground.plt"; do
    # shellcheck disable=SC2086
    run $arguments
    verdict "${arguments%% *} says nothing to a script" "$(cat err)"
done

# ---- pictures --------------------------------------------------------------------

# drawn VARIABLE=VALUE...: --show on a terminal in that environment.
drawn() {
    env "$@" ./pty both "$PLANELET" render knot.plt --show --shader normal >seen 2>out </dev/null
    status=$?
}

# without PATTERN...: trouble, where one of them is in `seen`.
without() {
    for pattern in "$@"; do
        [ "$(grep -c "$pattern" seen)" -eq 0 ] || echo "there is '$pattern'"
    done
}
escape=$(printf '\033')

drawn LC_ALL=C.UTF-8 COLORTERM=truecolor
verdict "--show draws half blocks in 24-bit colour where COLORTERM says truecolor" "$(
    [ "$status" -eq 0 ] || echo "status $status"
    grep -q '▀' seen || echo "no half block"
    grep -q '38;2;[0-9]*;[0-9]*;[0-9]*' seen || echo "no colour"
    [ "$(wc -l <seen)" -le 23 ] || wc -l <seen
    tail -c 6 seen | od -An -c | grep -q '0   m  *.r  *.n' || tail -c 6 seen | od -c)"
drawn LC_ALL=C.UTF-8 COLORTERM=
verdict "... in 256 colours where nothing is said" "$(
    grep -q '▀' seen || echo "no half block"
    grep -q "${escape}\[38;5;[0-9]*m" seen || echo "no colour"
    without '[34]8;2;')"
drawn LC_ALL=C COLORTERM=
verdict "... and blanks where the locale is not UTF-8" "$(
    grep -q "${escape}\[48;5;[0-9]*m  *${escape}" seen || echo "no blanks in colour"
    without '38;5;' '▀')"
drawn LC_ALL=C.UTF-8 TERM=linux
verdict "... and characters in eight colours on Linux's console" "$(
    grep -q "${escape}\[1;3[1-7]m[-.:=+*#%@]" seen || echo "no characters in colour"
    without '▀' '[34]8;')"
drawn LC_ALL=C.UTF-8 COLORTERM=truecolor NO_COLOR=1
verdict "... and plain characters when NO_COLOR is set" "$(
    grep -q '[#%@*]' seen || echo "nothing to be seen"
    without '▀' "$escape")"
drawn LC_ALL=C.UTF-8 COLORTERM=truecolor TERM=dumb
verdict "... and on a dumb terminal" "$(
    grep -q '[#%@*]' seen || echo "nothing to be seen"
    without '▀' "$escape")"

# Bytes of a picture here: some thousand per line.
LC_ALL=C.UTF-8 COLORTERM=truecolor
export LC_ALL COLORTERM
for bytes in 1500 12000 20000 50000 120000; do
    ./pty $bytes "$PLANELET" serve knot.plt --emulate 4000000 --show --shader normal --orbit 500 \
        >seen 2>out </dev/null
    status=$?
    verdict "Ctrl-C after $bytes bytes of pictures: the one begun is ended, no process stays" "$(
        [ "$status" -eq 130 ] || echo "status $status"
        tr '\033' '\n' <seen | grep '^\[[0-9;]*m' | tail -n 1 | grep '^\[0m' >/dev/null ||
            tail -c 60 seen | cat -v)"
done

./pty 1000000 sh -c 'echo $$ >group; sleep 50 & sleep 50' >seen 2>out </dev/null &
pty=$!
for i in 1 2 3 4 5 6 7 8 9 10; do [ -s group ] || sleep 0.2; done
kill -9 $pty
wait $pty 2>/dev/null
verdict "a terminal that is killed takes with it what runs there" "$(
    [ -s group ] || echo "nothing ran"
    for i in 1 2 3 4 5 6 7 8 9 10; do kill -0 "-$(cat group)" 2>/dev/null && sleep 0.2; done
    kill -0 "-$(cat group)" 2>/dev/null && echo "its group is still there")"

# ---- progress of work of more than a second --------------------------------------

mkfifo slow.ply
run make ground -o closed.ply # without open edges: nothing to say
{ sleep 2; cat closed.ply; } >slow.ply &
seen err pack slow.ply -o slow.plt
verdict "reading a slow mesh counts the seconds, then wipes them" "$(
    progressed "reading slow.ply, 1 s"
    grep -q 'slow.plt: 12 triangles' lines || cat lines)"
hostile=$(printf 's\033[31m_a_very_long_name_that_does_not_fit_into_the_line.ply')
mkfifo "$hostile"
{ sleep 2; cat closed.ply; } >"$hostile" &
./pty err "$PLANELET" pack "$hostile" -o slow.plt >seen 2>out
status=$?
verdict "... without the controls of a hostile name, cut to fit" "$(
    progressed "reading \.\.\."
    grep -q '31m' lines && cat lines
    awk 'length > 78 && !/slow.plt/ { print length ": " $0 }' lines)"
{ sleep 2; cat closed.ply; } >slow.ply &
run pack slow.ply -o slow.plt
verdict "... and nothing for a script" "$(cat err)"
seen err render none.plt -o slow.y4m --size 256x256 --orbit 25
verdict "a long render shows per cent, then wipes them" "$(progressed "rendering: [0-9]* %")"
run make knot --triangles 40000 -o slow.mesh.ply
run pack slow.mesh.ply -o slow.plt --build none
seen err serve slow.plt --emulate 40000000 -o slow.ppm --size 352x352
verdict "serve shows per cent of each frame that needs long, then erases them" "$(
    [ "$status" -eq 0 ] || echo "status $status"
    tr '\r\033' '\n~' <seen >lines
    grep -q '^~\[Kserve: rendering, frame [0-9]*: [0-9]* %' lines || cat lines
    grep '^~' lines | tail -n 1 | grep -q '^~\[K$' || echo "the progress was not wiped")"
seen err trace none.plt ray hit --repeat 60000
verdict "a long trace shows per cent, then wipes them" "$(progressed "tracing: [0-9]* %")"
seen err bench none.plt --kinds random --repeat 20 --size 24x24
verdict "a long bench likewise" "$(progressed "tracing: [0-9]* %")"
finish

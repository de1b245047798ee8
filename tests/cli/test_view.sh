#!/bin/sh
# test_view.sh - planelet view in a pseudo terminal: keys, the mouse, and what it leaves
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin view
TERM=xterm-256color COLORTERM=truecolor LC_ALL=C.UTF-8
export TERM COLORTERM LC_ALL
unset NO_COLOR

$CC -std=c11 -Wall -Wextra "$CLI_TESTS/pty_view.c" -o pty_view 2>trouble || {
    verdict "the terminal of the tests builds" "$(cat trouble)"
    finish
    exit 1
}
./pty_view -- true >/dev/null
if [ $? -eq 125 ]; then
    verdict "there are pseudo terminals here" "none; is /dev/pts mounted?"
    finish
    exit 1
fi
run make knot --triangles 1000 -o knot.ply
run pack knot.ply -o knot.plt
for i in 0 1 2 3; do run make marbles --triangles 400 --frame $((4 * i)) -o tray_00$i.ply; done
run pack --sequence 'tray_{}.ply' --frames 0:4 --rate 2 -o tray.plt

# viewed FILE STEP...: with the flags in `more`; what pty_view says is in `said`.
viewed() {
    file=$1
    shift
    # shellcheck disable=SC2086
    ./pty_view "$@" -- "$PLANELET" view "$file" $more >said 2>trouble </dev/null
    more=
}
more=
escape=$(printf '\033')

# whole STATUS: trouble, unless it ended so and left the terminal as it was.
whole() {
    grep -q "^status $1\$" said || grep '^status' said
    grep -q '^modes same' said || grep '^modes' said
    grep -q '^left 0' said || grep '^left' said
    tail -c 60 screen | tr '\033' '~' | grep -qF '~[?1006l~[?1002l~[?25h~[?1049l' ||
        { echo "the screen is not put back:" && tail -c 60 screen | cat -v; }
    cat trouble
}
picture() { # NUMBER: its hash
    grep '^picture' said | sed -n "$1p" | cut -d ' ' -f 2
}

viewed knot.plt settle send=q
verdict "q ends it and leaves the terminal whole" "$(whole 0)"
verdict "... which has shown half blocks in 24 bits, and what keys there are" "$(
    grep -q '▀' screen || echo "no half block"
    grep -q '38;2;[0-9]*;[0-9]*;[0-9]*' screen || echo "no colour"
    grep -q "arrows, mouse: turn" screen || echo "no keys")"
verdict "... on the alternate screen, without a cursor" "$(
    head -c 16 screen | grep -q "^${escape}\[?1049h${escape}\[?25l" || head -c 16 screen | cat -v)"
viewed knot.plt settle 'send=\003'
verdict "Ctrl-C ends it, too" "$(whole 0)"
viewed knot.plt settle type=qabcdef
verdict "what was typed behind the q is not left to the shell" "$(whole 0)"

viewed knot.plt settle 'send=\e[C' settle 'send=\e[D' settle 'send=\eOA' settle 'send=\e[B' settle \
    send=q
verdict "every arrow turns it, and the opposite one back" "$(
    whole 0
    [ "$(picture 1)" != "$(picture 2)" ] || echo "right: nothing"
    [ "$(picture 1)" = "$(picture 3)" ] || echo "left: not back"
    [ "$(picture 1)" != "$(picture 4)" ] || echo "up: nothing"
    [ "$(picture 1)" = "$(picture 5)" ] || echo "down: not back")"
viewed knot.plt settle send=+ settle 'send=\e[<64;5;5M' settle 'send=\e[<65;5;5M' settle \
    send=r settle send=q
verdict "+ and the wheel zoom, and r is the first view again" "$(
    whole 0
    [ "$(picture 1)" != "$(picture 2)" ] || echo "+: nothing"
    [ "$(picture 3)" != "$(picture 2)" ] || echo "wheel up: nothing"
    [ "$(picture 4)" = "$(picture 2)" ] || echo "wheel down: not back"
    [ "$(picture 5)" = "$(picture 1)" ] || echo "r: another view")"
viewed knot.plt settle 'send=\e[<0;10;10M\e[<32;20;10M\e[<0;20;10m' settle \
    'send=\e[<0;20;10M\e[<32;10;10M\e[<0;10;10m' settle send=q
verdict "the mouse turns it with its button down" "$(
    whole 0
    [ "$(picture 1)" != "$(picture 2)" ] || echo "nothing"
    [ "$(picture 1)" = "$(picture 3)" ] || echo "not back")"
viewed knot.plt settle 'send=\e[' settle send=C settle 'send=x\e[5~\e[1;2P\e]0;a\007' settle send=q
verdict "a key that comes in two parts is one, and others do nothing" "$(
    whole 0
    [ "$(picture 1)" = "$(picture 2)" ] || echo "half a key does something"
    [ "$(picture 2)" != "$(picture 3)" ] || echo "nothing"
    [ "$(picture 3)" = "$(picture 4)" ] || echo "another key does something")"
viewed knot.plt settle resize=40x12 settle send=q
verdict "another size of the terminal is another picture" "$(
    whole 0
    [ "$(picture 1)" != "$(picture 2)" ] || echo "the same"
    bytes=$(grep '^picture' said | cut -d ' ' -f 3 | tr '\n' ' ')
    [ "${bytes% * }" -gt "$(echo $bytes | cut -d ' ' -f 2)" ] || echo "bytes: $bytes")"
for signal in 1 2 15; do
    viewed knot.plt settle signal=$signal
    verdict "signal $signal ends it, and it leaves the terminal whole" "$(whole $((128 + signal)))"
done

# ---- stopped, and in the foreground again -----------------------------------------

viewed knot.plt settle 'send=\e[C' settle 'send=\032' stopped fg settle 'send=\e[D' settle send=q
verdict "Ctrl-Z stops it, and leaves the terminal whole" "$(
    whole 0
    grep -q '^stopped modes same screen back' said || cat said)"
verdict "... fg shows the picture again, and keys turn it" "$(
    [ "$(picture 3)" = "$(picture 2)" ] || echo "another picture"
    [ "$(picture 4)" = "$(picture 1)" ] || echo "left: not back")"
viewed knot.plt settle signal=20 stopped fg settle signal=20 stopped fg settle send=q
verdict "a SIGTSTP of others does, too, and again" "$(
    whole 0
    [ "$(grep -c '^stopped modes same screen back' said)" -eq 2 ] || cat said
    [ "$(picture 1)" = "$(picture 3)" ] || echo "another picture")"
viewed knot.plt settle signal=19 stopped fg settle send=q
verdict "after a SIGSTOP, which nobody can catch, it is drawn anew" "$(
    whole 0
    grep -q '^stopped modes changed screen kept' said || cat said
    [ "$(picture 1)" = "$(picture 2)" ] || echo "another picture"
    [ "$(tr '\033' '\n' <screen | grep -c '^\[?1049h')" -eq 2 ] || echo "no screen of its own")"
viewed knot.plt settle 'send=\032' stopped signal=15 fg
verdict "what is stopped can be ended" "$(
    grep -q '^status 143' said || cat said
    grep -q '^modes same' said || cat said)"

more='--graphics sixel'
viewed knot.plt deaf=1500 resize=60x20 deaf=300 settle send=q
verdict "another size while a picture is being written does not end it" "$(whole 0)"
more='--graphics sixel'
viewed knot.plt deaf=1500 signal=15
verdict "a picture that is cut short is at its end before the screen is put back" "$(
    tr '\033' '~' <screen | grep -q 'P0;1;0q' || echo "nothing is drawn"
    tail -c 60 screen | tr '\033' '~' | grep -qF '~\~[?2026l~[0m~[?1006l' || tail -c 60 screen |
        cat -v
    grep -q '^modes same' said || cat said)"
for keys in P ] _ ^ X; do
    viewed knot.plt settle "send=\\e$keys" settle send=q
    verdict "Alt and $keys does not make it deaf to q" "$(whole 0)"
    viewed knot.plt settle "send=\\e$keys\\003"
    verdict "... nor to Ctrl-C" "$(whole 0)"
done
viewed knot.plt settle close
verdict "a terminal that is gone ends it" "$(
    grep -q '^status \(0\|1\|129\)$' said || cat said)"

viewed tray.plt settle 'send= ' settle settle send=q
verdict "an image's frames go on until the space bar stops them" "$(
    whole 0
    [ "$(picture 2)" = "$(picture 3)" ] || echo "they still go on"
    [ "$(tr '\033' '\n' <screen | grep -c '^\[?2026l')" -gt 9 ] || echo "they do not")"

# ---- what the terminal can draw ---------------------------------------------------

for case in 'blocks:\e[?62;22c' 'sixel:\e[?62;4;22c' 'kitty:\e_Gi=31;OK\e\134\e[6;16;8t\e[?62;4c' \
    'blocks:\e_Gi=31;ENOTSUP\e\134\e[?6c'; do
    viewed knot.plt "answer=${case#*:}" settle send=q
    verdict "a terminal that answers ${case#*:} gets ${case%%:*}" "$(
        whole 0
        case ${case%%:*} in
        blocks) grep -q '▀' screen ;;
        sixel) grep -q "${escape}P0;1;0q\"1;1;640;368#0;2;0;0;0" screen ;;
        kitty) grep -q "${escape}_Ga=T,i=1,p=1,q=2,C=1,f=24,o=z,s=640,v=368,c=80,r=23,m=" screen ;;
        esac || echo "it does not")"
done
for kind in blocks kitty sixel; do
    more="--graphics $kind"
    viewed knot.plt settle send=q
    verdict "--graphics $kind does not wait for an answer" "$(
        whole 0
        case $kind in
        blocks) grep -q '▀' screen ;;
        sixel) grep -q "${escape}P0;1;0q" screen ;;
        kitty) grep -q "${escape}_Ga=d,d=I,i=1,q=2" screen ;;
        esac || echo "it is not drawn so")"
done
more='--shader normal --view top'
viewed knot.plt settle send=q
verdict "other flags are those of render" "$(whole 0)"

# ---- what is refused --------------------------------------------------------------

refused "without a terminal" terminal "use planelet render" view knot.plt
./pty_view settle -- "$PLANELET" view missing.plt >said
verdict "a scene that is not there is said, and the screen is never touched" "$(
    grep -q '^status 1' said || cat said
    grep -q 'missing.plt' screen || cat -v screen
    grep -q "1049" screen && echo "it was")"
./pty_view settle -- "$PLANELET" view - >said
verdict "standard input is for keys" "$(
    grep -q 'it is for keys; name a file' screen || cat -v screen)"
verdict "what is no terminal gets nothing" "$(
    "$PLANELET" view knot.plt --graphics kitty 2>&1 >drawn </dev/null | grep -q '^terminal: ' ||
        echo "it is not refused"
    [ -s drawn ] && cat -v drawn)"
misused "--graphics takes what there is" --graphics view knot.plt --graphics ascii
misused "view takes one scene" "use it as" view
finish

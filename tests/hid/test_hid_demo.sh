#!/bin/sh
# test_hid_demo.sh - make demo-hid at a terminal, and Ctrl-C in the midst of it
#
# On the emulated panel, whatever is plugged in here. The pseudo terminal is
# tests/cli/pty.c. SPDX-License-Identifier: MIT
. tests/check/report.sh
out=${OUT:-$BUILD/host}
work=$BUILD/test-tmp/hid_demo
TERM=xterm LC_ALL=C
export TERM LC_ALL
unset NO_COLOR COLUMNS LINES
rm -rf "$work"
mkdir -p "$work"

trouble=$($MAKE -s all "$out/planelet-hid-emulated" 2>&1 >/dev/null &&
    $CC -std=c11 -Wall -Wextra tests/cli/pty.c -o "$work/pty" 2>&1)
verdict "the demo and its terminal build" "$trouble"
[ -z "$trouble" ] || { finish; exit 1; }
ln "$out/planelet-hid-emulated" "$work/hid-emulated"

# A planelet that says 2,000 zeros and then packs for ever: its mesh does not end.
cat >"$work/slow" <<'END'
#!/bin/sh
[ "$1" = pack ] || exec "$REAL" "$@"
printf '%02000d\n' 0
{ head -c 1000 "$2"; sleep 100; } | "$REAL" pack /dev/stdin -o "$4"
END
chmod +x "$work/slow"

# demo WHERE FRAMES [PLANELET]: files `seen` and `err`, variable `status`.
demo() {
    REAL=$out/planelet PLANELET=${3:-$out/planelet} HID=$work/hid DEMO=$work/demo FRAMES=$2 \
        timeout 100 "$work/pty" "$1" sh tests/hid/demo.sh >"$work/seen" 2>"$work/err" </dev/null
    status=$?
    tr '\033' '\n' <"$work/seen" >"$work/codes"
}

# ended: trouble, unless colours and cursor are as before.
ended() {
    last=$(grep '^\[[0-9;]*m' "$work/codes" | tail -n 1)
    case $last in '' | '[0m'*) ;; *) echo "the last colour was $last" ;; esac
    grep '^\[?25l' "$work/codes" && echo "the cursor was hidden"
}

# kept: trouble, unless what lies in the demo's folder is whole.
kept() {
    find "$work" -name '.planelet-*'
    scene=$work/demo/marbles.plt
    [ ! -e "$scene" ] || "$out/planelet" info "$scene" 2>&1 >/dev/null
}

demo both 3
verdict "it ends well after its frames, each drawn over the last" "$(
    [ "$status" -eq 0 ] || { echo "status $status"; cat "$work/err"; }
    ended
    [ "$(grep -c '^\[2J' "$work/codes")" -eq 1 ] || echo "the screen is not cleared once"
    [ "$(grep -c '^\[H' "$work/codes")" -ge 3 ] || echo "too few pictures")"
for bytes in 2000 30000 100000; do
    demo $bytes 1000
    verdict "Ctrl-C after $bytes bytes, in a picture: statistics, no colour, nobody left behind" "$(
        [ "$status" -eq 0 ] || echo "status $status"
        grep -q 'frames in .* per second' "$work/seen" || echo "no statistics"
        # After the last line comes the reset of the colours, sent by hid-emulated.
        [ "$(tail -c 6 "$work/seen" | od -An -tx1 | tr -d ' ')" = 0d0a1b5b306d ] ||
            { echo "the last line has no end"; tail -c 20 "$work/seen" | od -c; }
        ended
        kept)"
done
rm -rf "$work/demo"
demo 2000 1000 "$work/slow"
verdict "Ctrl-C while the scene is packed: interrupted, nobody and nothing half-written left" "$(
    [ "$status" -eq 130 ] || echo "status $status"
    ended
    kept)"
finish

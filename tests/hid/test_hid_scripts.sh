#!/bin/sh
# test_hid_scripts.sh - planelet-hid itself, while displays refuse, stall, go dark, and come and go
#
# On a scripted bus in place of hidapi (tests/hid/script.h, scripted_main.c). Many more schedules,
# without the program around them: tests/host_tools/test_hid_schedules.c.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
out=$(absolute "${OUT:-$BUILD/host}")
trouble=$($MAKE -s all "${OUT:-$BUILD/host}/planelet-hid-scripted" 2>&1 >/dev/null)
verdict "the scripted bus builds" "$trouble"
[ -z "$trouble" ] || { finish; exit 1; }
budgets=$($MAKE -s hid-budgets 2>&1)
without=
begin hid_scripts
run make knot --triangles 500 -o knot.ply
run pack knot.ply -o knot.plt
for size in 128x40 128x64 240x160 640x48; do
    run render knot.plt -o $size.ppm --size $size
done
run render knot.plt -o orbit.y4m --size 128x40 --orbit 60

# hid SCRIPT ARGUMENT...: files `seen`, `err`; variables `status`, `took` in seconds. Lines of a
# script are parted by ";".
hid() {
    printf '%s\n' "$1" | sed 's/; */\n/g' >script
    shift
    began=$(date +%s.%N)
    # shellcheck disable=SC2086
    timeout 60 $without "$out/planelet-hid-scripted" script "$@" >seen 2>err </dev/null
    status=$?
    took=$(echo "$(date +%s.%N) $began" | awk '{ printf "%.2f", $1 - $2 }')
}

# value NUMBER NAME: of NAME=value in the line of that device.
value() {
    sed -n "s/^device $1 .* $2=\([^ ]*\) .*/\1/p" err
}

# whole KIND SIZE: trouble, unless panel 0 is as without faults.
whole() {
    cp device0.ppm got.ppm
    cp err err.got
    hid "device $1 /dev/fake0 S1" show "$2.ppm"
    cmp got.ppm device0.ppm || cat err.got
}

# ended_with STATUS SENTENCE: trouble, unless the program did, in a line of its own.
ended_with() {
    [ "$status" -eq "$1" ] && [ "$(grep -c -- "$2" err)" -eq 1 ] ||
        { echo "status $status after $took s"; cat err; }
    grep 'hidapi was used' err
}

# took_at_most SECONDS: on a busy machine some more.
took_at_most() {
    echo "$took $1" | awk '$1 > $2 { print "it took " $1 " s" }'
}

for kind in apex nova nexus streamdeck-mini; do
    case $kind in
    apex) size=128x40 ;; nova) size=128x64 ;; nexus) size=640x48 ;; *) size=240x160 ;;
    esac
    hid "device $kind /dev/fake0 S1; refuse 1000000" show $size.ppm --wait 1
    verdict "$kind that opens and refuses every report: one sentence, after --wait 1" "$(
        case $kind in
        streamdeck-mini) ended_with 1 'went away or does not answer; plug it in again' ;;
        *) ended_with 1 'is there, but refuses reports; plug it in again' ;;
        esac
        took_at_most 4)"
done

hid "device nova /dev/fake0 S1; late 200" show 128x64.ppm
verdict "a Nova that draws and acknowledges nothing: both halves are sent, once" "$(
    ended_with 0 '1 frames in'
    [ "$(value 0 reports)" = 2 ] || cat err
    whole nova 128x64)"

twins="device apex /dev/fake3; device apex /dev/fake5"
for named in '' '--device /dev/fake5'; do
    gone=$([ -z "$named" ] && echo 0 || echo 1)
    # shellcheck disable=SC2086
    hid "$twins; before 20 unplug $gone" show orbit.y4m --every --wait 1 $named
    verdict "of two equal displays one goes for good: its neighbour is left alone ${named:-}" "$(
        ended_with 1 'did not come back in 1 seconds; plug it in where it was'
        [ "$(value $((1 - gone)) reports)" = 0 ] || cat err)"
done
hid "device apex /dev/fake3 - 1-1; device apex /dev/fake5 - 1-2; before 20 unplug 0
before 20 unplug 1; after 20 300 plug 1 /dev/fake3; after 20 600 plug 0 /dev/fake5" \
    show orbit.y4m --every --device /dev/fake3
verdict "two equal displays are back under each other's number: the film goes on at its port" "$(
    ended_with 0 '1 reconnects'
    [ "$(value 1 reports)" = 0 ] && [ "$(value 0 reports)" -ge 40 ] || cat err)"

many="others 66; device nexus /dev/fake0 S1"
for named in '' '--device /dev/fake0' '--device S1' '--device 1b1c:1b8e'; do
    # shellcheck disable=SC2086
    hid "$many" show 640x48.ppm $named
    verdict "behind 66 other devices a Nexus is found ${named:-by itself}" "$(
        ended_with 0 '1 frames in')"
done
hid "$many - 4" list
verdict "a display of four collections is listed once" "$(
    [ "$(grep -c ' 1b1c:1b8e ' seen)" = 1 ] || cat seen)"

hid "device streamdeck-mini /dev/fake0 S1; after 120 500 dark 0" \
    show 240x160.ppm 240x160.ppm --hold 3
verdict "a panel that lost its picture is whole again, though no key has changed" "$(
    ended_with 0 '2 frames in'
    whole streamdeck-mini 240x160)"

# signalled SIGNAL SCRIPT ARGUMENT...: the signal comes after a second.
signalled() {
    printf '%s\n' "$2" | sed 's/; */\n/g' >script
    signal=$1
    shift 2
    "$out/planelet-hid-scripted" script "$@" >seen 2>err </dev/null &
    process=$!
    sleep 1
    began=$(date +%s.%N)
    kill "-$signal" $process
    wait $process
    status=$?
    took=$(echo "$(date +%s.%N) $began" | awk '{ printf "%.2f", $1 - $2 }')
}
for signal in INT TERM; do
    signalled $signal "device apex /dev/fake0 S1; before 20 unplug 0" \
        show orbit.y4m --every --repeat --wait 60
    verdict "SIG$signal during a wait for a display ends it, which is said" "$(
        ended_with 1 'stopped before the display was back'
        took_at_most 1)"
    signalled $signal "device nova /dev/fake0 S1; refuse 1000000" show 128x64.ppm --wait 60
    verdict "... and one for a display that refuses every report" "$(
        ended_with 1 'stopped before the display was back'
        took_at_most 1)"
done

# The node is a file here that nobody may use, but root; so that goes without that right.
: >barred
chmod 000 barred
[ "$(id -u)" -ne 0 ] || without='setpriv --bounding-set=-dac_override,-dac_read_search'
hid "device apex $PWD/barred S1; before 20 unplug 0; before 20 deny 1; after 20 100 plug 0" \
    show orbit.y4m --every --wait 1
verdict "back, but it may not be opened: the permission is named, and the rule" "$(
    ended_with 1 'no permission to use 1038:1618; install the udev rule: planelet-hid rules'
    grep 'did not come back' err)"
without=

hid "device nexus /dev/fake0 S1" show 640x48.ppm --brightness 0 --release
verdict "--release gives a Nexus back, and brightness up" "$(
    ended_with 0 '1 frames in'
    [ "$(value 0 releases)" = 1 ] && [ "$(value 0 brightness)" = 100 ] || cat err)"
hid "device streamdeck-mini /dev/fake0 S1" show 240x160.ppm missing.ppm --hold 0 --release
verdict "... and so it does when the show has failed, which is what is said" "$(
    ended_with 1 'missing.ppm'
    [ "$(value 0 releases)" = 1 ] || cat err)"
hid "device apex /dev/fake0 S1" show 128x40.ppm --release
verdict "that a display has no picture of its own is said before anything is shown" "$(
    ended_with 1 'it has no picture of its own; leave out --release'
    [ "$(value 0 reports)" = 0 ] || cat err)"

hid "device nexus /dev/fake0 S1" list
sed -n '/^drivers:/,/^[*]/s/^  \([^ *]*\)[ *].*/\1/p' seen >names
hid "device nexus /dev/fake0 S1" list --keys
verdict "list --keys has the keys of every driver: dials, a strip, a finger" "$(
    [ "$(wc -l <names)" -ge 15 ] || cat names
    while read -r name; do
        grep -q "^$name:" seen || echo "$name is missing"
    done <names
    for line in 'first dial to the left *turn left' 'swipe to the left *turn right' \
        'strip, held *the first view' 'tap, right third *nearer' \
        'first below the panel *turn left' 'scroll up *turn left'; do
        grep -q "^  $line" seen || { echo "no $line"; cat seen; }
    done
    grep -q '^apex: none' seen || echo "apex has keys")"

echo "$budgets" >budgets
verdict "make hid-budgets measures every driver, but Planelet's own" "$(
    while read -r name; do
        [ "$name" = planelet ] || grep -q "^ *$name .* reports of .* frames per second" budgets ||
            echo "$name is missing"
    done <names
    grep FAIL budgets)"

# Two programs; the node is a file here.
: >node
printf 'device apex %s S1\n' "$PWD/node" >both
"$out/planelet-hid-scripted" both show 128x40.ppm 128x40.ppm --hold 60 >seen 2>first </dev/null &
process=$!
sleep 1
hid "$(cat both)" show 128x40.ppm
verdict "a second program on a display is told which process shows there" "$(
    ended_with 1 "process $process shows pictures on 1038:1618; stop that one, or choose another"
    [ "$(value 0 reports)" = 0 ] || cat err)"
kill -KILL $process
wait $process 2>/dev/null
hid "$(cat both)" show 128x40.ppm
verdict "... and shows once that was killed" "$(ended_with 0 '1 frames in')"
finish

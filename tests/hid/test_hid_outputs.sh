#!/bin/sh
# test_hid_outputs.sh - planelet-hid writes over nothing that it shows, and says what is out of
# range, on an emulated panel
# SPDX-License-Identifier: MIT
. tests/check/report.sh
out=${OUT:-$BUILD/host}
case $out in
/*) ;;
*) out=$PWD/$out ;;
esac
work=$BUILD/test-tmp/hid_outputs
LC_ALL=C TERM=dumb
export LC_ALL TERM
rm -rf "$work"
mkdir -p "$work"
trouble=$($MAKE -s all "${OUT:-$BUILD/host}/planelet-hid-emulated" 2>&1 >/dev/null)
verdict "the emulated panel builds" "$trouble"
[ -z "$trouble" ] || { finish; exit 1; }
cd "$work" || exit 1
"$out/planelet" make knot --triangles 500 -o knot.ply
"$out/planelet" pack knot.ply -o knot.plt
"$out/planelet" render knot.plt -o knot.ppm --size 64x48
"$out/planelet" render knot.plt -o knot.y4m --size 64x48 --orbit 3
mkdir keep
for name in knot.plt knot.ppm knot.y4m; do
    cp $name keep
    ln $name "hard.$name"
    ln -s $name "soft.$name"
done

# show ARGUMENT...: files `seen` and `err`, variable `status`.
show() {
    timeout 60 "$out/planelet-hid-emulated" show "$@" >seen 2>err </dev/null
    status=$?
}
for name in knot.plt knot.ppm knot.y4m; do
    for stats in $name ./$name hard.$name soft.$name; do
        show $name --frames 2 --json $stats
        verdict "statistics of $name do not go into $stats" "$(
            [ $status -eq 1 ] || echo "status $status"
            grep -q "^$name: is the same file as the output $stats;" err || cat err
            cmp keep/$name $name 2>&1
            ls -a | grep '^\.planelet-')"
    done
    show $name --frames 2 --json stats
    verdict "... they do into a file of their own" "$(
        [ $status -eq 0 ] || cat err
        grep -q '"driver": "planelet"' stats || cat stats)"
    rm -f stats
done
show knot.ppm --json missing/stats
verdict "statistics that cannot be written are refused before anything is shown" "$(
    [ $status -eq 1 ] || echo "status $status"
    grep -q '^missing/stats: .*create the directory' err || cat err
    [ ! -s seen ] || echo "something was shown")"
timeout 60 "$out/planelet-hid-emulated" show knot.ppm --json closed --frames 1 2>&- >seen </dev/null
verdict "without standard error statistics hold no message" "$(
    head -n 1 closed | grep -v '^{$'
    tail -n 1 closed | grep -v '^}$')"

# limits FLAG BELOW LEAST MOST ABOVE
limits() {
    for value in "$3" "$4"; do
        [ "$value" != - ] || continue
        show knot.plt --frames 1 --turn 0 "$1" "$value"
        verdict "$1 $value is in range" "$([ $status -eq 0 ] || cat err)"
    done
    for value in "$2" "$5"; do
        [ "$value" != - ] || continue
        show knot.plt --frames 1 "$1" "$value"
        verdict "$1 $value is out of range" "$(
            [ $status -eq 2 ] || echo "status $status"
            grep -q "^planelet-hid show: $1 takes" err || cat err)"
    done
}
limits --brightness -1 0 100 101
limits --near -1 0 15 16
limits --fps 0 1 100 101
limits --frames 0 1 - 1000000001
limits --hold -0.1 0 100 -
limits --wait -0.1 0 100 -
limits --turn -0.1 0 100 -
limits --fov 0.0001 0.0002 179.999 180
limits --arena 0 - 1073741824 1073741825
show knot.plt --frames 1 --up 0,0,0
verdict "a camera without up is refused as such" "$(
    [ $status -eq 1 ] || echo "status $status"
    grep -q '^camera: up has no direction' err || cat err)"
finish

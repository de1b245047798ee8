#!/bin/sh
# test_hid_rules.sh - planelet-hid without hidapi, its words, and the udev rules
# SPDX-License-Identifier: MIT
. tests/check/report.sh
out=${OUT:-$BUILD/host}
rules=host_tools/hid/70-planelet.rules
mkdir -p "$BUILD/hid"
notes="implemented from published protocol notes; tested byte for byte against our own emulator"

if needs pkg-config readelf && pkg-config --exists hidapi-hidraw hidapi-libusb; then
    trouble=$($MAKE -s planelet-hid 2>&1 >/dev/null)
    verdict "planelet-hid builds with both backends" "$trouble"
    program=$out/planelet-hid
    verdict "the udev rules that are shipped are those of the drivers" "$(
        "$program" rules | diff - "$rules")"
    verdict "list says that the drivers of others were not run on hardware" "$(
        "$program" list | grep -q "$notes only, not on hardware" || "$program" list)"
    verdict "the help of show says so too" "$(
        "$program" show --help | tr -s ' \n' '  ' | grep -q "$notes only, not on hardware" ||
            "$program" show --help)"
    verdict "help show is show --help, as with planelet" "$(
        "$program" show --help >"$BUILD/hid/help" && [ -s "$BUILD/hid/help" ] || echo "no help"
        "$program" help show | diff "$BUILD/hid/help" -)"
    for backend in hidraw libusb; do
        libraries=$(readelf -d "$out/planelet-hid-$backend" |
            sed -n 's/.*(NEEDED).*\[\(.*\)\]/\1/p')
        verdict "planelet-hid-$backend links hidapi-$backend and libc alone" "$(
            echo "$libraries" | grep -q "^libhidapi-$backend" || echo "not hidapi: $libraries"
            echo "$libraries" | grep -vE "^(libhidapi-$backend|libc|libm)\.so")"
    done
    text=$("$program" show picture.ppm --device ffff:ffff 2>&1)
    status=$?
    verdict "a display that is not there: status 1 and one line that says what to do" "$(
        [ $status -eq 1 ] && [ "$(echo "$text" | wc -l)" -eq 1 ] &&
            echo "$text" | grep -q 'ffff:ffff: no such device.*planelet-hid list' ||
            echo "status $status: $text")"
    text=$("$program" show --fit wide picture.ppm 2>&1)
    status=$?
    verdict "wrong usage: status 2 and one line" "$(
        [ $status -eq 2 ] && [ "$(echo "$text" | wc -l)" -eq 1 ] || echo "status $status: $text")"
else
    verdict "hidapi is installed" "pkg-config knows not both of its backends; run: make setup"
fi
verdict "the rules' file comes before 73-seat-late.rules" "$(
    number=$(basename "$rules" | sed 's/-.*//')
    [ "$number" -lt 73 ] || echo "$rules")"
text=$($MAKE -s PKG_CONFIG=false OUT="$BUILD/hid/without" \
    "$BUILD/hid/without/hid-hidraw/device/port.o" 2>&1)
status=$?
verdict "without hidapi make planelet-hid fails and says what to install" "$(
    [ $status -ne 0 ] && echo "$text" | grep -q 'install libhidapi-dev' || echo "$text")"
finish

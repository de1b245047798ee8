# guest_tests.sh - what the bench shows; sourced by guest.sh in the guest
#
# A display compares its whole panel, in every pixel, with each picture that came
# (device_main.c). What is not compared so: the states between the keys of a
# Stream Deck and the halves of a Nova, which are no pictures; the picture a display
# was killed in; and films on a paced bus (blind=1), where comparing would need the
# time that is measured, and whose pictures are compared elsewhere.
# SPDX-License-Identifier: MIT

# display DRIVER WxH TRANSPORT BACKEND COUNT [device key=value ...]
display() {
    name=$1 panel=$2 transport=$3 library=$4 pictures=$5
    shift 5
    start "$transport" "$name" "$@"
    show "$library" "$panel" "$pictures"
    stop
    verdict "$name over $transport, $library${*:+, $*}: $pictures pictures, every pixel" \
        "$(trouble_of "$name" "$pictures")"
}

# Reports of real displays, over every transport.
real_displays() {
    for backend in hidraw-sanitize libusb-sanitize; do
        display nexus 640x48 usbip $backend 3 speed=high
        display streamdeck-mini 240x160 usbip $backend 2 speed=high
        display nova 128x64 usbip $backend 5
        display apex 128x40 usbip $backend 5
        display apex-2023 128x40 usbip $backend 5
        display logitech 160x43 usbip $backend 5
    done
    # No acknowledgement would bring back what uhid drops when its queue is full.
    display nexus 640x48 uhid hidraw 3 eager=1
    display streamdeck-mini 240x160 uhid hidraw 2 eager=1
    display nova 128x64 uhid hidraw 5
    display apex 128x40 uhid hidraw 5
    display apex-2023 128x40 uhid hidraw 5
    display logitech 160x43 uhid hidraw 5
}

# Our own wire beyond the combinations of guest_cross.sh. 96x70: a tile is cut.
own() { # BACKEND TRANSPORT COUNT [key=value ...]
    library=$1 transport=$2 pictures=$3
    shift 3
    display planelet 96x70 "$transport" "$library" "$pictures" size=96x70 "$@"
}

own_displays() {
    for backend in hidraw libusb; do
        own $backend usbip 4 reads=1
        own $backend usbip 4 report=1024 speed=high
        own $backend usbip 4 no_out=1
    done
    own hidraw-sanitize usbip 4 format=4
    own libusb-sanitize usbip 4 format=3
}

# Killed in the middle of a frame, and plugged in again a quarter second later: sets
# `trouble` to what is wrong but the time, `away` to the seconds without a device.
unplug() { # BACKEND
    start usbip planelet size=320x240 die_after=150
    ./make_pattern 320x240 6 >"$scratch/pictures"
    "./planelet-hid-$1" show "$scratch/pictures" --every --json "$scratch/json" \
        --device 1209:0001 >"$scratch/host" 2>&1 &
    host=$!
    wait $device 2>/dev/null
    gone=$(uptime_seconds)
    until_devices 0
    usleep 250000
    away=$(echo "$(uptime_seconds) $gone" | awk '{ print $1 - $2 }')
    ./device usbip planelet size=320x240 >"$scratch/device" 2>&1 &
    device=$!
    wait $host
    status=$?
    stop
    trouble=$(
        [ $status -eq 0 ] && [ "$(value last)" = 5 ] && [ "$(value other)" = 0 ] ||
            { echo "host $status, $line"; cat "$scratch/host"; }
        [ "$(statistic reconnects)" = 1 ] || echo "$(statistic reconnects) reconnects")
}

back_in_time() {
    echo "$(statistic longest_gap_s) $away" | awk '{ exit !($1 > 0 && $1 - $2 < 2) }'
}

# What else the machine under the emulator does can only add to the time, so the
# best of three counts; the pictures must be right in each.
unplugged() {
    for backend in hidraw libusb; do
        for attempt in 1 2 3; do
            unplug $backend
            echo "    $backend: whole after $(statistic longest_gap_s) s, $away s of them unplugged"
            { [ -n "$trouble" ] || back_in_time; } && break
        done
        [ -n "$trouble" ] || back_in_time || trouble="late $attempt times"
        verdict "$backend: killed in mid-frame and plugged in, the picture is whole within 2 s" \
            "$trouble"
    done
}

# A full-speed bus of 64 bytes per millisecond. The share of it that a frame needs
# hardly depends on this machine, and gives the frames per second that fit. Half
# of these are demanded of the emulated processor, which encodes, decodes and
# is the bus: on a quiet machine all come, with other programs on two busy
# processors 0.7 of them came at worst. Of the speeds here this is the only one
# that says something of hardware.
paced() { # SENTENCE BACKEND AT_LEAST FILE size=WxH [key=value ...]
    sentence=$1 backend=$2 least=$3 file=$4
    shift 4
    start usbip planelet paced=1 blind=1 reads=1 "$@"
    "./planelet-hid-$backend" show "$file" --near "$near" --json "$scratch/json" \
        >"$scratch/host" 2>&1
    status=$?
    stop
    reports=$(statistic steady_reports_per_frame)
    speed=$(statistic steady_frames_per_s)
    bus=$(echo "$reports" | awk '{ printf "%d", 1000 / ($1 > 0 ? $1 : 1) }')
    verdict "paced full speed, $backend: $sentence: the bus has room for $least per second" "$(
        [ $status -eq 0 ] && [ "$(value wrong)" = 0 ] ||
            { echo "$status: $line"; cat "$scratch/host"; }
        [ "$bus" -ge "$least" ] || echo "$reports reports per frame, room for $bus"
        echo "$speed $least" | awk '{ exit !(2 * $1 >= $2) }' || echo "only $speed came")"
    echo "    $backend: $sentence: $reports reports per frame; $speed frames per second here"
}

paced_displays() {
    for backend in hidraw libusb; do
        near=0
        paced "marbles, 128x64 of 1 bit" $backend 50 small.ppm size=128x64 format=4
        paced "an orbit, 320x240 RGB565" $backend 4 orbit.y4m size=320x240
        near=auto
        paced "marbles before a still camera, 320x240 RGB565, goal of 12" $backend 12 marbles.ppm \
            size=320x240
    done
}

# Anyone but root needs the udev rule; the sentence says so.
permissions() {
    start usbip planelet
    for backend in hidraw libusb; do
        start-stop-daemon -S -c 65534:65534 -x "/t/planelet-hid-$backend" -- \
            show /t/guest_tests.sh >"$scratch/host" 2>&1
        verdict "$backend: without permission one sentence with the udev rule" "$(
            [ "$(wc -l <"$scratch/host")" -eq 1 ] &&
                grep -q '1209:0001; install the udev rule: planelet-hid rules' "$scratch/host" ||
                cat "$scratch/host")"
    done
    chmod 666 /dev/hidraw*
    start-stop-daemon -S -c 65534:65534 -x /t/planelet-hid-hidraw -- show "$scratch/one" --every \
        >"$scratch/host" 2>&1
    verdict "hidraw: with permission on the device any user shows pictures" "$(
        grep -q '1 frames in' "$scratch/host" || cat "$scratch/host")"
    stop
}

# The same vid:pid, another device.
strangers() {
    start usbip nexus vendor=1209 id=1
    for backend in hidraw libusb; do
        "./planelet-hid-$backend" show "$scratch/one" --device 1209:0001 >"$scratch/host" 2>&1
        verdict "$backend: a stranger at our vid:pid is named as such" "$(
            grep -q 'does not answer as a planelet display' "$scratch/host" || cat "$scratch/host")"
    done
    stop
}

lists() {
    start usbip nexus speed=high serial=SN42
    for backend in hidraw libusb; do
        verdict "$backend: list shows path, vid:pid, serial number, driver and names" "$(
            "./planelet-hid-$backend" list |
                grep -q '1b1c:1b8e  SN42 .* nexus .* Planelet emulated nexus' ||
                "./planelet-hid-$backend" list)"
    done
    stop
}

# With libusb the second cannot open it; on hidraw it would write, too.
held() {
    start usbip planelet
    ./planelet-hid-hidraw show "$scratch/one" "$scratch/one" --hold 600 >/dev/null 2>&1 &
    host=$!
    sleep 2
    ./planelet-hid-hidraw show "$scratch/one" >"$scratch/host" 2>&1
    verdict "hidraw: a second program is told which process shows on the display" "$(
        grep -q "process $host shows pictures on 1209:0001; stop that one" "$scratch/host" ||
            cat "$scratch/host")"
    kill -KILL $host
    wait $host 2>/dev/null
    ./planelet-hid-hidraw show "$scratch/one" --every >"$scratch/host" 2>&1
    verdict "hidraw: ... and shows there once that is killed" "$(
        grep -q '1 frames in' "$scratch/host" || cat "$scratch/host")"
    stop
}

# Two displays that differ in their ports alone.
neighbours() {
    ./device usbip planelet size=64x48 port=1 >"$scratch/neighbour" 2>&1 &
    neighbour=$!
    until_devices 1
    ./device usbip planelet size=64x48 die_after=60 >"$scratch/device" 2>&1 &
    device=$!
    until_devices 2
    usleep 50000
    ./make_pattern 64x48 40 >"$scratch/pictures"
    ./planelet-hid-hidraw show "$scratch/pictures" --every --device /dev/hidraw1 \
        >"$scratch/host" 2>&1 &
    host=$!
    wait $device 2>/dev/null
    until_devices 1
    usleep 500000
    ./device usbip planelet size=64x48 >"$scratch/device" 2>&1 &
    device=$!
    wait $host
    status=$?
    kill -TERM $neighbour
    wait $neighbour 2>/dev/null
    stop
    verdict "hidraw: a display that was unplugged is waited for, its equal neighbour left alone" "$(
        [ $status -eq 0 ] && grep -q ' 1 reconnects' "$scratch/host" && [ "$(value last)" = 39 ] ||
            { echo "$status: $line"; cat "$scratch/host"; }
        grep -q ' changes=0 ' "$scratch/neighbour" || cat "$scratch/neighbour")"
}

# Keys: input reports through the kernel and hidapi. Each press is counted once, however
# many reports of the link come between.
keyed() { # DRIVER BACKEND [key=value ...]
    name=$1 backend=$2
    shift 2
    start usbip "$name" blind=1 key=3 "$@"
    "./planelet-hid-$backend" show knot.plt --turn 0 --json "$scratch/json" \
        >"$scratch/host" 2>&1 &
    host=$!
    for i in $(seq 300); do
        grep -q pressed "$scratch/device" && break
        usleep 200000
    done
    sleep 4 # a picture takes seconds on a busy machine, and keys are heard between two
    kill -TERM $host
    wait $host
    status=$?
    stop
    verdict "$name over usbip, $backend: four presses of a key turn a scene four times" "$(
        [ $status -eq 0 ] && [ "$(value wrong)" = 0 ] ||
            { echo "$status: $line"; cat "$scratch/host"; }
        [ "$(statistic steered)" = 4 ] ||
            { echo "$(statistic steered) times; $line"; cat "$scratch/host"; })"
}

keyed_displays() {
    for backend in hidraw-sanitize libusb; do
        keyed planelet $backend size=64x48
        keyed streamdeck-mini $backend speed=high
    done
}

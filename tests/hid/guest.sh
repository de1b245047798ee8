#!/bin/busybox sh
# guest.sh - the first process of the bench: real hidapi on real drivers
#
# Runs in QEMU on Debian's kernel. Displays are emulated beside the host's
# program (tests/hid/device_main.c); between them are the kernel's HID and USB
# drivers and hidapi. Prints "pass SENTENCE" and "FAIL SENTENCE" and, at the
# end, "DONE". SPDX-License-Identifier: MIT
/bin/busybox --install -s /bin
export PATH=/bin
mount -t proc proc /proc
mount -t sysfs sys /sys
mount -t devtmpfs dev /dev 2>/dev/null
mount -t tmpfs tmp /tmp
while read -r module; do
    insmod "/mod/$module" || echo "FAIL the module $module loads"
done </mod/list
mount -t configfs config /sys/kernel/config 2>/dev/null
mkdir -p /etc
echo "nobody:x:65534:65534::/:/bin/sh" >/etc/passwd
echo 1 >/proc/sys/vm/overcommit_memory # the program's largest arena is not touched
cd /t || exit
scratch=$(mktemp -d)
chmod 755 "$scratch"
for word in $(cat /proc/cmdline); do
    case $word in HID_GROUPS=*) HID_GROUPS=$(echo "${word#*=}" | tr , " ") ;; esac
done

verdict() { # SENTENCE TROUBLE
    if [ -z "$2" ]; then
        echo "pass $1"
    else
        echo "$2" | sed 's/^/    /'
        echo "FAIL $1"
    fi
}

hid_devices() {
    ls /sys/bus/hid/devices | wc -l
}

# until_devices COUNT: waits until there are so many, three seconds at most.
until_devices() {
    tries=0
    while [ "$(hid_devices)" -ne "$1" ] && [ $tries -lt 60 ]; do
        tries=$((tries + 1))
        usleep 50000
    done
}

uptime_seconds() {
    cut -d ' ' -f 1 /proc/uptime
}

# start TRANSPORT DRIVER [key=value ...]: a display, plugged in.
start() {
    ./device "$@" >"$scratch/device" 2>&1 &
    device=$!
    until_devices 1
    usleep 100000
}

# stop: unplugs it; $line is what it has to say.
stop() {
    kill -TERM $device 2>/dev/null
    wait $device 2>/dev/null
    line=$(cat "$scratch/device")
    until_devices 0
}

value() { # NAME: of NAME=value in $line
    echo "$line" | tr ' ' '\n' | sed -n "s/^$1=//p" | head -n 1
}

# show BACKEND WxH COUNT [flag ...]: pictures 0 .. COUNT - 1, every one of them.
show() {
    backend=$1 size=$2 count=$3
    shift 3
    ./make_pattern "$size" "$count" >"$scratch/pictures"
    "./planelet-hid-$backend" show "$scratch/pictures" --every --json "$scratch/json" "$@" \
        >"$scratch/host" 2>&1
    status=$?
}

# judge SENTENCE COUNT: so many pictures came in order, every pixel right.
judge() {
    verdict "$1" "$(
        [ "$status" -eq 0 ] || { echo "the host ended with $status:"; cat "$scratch/host"; }
        [ "$(value matched)" = "$2" ] && [ "$(value last)" = $(($2 - 1)) ] &&
            [ "$(value wrong)" = 0 ] || echo "$line"
        case $1 in planelet*) [ "$(value other)" = 0 ] || echo "a wrong picture: $line" ;; esac)"
}

figure() { # NAME: of the host's figures
    sed -n "s/.*\"$1\": \"\{0,1\}\([^\",]*\).*/\1/p" "$scratch/json"
}

. ./guest_tests.sh
echo "DONE in $(cut -d ' ' -f 1 /proc/uptime) s of the guest's clock"
poweroff -f

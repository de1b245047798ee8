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

verdicts=0
verdict() { # SENTENCE TROUBLE
    verdicts=$((verdicts + 1))
    if [ -z "$2" ]; then
        echo "pass $1"
    else
        echo "$2" | sed 's/^/    /'
        echo "FAIL $1"
    fi
}

# To start a process takes this machine milliseconds: what runs often starts none.

# until_devices COUNT: waits until there are so many, three seconds at most.
until_devices() {
    wanted=$1 tries=0
    set -- /sys/bus/hid/devices/*
    while [ -e "$1" ] && there=$# || there=0 && [ $there -ne "$wanted" ] && [ $tries -lt 150 ]; do
        tries=$((tries + 1))
        usleep 20000
        set -- /sys/bus/hid/devices/*
    done
}

uptime_seconds() {
    cut -d ' ' -f 1 /proc/uptime
}

# start TRANSPORT DRIVER [key=value ...]: a display, plugged in.
start() {
    : >"$scratch/device"
    ./device "$@" >>"$scratch/device" 2>&1 &
    device=$!
    until_devices 1
    usleep 50000
}

# stop: unplugs it; $line is what it has to say.
stop() {
    kill -TERM $device 2>/dev/null
    wait $device 2>/dev/null
    line=$(cat "$scratch/device")
    until_devices 0
}

value() { # NAME: of NAME=value in $line
    for word in $line; do
        case $word in "$1="*) echo "${word#*=}" && return ;; esac
    done
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

# trouble_of DRIVER COUNT: unless the host ended well and so many pictures came in
# order, each right in every pixel and with nothing in between; displays that
# change key by key, or half by half, pass through the states between.
trouble_of() {
    case $1 in
    streamdeck-mini) between=$((5 * $2)) ;;
    nova) between=$2 ;;
    *) between=0 ;;
    esac
    [ "$status" -eq 0 ] || { echo "the host ended with $status:"; cat "$scratch/host"; }
    [ "$(value matched)" = "$2" ] && [ "$(value last)" = $(($2 - 1)) ] &&
        [ "$(value wrong)" = 0 ] && [ "$(value other)" -le "$between" ] || echo "$line"
}

statistic() { # NAME: of the host's statistics
    sed -n "s/.*\"$1\": \"\{0,1\}\([^\",]*\).*/\1/p" "$scratch/json"
}

for file in gadget cross tests; do
    . "./guest_$file.sh"
done
./make_pattern 64x48 1 >"$scratch/one"
chmod 644 "$scratch/one"
for group in ${HID_GROUPS:-lists real_displays own_displays cross gadgets strangers permissions \
    held neighbours unplugged paced_displays keyed_displays}; do
    began=$(uptime_seconds) before=$verdicts
    $group
    [ $verdicts -gt $before ] || echo "FAIL the group $group shows anything"
    echo "    $group: $(echo "$(uptime_seconds) $began" | awk '{ print $1 - $2 }') s"
done
echo "DONE in $(cut -d ' ' -f 1 /proc/uptime) s of the guest's clock"
poweroff -f

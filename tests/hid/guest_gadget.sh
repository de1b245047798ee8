# guest_gadget.sh - displays behind the kernel's own HID function; sourced by guest.sh
#
# The function is plugged into dummy_hcd, which is host and device in one.
# SPDX-License-Identifier: MIT

g=/sys/kernel/config/usb_gadget/g

# function_hid VENDOR ID DESCRIPTOR REPORT_BYTES NO_OUT: makes the gadget. Input reports
# need 64 bytes of room, and what does not fit in a packet of full speed needs high
# speed. NO_OUT of 1: reports come by SET_REPORT, feature reports too.
function_hid() {
    speed=full-speed
    [ "$4" -le 64 ] || speed=high-speed
    mkdir $g $g/strings/0x409 $g/functions/hid.h $g/configs/c.1
    echo "0x$1" >$g/idVendor
    echo "0x$2" >$g/idProduct
    echo $speed >$g/max_speed
    echo Planelet >$g/strings/0x409/manufacturer
    echo "emulated display" >$g/strings/0x409/product
    echo SN0001 >$g/strings/0x409/serialnumber
    echo 0 >$g/functions/hid.h/protocol
    echo 0 >$g/functions/hid.h/subclass
    echo "$5" >$g/functions/hid.h/no_out_endpoint
    echo $(($4 > 64 ? $4 : 64)) >$g/functions/hid.h/report_length
    cat "$3" >$g/functions/hid.h/report_desc
    ln -s $g/functions/hid.h $g/configs/c.1/
    ls /sys/class/udc | head -n 1 >$g/UDC
}

# gadget REPORT_BYTES DRIVER VENDOR ID [key=value ...]: a display, plugged in.
gadget() {
    bytes=$1 driver=$2 vendor=$3 id=$4
    shift 4
    ./device descriptor "$driver" "$@" >"$scratch/descriptor"
    case " $* " in *" no_out=1 "*) no_out=1 ;; *) no_out=0 ;; esac
    function_hid "$vendor" "$id" "$scratch/descriptor" "$bytes" $no_out
    until_devices 1
    : >"$scratch/device"
    ./device gadget "$driver" "$@" path=/dev/"$(ls /dev | grep '^hidg' | tail -n 1)" \
        >>"$scratch/device" 2>&1 &
    device=$!
    usleep 50000
}

# no_gadget: unplugs it; $line is what the display has to say.
no_gadget() {
    kill -TERM $device
    wait $device 2>/dev/null
    line=$(tail -n 1 "$scratch/device")
    echo "" >$g/UDC
    rm $g/configs/c.1/hid.h
    rmdir $g/configs/c.1 $g/functions/hid.h $g/strings/0x409 $g
    until_devices 0
}

# Interfaces of the real ones are others: they are named. What has feature reports
# has no OUT endpoint here, and the kernel keeps but the last SET_REPORT that was not
# read: such displays go first.
gadgets() {
    for backend in hidraw libusb; do
        while read -r bytes driver vendor id panel pictures words; do
            gadget "$bytes" "$driver" "$vendor" "$id" $words
            show $backend "$panel" "$pictures" --driver "$driver" --device SN0001
            no_gadget
            verdict "$driver over the kernel's gadget, $backend${words:+, $words}: \
$pictures pictures, every pixel" \
                "$(trouble_of "$driver" "$pictures")"
        done <<END
64 planelet 1209 0001 96x70 4 size=96x70
1024 planelet 1209 0001 96x70 4 size=96x70 report=1024
1024 nexus 1b1c 1b8e 640x48 3
1024 streamdeck-mini 0fd9 0063 240x160 2
1024 nova 1038 12cb 128x64 5 no_out=1 eager=1
1024 apex 1038 1618 128x40 5 no_out=1 eager=1
1024 apex-2023 1038 1628 128x40 5 no_out=1 eager=1
1024 logitech 046d c21c 160x43 5
64 planelet 1209 0001 96x70 4 size=96x70 no_out=1
END
    done
}

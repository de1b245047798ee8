# emulate.sh - a firmware in QEMU, with exact counts: what run.sh of such a board has in common
#
#   machine='qemu-system-arm -M mps2-an386' cross=arm-none-eabi- board=NAME
#   . board/tools/emulate.sh
#
# (loader_bytes=N for a machine of QEMU that loads at most so many at once) with the arguments of
# run.sh: SCENE.plt|"" [key=value ...]. The scene goes into memory at
# plt_scene_start by QEMU's loader; "" leaves that to scene=PATH, and so does SOURCE=file, which
# gives its path: it stays in the file, and is fetched by semihosting. A board without memory for
# scenes has them so in any case.
# Prints what the firmware prints, then "instructions total=N open=N render=N ... render_longest=N
# stored_stack=N", "instructions_per_ray N" and "stack painted=N stored=N worst=N".
# PROFILE=PATH writes a count for every instruction there. MARKS=PATH, of PROGRAM=played, a line
# for what came before the first frame and one for each frame (board/tools/count.c); of
# plt_sequence_show it has the parts, which begin where the engine's functions do.
# PANEL=PATH.ppm writes what the board's display shows there, as QEMU draws it.
# FIRMWARE is the folder that it was built in (build/NAME).
# The exit status is the firmware's; 124 after QEMU_SECONDS (board/tools/limit.sh).
# SPDX-License-Identifier: MIT
. board/tools/limit.sh
out=${FIRMWARE:-${BUILD:-build}/$board}
elf=$out/firmware.elf
scene=$1
shift
folder=$(mktemp -d)
log=$folder/log counts=$folder/counts said=$folder/said
trap 'rm -rf "$folder"' EXIT
: >"$log" >"$counts" >"$said"

symbols=$("${cross}nm" "$elf")
symbol() {
    printf '%s\n' "$symbols" | awk -v name="$1" '$3 == name { print "0x" $1 }'
}
plugin=$out/libcount.so,out=$counts
plugin=$plugin,stack=$(symbol plt_stack_bottom):$(symbol plt_stack_top):$(symbol machine_main)
region() { # NAME BEGIN END: if the firmware has both
    begin=$(symbol "$2") end=$(symbol "$3")
    [ -z "$begin" ] || [ -z "$end" ] || plugin=$plugin,region=$1:$begin:$end
}
for name in open render read show rebuild; do
    region $name firmware_${name}_begin firmware_${name}_end
done
if [ -n "$MARKS" ]; then
    region records plt_vertices_put plt_refit_all
    region refit plt_refit_all plt_moved
    region grid plt_moved firmware_show_end
    region beside plt_beside_more firmware_read_end
    region vertices plt_beside_put plt_moved
    plugin=$plugin,mark=$(symbol firmware_frame_done),marks=$MARKS
fi
[ -n "$PROFILE" ] &&
    plugin=$plugin,code=$(symbol plt_text_start):$(symbol plt_text_end),profile=$PROFILE

# A comma ends an option of QEMU unless it is doubled.
escaped() {
    printf '%s' "$1" | sed 's/,/,,/g'
}

parameters=$*
set --
if [ -n "$scene" ]; then
    [ -r "$scene" ] || { echo "$scene: cannot be read" >&2; exit 1; }
    if [ "$SOURCE" = file ] || [ "$(symbol plt_scene_start)" = "$(symbol plt_scene_end)" ]; then
        # A blank ends a parameter of the firmware: it gets a name that has none.
        ln -s "$(realpath "$scene")" "$folder/scene"
        parameters="scene=$folder/scene $parameters"
    else
        parameters="bytes=$(wc -c <"$scene" | tr -d ' ') $parameters"
        # In pieces, as QEMU loads none that is larger than what it takes for the machine's RAM; and
        # not what the firmware will refuse, as some of QEMU's machines do not survive it.
        at=$(symbol plt_scene_start)
        [ "$(wc -c <"$scene")" -gt $(($(symbol plt_scene_end) - at)) ] ||
            split -b "${loader_bytes:-16777216}" "$scene" "$folder/piece"
        for piece in "$folder"/piece*; do
            [ -e "$piece" ] || break # an empty file has nothing to load
            set -- "$@" -device "loader,file=$piece,addr=$at,force-raw=on"
            at=$((at + ${loader_bytes:-16777216}))
        done
    fi
fi
# photograph: asks QEMU's monitor for a picture when the firmware says that its panel shows the
# frame, and tells it to go on. A monitor does one command after the other, so the answer to the
# second says that the first is done.
photograph() {
    until grep -q '^panel ' "$log"; do
        sleep 0.2
    done
    timeout 60 cat "$folder/monitor.out" >"$said" &
    printf '%s\n' "screendump $folder/panel.ppm" "info status" >"$folder/monitor.in"
    until grep -q 'VM status' "$said"; do
        sleep 0.2
    done
    : >"$folder/seen"
}
monitor='-monitor none'
photographer=
if [ -n "$PANEL" ]; then
    mkfifo "$folder/monitor.in" "$folder/monitor.out"
    monitor="-chardev pipe,id=monitor,path=$folder/monitor -mon chardev=monitor"
    parameters="$parameters hold=$folder/seen"
    photograph &
    photographer=$!
fi
# shellcheck disable=SC2086
limited $machine -display none $monitor \
    -serial null -icount shift=0 -chardev "file,id=text,path=$log" \
    -semihosting-config \
    "enable=on,target=native,chardev=text,arg=firmware,arg=$(escaped "$parameters")" \
    -plugin "$plugin" "$@" -kernel "$elf"
status=$?
if [ -n "$PANEL" ]; then
    kill "$photographer" 2>/dev/null
    wait "$photographer" 2>/dev/null
    [ $status -ne 0 ] || cp "$folder/panel.ppm" "$PANEL" || status=1
fi
cat "$log" "$counts"
# One that begins elsewhere runs what is there, until it is ended.
if [ $status -eq 124 ] && grep -q ' stored_stack=0$' "$counts"; then
    echo "error: machine_main was not reached in ${QEMU_SECONDS:-600} seconds; memory.ld puts" \
        "code at $(symbol plt_text_start): take what QEMU begins at, and on RISC-V -bios none" >&2
fi
awk '
    { for (i = 2; i <= NF; i++) { split($i, item, "="); value[$1, item[1]] = item[2] } }
    /^worst / { value["static", "worst"] = $2 }
    END {
        rays = value["stats", "rays"]
        if (rays > 0) {
            printf "instructions_per_ray %.1f\n", value["instructions", "render"] / rays
        }
        printf "stack painted=%d stored=%d worst=%d\n", value["stack", "painted"],
               value["instructions", "stored_stack"], value["static", "worst"]
    }' "$log" "$counts" "$out/stack.txt"
exit $status

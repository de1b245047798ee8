#!/bin/sh
# run.sh SCENE.plt|"" [key=value ...] - runs the firmware in QEMU and counts
#
# The scene goes into PSRAM by QEMU's loader; "" leaves that to scene=PATH, and so does
# SOURCE=file, which gives its path: it stays in the file, and is fetched by semihosting.
# Prints what the firmware prints, then "instructions total=N open=N render=N ... render_longest=N
# stored_stack=N", "instructions_per_ray N" and "stack painted=N stored=N worst=N".
# PROFILE=PATH writes a count for every instruction there. MARKS=PATH, of PROGRAM=played, a line
# for what came before the first frame and one for each frame (board/tools/count.c); of
# plt_sequence_show it has the parts, which begin where the engine's functions do.
# FIRMWARE is the folder that it was built in (build/mps2_an386).
# The exit status is the firmware's; 124 after QEMU_SECONDS (default 600).
# SPDX-License-Identifier: MIT
out=${FIRMWARE:-${BUILD:-build}/mps2_an386}
elf=$out/firmware.elf
scene=$1
shift
log=$(mktemp) counts=$(mktemp)
trap 'rm -f "$log" "$counts"' EXIT

symbol() {
    arm-none-eabi-nm "$elf" | awk -v name="$1" '$3 == name { print "0x" $1 }'
}
plugin=$out/libcount.so,out=$counts
plugin=$plugin,stack=$(symbol plt_stack_bottom):$(symbol plt_stack_top):$(symbol cortex_m_main)
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
[ -n "$PROFILE" ] && plugin=$plugin,code=0:0x100000,profile=$PROFILE

parameters=$*
set --
if [ -n "$scene" ] && [ "$SOURCE" = file ]; then
    parameters="scene=$scene $parameters"
elif [ -n "$scene" ]; then
    [ -r "$scene" ] || { echo "$scene: cannot be read" >&2; exit 1; }
    parameters="bytes=$(wc -c <"$scene" | tr -d ' ') $parameters"
    # An empty file has nothing to load.
    [ -s "$scene" ] && set -- -device "loader,file=$scene,addr=0x21000000,force-raw=on"
fi
# A comma ends an option of QEMU unless it is doubled.
escaped=$(printf '%s' "$parameters" | sed 's/,/,,/g')
timeout "${QEMU_SECONDS:-600}" qemu-system-arm -M mps2-an386 -display none -monitor none \
    -serial null -icount shift=0 -chardev "file,id=text,path=$log" \
    -semihosting-config "enable=on,target=native,chardev=text,arg=firmware,arg=$escaped" \
    -plugin "$plugin" "$@" -kernel "$elf"
status=$?
cat "$log" "$counts"
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

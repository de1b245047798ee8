# rows - what the engine costs, a row of CSV for a board, or for a build of some parts of it
#
# Sourced beside tests/check/report.sh. Rows of tests/golden/boards.csv: every board as it is, with
# the scene knot_600 by 80x60. Rows of tests/golden/parts.csv: the Cortex-M4F mps2_an386, PARTS by
# PARTS, with knot_2000 in the format that these have. The longest step is that of 20,000 visits and
# the largest packets, the finest that of one visit and packets of 2x2.
# SPDX-License-Identifier: MIT
planelet=$BUILD/host/planelet

boards_header=board,engine_code,engine_constants,engine_data,engine_bss,firmware_code,\
ram_without_arena_and_stack,arena_bytes,arena_peak,stack_bytes,stack_worst,stack_painted,\
longest_step,longest_step_finest,instructions_per_ray,frame_hash
parts_header=parts,code,constants,data,bss,code_and_constants,stack_open,stack_render_step,\
stack_trace,stack_worst,stack_worst_below,firmware_stack_worst,firmware_stack_painted,arena_peak,\
longest_step,instructions_per_ray,code_and_constants_most,stack_worst_most

value() { # NAME: of the last NAME=value in the text
    echo "$text" | tr ' ' '\n' | sed -n "s/^$1=//p" | tail -n 1
}
per_ray() {
    echo "$text" | sed -n 's/^instructions_per_ray //p'
}

# linked SOURCE_FOLDER...: the objects of $built/firmware.elf from there, whatever else lies beside.
linked() {
    for source_folder in "$@"; do
        sed -n "s|^LOAD \\($built/$source_folder/.*\\.o\\)\$|\\1|p" "$built/firmware.map"
    done
}
# bytes_of FILE...: "code constants data bss", of the board's objects or of an ELF file.
bytes_of() {
    {
        "$(cross_of "$board")size" -A "$@" | awk '$1 ~ /^\.text/ { s += $2 } END { print s + 0 }'
        "$(cross_of "$board")size" "$@" | awk 'NR > 1 { t += $1; d += $2; b += $3 }
            END { print t + 0, d + 0, b + 0 }'
    } | awk 'NR == 1 { code = $1 } NR == 2 { print code, $1 - code, $2, $3 }'
}

# run_frame SCENE [key=value ...]: sets text, and status, 0 if the frame is the host's.
run_frame() {
    text=$(FIRMWARE=$built sh board/tools/run_like_host.sh "$board" "$1" 80x60 ${2:+"$2"} \
        ${3:+"$3"} 2>&1)
    status=$?
    echo "$text" | grep -q '^the host renders the same frame' || status=1
}

# scene_of NAME TRIANGLES [pack option ...]: makes $BUILD/rows/NAME.plt, if it is not there.
scene_of() {
    scene=$BUILD/rows/$1.plt triangles=$2
    shift 2
    [ -z "$(find "$scene" -newer "$planelet" 2>/dev/null)" ] || return 0
    mkdir -p "$BUILD/rows" &&
        "$planelet" make knot --triangles "$triangles" -o "$BUILD/rows/knot.ply" >/dev/null &&
        "$planelet" pack "$BUILD/rows/knot.ply" "$@" -o "$scene" >/dev/null 2>&1
}

# board_row SCENE: of $board, built in $built; `text` and `status` are those of its usual frame.
board_row() {
    run_frame "$1" visits=1 packet=2
    finest=$(value render_longest) finest_status=$status
    run_frame "$1"
    [ "$finest_status" -eq 0 ] || status=$finest_status
    # shellcheck disable=SC2046
    set -- $(bytes_of $(linked engine)) $(bytes_of "$built/firmware.elf") \
        "$(echo "$text" | sed -n 's/^arena .* bytes=//p')" \
        "$(echo "$text" | sed -n 's/^stack painted=.* bytes=//p')"
    echo "$board,$1,$2,$3,$4,$(($5 + $6)),$(($7 + $8 - ${9:-0} - ${10:-0})),$9,$(value peak),${10},\
$(value worst),$(value painted),$(value render_longest),$finest,$(per_ray),$(value frame_hash)"
}

# Every public function that $built has: those of planelet.h, whichever the parts leave.
public_functions_there() {
    # shellcheck disable=SC2046
    "$(cross_of "$board")nm" $(linked engine) | awk 'NR == FNR {
            if (/^[a-z].*[ *]plt_[a-z_]+\(/) {
                sub(/\(.*/, ""); sub(/.*[ *]/, ""); public[$0]
            }
            next
        }
        $2 == "T" && ($3 in public) { printf "%s ", $3 }' engine/planelet.h -
}
# stacks: "BYTES NAME" of each of them, the deepest first; functions of a source are not counted.
stacks() {
    folders='engine platform/bare platform/cortex_m'
    # shellcheck disable=SC2046,SC2086
    arm-none-eabi-objdump -d $(linked $folders) |
        awk -v out="$built/" -v root="$(public_functions_there)" -v outward=1 \
            -f board/tools/stack.awk $(linked $folders | sed 's/o$/ci/') - |
        awk '/^error/ { print } /^(worst|root)/ { print $2, $3 }' | sort -rn
}
below() { # NAME: in `depths`
    echo "$depths" | awk -v name="$1" '$2 == name { print $1 }'
}

# most_of "WORDS": the bounds of the row that there is, which no measurement changes.
most_of() {
    awk -F, -v words="$1" '$1 == words { most = $(NF - 1) "," $NF }
        END { print most ? most : "," }' tests/golden/parts.csv
}

# parts_row "WORDS": of mps2_an386, built in $built; `text` and `status` are those of a frame, and
# `depths` what `stacks` prints. Without words: all.
parts_row() {
    case " $1 " in
    *' compact '*) scene_of compact_2000 2000 --nodes compact --geometry lattice:14 ;;
    *) scene_of thesis_2000 2000 ;;
    esac
    run_frame "$scene"
    depths=$(stacks)
    row=${1:-all}
    # shellcheck disable=SC2046
    set -- $(bytes_of $(linked engine))
    echo "$row,$1,$2,$3,$4,$(($1 + $2)),$(below plt_open),$(below plt_render_step),\
$(below plt_trace),$(echo "$depths" | head -n 1 | tr ' ' ,),$(value worst),$(value painted),\
$(value peak),$(value render_longest),$(per_ray),$(most_of "$row")"
}

# all_parts: the rows that there are, a line of words each; $built of one: folder_of "WORDS".
all_parts() {
    sed '1d; s/,.*//' tests/golden/parts.csv
}
folder_of() {
    [ "$1" = all ] && set -- ''
    echo "$BUILD/mps2_an386$(echo "$1" | tr ' ' '\n' | sort | sed '/^$/d; s/^/-/' | tr -d '\n')"
}

# structures_csv: rows of tests/golden/structures.csv, those of 256 bytes and more of $built.
structures_csv() {
    echo structure,bytes
    # shellcheck disable=SC2046
    "$(cross_of "$board")objdump" --dwarf=info $(linked engine) |
        awk -v least=256 -f tests/measure/structures.awk | tr ' ' ,
}

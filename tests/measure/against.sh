#!/bin/sh
# against.sh BASE SCENES PEER - this build beside another build of the project
#
# BASE is the folder of another checkout, with its build/host/planelet built; SCENES a
# folder of binary PLY meshes; PEER a program that makes ray files ("rays"). Each build
# packs its own images, so a new version of the format does not matter. First the results:
# images (but for the version and the CRC of the header), frames of 320x240 and the hits
# of primary, shadow and bounce rays must be the same, byte for byte. Then the speed: rays
# per second in alternating runs of this build and BASE; for each mesh, format and kind of
# ray the median of the ratios counts. Last the instructions per ray of a firmware, which
# are exact. A run of a few milliseconds measures the machine's other work: all runs of a
# row repeat their rays until they take at least MILLISECONDS. Set MESHES, FORMATS, KINDS,
# ROUNDS or MILLISECONDS for less; ROUNDS=0 leaves out the speed, DEVICE= the firmware,
# MESHES= all but the firmware.
# SPDX-License-Identifier: MIT
set -u
base=${1:-} scenes=${2:-} peer=${3:-}
planelet=${PLANELET:-build/host/planelet}
build=${BUILD:-build}
make=${MAKE:-make}
meshes=${MESHES-hand bunny dragon engine terrain car diorama statues}
formats=${FORMATS:-thesis compact}
kinds=${KINDS:-primary shadow bounce}
rounds=${ROUNDS:-7} milliseconds=${MILLISECONDS:-500} repeat=1
board=${DEVICE-mps2_an386}
passed=0 failed=0

[ -x "$base/build/host/planelet" ] && [ -d "$scenes" ] && [ -x "$peer" ] || {
    echo "use it as: make against BASE=checkout-that-is-built SCENES=folder-of-meshes" \
        "PEER=judge-program" >&2
    exit 2
}
base=$(cd "$base" && pwd)
before=$base/build/host/planelet
mkdir -p "$build/against"
work=$(cd "$build/against" && pwd)
rm -f "$work/races" "$work/instructions"

verdict() { # STATUS SENTENCE
    if [ "$1" -eq 0 ]; then
        echo "pass $2"
        passed=$((passed + 1))
    else
        echo "FAIL $2"
        failed=$((failed + 1))
    fi
}

field() { # NAME: of JSON on standard input, number or text
    sed -n "s/^ *\"$1\": \"*\([0-9a-z.]*\)\"*,*$/\1/p"
}

# The options of `planelet pack` for a format.
options_of() { # FORMAT
    case $1 in
    thesis) ;;
    compact) echo "--nodes compact --geometry lattice:14" ;;
    float) echo "--nodes compact --geometry float" ;;
    device) echo "--nodes compact --geometry lattice:14 --build device" ;;
    *)
        echo "against: there is no format $1; formats: thesis compact float device" >&2
        return 1
        ;;
    esac
}

# Compact blocks are traversed in one order.
orders_of() { # FORMAT
    [ "$1" = thesis ] && echo depth two-stage || echo depth
}

# Options of `planelet trace` for a kind of ray.
any_of() { # KIND
    [ "$1" = shadow ] && echo --any
}

# pack PROGRAM MESH FORMAT IMAGE
pack() {
    options=$(options_of "$3") || return 1
    # shellcheck disable=SC2086
    "$1" pack "$2" -o "$4" $options >"$work/said" 2>&1 || {
        cat "$work/said" >&2
        return 1
    }
}

# SPEC.md, section 2: the version is at bytes 8 to 11, the header's CRC at 20 to 23;
# cmp counts from 1.
images() { # MESH FORMAT
    pack "$planelet" "$scenes/$1.ply" "$2" "$work/this.plt" &&
        pack "$before" "$scenes/$1.ply" "$2" "$work/base.plt" || return 1
    other=$(cmp -l "$work/this.plt" "$work/base.plt" 2>&1 |
        awk '($1 >= 9 && $1 <= 12) || ($1 >= 21 && $1 <= 24) { next } { print; exit }')
    header=
    cmp -s "$work/this.plt" "$work/base.plt" || header=" but for version and CRC of the header"
    [ -z "$other" ]
    verdict $? "$1 $2: the same image$header${other:+; first difference (cmp -l): $other}"
}

frame_hash() { # PROGRAM IMAGE
    "$1" render "$2" -o "$work/frame.ppm" --size 320x240 --json - | field frame_hash
}

frames() { # MESH FORMAT
    ours=$(frame_hash "$planelet" "$work/this.plt")
    theirs=$(frame_hash "$before" "$work/base.plt")
    [ -n "$ours" ] && [ "$ours" = "$theirs" ]
    verdict $? "$1 $2: the same frame of 320x240, ${ours:-none} here, ${theirs:-none} there"
}

hits() { # MESH FORMAT KIND ORDER
    rm -f "$work/this.hits" "$work/base.hits"
    # shellcheck disable=SC2046
    "$planelet" trace "$work/this.plt" "$work/rays.$3" "$work/this.hits" --packet 8 \
        --walk "$4" $(any_of "$3")
    # shellcheck disable=SC2046
    "$before" trace "$work/base.plt" "$work/rays.$3" "$work/base.hits" --packet 8 \
        --walk "$4" $(any_of "$3")
    [ -s "$work/this.hits" ] && cmp "$work/this.hits" "$work/base.hits"
    verdict $? "$1 $2: the same hits of $3 rays, $4"
}

rate_of() { # PROGRAM IMAGE KIND
    # shellcheck disable=SC2046
    "$1" trace "$2" "$work/rays.$3" "$work/hits" --packet 8 --repeat "$repeat" $(any_of "$3") \
        --json - | field mrays_per_s
}

# How often the rays of a kind are repeated, by the rate of one pass: 32 bytes per ray.
repeats() { # KIND
    repeat=1
    rate=$(rate_of "$before" "$work/base.plt" "$1")
    awk -v rate="${rate:-0}" -v bytes="$(wc -c <"$work/rays.$1")" -v ms="$milliseconds" \
        'BEGIN { n = rate * 1000 * ms / (bytes / 32); print int(n) + 1 }'
}

# The median of column $1 of the race.
median() {
    cut -d ' ' -f "$1" "$work/race" | sort -n | sed -n "$(((rounds + 1) / 2))p"
}

# Who begins changes from round to round, so that being first is no advantage.
race() { # MESH FORMAT KIND
    repeat=$(repeats "$3")
    for round in $(seq "$rounds"); do
        [ $((round % 2)) -eq 1 ] && ours=$(rate_of "$planelet" "$work/this.plt" "$3")
        theirs=$(rate_of "$before" "$work/base.plt" "$3")
        [ $((round % 2)) -eq 0 ] && ours=$(rate_of "$planelet" "$work/this.plt" "$3")
        echo "$ours $theirs"
    done | awk '{ printf "%.4f %s %s\n", ($2 > 0) ? $1 / $2 : 0, $1, $2 }' >"$work/race"
    line="$1|$2|$3|$(median 1)|$(median 2)|$(median 3)"
    echo "$line" >>"$work/races"
    echo "     $line"
}

compare_mesh() { # MESH
    [ -r "$scenes/$1.ply" ] && "$peer" rays "$scenes/$1.ply" "$work/rays" >/dev/null || return 1
    for format in $formats; do
        images "$1" "$format" || return 1
        frames "$1" "$format"
        for kind in $kinds; do
            for order in $(orders_of "$format"); do
                hits "$1" "$format" "$kind" "$order"
            done
        done
        [ "$rounds" -gt 0 ] || continue
        for kind in $kinds; do
            race "$1" "$format" "$kind"
        done
    done
}

# The median ratios of all races: "MEAN LEAST COUNT", the mean a geometric one.
summary() {
    awk -F '|' '$4 > 0 { sum += log($4); if (!n++ || $4 < least) { least = $4 } }
        $4 <= 0 { least = 0; none = 1 }
        END { printf "%.4f %.4f %d\n", (n && !none) ? exp(sum / n) : 0, least, n }' "$work/races"
}

speeds() {
    [ -s "$work/races" ] || {
        verdict 1 "rays per second are measured"
        return
    }
    echo "rays per second, this build / BASE, medians of $rounds: mesh | format | rays |" \
        "ratio | Mray/s here | there"
    cat "$work/races"
    line=$(summary)
    mean=${line%% *} count=${line##* }
    least=${line#* } least=${least% *}
    awk "BEGIN { exit !($mean >= 1) }"
    verdict $? "rays per second: geometric mean $mean of BASE's over $count, at least 1.0"
    awk "BEGIN { exit !($least >= 0.97) }"
    verdict $? "rays per second: the least is $least of BASE's, none below 0.97"
}

# instructions CHECKOUT BUILD IMAGE: "PER-RAY HASH" of a run, which makes its own firmware.
instructions() {
    MAKEFLAGS='' MFLAGS='' "$make" -s -C "$1" BUILD="$2" BOARD="$board" run SCENE="$3" \
        SIZE=320x240 >"$work/said" 2>&1 || {
        tail -n 5 "$work/said" >&2
        return 1
    }
    awk '$1 == "instructions_per_ray" { n = $2 } /^frame_hash=/ { sub(/.*=/, ""); hash = $0 }
        END { if (n == "" || hash == "") { exit 1 } print n, hash }' "$work/said"
}

# The scene of `make demo`, which needs no download.
firmware() { # FORMAT
    pack "$planelet" "$work/marbles.ply" "$1" "$work/this.plt" &&
        pack "$before" "$work/marbles.ply" "$1" "$work/base.plt" || return 1
    ours=$(instructions . "$(cd "$build" && pwd)" "$work/this.plt") &&
        theirs=$(instructions "$base" "$work/base" "$work/base.plt") || return 1
    echo "$1|${ours% *}|${theirs% *}" >>"$work/instructions"
    [ "${ours#* }" = "${theirs#* }" ]
    verdict $? "marbles $1, $board: the same frame of 320x240, ${ours#* }"
    awk "BEGIN { exit !(${ours% *} <= ${theirs% *}) }"
    verdict $? "marbles $1, $board: ${ours% *} instructions per ray, ${theirs% *} before, not above"
}

for mesh in $meshes; do
    compare_mesh "$mesh" || verdict 1 "$mesh: packed and traced by both builds"
done
if [ -n "$board" ]; then
    "$planelet" make marbles -o "$work/marbles.ply" >/dev/null
    for format in $formats; do
        firmware "$format" || verdict 1 "marbles $format, $board: run by both builds"
    done
fi
echo
[ -z "$meshes" ] || [ "$rounds" -eq 0 ] || speeds
if [ -s "$work/instructions" ]; then
    echo "instructions per ray, $board, marbles 320x240: format | here | there"
    cat "$work/instructions"
fi
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]

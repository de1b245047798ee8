#!/bin/sh
# test_race.sh - a race is refused where the machine lacks the instruction set that it is for
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
top=$PWD
begin race
printf '#!/bin/sh\necho "$@" >>ran\nexit 1\n' >peer
chmod +x peer
mkdir -p scenes
echo 'flags : fpu sse2 ssse3 sse4_1 sse4_2 avx f16c bmi1 bmi2 avx2 fma avx512f avx512dq' >lesser
echo 'flags : sse2 sse4_2 avx f16c bmi1 bmi2 avx2 fma avx512f avx512dq avx512cd avx512bw avx512vl' \
    >greater
echo 'Features : fp asimd' >strange

# asked ISA CPUINFO: status and `said` of isa.sh.
asked() {
    said=$(CPUINFO=$2 sh "$top/tests/measure/isa.sh" "$1" 2>&1)
    status=$?
}
for isa in sse2 sse4.2 avx avx2; do
    asked $isa lesser
    verdict "a machine with $isa may race with it" "$([ "$status" -eq 0 ] && [ -z "$said" ] ||
        echo "$status: $said")"
done
asked avx512 greater
verdict "... and one with all five parts of avx512" "$([ "$status" -eq 0 ] || echo "$said")"
asked avx512 lesser
verdict "one without three of them may not, and hears which, and what to do" "$(
    [ "$status" -eq 2 ] || echo "status $status"
    echo "$said" | grep -q 'no avx512 (missing: avx512cd avx512bw avx512vl); choose ISA=avx2,' ||
        echo "$said")"
asked avx512 strange
verdict "where nothing is known nothing is refused" "$([ "$status" -eq 0 ] || echo "$said")"
asked avx1024 greater
verdict "a set that is none is told which there are" "$(
    [ "$status" -eq 2 ] && echo "$said" | grep -q "'avx1024'.*sse2 sse4.2 avx avx2 avx512" ||
        echo "$status: $said")"
here=$PWD
for script in race peers; do
    rm -f ran
    said=$(cd "$top" && CPUINFO=$here/lesser ISA=avx512 BUILD=$here MESHES=none \
        sh tests/measure/$script.sh "$here/scenes" "$here/peer" 2>&1)
    status=$?
    verdict "$script.sh looks first, and runs nothing" "$(
        [ "$status" -eq 2 ] || echo "status $status"
        echo "$said" | grep -q '^isa: this machine has no avx512' || echo "$said"
        cat ran 2>/dev/null)"
done
finish

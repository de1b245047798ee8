#!/bin/sh
# isa.sh ISA - whether this machine has an instruction set that a race asks for
#
# Says nothing and ends with 0, or says what is missing and what to ask for instead, and ends
# with 2: a tracer that lacks it may go on with another, and the figures would be of that one.
# Where the system does not list a processor's sets (CPUINFO, /proc/cpuinfo) nothing is known,
# and nothing refused. SPDX-License-Identifier: MIT
set -u
isa=${1:-} cpuinfo=${CPUINFO:-/proc/cpuinfo}
all='sse2 sse4.2 avx avx2 avx512'

# What the system calls them; all have to be there.
flags_of() { # ISA
    case $1 in
    sse2) echo sse2 ;;
    sse4.2) echo sse4_2 ;;
    avx) echo avx ;;
    avx2) echo avx2 fma bmi1 bmi2 f16c ;;
    avx512) echo avx512f avx512dq avx512cd avx512bw avx512vl ;;
    *) return 1 ;;
    esac
}

missing() { # ISA: its flags that the processor does not have
    for flag in $(flags_of "$1"); do
        case " $have " in
        *" $flag "*) ;;
        *) echo "$flag" ;;
        esac
    done
}

flags_of "$isa" >/dev/null || {
    echo "isa: there is no instruction set '$isa'; ISA= takes one of: $all" >&2
    exit 2
}
have=$(sed -n 's/^flags[[:blank:]]*: *//p' "$cpuinfo" 2>/dev/null | head -n 1)
[ -n "$have" ] || exit 0
lacks=$(missing "$isa" | tr '\n' ' ')
[ -n "$lacks" ] || exit 0
best=
for other in $all; do
    [ -n "$(missing "$other")" ] || best=$other
done
echo "isa: this machine has no $isa (missing: ${lacks% }); choose ISA=${best:-sse2}, or run on a" \
    "machine that has it" >&2
exit 2

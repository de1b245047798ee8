# profile - instructions by function, from `nm -n` and counts by address
#
#   nm -n firmware.elf | awk -f profile.awk - profile.txt
#
# Both are in the order of addresses, so one walk over both is enough.
# SPDX-License-Identifier: MIT
FNR == NR {
    if ($2 ~ /^[tT]$/ && $3 !~ /^\$/) {
        start[++functions] = $1
        name[functions] = $3
    }
    next
}
{
    while (at < functions && start[at + 1] <= $1) {
        at++
    }
    sum[at] += $2
    total += $2
}
END {
    for (i = 1; i <= functions; i++) {
        if (sum[i]) {
            printf "%12d %5.1f %% %s\n", sum[i], 100 * sum[i] / total, name[i]
        }
    }
}

# profile - instructions by function, from `nm -n` and counts by address
#
#   nm -n firmware.elf | awk -f profile.awk - profile.txt
#
# Both are in the order of addresses, so one pass over both is enough. Addresses
# are compared as strings of equal length: to awk 00005e84 as a number is 5 times
# 10^84. SPDX-License-Identifier: MIT
function address(hex) {
    hex = tolower(hex)
    sub(/^0x/, "", hex)
    while (length(hex) < 16) {
        hex = "0" hex
    }
    return "x" hex
}
FNR == NR {
    if ($2 ~ /^[tT]$/ && $3 !~ /^\$/) {
        start[++functions] = address($1)
        name[functions] = $3
    }
    next
}
{
    here = address($1)
    while (at < functions && start[at + 1] <= here) {
        at++
    }
    sum[at] += $2
    total += $2
}
END {
    if (total == 0) {
        print "profile.awk: no instruction was counted" >"/dev/stderr"
        exit 1
    }
    if (sum[0]) {
        printf "%12d %5.1f %% %s\n", sum[0], 100 * sum[0] / total, "(below every function)"
    }
    for (i = 1; i <= functions; i++) {
        if (sum[i]) {
            printf "%12d %5.1f %% %s\n", sum[i], 100 * sum[i] / total, name[i]
        }
    }
}

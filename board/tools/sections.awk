# sections - where each function lies and whose it is, from the linker's map
#
#   awk -f sections.awk firmware.map | sort | awk -f profile.awk - profile.txt
#
# Prints "ADDRESS t PART" as nm does, PART being engine, wire or rest: so profile.awk counts
# the instructions of each part, a line per function. SPDX-License-Identifier: MIT
/^ \.text/ {
    if (NF == 1) { # a long name stands alone
        getline
        $0 = "- " $0
    }
    if (NF == 4 && $2 !~ /^0x0*$/) {
        part = $4 ~ /\/engine\// ? "engine" : $4 ~ /\/platform\/wire\// ? "wire" : "rest"
        print substr($2, length($2) - 7) " t " part
    }
}

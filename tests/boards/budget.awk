# budget.awk BUDGET.csv NOW.csv - what boards or parts cost beside what they may cost
#
# Prints "row: column was, now" for each figure that differs, and lines that begin with "error: "
# for one above its budget by more than `slack` percent (1), or above the column NAME_most of
# BUDGET.csv, whatever it was; for a row that is not there, unless `new` names it; for data or bss;
# and for a frame's hash that is another. Rows of BUDGET.csv that NOW.csv lacks are left out.
# Columns of NOW.csv have the names of BUDGET.csv, in any order. SPDX-License-Identifier: MIT
BEGIN { FS = ","; slack = slack == "" ? 1 : slack }
FNR == 1 {
    for (i = 1; i <= NF; i++) {
        name[NR == 1, i] = $i
    }
    next
}
NR == FNR {
    known[$1]
    for (i = 2; i <= NF; i++) {
        may[$1, name[1, i]] = $i
    }
    next
}
!($1 in known) {
    if (index(" " new " ", " " $1 " ")) {
        print $1 " has no budget yet: when it stays, its line of " FILENAME " belongs there"
    } else {
        print "error: " $1 " has no row; add its line of " FILENAME
    }
    next
}
{
    for (i = 2; i <= NF; i++) {
        column = name[0, i]
        was = may[$1, column]
        most = may[$1, column "_most"]
        if (column ~ /^(engine_)?(data|bss)$/ && $i != 0) {
            print "error: " $1 ": the engine has " $i " bytes of " column
        }
        if (most != "" && $i + 0 > most + 0) {
            print "error: " $1 ": " column " is " $i ", and may be " most
        }
        if ($i == was) {
            continue
        }
        print $1 ": " column " " was ", now " $i
        if (column ~ /^(frame_hash|bunny|toasters)$/ || was == "" || $i == "") {
            print "error: " $1 ": " column " is not " was
        } else if (was ~ /^[0-9.]+$/ && $i > was * (1 + slack / 100)) {
            print "error: " $1 ": " column " is above its budget, " was
        }
    }
}

# library - the call graph of a library that comes without one, as stack.awk reads it
#
#   objdump -dtr LIBRARY.a | awk -f library.awk >LIBRARY.ci
#
# Every function of a member gets all that its functions push, together, and calls whatever
# any of them calls: the result is a bound. Calls by relocation lead to other
# members, other jumps stay in their own. Knows pushes of Thumb and RISC-V.
# SPDX-License-Identifier: MIT

function flush(    i, j) {
    for (i = 1; i <= functions; i++) {
        printf "node: { title: \"%s\" label: \"%s\\n%d bytes (static)\" }\n",
            name[i], name[i], bytes
        for (j = 1; j <= calls; j++) {
            if (!(target[j] in own)) {
                printf "edge: { sourcename: \"%s\" targetname: \"%s\" }\n", name[i], target[j]
            }
        }
    }
    functions = calls = bytes = 0
    delete own
    delete seen
}

function registers(list,    n, i, items, ends, sum) { # "{r4, r5-r7, lr}"
    gsub(/[{} ]/, "", list)
    n = split(list, items, ",")
    for (i = 1; i <= n; i++) {
        sum += split(items[i], ends, "-") == 2 ? substr(ends[2], 2) - substr(ends[1], 2) + 1 : 1
    }
    return sum
}

/file format/ { flush() }

# The symbol table has all names of a function, the code only one.
/^[0-9a-f]+ [glw! ]/ && / \.text[.a-z_0-9]*\t/ && !($NF ~ /^[.$]/) {
    if (!($NF in own)) {
        name[++functions] = $NF
        own[$NF] = 1
    }
}

# Thumb, and calls of either.
/^ *[0-9a-f]+:\t/ {
    split($0, part, "\t")
    rest = part[4]
    sub(/[ \t]*[@;#].*$/, "", rest)
    if (part[3] ~ /^v?push/ || (part[3] ~ /^v?stmdb/ && rest ~ /^sp!/)) {
        sub(/^sp!, */, "", rest)
        bytes += registers(rest) * (rest ~ /d[0-9]/ ? 8 : 4)
    } else if (part[4] ~ /^sp, .*#/ && part[3] ~ /^sub/) {
        rest = part[4]
        sub(/.*#/, "", rest)
        bytes += rest + 0
    } else if (part[3] ~ /^str/ && part[4] ~ /\[sp, #-[0-9]+\]!/) {
        rest = part[4]
        sub(/.*#-/, "", rest)
        bytes += rest + 0
    } else if (part[3] ~ /^addi/ && rest ~ /^sp,sp,-/) {
        sub(/.*,-/, "", rest)
        bytes += rest + 0
    }
}

/R_ARM_(THM_CALL|THM_JUMP|CALL|JUMP|PC24)|R_RISCV_(CALL|JAL|RVC_JUMP|BRANCH|RVC_BRANCH)/ {
    text = $NF
    sub(/[-+]0x.*$/, "", text)
    if (text !~ /^\./ && !(text in seen)) {
        seen[text] = 1
        target[++calls] = text
    }
}

END { flush() }

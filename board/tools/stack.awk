# stack - worst C stack from the call graphs that GCC writes
#
#   objdump -d FILE.o ... | awk -v root='NAME ...' [-v indirect='[CALLER>]NAME ...'] \
#       [-v interrupt='NAME ...' -v entry=BYTES] [-v limit=BYTES] [-v out=FOLDER/] \
#       -f stack.awk FILE.ci ... -
#
# Reads the output of -fcallgraph-info=su,da (of a library that has none
# library.awk's), and the disassembly of the same objects (below FOLDER), because
# GCC 12 leaves out what a function pushes for arguments that came in registers:
# a stack frame is the larger of GCC's value
# and the sum of all pushes and decrements of sp. Prints "worst BYTES ROOT" for
# the root with the deepest path, the path itself with the frame of every
# function on it, and a line for each other root. Every path is followed, so
# the result is a bound, not a sample. The deepest of the handlers of `interrupt`,
# which do not interrupt each other, is added to every root, and `entry`, what the
# CPU stacks before it. What would make the bound wrong is an error, printed, with
# exit status 1: recursion, a frame whose size is only
# known at run time, a function without a call graph, a call by pointer when
# `indirect` does not say where it may lead, a frame above `limit`. A call by pointer may lead to
# every NAME; but those of a CALLER that is named only to the names behind it.
# SPDX-License-Identifier: MIT

function field(name,    text) { # the quoted text behind NAME: "
    if (!match($0, name ": \"[^\"]*\"")) {
        return ""
    }
    text = substr($0, RSTART, RLENGTH)
    sub(/^[^"]*"/, "", text)
    sub(/"$/, "", text)
    return text
}

function bare(title) { # "engine/a/b.c:f" names a static function
    sub(/^.*:/, "", title)
    return title
}

function complain(sentence) {
    if (!(sentence in complaints)) {
        complaints[sentence] = 1
        print "error: " sentence
        errors++
    }
}

function resolve(title,    name) { # a name of the command line to a title
    if (title in frame) {
        return title
    }
    name = bare(title)
    return (name in by_name) ? by_name[name] : title
}

# Depth of the deepest path below and with `title`; next_on[] leads along it.
function depth(title,    i, n, called, best, below, targets) {
    if (title in done) {
        return done[title]
    }
    if (title in open) {
        complain("recursion through " bare(title))
        return 0
    }
    if (!(title in frame)) {
        complain("no call graph for " bare(title) ", called by " bare(caller))
        return 0
    }
    open[title] = 1
    best = 0
    n = split(calls[title], targets, SUBSEP)
    for (i = 1; i <= n; i++) {
        if (targets[i] == "") {
            continue
        }
        caller = title
        called = resolve(targets[i])
        below = depth(called)
        if (below > best) {
            best = below
            next_on[title] = called
        }
    }
    delete open[title]
    done[title] = frame[title] + best
    return done[title]
}

# By pointer: where it may lead from this function.
function add_indirect(title,    i, count, names, pair, own, any) {
    count = split(indirect, names, " ")
    for (i = 1; i <= count; i++) {
        if (split(names[i], pair, ">") < 2) {
            any = any SUBSEP names[i]
        } else if (pair[1] == bare(title)) {
            own = own SUBSEP pair[2]
        }
    }
    calls[title] = calls[title] (own == "" ? any : own)
    if (own any == "" && !outward) {
        complain(bare(title) " calls by a pointer; where to is not known")
    }
}

/^node:/ {
    title = field("title")
    label = field("label")
    if (match(label, /[0-9]+ bytes \([a-z,]+\)/)) {
        size = substr(label, RSTART, RLENGTH)
        if (size + 0 >= frame[title]) { # of two members of a library the larger
            frame[title] = size + 0
        }
        by_name[bare(title)] = title
        if (size ~ /dynamic/ && size !~ /bounded/) {
            complain("the frame of " bare(title) " has no fixed size")
        }
    }
}

/^edge:/ {
    source = field("sourcename")
    target = field("targetname")
    if (target != "__indirect_call") {
        calls[source] = calls[source] SUBSEP target
    } else {
        add_indirect(source)
    }
}

# ---- disassembly of Thumb and RISC-V ----
# Vectors of MVE are stored as floats are, or as objdump calls them, by STC.

/file format/ {
    file = $1
    sub(/:$/, "", file)
    if (index(file, out) == 1) {
        file = substr(file, length(out) + 1)
    }
    sub(/\.o$/, ".c", file)
}

/^[0-9a-f]+ <[^>]*>:$/ {
    name = $2
    gsub(/[<>:]/, "", name)
    in_code = ((file ":" name) in frame) ? file ":" name : (name in by_name) ? by_name[name] : name
}

function registers(list,    n, i, items, ends, bytes) { # "{r4, lr}", "{d8-d11}"
    gsub(/[{} ]/, "", list)
    n = split(list, items, ",")
    bytes = 0
    for (i = 1; i <= n; i++) {
        if (split(items[i], ends, "-") == 2) {
            bytes += (substr(ends[2], 2) - substr(ends[1], 2)) * (items[i] ~ /^d/ ? 8 : 4)
        }
        bytes += items[i] ~ /^d/ ? 8 : 4
    }
    return bytes
}

function constant(text) { # the number behind the last '#'
    sub(/[ \t]*[@;].*/, "", text)
    sub(/.*#-?/, "", text)
    return text + 0
}

/^ *[0-9a-f]+:\t/ {
    split($0, part, "\t")
    op = part[3]
    rest = part[4]
    if (op ~ /^v?push/ || (op ~ /^v?stmdb/ && rest ~ /^sp!/)) {
        sub(/^sp!, */, "", rest)
        pushed[in_code] += registers(rest)
    } else if (op ~ /^sub/ && rest ~ /^sp, .*#/) {
        pushed[in_code] += constant(rest)
    } else if (op ~ /^sub/ && rest ~ /^sp,/) {
        complain("the frame of " bare(in_code) " has no fixed size")
    } else if (op ~ /^addi/ && rest ~ /^sp,sp,-/) {
        sub(/^sp,sp,-/, "", rest)
        pushed[in_code] += rest + 0
    } else if (op ~ /^(v?str|stc)/ && rest ~ /\[sp, #-[0-9]+\]!/) {
        sub(/\]!.*/, "", rest)
        pushed[in_code] += constant(rest)
    }
}

END {
    for (title in pushed) {
        if ((title in frame) && pushed[title] > frame[title]) {
            frame[title] = pushed[title]
        }
    }
    worst = -1
    on_top = 0
    count = split(interrupt, names, " ")
    for (k = 1; k <= count; k++) {
        below = entry + depth(resolve(names[k]))
        if (below > on_top) {
            on_top = below
            handler = names[k]
        }
    }
    count = split(root, names, " ")
    for (k = 1; k <= count; k++) {
        total[k] = depth(resolve(names[k])) + on_top
        if (total[k] > worst) {
            worst = total[k]
            deepest = names[k]
        }
    }
    for (title in frame) {
        if (limit && frame[title] > limit) {
            complain("the frame of " bare(title) " is " frame[title] " bytes, more than " limit)
        }
    }
    if (errors) {
        exit 1
    }
    print "worst " worst " " deepest
    for (title = resolve(deepest); title != ""; title = next_on[title]) {
        printf "%8d %s\n", frame[title], bare(title)
    }
    for (title = handler == "" ? "" : resolve(handler); title != ""; title = next_on[title]) {
        if (bare(title) == handler) {
            printf "%8d an interrupt\n", entry
        }
        printf "%8d %s\n", frame[title], bare(title)
    }
    for (k = 1; k <= count; k++) {
        if (names[k] != deepest) {
            print "root " total[k] " " names[k]
        }
    }
}

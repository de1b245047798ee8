# circles - the circles of a graph, each node's shortest one
#
# Reads "FROM TO [WHY]" lines, an edge each, and prints "A -> B (WHY) -> A (WHY)". Every
# node that is on a circle is on one that is printed. Nodes without an edge in or out
# are removed until none is left; from each of the others, by name, a breadth-first
# search leads back to it. SPDX-License-Identifier: MIT
$1 != $2 && !(($1, $2) in why) {
    why[$1, $2] = $3
    to[$1] = to[$1] " " $2
    if (!($1 in node)) { node[$1] = 1; name[++nodes] = $1 }
    if (!($2 in node)) { node[$2] = 1; name[++nodes] = $2 }
}

# Nodes that lead nowhere and nodes that nothing leads to are on no circle.
function trim(    i, k, n, next_to, changed, out, reached) {
    do {
        changed = 0
        split("", reached)
        for (i = 1; i <= nodes; i++) {
            if (!node[name[i]]) { continue }
            n = split(to[name[i]], next_to, " ")
            for (k = 1; k <= n; k++) { reached[next_to[k]] = 1 }
        }
        for (i = 1; i <= nodes; i++) {
            if (!node[name[i]]) { continue }
            n = split(to[name[i]], next_to, " ")
            out = 0
            for (k = 1; k <= n; k++) { out += node[next_to[k]] }
            if (!out || !(name[i] in reached)) { node[name[i]] = 0; changed = 1 }
        }
    } while (changed)
}

# Prints the shortest circle through `start`, if there is one.
function circle(start,    queue, head, tail, from, at, n, k, next_to, text, step) {
    queue[tail = 1] = start
    for (head = 1; head <= tail; head++) {
        at = queue[head]
        n = split(to[at], next_to, " ")
        for (k = 1; k <= n; k++) {
            if (!node[next_to[k]] || (next_to[k] in from)) { continue }
            from[next_to[k]] = at
            if (next_to[k] == start) { head = tail; break }
            queue[++tail] = next_to[k]
        }
    }
    if (!(start in from)) { return }
    at = start
    do {
        step = from[at]
        text = " -> " at (why[step, at] == "" ? "" : " (" why[step, at] ")") text
        shown[at] = 1
        at = step
    } while (at != start)
    print start text
}

function sort_names(    i, k, text) {
    for (i = 2; i <= nodes; i++) {
        text = name[i]
        for (k = i; k > 1 && name[k - 1] > text; k--) { name[k] = name[k - 1] }
        name[k] = text
    }
}

END {
    trim()
    sort_names()
    for (i = 1; i <= nodes; i++) {
        if (node[name[i]] && !(name[i] in shown)) { circle(name[i]) }
    }
}

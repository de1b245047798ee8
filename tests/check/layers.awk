# layers - who refers up, by the table of check_layers.sh
#
# Reads "FROM TO WHAT WHERE" lines: a file or object, what it refers to, its name for
# that, and where. `table` has a level a line, from the ground up, with its folders; a
# "*" stands for one part of a path (of a board: the same one on both sides), and
# "engine/planelet*.h" for the public headers. Prints "WHERE: WHAT: why not" for
# each reference to a folder above or beside its own. With folders=1 the input is a
# folder a line, and those are printed that no level has. SPDX-License-Identifier: MIT
BEGIN {
    levels = split(table, line, "\n")
    for (i = 1; i <= levels; i++) {
        n = split(line[i], part, " ")
        for (k = 1; k <= n; k++) {
            if (part[k] ~ /\*$|\*\//) {
                pattern[++patterns] = part[k]
                gsub(/\*/, "[^/]+", pattern[patterns])
                pattern_level[patterns] = i
            } else {
                level[part[k]] = i
            }
        }
    }
}

function folder_of(path) {
    if (path ~ /^engine\/planelet[a-z0-9_]*\.h$/) { return "engine/planelet*.h" }
    if (path ~ /^tests\//) { return "tests" }
    sub(/\/[^\/]*$/, "", path)
    return path
}

# The level of a folder, 0 when the table has none; `kind` of a board: its name.
function level_of(folder,    i, parts) {
    kind = ""
    if (folder in level) { return level[folder] }
    for (i = 1; i <= patterns; i++) {
        if (folder ~ "^" pattern[i] "$") {
            split(folder, parts, "/")
            kind = parts[2]
            return pattern_level[i]
        }
    }
    return 0
}

folders {
    if (!level_of(folder_of($1 "/."))) { print $1 ": no level of the table has this folder" }
    next
}

{
    from = folder_of($1)
    to = folder_of($2)
    if (from == to) { next }
    mine = level_of(from)
    mine_kind = kind
    other = level_of(to)
    if (!other) {
        print $4 ": " $3 ": no level of the table has " to
    } else if (other > mine) {
        print $4 ": " $3 ": " to " is above " from
    } else if (other == mine) {
        print $4 ": " $3 ": " from " and " to " are beside each other"
    } else if (kind != "" && mine_kind != "" && kind != mine_kind) {
        print $4 ": " $3 ": " from " and " to " are of two boards"
    }
}

# messages - the string literals of C files that tell a user what to do
#
# Prints "FILE:LINE<tab>LITERAL" for every literal, adjacent ones joined, that
#   - holds "; ", after which a message names its remedy,
#   - asks whether something is so ("is the disk full?"),
#   - is one of args_complain, whose texts all say what is taken,
#   - begins with "next: ",
#   - is all that a failure says (fail_set(f or fail_set(&f), not a report's line), if it does not
#     leave the end to others: no failure goes without a remedy unseen, or
#   - is a remedy on its own: of a function or a variable called `remedy`, the text of a
#     call that has a remedy as its last argument (fail_with), or one that stands
#     for the last %s of a text that ends in "; %s".
# A macro of literals with one parameter is put in. Tables of flags and commands (--help), texts
# of a terminal, and what output_print writes into a file are not messages.
# SPDX-License-Identifier: MIT

# Has several words of its own, and is no code of a terminal; "; %s" leaves the remedy to others.
function is_message(text) {
    gsub(/%[-+ 0-9.*]*(ll|l|z|h)*[a-z]/, "%", text)
    return text ~ /[a-z][a-z]/ && text ~ / / && text !~ /\\x1b|; %(\\n)?$/
}

# A statement is over: its literals are known, and what stood between them.
function end_statement(    i, all, bare, open, whole) {
    whole = code
    open = 0
    bare = whole ~ /fail_set *\( *&?f *,/
    for (i = 1; i <= literals; i++) {
        open += literal[i] ~ /; %s(\\n)?$/
        if (literal[i] ~ /; |[?](\\n)?$|%s$/) { bare = 0 }
    }
    for (i = 1; i <= literals; i++) {
        all = open > 0 || bare || whole ~ /args_complain|remedy *=/ || header ~ /remedy/
        if (whole ~ /fail_with *\(/) { all = i == literals }
        if (is_message(literal[i]) && whole !~ /arg_flag|arg_command|output_print/ &&
            (all || literal[i] ~ /; [-a-z]/ || literal[i] ~ /[?](\\n)?$/ ||
             literal[i] ~ /^next: /)) {
            sub(/\\n$/, "", literal[i])
            print FILENAME ":" line_of[i] "\t" literal[i]
        }
    }
    literals = 0
    code = ""
    joined = 0
}

function add_code(c) {
    code = code c
    if (c !~ /[ \t]/) { joined = 0 }
}

# The line with macros put in: "is OFF; " BY_ASSIMP("in.off").
function expand(line,    name, head, tail) {
    for (name in macro) {
        while ((at = index(line, name "(\"")) > 0) {
            head = substr(line, 1, at - 1)
            tail = substr(line, at + length(name) + 1)
            match(tail, /^"[^"]*"/)
            text = macro[name]
            sub(/PARAMETER/, substr(tail, 1, RLENGTH), text)
            line = head text substr(tail, RLENGTH + 2)
        }
    }
    return line
}

FNR == 1 {
    depth = literals = in_comment = joined = 0
    code = header = ""
    split("", macro)
}

/^#define [A-Z_]+[(][a-z]+[)] "/ {
    match($0, /[(][a-z]+[)]/)
    parameter = substr($0, RSTART + 1, RLENGTH - 2)
    text = substr($0, RSTART + RLENGTH)
    sub("\" " parameter " \"", "\" PARAMETER \"", text)
    macro[substr($2, 1, index($2, "(") - 1)] = text
}

/^#/ { next }

{
    rest = expand($0)
    while (rest != "") {
        if (in_comment) {
            at = index(rest, "*/")
            if (at == 0) { break }
            rest = substr(rest, at + 2)
            in_comment = 0
            continue
        }
        c = substr(rest, 1, 1)
        if (substr(rest, 1, 2) == "/*") {
            in_comment = 1
            rest = substr(rest, 3)
        } else if (substr(rest, 1, 2) == "//") {
            break
        } else if (c == "'") {
            match(rest, /^'(\\.[0-9a-fA-F]*|[^'\\])'/)
            rest = substr(rest, RLENGTH > 0 ? RLENGTH + 1 : 2)
            add_code("0")
        } else if (c == "\"") {
            match(rest, /^"([^"\\]|\\.)*"/)
            text = substr(rest, 2, RLENGTH - 2)
            rest = substr(rest, RLENGTH + 1)
            if (joined) {
                literal[literals] = literal[literals] text
            } else {
                literal[++literals] = text
                line_of[literals] = FNR
            }
            joined = 1
        } else if (match(rest, /^PRI[ux](64|32)/) && joined) {
            literal[literals] = literal[literals] (substr(rest, 5, 2) == "64" ? "llu" : "u")
            rest = substr(rest, RLENGTH + 1)
        } else if (c == ";" || c == "{" || c == "}") {
            if (c == "{" && depth == 0) { header = code }
            table = depth > 0 && header ~ /=/ # an initialiser is one statement
            if (!table || (c == "}" && depth == 1)) {
                if (table || header ~ /=/) { code = header " " code }
                end_statement()
            }
            depth += (c == "{") - (c == "}")
            if (depth == 0 && c == "}") { header = "" }
            rest = substr(rest, 2)
        } else {
            add_code(c)
            rest = substr(rest, 2)
        }
    }
    add_code(" ")
}

# json - the values of a JSON text as lines "PATH<tab>VALUE", or what is wrong with it
#
# A path is ".files[0].open_edges"; strings keep their quotes and escapes. Run it with
# LC_ALL=C: characters are bytes, and those of a string have to be UTF-8. Source: RFC 8259,
# 2017. SPDX-License-Identifier: MIT

function wrong(what) {
    print "wrong at byte " at - 1 ": " what
    exit 1
}

# The text at `at` that matches `pattern`, which begins with ^; moves over it.
function take(pattern,    rest) {
    rest = substr(text, at)
    if (!match(rest, pattern)) { return "" }
    at += RLENGTH
    return substr(rest, 1, RLENGTH)
}

function blanks() { take("^[ \t\r\n]+") }

function string(    got) {
    got = take(STRING)
    if (got == "") { wrong("no string") }
    return got
}

# The members of an object, or the elements of a list, up to `last`.
function parts(path, last,    i, name) {
    at++
    blanks()
    for (i = 0; substr(text, at, 1) != last; i++) {
        if (i > 0 && take("^,") == "") { wrong("no comma") }
        blanks()
        if (last == "]") {
            value(path "[" i "]")
        } else {
            name = string()
            blanks()
            if (take("^:") == "") { wrong("no colon") }
            name = path "." substr(name, 2, length(name) - 2)
            if (seen[name]++) { wrong("twice: " name) }
            value(name)
        }
        blanks()
        if (at > length(text)) { wrong("ends too early") }
    }
    at++
}

function value(path,    c, got) {
    blanks()
    c = substr(text, at, 1)
    if (c == "{") {
        parts(path, "}")
    } else if (c == "[") {
        parts(path, "]")
    } else {
        got = c == "\"" ? string() : take(NUMBER "|^(true|false|null)")
        if (got == "") { wrong("no value") }
        print path "\t" got
    }
}

BEGIN {
    NUMBER = "^-?(0|[1-9][0-9]*)([.][0-9]+)?([eE][-+]?[0-9]+)?"
    STRING = "^\"([^\"\\\\\001-\037\177-\377]" \
        "|\\\\([\"\\\\/bfnrt]|u[0-9a-f][0-9a-f][0-9a-f][0-9a-f])" \
        "|[\302-\337][\200-\277]|\340[\240-\277][\200-\277]" \
        "|[\341-\354\356\357][\200-\277][\200-\277]" \
        "|\355[\200-\237][\200-\277]|\360[\220-\277][\200-\277][\200-\277]" \
        "|[\361-\363][\200-\277][\200-\277][\200-\277]|\364[\200-\217][\200-\277][\200-\277])*\""
}

{ text = text $0 "\n" }

END {
    at = 1
    value("")
    blanks()
    if (at <= length(text)) { wrong("goes on after its end") }
}

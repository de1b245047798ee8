# cli - what the tests of the command line share
#
# Sourced from the top of the repository, after report.sh. `begin NAME` makes an
# empty folder and goes there. `run ARGUMENT...` runs planelet: files `out` and
# `err`, variable `status`. The others are verdicts on one run:
#   works SENTENCE ARGUMENT...                status 0, nothing on standard error but how
#                                             many open edges a mesh has
#   misused SENTENCE WORD ARGUMENT...         status 2, one line there, names WORD
#   refused SENTENCE NAME WHERE ARGUMENT...   status 1, one line "NAME: ...; REMEDY"
#                                             in which the pattern WHERE occurs
# SPDX-License-Identifier: MIT
LC_ALL=C
export LC_ALL
unset NO_COLOR COLORTERM COLUMNS LINES

absolute() {
    case $1 in
    /*) echo "$1" ;;
    *) echo "$PWD/$1" ;;
    esac
}
PLANELET=$(absolute "${PLANELET:-${OUT:-$BUILD/host}/planelet}")
CLI_TESTS=$(absolute tests/cli)

begin() {
    if ! [ -x "$PLANELET" ]; then
        verdict "there is a planelet to test" "$PLANELET cannot be run; run: make"
        finish
        exit 1
    fi
    work=$(absolute "$BUILD/test-tmp/cli/$1")
    rm -rf "$work"
    mkdir -p "$work"
    cd "$work" || exit 1
}

run() {
    "$PLANELET" "$@" >out 2>err </dev/null
    status=$?
}

# trouble: what the last run has said beyond the open edges of meshes with a border, which knots
# and marbles have not.
trouble() {
    awk '/^[^:]*: [1-9][0-9]* open edges?: / && !/^(knot|marbles)/ { next } { print }' err
}

works() {
    sentence=$1
    shift
    run "$@"
    verdict "$sentence" "$(
        [ "$status" -eq 0 ] || echo "status $status"
        trouble)"
}

# one_line [FILE]: trouble, unless `err` holds exactly one line without control characters.
one_line() {
    [ "$(wc -l <"${1:-err}")" -eq 1 ] || echo "$(wc -l <"${1:-err}") lines on standard error"
    tr -d '\n' <"${1:-err}" | grep '[[:cntrl:]]' | cat -v
}

# misuse WORD: trouble, unless the last run was ended as wrong usage.
misuse() {
    [ "$status" -eq 2 ] || echo "status $status"
    one_line
    grep -q '^planelet' err || echo "the line does not begin with planelet"
    grep -qF -- "$1" err || echo "not a word about $1"
    [ ! -s out ] || echo "something on standard output"
}

misused() {
    sentence=$1 word=$2
    shift 2
    run "$@"
    trouble=$(misuse "$word")
    verdict "$sentence" "${trouble:+$trouble
$(cat err)}"
}

# refusal NAME WHERE: trouble, unless the last run was refused so.
refusal() {
    [ "$status" -eq 1 ] || echo "status $status"
    one_line
    [ "$(cut -c "1-$((${#1} + 2))" err)" = "$1: " ] || echo "the line does not begin with '$1: '"
    grep -q -- "$2" err || echo "not there: '$2'"
    grep -q '; ..*\|? *$' err || echo "no remedy"
}

refused() {
    sentence=$1 name=$2 where=$3
    shift 3
    run "$@"
    trouble=$(
        refusal "$name" "$where"
        [ ! -s out ] || echo "something on standard output")
    verdict "$sentence" "${trouble:+$trouble
$(cat err)}"
}

# number NAME: the number of that name in the JSON on standard input.
number() {
    sed -n "s/^  \"$1\": \(-*[0-9][-+.e0-9]*\),*\$/\1/p"
}

# flat_json FILE NAME...: trouble, unless FILE is one flat JSON object, a member
# per line, no name twice, and each NAME is there with a number. A member may also be a
# list of flat objects, one per line, or of numbers or texts on its own.
flat_json() {
    file=$1
    shift
    awk -v pair='"[a-z_]+": (-?[0-9]+|"[^"]*")' '
        BEGIN {
            text = "\"[^\"\\\\]*\""
            value = "(-?[0-9]+([.][0-9]+)?(e[-+][0-9]+)?|" text "|null|\\[[-+.e0-9, ]+\\]|"
            value = value "\\[" text "(, " text ")*\\])"
        }
        NR == 1 { if ($0 != "{") print "begins with " $0; next }
        ended { print "goes on after the end: " $0 }
        list && /^  \],?$/ {
            if (comma && NR > list + 1) print "a comma before the end of a list"
            list = 0
            comma = /,$/
            next
        }
        list {
            if (!comma) print "no comma before line " NR
            if ($0 !~ "^    \\{" pair "(, " pair ")*\\},?$") print "no flat object: " $0
            comma = /,$/
            next
        }
        $0 == "}" { ended = 1; if (comma) print "a comma before the end"; next }
        NR > 2 && !comma { print "no comma before line " NR }
        /^  "[a-z_]+": \[\],?$/ { comma = /,$/; if (seen[$1]++) print "twice: " $1; next }
        /^  "[a-z_]+": \[$/ { list = NR; comma = 1; if (seen[$1]++) print "twice: " $1; next }
        $0 !~ "^  \"[a-z_]+\": " value ",?$" {
            print "no member: " $0
        }
        { comma = /,$/; name = $1; if (seen[name]++) print "twice: " name }
        END { if (!ended) print "has no end" }' "$file"
    for name in "$@"; do
        [ -n "$(number "$name" <"$file")" ] || echo "no number '$name'"
    done
}

# touched_bytes: what counting touched treelets of thesis nodes adds to an arena: a bit for
# each, in whole words and 16 bytes. The JSON of info is on standard input.
touched_bytes() {
    cat >touched.json
    words=$(($(number node_slots <touched.json) / $(number treelet_nodes <touched.json) / 32 + 1))
    echo $(((4 * words + 15) / 16 * 16))
}

# same FILE FILE SENTENCE
same() {
    verdict "$3" "$(cmp "$1" "$2" 2>&1)"
}

# differ FILE FILE: trouble, unless both are there and are not the same.
differ() {
    cmp -s "$1" "$2"
    [ $? -eq 1 ] || echo "$1 and $2: equal, or not there"
}

# equal: trouble, unless the numbers in all lines "WHAT|NUMBER|NUMBER" on
# standard input are equal to 6 digits.
equal() {
    awk -F '|' '
        { difference = $2 - $3; if (difference < 0) difference = -difference }
        $2 !~ /[0-9]/ || $3 !~ /[0-9]/ || difference > 1e-6 * ($2 < 0 ? -$2 : $2) + 1e-9 {
            print $1 ": " $2 " is not " $3
        }'
}

# bytes FILE: octal escapes, or whatever printf accepts, into FILE.
bytes() {
    # shellcheck disable=SC2059
    printf "$2" >"$1"
}

# rays FILE: lines of 8 numbers on standard input as little-endian float32.
rays() {
    bytes "$1" "$(awk -f "$CLI_TESTS/float32.awk")"
}

# hits FILE: a line "t u v number" each.
hits() {
    od -An -v -t f4 "$1" >hits.floats
    od -An -v -t u4 "$1" >hits.numbers
    paste hits.floats hits.numbers | awk '{ print $1, $2, $3, $8 }'
}

# seams FILE: an ASCII STL of a tetrahedron, three sides with 17 digits and its base with 6.
seams() {
    {
        echo 'solid a'
        for side in "0.33333334326744079 0 0|0 0.66666668653488159 0|0 0 1" \
            "0 0.66666668653488159 0|0 0 0|0 0 1" "0 0 0|0.33333334326744079 0 0|0 0 1" \
            "0 0 0|0 0.666667 0|0.333333 0 0"; do
            echo 'facet normal 0 0 0 outer loop'
            echo "$side" | tr '|' '\n' | sed 's/^/vertex /'
            echo 'endloop endfacet'
        done
        echo 'endsolid a'
    } >"$1"
}

# all_kinds FILE: an OBJ of a square and whatever else one can hold.
all_kinds() {
    cat >"$1" <<'END'
mtllib x.mtl
v 0 0 0 1 0 0
v 1 0 0 0 1 0
v 1 1 0 0 0 1
v 0 1 0
vn 0 0 1
vt 0 0
vt 1 0
usemtl red
f 1 2 3
f 1 3 4
f 1 2
p 1
l 1 2
l 2 3
curv 0 1 1 2
END
}

# quad FILE: two triangles that are the unit square of z = 0, number 0 below
# the diagonal and number 1 above it.
quad() {
    cat >"$1" <<'END'
ply
format ascii 1.0
element vertex 4
property float x
property float y
property float z
element face 2
property list uchar int vertex_indices
end_header
0 0 0
1 0 0
1 1 0
0 1 0
3 0 1 2
3 0 2 3
END
}

# left_behind: names of temporary files in this folder.
left_behind() {
    ls -a | grep '^\.planelet-'
}

# remedies - provokes a message, does what it says, and looks whether that helps
#
# Sourced after cli.sh. Messages are given as they stand in the C source, conversions and
# all; tests/check/check_remedies.sh looks for them here.
#   says MESSAGE ARGUMENT...       the program (planelet, or $PROGRAM) fails with that message
#   says_by MESSAGE COMMAND...     the same of any command, whose errors are in `err`
#   cured ARGUMENT...              with the remedy the program succeeds; one verdict for both
#   cured_by COMMAND...            the same of any command
#   packs TRIANGLES ARGUMENT...    cured: pack ARGUMENT... -o cured.plt, which holds so many
# Several remedies of one message are several calls of cured.
# SPDX-License-Identifier: MIT

# pattern MESSAGE: for grep; what a conversion stands for may be anything.
pattern() {
    printf '%s\n' "$1" | sed 's/%[-+ 0-9.*]*[lzh]*[a-z]/\n/g
        s/[][\\.*^$]/\\&/g
        s/\n/.*/g
        s/%%/%/g'
}

# unlike MESSAGE: trouble, unless the last command failed with it.
unlike() {
    [ "$status" -eq 1 ] || [ "$status" -eq 2 ] || echo "status $status, and not this message"
    grep -q -- "$(pattern "$1")" err || { echo "another message:"; cat err; }
    [ "$(grep -vc '^serve: waiting' err)" -le 1 ] || echo "more than one line"
}

says_by() {
    message=$1
    shift
    "$@" >out 2>err </dev/null
    status=$?
    said=$(unlike "$message")
}

says() {
    message=$1
    shift
    says_by "$message" "${PROGRAM:-$PLANELET}" "$@"
}

# helped [TROUBLE]: the verdict on the last command, after the remedy.
helped() {
    verdict "helps: $message" "$(
        [ -z "$said" ] || echo "$said"
        [ "$status" -eq 0 ] || { echo "with the remedy: status $status"; cat err; }
        [ -z "$1" ] || echo "$1")"
}

cured_by() {
    "$@" >out 2>err </dev/null
    status=$?
    helped
}

cured() {
    cured_by "${PROGRAM:-$PLANELET}" "$@"
}

packs() {
    triangles=$1
    shift
    rm -f cured.plt
    "$PLANELET" pack "$@" -o cured.plt >out 2>err </dev/null
    status=$?
    helped "$(
        "$PLANELET" info cured.plt --json 2>&1 | number source_triangles | grep -qx "$triangles" ||
            { echo "not $triangles triangles:"; "$PLANELET" info cured.plt; })"
}

# limited WHAT NUMBER COMMAND...: under `ulimit -WHAT NUMBER`.
limited() (
    ulimit -S "-$1" "$2" || exit 99
    shift 2
    "$@"
)

# least LOW HIGH COMMAND...: the least MiB of address space with which it works, to 1.
least() {
    low=$1 high=$2
    shift 2
    while [ $((high - low)) -gt 1 ]; do
        middle=$(((low + high) / 2))
        if limited v $((1024 * middle)) "$@" >/dev/null 2>&1 </dev/null; then
            high=$middle
        else
            low=$middle
        fi
    done
    echo "$high"
}

# grown PROGRAM ARGUMENT...: it in as few MiB as it starts with, and in one more until it
# works, at most 100. `all.err` gets the limits and what was said, which may only be about
# memory.
grown() {
    grower=$1
    start=$(least 8 8192 "$1" --version)
    limit=$start
    status=1
    : >all.err
    while [ "$status" -ne 0 ] && [ "$limit" -lt $((start + 100)) ]; do
        limited v $((1024 * limit)) "$@" >out 2>err </dev/null
        status=$?
        [ "$status" -eq 0 ] || sed "s/^/$limit /" err >>all.err
        limit=$((limit + 1))
    done
}

# larger MESSAGE: is among them, and a larger machine was the remedy.
larger() {
    message=$1
    said=$(grep -q -- "$(pattern "$1")" all.err || { echo "not said:"; sort -u all.err; })
    helped "$(grep -v 'memory' all.err)"
}

# smaller MESSAGE ARGUMENT...: is among them, and where it was said these arguments work.
smaller() {
    message=$1
    shift
    said=$(grep -q -- "$(pattern "$message")" all.err || { echo "not said:"; cat all.err; })
    at=$(grep -- "$(pattern "$message")" all.err | tail -n 1 | cut -d ' ' -f 1)
    cured_by limited v $((1024 * ${at:-1})) "$grower" "$@"
}

# common COMMAND...: as a user that permissions apply to. `has_common` is empty when there is
# none who may use these programs.
if [ "$(id -u)" -ne 0 ]; then
    common() { "$@"; }
    has_common=1
else
    common() { setpriv --reuid=65534 --regid=65534 --clear-groups "$@"; }
    has_common=$(common "$PLANELET" --version 2>/dev/null)
fi

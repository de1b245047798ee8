#!/bin/sh
# test_remedies_view.sh - what planelet view says in a terminal, and whether it helps
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/remedies.sh
begin remedies_view
TERM=xterm-256color LC_ALL=C.UTF-8
export TERM LC_ALL

$CC -std=c11 -Wall -Wextra "$CLI_TESTS/pty_view.c" -o pty_view 2>trouble || {
    verdict "the terminal of the tests builds" "$(cat trouble)"
    finish
    exit 1
}
quad quad.ply
run pack quad.ply -o quad.plt

# in_terminal KEYS ARGUMENT...: planelet view there; what is left on the screen is in `err`.
in_terminal() {
    keys=$1
    shift
    ./pty_view settle "send=$keys" settle send=q -- "$PLANELET" view "$@" >said
    sed 's/.*1049l//' screen | grep '; ' | tail -n 1 >&2 # keys may be echoed behind it
    return "$(sed -n 's/^status //p' said)"
}

says "standard input and output are none; use planelet render" view quad.plt
cured render quad.plt -o x.png
run pack --nodes compact --build device quad.ply -o compact.plt
says_by "%s; leave out --shader smooth" in_terminal + compact.plt --shader smooth
cured_by in_terminal + compact.plt
cured_by in_terminal + quad.plt --shader smooth
says_by "it is for keys; name a file" in_terminal + -
cured_by in_terminal + quad.plt
away=--------------------------
far='--eye 5e11,0,5e11'
for remedy in '--eye 1e9,0,1e9' '--eye 5e11,0,5e11 --look 4.99e11,0,4.99e11'; do
    # shellcheck disable=SC2086
    says_by "it leaves the range of 2^40; change --eye or --look" in_terminal $away quad.plt $far
    # shellcheck disable=SC2086
    cured_by in_terminal $away quad.plt $remedy
done
finish

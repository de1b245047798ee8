#!/bin/sh
# check_format.sh - the layout of every source file
# Beside builders: it builds nothing.
# SPDX-License-Identifier: MIT
. tests/check/report.sh

folders='engine platform board host_tools tests'
format=clang-format
command -v clang-format-14 >/dev/null 2>&1 && format=clang-format-14
if needs "$format"; then
    # shellcheck disable=SC2086
    verdict "clang-format has nothing to change" "$(
        find $folders -name '*.[ch]' | sort | xargs "$format" --dry-run -Werror 2>&1 |
            awk -F: -v format="$format" '/: error: / { if (!seen[$1]++) {
                print $1 ": run " format " -i on it" } next }
                /^error|^fatal|No such/ { print }')"
fi
# shellcheck disable=SC2086
files=$(find $folders Makefile .ci/run -type f \( -name '*.[chS]' -o -name '*.sh' -o -name '*.awk' \
    -o -name '*.ld' -o -name '*.mk' -o -name Makefile -o -path .ci/run \))
# shellcheck disable=SC2086
verdict "every source file has its licence line" "$(grep -L 'SPDX-License-Identifier: MIT' $files)"
# shellcheck disable=SC2086
verdict "no line is longer than 100 columns" "$(
    awk 'length > 100 && !/[^ -~]/ { print FILENAME ":" FNR ": " length " columns" }' $files)"
# shellcheck disable=SC2086
verdict "every target with a sentence is in a group that make help prints" "$(
    grep -nE '^##' Makefile $(find $folders -name '*.mk') |
        grep -vE ':##(build|try|test|measure|keep) [^ ].*: .')"
# shellcheck disable=SC2086
verdict "no line ends in a blank" "$(grep -nE '[[:blank:]]$' $files)"
verdict "nothing is left to do in engine, platform and board" \
    "$(grep -rnE 'TODO|FIXME|XXX|HACK' engine platform board)"
finish

#!/bin/sh
# check_headers.sh - every header of engine and board compiles alone
# Beside builders: it builds nothing.
# SPDX-License-Identifier: MIT
. tests/check/report.sh
CXX=${CXX:-g++}

# alone LANGUAGE STANDARD COMPILER DEFINE FILE...: the headers that do not.
alone() {
    language=$1 standard=$2 compiler=$3 define=$4
    shift 4
    for header in "$@"; do
        # An order is written against a format (trace/format.h), which comes first.
        case $header in
        engine/trace/order_* | engine/trace/collapse.h) first=engine/trace/format_thesis.h ;;
        # And compact blocks are reached in one way or the other.
        engine/trace/format_compact.h) first=engine/trace/blocks_streamed.h ;;
        *) first=$header ;;
        esac
        printf '#include "%s"\n' "$first" "$header" |
            "$compiler" -x "$language" -std="$standard" -Wall -Wextra -Werror -fsyntax-only -I. \
                -DPLT_BOARD_ARENA_BYTES=65536u $define - 2>&1 | grep -E 'error|warning' | head -n 2
    done
}

headers=$(find engine board -name '*.h' | sort)
# shellcheck disable=SC2086
verdict "every engine and board header compiles alone as C11" "$(alone c c11 "$CC" "" $headers)"
if needs "$CXX"; then
    # C++ spells _Static_assert without the underscore.
    # shellcheck disable=SC2086
    verdict "every engine and board header compiles alone as C++17" \
        "$(alone c++ c++17 "$CXX" -D_Static_assert=static_assert $headers)"
fi
finish

#!/bin/sh
# archs.sh [ci] - the names that make takes by ARCH=, or those of CI
# SPDX-License-Identifier: MIT
for file in tests/cpus/*.mk; do
    grep -q '^TRIPLE := ' "$file" || continue
    arch=${file##*/} arch=${arch%.mk}
    case $1 in
    ci) grep -q '^IN_CI := yes$' "$file" && echo "$arch" ;;
    *) echo "$arch" ;;
    esac
done

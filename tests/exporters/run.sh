#!/bin/sh
# run.sh SCRIPT ARGUMENT... - runs a writer or reader by the ending of its name
#
# $BUILD/exporters/npm/NAME is where an npm package of that name lies; Debian's Python modules
# belong to /usr/bin/python3. SPDX-License-Identifier: MIT
script=$1
shift
base=$(basename "$script")
name=${base#*_}
name=${name%.*}

compiled() {
    program=$BUILD/exporters/programs/${base%.*}
    mkdir -p "$(dirname "$program")"
    if [ -z "$(find "$program" -newer "$script" 2>/dev/null)" ]; then
        # shellcheck disable=SC2046
        g++ -w -o "$program" "$script" $(sed -n 's,^// Link: ,,p' "$script") || exit 1
    fi
    "$program" "$@"
}

case $base in
*_blender.py) blender -b --factory-startup --python-exit-code 1 -P "$script" -- "$@" ;;
*_freecad.py) ARGUMENTS=$(printf '%s\n' "$@") FOLDER=$(dirname "$script") freecadcmd "$script" ;;
*.py) /usr/bin/python3 -W ignore "$script" "$@" ;;
*.sh) sh "$script" "$@" ;;
*.R) Rscript "$script" "$@" ;;
*.m) octave-cli "$script" "$@" ;;
*.cpp) compiled "$@" ;;
*.mjs) cd "$BUILD/exporters/npm/$name" && node "$script" "$@" ;;
esac

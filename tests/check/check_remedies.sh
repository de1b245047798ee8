#!/bin/sh
# check_remedies.sh - every remedy that the tools name is tried by a test, or has a reason
#
# messages.awk lists the messages. A test tries one when the message stands in it between
# double quotes: tests/cli/test_remedies_*.sh (see remedies.sh there) do what it says, and so
# do tests/host_tools/test_*_remedies.c without a device. SPDX-License-Identifier: MIT
. tests/check/report.sh
out=$BUILD/check
mkdir -p "$out"

# MESSAGE | why no test does what it says. A line may end in a backslash.
few='so few bytes do not run out before others do'
size='a file of that size does not fit into a test'
large="of a mesh that large as well; test_pack_need asks for the sizes"
reasons="
out of memory; close other programs | $few
%s %s: out of memory; close other programs | $few
%u triangles: out of memory for a kd-tree, which had %llu bytes; leave some out, or take another \
structure | test_baselines gives less memory
%u triangles: out of memory for a hierarchy; leave some out | likewise
out of memory for treelets; leave out triangles, or choose smaller ones | likewise
out of memory for counts; leave out --counts | likewise
out of memory for treelets; leave out triangles | likewise
out of memory for edges that wait; choose smaller treelets | likewise
%s has no switches; leave ':%.*s' out | all structures have some so far
%zu triangles: more than %u; leave some out | $large
%zu triangles cannot move to be %zu; open a new one | no command moves them; test_baselines does
this build cannot open it; choose another structure | no command opens the engine so
out of memory for an arena of %llu bytes; leave out triangles | likewise
%s; choose another structure | likewise
out of memory for corners; leave out triangles | likewise
%s; write numbers within 2^40 | likewise
not traced; choose another structure | likewise
frame %u: triangle %u: %s; bring the mesh nearer to 0,0,0 | readers refuse such meshes before
out of memory for its frames; pack on a larger machine | $few
out of memory for the frames of --tree-for all; use --tree-for first | $few
%zu triangles: out of memory for a tree of so many frames; use --tree-for first | \
test_pack_poses gives less memory
out of memory for normals or colours; use a larger machine | $few
%zu corners: out of memory for their normals and colours; pack on a larger machine | $few
use --normals none, --colours none and --texcoords none, or --reduce | $large
use --materials none, or --reduce | $large
use --textures blocks, or none | $large
out of memory, or more than 65534 materials; split the mesh | $few
there is no room for one more section; please report this | no image of ours has seven
use fewer frames, or --geometry lattice of fewer bits | $size
use fewer frames, or reduce the meshes | $size
bodies of %llu triangles and instances of %llu are more than 2^27 - 1 and 2^32 - 2; reduce their \
meshes | $size
out of memory; choose a smaller --size | a frame of 1,200 tiles is less than one MiB
close other programs | a system without memory for two sockets cannot be had here
cannot read at byte %zu: %s; check the disk | no disk fails when asked to
cannot be read to its end; check the disk or the pipe | likewise; test_hid_stream provokes it
your quota is used up: remove files or write to another disk | there are no quotas here
the file system cannot map it; use --source read | no such file system here can hold a scene
%s; use --socket instead | a system without pseudo terminals has no test_terminal either
a face of more than 2^32 - 1 corners; split it | $size
%u triangles: %s; use --nodes thesis | 128 MiB of blocks: $size
more than 2^32 - 1 rays; split the file | $size
more than 2^32 - 2 vertices; split the mesh | $size
more than 2^32 - 2 triangles; split the mesh | $size
PLY numbers only 2^31 vertices with int; split the mesh | $size
more than %llu bytes, the most that is read of a stream; name the file | $size
%llu triangles: an image holds at most %u; use --reduce, or pack parts of it | $large
use --nodes compact, a larger --leaf, or --reduce | $large
use --nodes compact, or --reduce | $large
use --build host, at most 16 bits, or --reduce | $large
use --geometry lattice, or --reduce | $large
use --numbers none, or --reduce | $large
use --reduce | $large
at least  | no remedy
%llu triangles: the blocks would have at least %llu bytes, and must have at most %u; use a larger \
--leaf, --nodes thesis, or --reduce | $large
%u triangles: compact blocks have at most %u bytes, and %u of the triangles fill them; use \
%s--nodes thesis, or --reduce | 128 MiB of blocks: $size
takes more than the %llu bytes that --memory gives; use --memory %llu or more | pack knows before; \
but for vertices of many slivers
status %d; please report this | cannot happen; if it does, there is somebody to tell
the finished tree is refused: %s; please report this | likewise
the finished image is refused: %s; please report this | likewise
hits of %s rays differ between modes; please report this | likewise
hits of %s rays by %s differ from those by %s; please report this | likewise
hits that are counted differ; please report this | likewise
%s; please report this | likewise, of a C array
there is no measurement '%s'; please report this | likewise
the engine ends with status %d; please report this | likewise
cannot read: %s; move it away, or choose another folder for -o | regular files can be read
two triangles have the same id; pack it again | a forged image does; test_baseline has one
%ux%u has more than %d tiles of 16x16; choose a smaller one | likewise: the command looks before
eye and look coincide, up runs along the view, or one of them is beyond 2^40; change --eye, \
--look, --up or --fov | likewise; test_wire_device provokes it
picture of %u x %u pixels: a side is 1 to %u; choose such a size | no command asks for it
video at 0 frames per second; choose 1 or more | likewise; test_picture_frames does
the mesh has %zu vertices already; start with an empty one | likewise; test_scenes does
bytes of the scene did not come, from byte %u on; check the link and serve it again | no link \
here fails so; test_wire_streamed provokes it
speaks version %u of the protocol, this program %d; build both from the same source | \
there is one version; test_wire_hello provokes it
its engine does not take so many samples; use --samples 4, or 1 | needs an engine of packets of \
2 x 2; test_wire_versions provokes it
its firmware knows no background; leave out --background, or build it with PARTS that say \
background | needs such a firmware; likewise
its firmware knows one sample per pixel; leave out --samples, or build it with PARTS that say \
samples | likewise
no permission to use %04x:%04x; install the udev rule: planelet-hid rules | sudo tee \
/etc/udev/rules.d/70-planelet.rules && sudo udevadm control --reload, then plug the display in \
again | test_hid_rules does so in a machine of its own
reports of %u bytes out and %u in are not for the planelet driver (8 to 1024 and 8 to 64); \
choose another with --driver | sizes come from Linux's /sys; the driver is chosen in \
test_hid_remedies
the display reports error %u (%u); see platform/WIRE.md | something to read: its list of errors
another program shows pictures on %04x:%04x; stop that one, or choose another display with \
--device | every system that the tests run on names the process, and that is tried
no display is plugged in (%u HID devices; --all lists them) | no failure, and list --all is tried
stopped before the display was back | says what was done; test_hid_session does it
stopped before the display had answered | likewise
%04x:%04x went away; waiting for it | says what the program does; test_hid_session waits, too
is a Blender file; export it from there as PLY, OBJ or STL | needs Blender
; primitive ids are positions in the image | says what is the case
. The licence is that of the meshes; planelet adds none. | likewise, in the head of a C array
lattice of %u bits: vertices moved by up to %.2g of the longest side, %llu triangle%s lost %s \
area (%llu had none), %llu position%s merged, %llu T-junction%s (%llu mended); step %.9g, %llu of \
%llu vertices stayed exactly where they were%s | likewise; its remedy stands apart
; nothing is left to trace | likewise
it takes no other mode; use another terminal | every terminal takes other modes
the picture cannot be drawn; is the terminal still there? | a terminal that goes ends the program
%s: a standard stream is closed, and / cannot be opened; leave it open | / can always be opened here
serve: %u frames in %.2f s, image of %u bytes; reports %u out, %u in, %u lost, %u late, %u bad; \
%u bytes of tiles, %u tiles, %u sessions | statistics
the scene needs %u bytes and there are %u; choose a larger one%s | of the page; tests/web does \
what it says
%s (rule %c%u, byte %u); pack the mesh again, or copy the file again | likewise
it does not answer; plug it in again and connect it | likewise
byte %u cannot be read; copy the file again, it may be cut | a page has all bytes that it names
%s; choose another shader, or pack it otherwise | of the page, for images that no test packs
this scene cannot be shown so; choose another shader, or fewer samples | of the page, likewise
its %u bytes are more than the browser has; stream it | $size
its %u bytes are more than the browser has; choose a smaller one | $few
%u x %u pixels are more than the browser has; choose fewer | $few
it changed its size to %u x %u pixels; connect it again | no panel of ours changes its size
no driver is for it; connect another device | browsers list devices that drivers are for
reports of %u bytes out and %u in are none of a Planelet display; connect another device | \
likewise; descriptors that lie
it has a panel of %u x %u pixels, up to %u tiles of 16 x 16 can be shown; connect another device | \
likewise
"

# Texts of several lines in one: those of sh end in a backslash, those of C are joined.
joined() {
    awk '{
        line = $0
        if (held != "" && line ~ /^ *"/) { sub(/^ *"/, "", line) } else { printf "%s", held }
        held = ""
        if (line ~ /\\$/) { printf "%s", substr(line, 1, length(line) - 1); next }
        if (FILENAME ~ /[.]c$/ && line ~ /"$/) {
            printf "%s", substr(line, 1, length(line) - 1)
            held = "\"\n"
            next
        }
        print line
    }
    END { printf "%s", held }' "$@"
}

# check FILE...: what is wrong with these sources. $tests: the tests; $table: the reasons.
check() {
    awk -f tests/check/messages.awk "$@" >"$out/messages"
    # shellcheck disable=SC2086
    joined $tests >"$out/tests"
    printf '%s\n' "$table" | sed -n 's/\(.*\) | .*/\1/p' >"$out/reasons"
    while IFS='	' read -r at text; do
        grep -qF "\"$text\"" "$out/tests" || grep -qxF -- "$text" "$out/reasons" ||
            echo "$at: no test does what this says: $text"
    done <"$out/messages"
    cut -f 2- "$out/messages" >"$out/texts"
    while IFS= read -r text; do
        grep -qxF -- "$text" "$out/texts" || echo "a reason for what nobody says: $text"
        ! grep -qF "\"$text\"" "$out/tests" || echo "a reason for what is tried: $text"
    done <"$out/reasons"
    by='says\|says_by\|warns\|converted\|larger\|smaller\|refused_as\|message='
    sed -n "s/^ *\($by\) *\"\([^\"]*\)\".*/\2/p"'
            s/^ *says(&f, "\([^"]*\)").*/\1/p' "$out/tests" |
        grep -v '^[$]' | while IFS= read -r text; do
            grep -qxF -- "$text" "$out/texts" || echo "tried, but nobody says it: $text"
        done
}

# An example of each kind, and of what is none.
cat >"$out/example.c" <<'END'
#include "no message; use none.h"
#define BY_TOOL(in) "convert it: " in " out"
static const arg_flag flags[] = {{"--x", "N", "help; use it"}};
static const char *remedy(int error) {
    return error == 1 ? "use a" : "use b"; /* "no message; use none" */
}
static int f(fail *f, args *a, char *s) {
    const char *remedy = "use c";
    args_complain(a, "%s takes d", "d");
    fail_with(s, "it is wrong", "use e");
    printf("next: use f\n");
    output_print(o, f, "what a file says; use none");
    fail_set(f, path, "%s of it; %s", s, x ? "use i, "
                                                        "then j"
                                                      : "is it k");
    fail_set(f, path, x ? "it is l; use m"
                        : "it is n; use o");
    intake_fail(in, "is OFF; " BY_TOOL("in.off"));
    fail_set(f, "device", "no remedy of %d", 1);
    fail_set(f, "device", "what others say: %s", s);
    fail_set(&line, "device", "a report of %d", 1);
    return fail_set(f, NULL, "%" PRIu64 " of '\"', "
                             "so; use g %s", x) + fail_set(f, "no; %s", "is it h?");
}
END
awk -f tests/check/messages.awk "$out/example.c" | cut -f 2- >"$out/found"
verdict "messages of every kind are found, and nothing else" "$(
    cat >"$out/wanted" <<'END'
use a
use b
use c
%s takes d
use e
next: use f
use i, then j
is it k
it is l; use m
it is n; use o
is OFF; convert it: in.off out
no remedy of %d
%llu of '\"', so; use g %s
is it h?
END
    diff "$out/found" "$out/wanted")"
printf '%s\n' 'says "use a"' 'says "use \' 'b" x' 'larger "use z"' >"$out/example.sh"
verdict "what is not tried, and what nobody says, is found" "$(
    tests=$out/example.sh
    table='use c | so
%s takes d | so
use e | so
next: use f | so
use i, then j | so
is it k | so
it is l; use m | so
it is n; use o | so
is OFF; convert it: in.off out | so
%llu of '"'"'\"'"'"', so; use g %s | so
use a | so
use y | so'
    cat >"$out/wanted" <<END
$out/example.c:19: no test does what this says: no remedy of %d
$out/example.c:23: no test does what this says: is it h?
a reason for what is tried: use a
a reason for what nobody says: use y
tried, but nobody says it: use z
END
    check "$out/example.c" | diff - "$out/wanted")"

# A coarse look that knows nothing of C: what stands in quotes and names a remedy is part of
# some message, but for the help of flags and two that give no advice.
verdict "no literal with a remedy is overlooked" "$(
    # shellcheck disable=SC2046
    set -- $(find host_tools board/host -name '*.c' | sort)
    awk -f tests/check/messages.awk "$@" | cut -f 2- >"$out/texts"
    awk '/^(static )?const arg_(flag|command) /, /^}|;$/ { next }
        { rest = $0
          while (match(rest, /"([^"\\]|\\.)*"/)) {
            text = substr(rest, RSTART + 1, RLENGTH - 2)
            rest = substr(rest, RSTART + RLENGTH)
            sub(/\\n$/, "", text)
            if (text ~ /; [-a-z]|[?]$|^(use|try|choose|write|check|make|leave) / &&
                text !~ /do not edit|^use of/) {
                print FILENAME ":" FNR "\t" text
            }
        } }' "$@" | while IFS='	' read -r at text; do
        grep -qF -- "$text" "$out/texts" || echo "$at: $text"
    done)"

tests='tests/cli/test_remedies_*.sh'
for file in tests/host_tools/test_*_remedies.c; do
    [ -e "$file" ] && tests="$tests $file"
done
table=$reasons
# shellcheck disable=SC2046
trouble=$(check $(find host_tools board/host -name '*.c' | sort))
verdict "each of $(wc -l <"$out/texts") messages with a remedy is tried, or there is a reason" \
    "$trouble"
finish

#!/bin/sh
# test_outputs.sh - outputs never harm: inputs and other outputs under another name, closed
# streams, links, signals, terminals
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
begin outputs
ulimit -c 0
TERM=xterm
export TERM
$CC -std=c11 -Wall -Wextra "$CLI_TESTS/pty.c" -o pty 2>trouble ||
    verdict "the terminal of the tests builds" "$(cat trouble)"

quad quad.ply
run make knot --triangles 500 -o knot.ply
run pack knot.ply -o knot.plt
echo '0 0 5 0 0 0 -1 100' | rays ray
echo 'quad.ply 1 0 0 0' >recipe.txt
mkdir keep here
cp quad.ply knot.plt ray recipe.txt keep
ln -s . me

# ---- what is read is not written -----------------------------------------------

for name in quad.ply knot.plt ray recipe.txt; do
    ln $name hard.$name
    ln -s ../$name here/soft.$name
    ln -s here/soft.$name chain.$name
done
for ending in png y4m; do
    ln knot.plt hard.$ending
    ln -s knot.plt soft.$ending
done
# spared INPUT NAME ARGUMENT...: an output NAME that is INPUT; both are named, all inputs are
# as they were.
spared() {
    input=$1 name=$2
    shift 2
    run "$@"
    trouble=$(
        refusal "$name" "is the same file as the input $input;"
        left_behind
        for kept in quad.ply knot.plt ray recipe.txt; do
            cmp keep/$kept $kept
        done 2>&1)
    verdict "$* is refused, $input is as it was" "${trouble:+$trouble
$(cat err)}"
}
for name in quad.ply ./quad.ply "$PWD/quad.ply" me/quad.ply hard.quad.ply here/soft.quad.ply \
    chain.quad.ply; do
    spared quad.ply "$name" pack quad.ply -o "$name"
done
spared quad.ply quad.ply pack knot.ply quad.ply -o quad.ply
spared recipe.txt hard.recipe.txt pack recipe.txt -o hard.recipe.txt
spared quad.ply hard.quad.ply pack recipe.txt -o hard.quad.ply
for name in ray ./ray hard.ray chain.ray; do
    spared ray "$name" trace knot.plt ray "$name"
    spared ray "$name" trace knot.plt ray x.hits --json "$name"
done
for name in knot.plt hard.knot.plt chain.knot.plt; do
    spared knot.plt "$name" trace knot.plt ray "$name"
    spared knot.plt "$name" trace knot.plt ray "$name" --source read
    spared knot.plt "$name" trace knot.plt ray x.hits --json "$name"
    spared knot.plt "$name" render knot.plt --json "$name"
done
for name in hard.png soft.png hard.y4m soft.y4m; do
    spared knot.plt $name render knot.plt -o $name --size 8x8
    spared knot.plt $name serve knot.plt --emulate 600000 -o $name --size 8x8
done

# streamed SENTENCE INPUT NAME: the verdict on a run whose streams were redirected.
streamed() {
    status=$?
    verdict "$1" "$(
        refusal "$3" "is the same file as the input $2;"
        for kept in quad.ply knot.plt ray; do
            cmp keep/$kept $kept
        done 2>&1
        left_behind)"
}
"$PLANELET" pack - -o hard.quad.ply <quad.ply >out 2>err
streamed "pack - over what standard input is" "standard input" hard.quad.ply
"$PLANELET" pack quad.ply -o - >>quad.ply 2>err
streamed "pack appended to its own input" quad.ply "standard output"
"$PLANELET" trace knot.plt - ray <ray >out 2>err
streamed "trace - over the rays on standard input" "standard input" ray
"$PLANELET" info knot.plt >>knot.plt 2>err
streamed "info appended to its own scene" knot.plt "standard output"
"$PLANELET" render knot.plt --show >>hard.knot.plt 2>err
streamed "render --show appended to its own scene" knot.plt "standard output"
"$PLANELET" render knot.plt --json - >>knot.plt 2>err
streamed "render --json - appended to its own scene" knot.plt "standard output"
"$PLANELET" serve knot.plt --emulate 600000 -o - >>knot.plt 2>err
streamed "serve -o - appended to its own scene" knot.plt "standard output"

# ---- standard error -----------------------------------------------------------------

# erring SENTENCE NAME FILE ARGUMENT...: with errors appended to FILE, NAME is refused; FILE keeps
# what it held. A file that is read gets no word more: that is on standard output.
erring() {
    sentence=$1 name=$2 file=$3
    shift 3
    [ -e "$file" ] || : >"$file"
    cp "$file" was
    "$PLANELET" "$@" >out 2>>"$file"
    status=$?
    if [ -s out ]; then mv out err; else tail -c +$(($(wc -c <was) + 1)) "$file" >err; fi
    verdict "$sentence" "$(
        refusal "$name" "is the file that standard error goes to;"
        head -c "$(wc -c <was)" "$file" | cmp was - 2>&1
        for kept in quad.ply knot.plt ray recipe.txt; do
            cmp keep/$kept $kept
        done 2>&1
        left_behind)"
}
printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' >border.obj # open edges are said of it
cp border.obj keep
erring "errors appended to the mesh that is packed" quad.ply hard.quad.ply pack quad.ply -o x.plt
erring "... that has something to say" border.obj border.obj pack border.obj -o x.plt
same border.obj keep/border.obj "... which is as it was"
erring "... or to the rays" ray ray trace knot.plt ray x.hits
erring "... or to the scene" knot.plt chain.knot.plt render knot.plt -o x.ppm
erring "... or to the scene that is served" knot.plt knot.plt serve knot.plt --emulate 600000 \
    -o x.ppm
erring "errors into the image that is written" w.plt w.plt pack border.obj -o w.plt
erring "... under another name" me/w.plt w.plt pack border.obj -o me/w.plt
erring "... or into the statistics" log log render knot.plt --json log
if [ -d /proc/self/fd ]; then
    erring "... or called /dev/stderr" /dev/stderr log pack border.obj -o /dev/stderr
fi
"$PLANELET" pack - -o x.plt <border.obj >out 2>>border.obj
status=$?
mv out err
verdict "... or what standard input is" "$(
    refusal "standard input" "is the file that standard error goes to;"
    cmp border.obj keep/border.obj 2>&1)"
"$PLANELET" pack border.obj -o - >mixed 2>&1
status=$?
cp mixed err
verdict "an image and errors do not mix in a file" "$(
    refusal "standard output" "is the file that standard error goes to;")"
"$PLANELET" info knot.plt --json >mixed 2>&1
status=$?
verdict "... but text and errors may" "$(
    [ "$status" -eq 0 ] || cat mixed
    flat_json mixed)"
# piped SENTENCE NAME WORDS ARGUMENT...: refused, with standard output a pipe; $errors, if set, is
# where standard error goes.
piped() {
    sentence=$1 name=$2 words=$3
    shift 3
    {
        sh -c 'exec "$@" '"${errors:-2>err}" sh "$PLANELET" "$@" </dev/null
        echo $? >status
    } | cat >mixed
    status=$(cat status)
    [ -z "$errors" ] || cp mixed err
    verdict "$sentence" "$(
        refusal "$name" "$words"
        left_behind)"
}
errors='2>&1'
piped "nor do they in a pipe" "standard output" "is the pipe that standard error goes to;" \
    pack border.obj -o -
[ ! -d /proc/self/fd ] || piped "... under another name" /dev/stdout \
    "is the pipe that standard error goes to;" trace knot.plt ray /dev/stdout
errors=
"$PLANELET" info knot.plt --json 2>&1 | cat >mixed
verdict "... but text and errors may" "$(flat_json mixed)"
if [ -d /proc/self/fd ]; then
    same="is the same pipe as the output"
    piped "two outputs in a pipe" /dev/stdout "$same standard output;" \
        pack border.obj -o - --json /dev/stdout
    piped "... the other way round" "standard output" "$same /dev/stdout;" \
        trace knot.plt ray /dev/stdout --json -
    piped "... under two names" /dev/fd/1 "$same /dev/stdout;" \
        trace knot.plt ray /dev/stdout --json /dev/fd/1
    piped "... and a picture that is drawn" /dev/stdout "$same standard output;" \
        render knot.plt --show --json /dev/stdout --size 8x8
fi
rm -f x.* w.plt log mixed

# ---- no file is written twice ----------------------------------------------------

echo old >old.ppm
ln old.ppm twin.ppm
ln -s old.ppm soft.ppm
ln -s new.ppm newer.ppm
# apart OUT STATS: both are refused as one file, nothing is written.
apart() {
    refused "render -o $1 --json $2: one file" "$2" "is the same file as the output $1;" \
        render knot.plt -o "$1" --json "$2" --size 8x8
    refused "trace knot.plt ray $1 --json $2: one file" "$2" "is the same file as the output $1;" \
        trace knot.plt ray "$1" --json "$2"
    verdict "... nothing was written" "$(
        [ "$(cat old.ppm)" = old ] || echo "the old output changed"
        ls new.ppm 2>/dev/null
        left_behind)"
}
apart old.ppm ./old.ppm
apart twin.ppm old.ppm
apart soft.ppm me/old.ppm
apart new.ppm ./new.ppm
apart me/new.ppm "$PWD/new.ppm"
apart newer.ppm new.ppm
apart new.ppm newer.ppm
"$PLANELET" render knot.plt -o old.ppm --json - --size 8x8 >>twin.ppm 2>err
status=$?
verdict "a picture and statistics on standard output that is the picture" "$(
    refusal "standard output" "is the same file as the output old.ppm;"
    [ "$(cat old.ppm)" = old ] || echo "the old output changed")"
ln -s a000.ply a001.ply
refused "frames that are one file through a link" a001.ply \
    "is the same file as the output a000.ply;" make marbles --frames 2 -o 'a{}.ply'
rm -f a000.ply
ln -s b001.ply b000.ply
refused "... also the other way round" b001.ply "is the same file as the output b000.ply;" \
    make marbles --frames 2 -o 'b{}.ply'
run make marbles --frame 0 -o frame.ply
same b001.ply frame.ply "... the one that was written first is as it was"
rm -f a0* b0* frame.ply
misused "one word for two outputs is wrong usage" "two different files" \
    render knot.plt -o x.ppm --json x.ppm
misused "the scene and the rays are not both standard input" "standard input" trace - - x.hits
for device in /dev/null; do
    works "a device may be two outputs" trace knot.plt ray $device --json $device
    works "... a picture, too, under two names" \
        trace knot.plt ray /dev/./null --json $device
done
"$PLANELET" render knot.plt -o new.ppm --show --size 8x8 >new.ppm 2>err
status=$?
verdict "a picture and its drawing in one file" "$(
    refusal new.ppm "is the same file as the output standard output;"
    [ ! -s new.ppm ] || echo "it was written")"
"$PLANELET" serve knot.plt --emulate 600000 -o new.ppm --show --size 8x8 >new.ppm 2>err
status=$?
verdict "... of serve, too" "$(
    refusal new.ppm "is the same file as the output standard output;"
    [ ! -s new.ppm ] || echo "it was written")"
if [ -c /dev/full ]; then
    for command in "pack quad.ply -o new.ppm" "render knot.plt -o new.ppm --size 8x8" \
        "trace knot.plt ray new.ppm"; do
        echo old >new.ppm
        # shellcheck disable=SC2086
        refused "$command with statistics that cannot be written" /dev/full "cannot write" \
            $command --json /dev/full
        verdict "... leaves what was there" "$(
            [ "$(cat new.ppm)" = old ] || echo "it was replaced"
            left_behind)"
    done
fi
works "outputs that are two files" render knot.plt -o new.ppm --json stats --size 8x8
rm -f new.ppm

# ---- closed streams ------------------------------------------------------------------

# as_open NAME: the run that wrote NAME with a stream closed gave what it gives otherwise.
as_open() {
    status=$?
    verdict "$2" "$(
        [ $status -eq 0 ] || echo "status $status"
        cmp "$1" closed.out 2>&1)"
}
run pack knot.ply -o compact.plt --nodes compact
"$PLANELET" pack knot.ply -o closed.out --nodes compact 2>&-
as_open compact.plt "pack without standard error writes the same image"
"$PLANELET" pack knot.ply -o closed.out --nodes compact <&- >&- 2>&-
as_open compact.plt "... without any of the three"
run render knot.plt -o open.ppm --size 9x9
for streams in '<&-' '>&-' '2>&-' '<&- >&-' '>&- 2>&-' '<&- >&- 2>&-'; do
    rm -f closed.ppm closed.out
    eval "\"\$PLANELET\" render knot.plt -o closed.ppm --size 9x9 $streams"
    status=$?
    mv closed.ppm closed.out
    (exit $status)
    as_open open.ppm "render with $streams writes the same picture"
done
run trace knot.plt ray open.hits
"$PLANELET" trace knot.plt ray closed.out <&- >&- 2>&-
as_open open.hits "trace without the three writes the same hits"
# unclosed SENTENCE: refused, as standard input or output is closed.
unclosed() {
    status=$?
    verdict "$2" "$(
        refusal "$1" "closed"
        ls x.* 2>/dev/null
        left_behind)"
}
for command in "render knot.plt -o -" "render knot.plt --json -" "render knot.plt --show" \
    "pack quad.ply -o -" "make ground -o -" "trace knot.plt ray -" "info knot.plt" --version; do
    # shellcheck disable=SC2086
    "$PLANELET" $command >&- 2>err
    unclosed "standard output" "$command with standard output closed"
done
if [ -d /proc/self/fd ]; then
    for name in /dev/stdout /dev/fd/1; do
        for command in "pack quad.ply -o $name" "pack quad.ply -o x.plt --json $name" \
            "trace knot.plt ray $name" "render knot.plt --json $name"; do
            # shellcheck disable=SC2086
            "$PLANELET" $command >&- 2>err
            unclosed $name "$command with standard output closed"
        done
    done
    "$PLANELET" pack quad.ply -o /dev/stdin <&- >out 2>err
    unclosed /dev/stdin "pack -o /dev/stdin with standard input closed"
    "$PLANELET" pack quad.ply -o /dev/stderr 2>&- >out
    status=$?
    verdict "pack -o /dev/stderr with standard error closed is no success" "$(
        [ $status -eq 1 ] || echo "status $status")"
    "$PLANELET" pack quad.ply -o /dev/null >&- 2>err
    status=$?
    verdict "... but -o /dev/null with standard output closed is one" "$(
        [ $status -eq 0 ] || cat err)"
fi
for command in "pack - -o x.plt" "info -" "render - -o x.png" "trace knot.plt - x.hits"; do
    # shellcheck disable=SC2086
    "$PLANELET" $command <&- >out 2>err
    unclosed "standard input" "$command with standard input closed"
done

# ---- links that lead nowhere yet -----------------------------------------------------

ln -s made.plt first
ln -s ../first here/second
ln -s "$PWD/here/second" third
for name in first here/second third; do
    rm -f made.plt
    works "pack through $name, which leads to no file" pack quad.ply -o $name
    verdict "... makes the file, and the links stay" "$(
        [ -f made.plt ] && [ ! -h made.plt ] || echo "made.plt is not there"
        [ -h first ] && [ -h here/second ] && [ -h third ] || echo "a link is gone"
        left_behind
        ls -a here | grep '^\.planelet-')"
done
ln -s missing/x astray
refused "a link into a missing folder" astray "missing/x.*create the directory" \
    pack quad.ply -o astray
ln -s folder/ folderly
refused "a link to a folder that is not there" folderly "directory" pack quad.ply -o folderly
ln -s ring ring
refused "a link to itself" ring "links" pack quad.ply -o ring
verdict "... stays" "$([ -h astray ] && [ -h folderly ] && [ -h ring ] || ls -l)"

if [ -e /dev/fd/0 ] && [ -d /proc/self/fd ]; then
    exec 5>gone
    rm gone
    run pack quad.ply -o /dev/fd/5
    exec 5>&-
    verdict "a deleted file has no name under which it could appear" "$(
        refusal /dev/fd/5 "without a name"
        ls gone* 2>/dev/null)"
fi

# ---- signals -----------------------------------------------------------------------

mkfifo nobody.reads
# ended SIGNAL: pack, which has begun its image and waits for a reader of its statistics, as a
# person at a terminal ends it: a shell's own background commands ignore some signals.
ended() {
    echo old >old.plt
    rm -f pid
    ./pty err sh -c 'echo $$ >pid; exec "$@"' sh "$PLANELET" pack quad.ply -o old.plt \
        --json nobody.reads >seen 2>out </dev/null &
    terminal=$!
    tries=0
    until ls -a | grep -q '^\.planelet-' || ! kill -0 $terminal 2>/dev/null; do
        tries=$((tries + 1))
        [ $tries -lt 600 ] || break
        sleep 0.05
    done
    kill -s "$1" "$(cat pid)" 2>/dev/null
    wait $terminal
    status=$?
    verdict "SIG$1 ends pack, which leaves the old output and nothing else" "$(
        [ "$status" -eq $((128 + $(kill -l "$1" 2>/dev/null || echo 0))) ] ||
            [ "$(kill -l "$status" 2>/dev/null)" = "$1" ] || echo "status $status"
        [ "$(cat old.plt)" = old ] || echo "the old output changed"
        left_behind)"
    rm -f .planelet-*
}
for signal in INT TERM HUP QUIT USR1 USR2 XCPU VTALRM PROF BUS; do
    ended $signal
done
rm -f nobody.reads

# ---- terminals ---------------------------------------------------------------------

./pty both true
if [ $? -eq 125 ]; then
    verdict "there are pseudo terminals here" "none; is /dev/pts mounted?"
    finish
    exit 1
fi
# shellcheck disable=SC2086
for command in "render knot.plt -o -" "render knot.plt -o - --orbit 3" "pack quad.ply -o -" \
    "make ground -o -" "trace knot.plt ray -" "serve knot.plt --emulate 600000 -o -"; do
    ./pty both "$PLANELET" $command >seen 2>out </dev/null
    status=$?
    tr -d '\r' <seen >err
    verdict "$command does not write to a terminal" "$(refusal "standard output" "is a terminal")"
done
for name in /dev/stdout /dev/stderr /dev/tty; do
    [ -e $name ] || continue
    for command in "pack quad.ply" "make ground" "trace knot.plt ray"; do
        case $command in
        trace*) out= ;;
        *) out=-o ;;
        esac
        ./pty 1000000 sh -c "\"$PLANELET\" $command $out $name; echo \$? >ended" >seen 2>out \
            </dev/null
        status=$(cat ended)
        tr -d '\r' <seen >err
        verdict "$command does not write to a terminal called $name" "$(
            refusal $name "is your terminal")"
    done
done
./pty 1000000 "$PLANELET" trace knot.plt ray x.hits --json /dev/tty >seen 2>out </dev/null
status=$?
verdict "... where text is welcome" "$(
    [ "$status" -eq 0 ] || echo "status $status"
    tr -d '\r' <seen | grep -q '"rays": 1' || cat seen)"
./pty both "$PLANELET" render knot.plt --size 8x8 --json - >seen 2>out </dev/null
status=$?
verdict "statistics are text for a terminal" "$(
    [ "$status" -eq 0 ] || echo "status $status"
    tr -d '\r' <seen >stats
    flat_json stats rays)"
finish

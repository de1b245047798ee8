# play - what frames of a sequence took a board, from what it printed and what was counted
#
#   awk -v table=FILE -v most=N -f play.awk host.json marks.txt played.txt
#
# host.json: `planelet render --json`. marks.txt: "chapter" lines of count.c, the first of what
# came before the frames. played.txt: "played" lines of board/played/firmware.c. Fails, and says
# why, if a frame is not the host's, the arena's marks change, or a call takes more than `most`
# instructions (0: any). FILE gets a row for each frame. SPDX-License-Identifier: MIT

# The value of NAME=value in the line.
function value(name,    i) {
    for (i = 2; i <= NF; i++) {
        if (index($i, name "=") == 1) { return substr($i, length(name) + 2) }
    }
    return 0
}

function wrong(sentence) {
    print "error: " sentence
    failed = 1
}

# Shell sort of list[1 .. n].
function sort(list, n,    gap, i, k, x) {
    for (gap = int(n / 2); gap > 0; gap = int(gap / 2)) {
        for (i = gap + 1; i <= n; i++) {
            x = list[i]
            for (k = i; k > gap && list[k - gap] > x; k -= gap) { list[k] = list[k - gap] }
            list[k] = x
        }
    }
}

# A line of least, median and most of took[name, frame].
function summary(name, text,    i, list) {
    for (i = 1; i <= frames; i++) { list[i] = took[name, i] }
    sort(list, frames)
    if (list[frames] > 0) {
        printf "%-34s %11.0f %11.0f %11.0f\n", text, list[1], list[int((frames + 1) / 2)],
            list[frames]
    }
}

# The longest call of a region; of what opens the scene, none is too long.
function longest(name, text, bound) {
    if (pass_most[name] > 0) {
        printf "%-34s %11.0f  %s\n", text, pass_most[name], bound
        if (most > 0 && name != "open" && pass_most[name] > most) {
            wrong("a call of " text " takes more than " most " instructions")
        }
    }
}

BEGIN {
    most += 0
    names = split("read records refit grid rebuild render show open beside vertices", region, " ")
}

/"frame_hashes"/ {
    hashes = split($0, part, "\"")
    for (i = 4; i <= hashes; i += 2) { expected[i / 2 - 1] = part[i] }
    next
}

$1 == "chapter" {
    for (i = 1; i <= names; i++) {
        name = region[i]
        took[name, chapters] = value(name) + 0
        pass = value(name "_longest") + 0
        pass_most[name] = pass > pass_most[name] ? pass : pass_most[name]
    }
    took["total", chapters] = value("total") + 0
    chapters++
}

$1 == "scene" { triangles = value("triangles") + 0 }
$1 == "bounds" {
    blocks = value("blocks")
    visits = value("visits")
    over_vertices = value("over_vertices") + 0
    beside = value("beside") + 0
    rebuilt = value("triangles")
}
$1 == "arena" && frames == 0 {
    used = value("used") + 0
    peak = value("peak") + 0
    arena = value("bytes") + 0
}

$1 == "played" {
    frame[++frames] = value("frame")
    shown = value("frame_hash")
    if (expected[frames] == "" || shown != expected[frames]) {
        different++
        wrong("frame " frame[frames] " is " shown ", the host's " expected[frames])
    }
    end = value("touched") + 0
    if (value("used") + 0 != used || value("peak") + 0 != peak || end < used || end > peak) {
        moved++
        wrong("frame " frame[frames] ": the arena has used=" value("used") " peak=" \
            value("peak") " touched=" value("touched") ", opened with used=" used " peak=" peak)
    }
    touched = end > touched ? end : touched
    rays[frames] = value("rays") + 0
    node_visits[frames] = value("visits")
    rebuilds = value("rebuilds")
    given_up = value("given_up")
}

function write_table(    i) {
    print "frame read records refit grid rebuild trace rays visits" >table
    for (i = 1; i <= frames; i++) {
        printf "%u %.0f %.0f %.0f %.0f %.0f %.0f %u %u\n", frame[i], took["read", i],
            took["records", i], took["refit", i], took["grid", i], took["rebuild", i],
            took["render", i], rays[i], node_visits[i] >table
    }
    close(table)
}

END {
    if (frames == 0 || chapters != frames + 1) {
        wrong(frames + 0 " frames were played, " chapters - 1 " counted")
        exit 1
    }
    for (i = 1; i <= frames; i++) {
        # Without nodes a refit is a pass over all boxes; without a grid there is nothing to make.
        took["grid", i] = took["grid", i] < 100 ? 0 : took["grid", i]
        # Nodes beside are refitted in the calls that read, and at once where they are not beside.
        took["read", i] -= took["beside", i]
        took["show", i] += took["beside", i]
        took["refit", i] += took["beside", i] + took["vertices", i]
        took["engine", i] = took["read", i] + took["show", i] + took["rebuild", i] + \
            took["render", i]
        took["ray", i] = rays[i] > 0 ? took["render", i] / rays[i] : 0
    }
    write_table()
    is_grid = took["grid", 1] > 0
    printf "%-34s %11s %11s %11s\n", "instructions per frame", "least", "median", "most"
    summary("read", "read, decode: plt_sequence_step")
    summary("records", "show: records")
    summary("refit", is_grid ? "show: box of all" : beside ? "read: refit beside" : "show: refit")
    summary("grid", "show: grid")
    summary("rebuild", "rebuild: plt_rebuild_step")
    summary("render", "trace: plt_render_step")
    summary("engine", "all of these")
    summary("ray", "trace, per ray")
    printf "%-34s %11s\n", "the longest call, instructions", "most"
    longest("open", "plt_open_begin, plt_open_step", "before the first frame")
    longest("read", "plt_sequence_step", blocks " blocks")
    longest("beside", "... of these, a refit", blocks " blocks")
    longest("show", "plt_sequence_show", beside ? "an exchange" : "all " triangles " triangles")
    longest("rebuild", "plt_rebuild_step", rebuilt " triangles")
    longest("render", "plt_render_step", visits " visits, or the end of a tile")
    if (took["rebuild", 1] > 0 || rebuilds > 0 || given_up > 0) {
        print "trees built anew: " rebuilds ", given up for want of room: " given_up
    }
    printf "arena: %u of %u bytes in use when the scene is open, at most %u ever", used, arena, peak
    printf ", touched up to %u;", touched
    printf " the same after %u of %u frames\n", frames - moved, frames
    printf "%u of %u frames are the host's, bit for bit\n", frames - different, frames
    exit failed
}

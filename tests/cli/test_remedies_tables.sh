#!/bin/sh
# test_remedies_tables.sh - what planelet tables refuses, and whether its remedies help
# SPDX-License-Identifier: MIT
. tests/check/report.sh
. tests/cli/cli.sh
. tests/cli/remedies.sh
begin remedies_tables

# tables ARGUMENT...: the least of them, with these.
least='--rows ground --size 16 --views 1 1'
run make knot --triangles 100 -o knot.ply
mkdir empty meshes with
cp knot.ply meshes/bunny.ply

# shellcheck disable=SC2086
{
    says "there is no such folder; leave out --scenes to make scenes" tables $least --scenes nowhere
    cured tables $least
    says "has none of the meshes, such as bunny.ply; choose their folder, or leave out --scenes \
to make scenes" tables $least --scenes empty
    cured tables $least --scenes meshes
    cured tables $least

    echo 'a letter' >with/tables.cache
    says "%s; move it away, or choose another folder for -o" tables $least -o with
    cured tables $least -o other
    mv with/tables.cache letter
    cured tables $least -o with
    rm with/tables.cache
    mkdir with/tables.cache
    says "cannot open: %s; choose a folder you own for -o" tables $least -o with
    cured tables $least -o own
    says "cannot make this folder: %s; choose another one for -o" tables $least -o letter
    cured tables $least -o another
    says "cannot make this folder: %s; choose another one for -o" tables $least -o none/none
    cured tables $least -o none

    # Files of at most 512 bytes stand in for a disk that fills up; test_tables has all sizes.
    says_by "cannot write: %s; free some space, or choose another -o" \
        limited f 1 "$PLANELET" tables $least 5 -o filled
    cp err full
    cured tables $least 5 -o emptier
    verdict "... which names the file, and leaves whole lines in it and nothing else" "$(
        grep -q '^filled/tables.cache: ' full || cat full
        ls -A filled | grep -vx tables.cache
        [ "$(wc -l <filled/tables.cache)" -gt 2 ] || cat filled/tables.cache
        tail -c 1 filled/tables.cache | od -An -c | grep -q '\\n' ||
            tail -n 1 filled/tables.cache)"
    says_by "cannot write: %s; free some space, or choose another -o" \
        limited f 1 "$PLANELET" tables $least 5 -o filled
    cured tables $least 5 -o filled
    verdict "... nor has that run found any damage" "$(
        cmp emptier/tables.cache filled/tables.cache)"

    says "there is no table '%s': 1 to 6, or figures" tables $least 7
    cured tables $least 6
    says "--size takes multiples of 16, not '%s'" tables --rows ground --views 1 1 --size 40
    cured tables --rows ground --views 1 1 --size 48
    says "figures need -o DIR, the folder they go to" tables --rows ground --size 16 figures
    cured tables --rows ground --size 16 --views 1 --frames 2 --rounds 1 figures -o figures
}

# Poses that are of different meshes: the last one, and the last but one, of which frames are made.
mkdir -p meshes/horse_poses
for i in 000 001 002 003 004 005 006 007 008 009 010; do
    cp knot.ply meshes/horse_poses/horse_poses_$i.ply
done
hand='--rows hand --size 16 --views 1 --rounds 1 3 --scenes meshes'
run make knot --triangles 200 -o meshes/horse_poses/horse_poses_010.ply
# shellcheck disable=SC2086
{
    says "frame %u has %zu triangles, the first %zu; write all from one mesh" \
        tables $hand --frames 2
    cp knot.ply meshes/horse_poses/horse_poses_010.ply
    cured tables $hand --frames 2
    run make knot --triangles 200 -o meshes/horse_poses/horse_poses_009.ply
    says "its poses have other triangles; write them from one mesh" tables $hand --frames 8
    cp knot.ply meshes/horse_poses/horse_poses_009.ply
    cured tables $hand --frames 8
}

# A mesh of nothing.
{
    echo ply
    echo 'format ascii 1.0'
    echo 'element vertex 0'
    for axis in x y z; do echo "property float $axis"; done
    echo 'element face 0'
    echo 'property list uchar int vertex_indices'
    echo end_header
} >meshes/hand.ply
# shellcheck disable=SC2086
says "has no triangles; choose another mesh" tables --rows hand --size 16 1 --scenes meshes
cp knot.ply meshes/hand.ply
cured tables --rows hand --size 16 1 --scenes meshes
finish

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

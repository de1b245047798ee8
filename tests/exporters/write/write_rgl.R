# write_rgl - R's rgl: writePLY, writeOBJ, writeSTL of what a plot shows
#
# SPDX-License-Identifier: MIT
options(rgl.useNULL = TRUE)
library(rgl)
arguments <- commandArgs(trailingOnly = TRUE)
for (mesh in list.files(arguments[1], pattern = "\\.obj$", full.names = TRUE)) {
    stem <- file.path(arguments[2], sub("\\.obj$", "", basename(mesh)))
    open3d()
    lines <- strsplit(readLines(mesh), " ")
    places <- sapply(lines[sapply(lines, function(l) l[1] == "v")],
                     function(l) as.numeric(l[2:4]))
    faces <- lapply(lines[sapply(lines, function(l) l[1] == "f")],
                    function(l) as.integer(sub("/.*", "", l[-1])))
    cut <- unlist(lapply(faces, function(f)
        rbind(f[1], f[2:(length(f) - 1)], f[3:length(f)])))
    if (all(lengths(faces) == 4)) {
        shade3d(qmesh3d(rbind(places, 1), unlist(faces)), col = "red")
    } else {
        shade3d(tmesh3d(rbind(places, 1), cut), col = "red")
    }
    writePLY(paste0(stem, ".ascii.ply"), format = "ascii")
    writePLY(paste0(stem, ".binary.ply"))
    writePLY(paste0(stem, ".big.ply"), format = "big_endian")
    writeOBJ(paste0(stem, ".obj"))
    writeSTL(paste0(stem, ".ascii.stl"), ascii = TRUE)
    writeSTL(paste0(stem, ".binary.stl"))
    close3d()
}

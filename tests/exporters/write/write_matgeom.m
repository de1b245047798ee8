% write_matgeom - Octave's matGeom: ASCII PLY, of matrices and of cells of faces
%
% SPDX-License-Identifier: MIT
pkg load matgeom
folders = argv();
list = glob(fullfile(folders{1}, "*.json"));
for i = 1 : numel(list)
    made = jsondecode(fileread(list{i}));
    stem = fullfile(folders{2}, made.name);
    whole = made.polygons;
    if iscell(whole)
        whole = cellfun(@(f) double(f(:)') + 1, whole, "UniformOutput", false);
    else
        whole = double(whole) + 1;
    end
    writeMesh_ply([stem ".ply"], made.positions, whole);
    writeMesh_ply([stem ".cut.ply"], made.positions, double(made.triangles) + 1);
end

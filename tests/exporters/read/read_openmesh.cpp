// read_openmesh - OpenMesh
//
// Link: -lOpenMeshCore
// SPDX-License-Identifier: MIT
#include <cstring>
#include <iostream>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

int main(int count, char **argument) {
    for (int i = 1; i < count; i++) {
        OpenMesh::TriMesh_ArrayKernelT<> mesh;
        OpenMesh::IO::read_mesh(mesh, argument[i]);
        std::cout << std::strrchr(argument[i], '/') + 1 << ' ' << mesh.n_faces() << ' '
                  << mesh.n_vertices() << '\n';
    }
    return 0;
}

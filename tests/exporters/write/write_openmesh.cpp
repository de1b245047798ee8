// write_openmesh - OpenMesh: PLY, OBJ and STL, with and without colours and normals
//
// Link: -lOpenMeshCore
// SPDX-License-Identifier: MIT
#include <string>

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>

typedef OpenMesh::PolyMesh_ArrayKernelT<> Mesh;
using OpenMesh::IO::Options;

static bool write(Mesh &mesh, const std::string &stem) {
    const Options all = Options::VertexColor | Options::VertexNormal;
    const Options binary = Options::Binary, big = binary | Options::MSB;
    bool good = OpenMesh::IO::write_mesh(mesh, stem + ".ascii.ply", Options::Default, 9);
    good &= OpenMesh::IO::write_mesh(mesh, stem + ".binary.ply", binary);
    good &= OpenMesh::IO::write_mesh(mesh, stem + ".big.ply", big);
    good &= OpenMesh::IO::write_mesh(mesh, stem + ".all.ascii.ply", all);
    good &= OpenMesh::IO::write_mesh(mesh, stem + ".all.binary.ply", all | binary);
    good &= OpenMesh::IO::write_mesh(mesh, stem + ".all.obj", Options::VertexNormal);
    good &= OpenMesh::IO::write_mesh(mesh, stem + ".obj");
    mesh.triangulate();
    good &= OpenMesh::IO::write_mesh(mesh, stem + ".ascii.stl");
    good &= OpenMesh::IO::write_mesh(mesh, stem + ".binary.stl", binary);
    return good;
}

static const char *const NAMES[] = {"coloured", "cube",  "ell", "prism",
                                    "textured", "torus", "two"};

int main(int, char **argument) {
    const std::string shapes = argument[1], out = argument[2];
    for (const std::string name : NAMES) {
        Mesh mesh;
        mesh.request_vertex_colors();
        mesh.request_face_normals();
        mesh.request_vertex_normals();
        if (!OpenMesh::IO::read_mesh(mesh, shapes + "/" + name + ".off")) {
            return 1;
        }
        mesh.update_normals();
        unsigned i = 0;
        for (const auto vertex : mesh.vertices()) {
            mesh.set_color(vertex, Mesh::Color(37 * i % 256, 91 * i % 256, 53 * i % 256));
            i++;
        }
        if (!write(mesh, out + "/" + name)) {
            return 1;
        }
    }
    return 0;
}

// write_cgal - CGAL: PLY, STL and OBJ of a Surface_mesh, as IO::write_polygon_mesh writes them
//
// Link: -lgmp -lmpfr
// SPDX-License-Identifier: MIT
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>

typedef CGAL::Simple_cartesian<double> Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
namespace params = CGAL::parameters;

static const char *const NAMES[] = {"coloured", "cube",  "ell", "prism",
                                    "textured", "torus", "two"};

int main(int, char **argument) {
    const std::string shapes = argument[1], out = argument[2];
    for (const std::string name : NAMES) {
        Mesh mesh;
        const std::string stem = out + "/" + name;
        bool good = CGAL::IO::read_polygon_mesh(shapes + "/" + name + ".off", mesh);
        for (const bool binary : {false, true}) {
            const auto how = params::use_binary_mode(binary).stream_precision(17);
            const std::string word = binary ? ".binary" : ".ascii";
            good = good && CGAL::IO::write_polygon_mesh(stem + word + ".ply", mesh, how);
        }
        good = good && CGAL::IO::write_polygon_mesh(stem + ".obj", mesh);
        CGAL::Polygon_mesh_processing::triangulate_faces(mesh);
        for (const bool binary : {false, true}) {
            const auto how = params::use_binary_mode(binary);
            const std::string word = binary ? ".binary" : ".ascii";
            good = good && CGAL::IO::write_polygon_mesh(stem + word + ".stl", mesh, how);
        }
        if (!good) {
            return 1;
        }
    }
    return 0;
}

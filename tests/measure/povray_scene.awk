# povray_scene.awk - a floor and spheres, as OBJ and MTL, and for POV-Ray
#
# Variables: obj, mtl, pov: files to write; aspect, fov (vertical, degrees). Both get the same
# triangles (mesh2, without normals of corners) with the same digits. SPDX-License-Identifier: MIT

function vertex(x, y, z) {
    printf "v %.6f %.6f %.6f\n", x, y, z >obj
    points[count++] = sprintf("<%.6f,%.6f,%.6f>", x, y, z)
    return count
}

function triangle(a, b, c) {
    print "f", a, b, c >obj
    faces[triangles++] = "<" a - 1 - base "," b - 1 - base "," c - 1 - base ">"
}

function begin(name) {
    print "usemtl", name >obj
    base = count
    triangles = 0
}

# The mesh since begin, with a POV-Ray texture and what else belongs to it.
function finish(texture, i) {
    print "mesh2 { vertex_vectors {", count - base >pov
    for (i = base; i < count; i++) {
        print ",", points[i] >pov
    }
    print "} face_indices {", triangles >pov
    for (i = 0; i < triangles; i++) {
        print ",", faces[i] >pov
    }
    print "} inside_vector <0,0,1>", texture, "}" >pov
}

function sphere(name, x, y, z, r, texture, i, j, a, b, pi, first, next_one) {
    pi = 4 * atan2(1, 1)
    begin(name)
    for (i = 0; i <= 24; i++) {
        for (j = 0; j < 48; j++) {
            a = pi * i / 24
            b = 2 * pi * j / 48
            if ((i > 0 && i < 24) || j == 0) {
                vertex(x + r * sin(a) * cos(b), y + r * cos(a), z + r * sin(a) * sin(b))
            }
        }
    }
    for (j = 0; j < 48; j++) {
        next_one = (j + 1) % 48
        triangle(base + 1, base + 2 + next_one, base + 2 + j)
        for (i = 0; i < 22; i++) {
            first = base + 2 + 48 * i
            triangle(first + j, first + next_one, first + 48 + j)
            triangle(first + next_one, first + 48 + next_one, first + 48 + j)
        }
        first = base + 2 + 48 * 22
        triangle(first + j, first + next_one, count)
    }
    finish(texture)
}

function material(name, text) {
    print "newmtl " name "\n" text >mtl
}

BEGIN {
    count = 0
    print "mtllib " mtl_name >obj
    material("floor", "Kd 0.7 0.6 0.45\nillum 1")
    material("paint", "Kd 0.75 0.12 0.08\nKs 0.4 0.4 0.4\nNs 40\nillum 2")
    material("mirror", "Kd 0.05 0.05 0.05\nKs 0.8 0.8 0.8\nNs 1000\nillum 3")
    material("glass", "Kd 0 0 0\nKs 0 0 0\nNi 1.5\nd 0\nTf 0.8 0.8 0.8\nillum 4")
    pi = 4 * atan2(1, 1)
    half = sin(fov * pi / 360) / cos(fov * pi / 360) * aspect
    print "#version 3.7; global_settings { assumed_gamma 1 ambient_light rgb 1" >pov
    print "max_trace_level 7 adc_bailout 0 }" >pov
    # Misses: the sky, which is as bright as the ground.
    print "background { rgb <0.25,0.28,0.32> }" >pov
    # Negative: POV-Ray counts its axes by the left hand.
    printf "camera { location <0.5,2.2,6> up y right -%.9f*x angle %.9f look_at <0,0.7,0> }\n",
        aspect, 2 * atan2(half, 1) * 180 / pi >pov
    # It fades by 2 / (1 + (d / 0.01)^2), so near 0.0002 / d^2.
    print "light_source { <3,5,4> rgb 150000 fade_distance 0.01 fade_power 2 }" >pov
    ambient = "ambient rgb <0.25,0.28,0.32>"
    begin("floor")
    a = vertex(-5, 0, -5); b = vertex(-5, 0, 5); c = vertex(5, 0, 5); d = vertex(5, 0, -5)
    triangle(a, b, c)
    triangle(a, c, d)
    finish("texture { pigment { rgb <0.7,0.6,0.45> } finish { diffuse 1 " ambient " } }")
    # Its highlight is J. Blinn's, with 1 / roughness for the exponent.
    sphere("paint", -1.7, 0.8, 0.3, 0.8, "texture { pigment { rgb <0.75,0.12,0.08> } " \
        "finish { diffuse 1 " ambient " specular 0.4 roughness 0.025 } }")
    # Schlick's formula: all that grazes it, by the fifth power.
    sphere("mirror", 0.2, 1, -1, 1, "texture { pigment { rgb 0.05 } finish { diffuse 1 " ambient \
        " specular 0.8 roughness 0.001 reflection { 0.8, 1 falloff 5 } } }")
    # It fades by e^(-d / fade_distance), and so does light that comes through.
    glass = sprintf("interior { ior 1.5 fade_power 1001 fade_distance %.9f fade_color rgb 0 }",
        -1 / log(0.8))
    sphere("glass", 1.8, 0.7, 0.9, 0.7, "texture { pigment { rgbt <0,0,0,1> } finish { diffuse 0 " \
        "ambient 0 reflection { 0, 1 fresnel on } conserve_energy } } " glass)
}

# povray_mesh.awk MTL OBJ - an OBJ with its materials, as POV-Ray's mesh2
#
# Variables: eye, look, sun ("x,y,z"; the direction towards it), fov (vertical, degrees), aspect;
# power of the sun; sky, ground ("r g b"): light from above and below; crease, degrees: corners of
# triangles that lie at no more than this to each other share a normal, weighted by angles, as `pack
# --smooth` has it. Faces are triangles. SPDX-License-Identifier: MIT

function dot(a, b) {
    return a[1] * b[1] + a[2] * b[2] + a[3] * b[3]
}

function acos(x) {
    return x >= 1 ? 0 : x <= -1 ? PI : atan2(sqrt(1 - x * x), x)
}

function rgb(text, n) {
    split(text, n, " ")
    return "rgb <" n[1] "," n[2] "," n[3] ">"
}

# Direction from point a to b, of length 1, or of none.
function direction(a, b, to, i, length_) {
    for (i = 1; i <= 3; i++) {
        to[i] = place[b, i] - place[a, i]
    }
    length_ = sqrt(dot(to, to))
    for (i = 1; i <= 3 && length_ > 0; i++) {
        to[i] /= length_
    }
}

BEGIN {
    PI = 4 * atan2(1, 1)
    print "#version 3.7; global_settings { assumed_gamma 1 ambient_light rgb 1"
    print "max_trace_level 7 adc_bailout 0 }"
    print "sky_sphere { pigment { function { (y + 1) / 2 } color_map { [0 " rgb(ground) "] [1 " \
        rgb(sky) "] } } }"
    half = sin(fov * PI / 360) / cos(fov * PI / 360) * aspect
    # Negative: POV-Ray counts its axes by the left hand.
    printf "camera { location <%s> up y right -%.9f*x angle %.9f look_at <%s> }\n", eye, aspect, \
        2 * atan2(half, 1) * 180 / PI, look
    printf "light_source { 1000*<%s> rgb %s parallel point_at 0 }\n", sun, power
}

$1 == "newmtl" { name = $2; Kd[name] = "0 0 0"; d[name] = 1; next }
$1 == "Kd" { Kd[name] = $2 " " $3 " " $4; next }
$1 == "Ks" { Ks[name] = $2 " " $3 " " $4; next }
$1 == "Ns" { Ns[name] = $2; next }
$1 == "Ni" { Ni[name] = $2; next }
$1 == "d" { d[name] = $2; next }
$1 == "Tf" { Tf[name] = $2 " " $3 " " $4; next }
$1 == "illum" { illum[name] = $2; next }

$1 == "v" {
    points++
    for (i = 1; i <= 3; i++) {
        place[points, i] = $(i + 1)
    }
    # One number for one place, whichever objects touch there.
    key = $2 " " $3 " " $4
    if (!(key in number)) {
        number[key] = points
    }
    same[points] = number[key]
    next
}
$1 == "usemtl" { used = $2; next }
$1 == "f" {
    faces++
    material[faces] = used
    for (i = 1; i <= 3; i++) {
        split($(i + 1), part, "/")
        corner[faces, i] = same[part[1]]
    }
    direction(corner[faces, 1], corner[faces, 2], ab)
    direction(corner[faces, 1], corner[faces, 3], ac)
    n[1] = ab[2] * ac[3] - ab[3] * ac[2]
    n[2] = ab[3] * ac[1] - ab[1] * ac[3]
    n[3] = ab[1] * ac[2] - ab[2] * ac[1]
    size = sqrt(dot(n, n))
    for (i = 1; i <= 3; i++) {
        normal[faces, i] = size > 0 ? n[i] / size : 0
        direction(corner[faces, i], corner[faces, i % 3 + 1], ab)
        direction(corner[faces, i], corner[faces, (i + 1) % 3 + 1], ac)
        angle[faces, i] = acos(dot(ab, ac))
        there[corner[faces, i]] = there[corner[faces, i]] " " faces "," i
    }
    next
}

# The normal of a corner of a face, as POV-Ray has it.
function corner_normal(face, at, sum, all, count, i, k, part, cosine) {
    count = split(there[corner[face, at]], all, " ")
    sum[1] = sum[2] = sum[3] = 0
    for (i = 1; i <= count; i++) {
        split(all[i], part, ",")
        cosine = normal[face, 1] * normal[part[1], 1] + normal[face, 2] * normal[part[1], 2] \
            + normal[face, 3] * normal[part[1], 3]
        if (cosine >= cos(crease * PI / 180)) {
            for (k = 1; k <= 3; k++) {
                sum[k] += angle[part[1], part[2]] * normal[part[1], k]
            }
        }
    }
    return sprintf("<%.6f,%.6f,%.6f>", sum[1], sum[2], sum[3])
}

# Light from all sides turns from the ground's to the sky's by the cosine of the normal's angle;
# the pattern `slope` counts the angle itself, from 0 down to 1 up.
function lit(pigment, finish, i, up, k, s, g, text) {
    split(sky, s, " ")
    split(ground, g, " ")
    text = "texture { slope { y } texture_map {"
    for (i = 0; i <= 16; i++) {
        up = (1 - cos(PI * i / 16)) / 2
        text = text sprintf("\n[%.4f %s finish { ambient rgb <%.6f,%.6f,%.6f> %s }]", i / 16, \
            pigment, g[1] + up * (s[1] - g[1]), g[2] + up * (s[2] - g[2]), \
            g[3] + up * (s[3] - g[3]), finish)
    }
    return text "\n} }"
}

function texture(m, shine, i, a, t) {
    if (Ks[m] != "") {
        # J. Blinn's highlight; white, as POV-Ray has one number for it.
        split(Ks[m], a, " ")
        shine = sprintf("specular %s roughness %.6f", a[2], 1 / Ns[m])
    }
    if (d[m] == 0) {
        split(Tf[m], t, " ")
        return "hollow texture { pigment { rgbt <0,0,0,1> } finish { diffuse 0 ambient 0 " shine \
            " reflection { 0, 1 fresnel on } conserve_energy } } interior { ior " Ni[m] \
            sprintf(" media { absorption rgb <%.6f,%.6f,%.6f> ", -log(t[1]), -log(t[2]), \
                -log(t[3])) "method 1 intervals 1 samples 1,1 } }"
    }
    if (illum[m] == 3) {
        return lit("pigment { " rgb(Kd[m]) " }", "diffuse 1 " shine " reflection { " rgb(Ks[m]) \
            ", rgb 1 falloff 5 }")
    }
    return lit("pigment { " rgb(Kd[m]) " }", "diffuse 1 " shine)
}

END {
    for (f = 1; f <= faces; f++) {
        list[material[f]] = list[material[f]] " " f
    }
    for (m in list) {
        count = split(list[m], of, " ")
        print "mesh2 { vertex_vectors {", 3 * count
        for (j = 1; j <= count; j++) {
            for (i = 1; i <= 3; i++) {
                k = corner[of[j], i]
                print ",<" place[k, 1] "," place[k, 2] "," place[k, 3] ">"
            }
        }
        print "} normal_vectors {", 3 * count
        for (j = 1; j <= count; j++) {
            for (i = 1; i <= 3; i++) {
                print "," corner_normal(of[j], i)
            }
        }
        print "} face_indices {", count
        for (j = 0; j < count; j++) {
            print ",<" 3 * j "," 3 * j + 1 "," 3 * j + 2 ">"
        }
        print "} inside_vector <0.3,0.9,0.3>", texture(m), "}"
    }
}

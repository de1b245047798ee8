/* foreign - see foreign.h
 *
 * The commands were tried as they stand here: assimp 5.2.5 (with its own test models, but
 * for STEP, of which it reads only IFC), gmsh 4.8.4, gunzip, xz, bzip2, zstd, unzip.
 *
 * Sources: glTF 2.0, 2021, section 4.4.2; ISO 10303-21, 2016, section 5.4; 3MF Core
 * Specification 1.3, 2021, part 2; RFC 1952, 1996, section 2.3; RFC 8878, 2021, section
 * 3.1.1; the XZ file format 1.1.0, 2022, section 2.1.1; file(1).
 *
 * SPDX-License-Identifier: MIT */
#include "host_tools/mesh/foreign.h"

#include <ctype.h>
#include <string.h>

#define BY_ASSIMP(in) "convert it: assimp export " in " out.ply (Debian: assimp-utils)"

enum { XML_HEAD_BYTES = 1000 };

static const struct {
    const char *magic;
    size_t length;
    const char *says;
} beginnings[] = {
    {"PLANELET", 8, "is a packed scene already; planelet info and planelet render take it"},
    {"/* a scene image as a C array", 29,
     "is a packed scene as a C array; pack its meshes again, with -o SCENE.plt"},
    {"glTF", 4, "is a binary glTF; " BY_ASSIMP("in.glb")},
    {"Kaydara FBX Binary", 18, "is FBX; " BY_ASSIMP("in.fbx")},
    {"; FBX ", 6, "is FBX; " BY_ASSIMP("in.fbx")},
    {"ISO-10303-21;", 13, "is STEP; make triangles of it: gmsh -2 in.step -o out.stl"},
    {"BLENDER", 7, "is a Blender file; export it from there as PLY, OBJ or STL"},
    {"\x1f\x8b", 2, "is compressed; decompress it: gunzip -c in >out"},
    {"\xfd"
     "7zXZ\0",
     6, "is compressed; decompress it: xz -dc in >out"},
    {"BZh", 3, "is compressed; decompress it: bzip2 -dc in >out"},
    {"\x28\xb5\x2f\xfd", 4, "is compressed; decompress it: zstd -dc in >out"},
};

/* Whether `text` is in the first `most` bytes. */
static int holds(const input *in, const char *text, size_t most) {
    const size_t length = strlen(text), size = in->size < most ? in->size : most;
    for (size_t i = 0; i + length <= size; i++) {
        const unsigned char *at = memchr(in->bytes + i, text[0], size - length + 1 - i);
        if (at == NULL) {
            return 0;
        }
        i = (size_t)(at - in->bytes);
        if (memcmp(at, text, length) == 0) {
            return 1;
        }
    }
    return 0;
}

static const char *text_is(const input *in) {
    static const char *const offs[] = {"OFF", "COFF", "NOFF", "CNOFF", "STOFF"};
    const char *text = (const char *)in->bytes; /* a zero byte follows the last */
    text += strncmp(text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
    text += strspn(text, " \t\r\n");
    for (size_t i = 0; i < sizeof offs / sizeof offs[0]; i++) {
        const size_t length = strlen(offs[i]);
        if (strncmp(text, offs[i], length) == 0 && isspace((unsigned char)text[length])) {
            return "is OFF; " BY_ASSIMP("in.off");
        }
    }
    if (text[0] == '{' && holds(in, "\"asset\"", in->size)) {
        return "is glTF; " BY_ASSIMP("in.gltf");
    }
    if (text[0] != '<') {
        return NULL;
    }
    return holds(in, "<COLLADA", XML_HEAD_BYTES) ? "is COLLADA; " BY_ASSIMP("in.dae")
           : holds(in, "<X3D", XML_HEAD_BYTES)   ? "is X3D; " BY_ASSIMP("in.x3d")
           : holds(in, "<amf", XML_HEAD_BYTES)   ? "is AMF; " BY_ASSIMP("in.amf")
                                                 : NULL;
}

const char *foreign_is(const input *in) {
    for (size_t i = 0; i < sizeof beginnings / sizeof beginnings[0]; i++) {
        if (in->size >= beginnings[i].length &&
            memcmp(in->bytes, beginnings[i].magic, beginnings[i].length) == 0) {
            return beginnings[i].says;
        }
    }
    if (in->size >= 4 && memcmp(in->bytes, "PK\3\4", 4) == 0) {
        return holds(in, "3dmodel.model", in->size) || holds(in, "3DModel.model", in->size)
                   ? "is 3MF; " BY_ASSIMP("in.3mf")
                   : "is a zip archive; pack what is in it: unzip in.zip";
    }
    return text_is(in);
}

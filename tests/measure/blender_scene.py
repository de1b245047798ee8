# blender_scene.py MTL OBJ NAME WIDTH HEIGHT SAMPLES BOUNCES THREADS - an OBJ, by Cycles
#
# Writes NAME.png and NAME.ppm. Run by Blender: blender -b --factory-startup -P blender_scene.py --
# ARGUMENT... The marbles of `make demo` with their camera, sun and sky (blender.sh). y is up, and
# nothing is done to the picture but to write it in sRGB. Highlights are lobes of GGX as bright in
# the middle as the MTL's.
# SPDX-License-Identifier: MIT
import math
import sys

import bpy
from mathutils import Matrix, Vector

mtl, obj, name, width, height, samples, bounces, threads = sys.argv[sys.argv.index("--") + 1 :]
EYE, LOOK, FOV, CREASE = (6, 10, 22), (1.2, -0.6, 5), 35, 40
SUN, POWER, SKY, GROUND = (-0.8, 0.9, -0.15), 1.5, (0.4, 0.58, 0.9), (0.26, 0.2, 0.15)


def read_mtl():
    materials = {}
    for line in open(mtl):
        word = line.split()
        if word[:1] == ["newmtl"]:
            values = materials[word[1]] = {}
        elif word and word[0] != "#":
            values[word[0]] = [float(x) for x in word[1:]]
    return materials


def read_obj():
    points, faces, names, of = [], [], [], []
    for line in open(obj):
        word = line.split()
        if word[:1] == ["v"]:
            points.append([float(x) for x in word[1:4]])
        elif word[:1] == ["usemtl"]:
            if word[1] not in names:
                names.append(word[1])
            used = names.index(word[1])
        elif word[:1] == ["f"]:
            faces.append([int(x.split("/")[0]) - 1 for x in word[1:]])
            of.append(used)
    # One number for one place, whichever objects touch there.
    number = {}
    same = [number.setdefault(tuple(p), i) for i, p in enumerate(points)]
    return points, [[same[i] for i in f] for f in faces], names, of


class Nodes:
    def __init__(self, tree):
        self.tree = tree
        tree.nodes.clear()

    def add(self, kind, inputs, output=0, **settings):
        node = self.tree.nodes.new(kind)
        for name, value in settings.items():
            setattr(node, name, value)
        for name, value in inputs.items():
            if isinstance(value, bpy.types.NodeSocket):
                self.tree.links.new(value, node.inputs[name])
            else:
                node.inputs[name].default_value = value
        return node.outputs[output] if len(node.outputs) > 0 else node


def colour(rgb):
    return (*rgb, 1)


def make_material(name, m):
    material = bpy.data.materials.new(name)
    material.use_nodes = True
    n = Nodes(material.node_tree)
    end = {}
    if m.get("d", [1])[0] == 0:
        glass = n.add("ShaderNodeBsdfGlass", {"Color": colour((1, 1, 1)), "IOR": m["Ni"][0]})
        glass.node.inputs["Roughness"].default_value = 0
        # Light goes straight through, as ours does, and is absorbed on its way.
        is_shadow = n.add("ShaderNodeLightPath", {}, "Is Shadow Ray")
        clear = n.add("ShaderNodeBsdfTransparent", {"Color": colour((1, 1, 1))})
        surface = n.add("ShaderNodeMixShader", {0: is_shadow, 1: glass, 2: clear})
        fades = [-math.log(t) for t in m["Tf"]]
        most = max(fades)
        if most > 0:
            kept = colour([1 - f / most for f in fades])
            absorbs = n.add("ShaderNodeVolumeAbsorption", {"Color": kept, "Density": most})
            end["Volume"] = absorbs
    else:
        surface = n.add("ShaderNodeBsdfDiffuse", {"Color": colour(m["Kd"])})
    if m.get("illum", [1])[0] == 3:
        facing = n.add("ShaderNodeLayerWeight", {"Blend": 0.5}, "Facing")
        fifth = n.add("ShaderNodeMath", {0: facing, 1: 5.0}, operation="POWER")
        grazed = n.add(
            "ShaderNodeMixRGB", {"Fac": fifth, "Color1": colour(m["Ks"]), "Color2": (1, 1, 1, 1)}
        )
        mirror = n.add("ShaderNodeBsdfGlossy", {"Color": grazed, "Roughness": 0})
        surface = n.add("ShaderNodeAddShader", {0: surface, 1: mirror})
    if "Ks" in m:
        squared = 2 / (m["Ns"][0] + 2)  # of alpha; roughness is alpha's square root
        ks = colour([4 * squared * k for k in m["Ks"]])
        shine = n.add("ShaderNodeBsdfGlossy", {"Color": ks, "Roughness": squared**0.25})
        surface = n.add("ShaderNodeAddShader", {0: surface, 1: shine})
    n.add("ShaderNodeOutputMaterial", {"Surface": surface, **end})
    return material


def make_mesh():
    materials = read_mtl()
    points, faces, names, of = read_obj()
    mesh = bpy.data.meshes.new("scene")
    mesh.from_pydata(points, [], faces)
    for name in names:
        mesh.materials.append(make_material(name, materials[name]))
    for polygon, used in zip(mesh.polygons, of):
        polygon.material_index = used
        polygon.use_smooth = True
    mesh.use_auto_smooth = True
    mesh.auto_smooth_angle = math.radians(CREASE)
    bpy.context.collection.objects.link(bpy.data.objects.new("scene", mesh))


def aim(thing, at, towards):
    back = (Vector(at) - Vector(towards)).normalized()
    right = Vector((0, 1, 0)).cross(back).normalized()
    turn = Matrix((right, back.cross(right), back)).transposed().to_4x4()
    thing.matrix_world = Matrix.Translation(at) @ turn


def make_lights():
    sun = bpy.data.lights.new("sun", "SUN")
    sun.energy = POWER * math.pi  # of a white surface that faces it, power
    sun.angle = 0
    thing = bpy.data.objects.new("sun", sun)
    bpy.context.collection.objects.link(thing)
    aim(thing, SUN, (0, 0, 0))
    world = bpy.context.scene.world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    n = Nodes(world.node_tree)
    along = n.add("ShaderNodeTexCoord", {}, "Generated")
    up = n.add("ShaderNodeSeparateXYZ", {0: along}, "Y")
    high = n.add("ShaderNodeMath", {0: up, 1: 0.5, 2: 0.5}, operation="MULTIPLY_ADD")
    light = n.add(
        "ShaderNodeMixRGB", {"Fac": high, "Color1": colour(GROUND), "Color2": colour(SKY)}
    )
    n.add("ShaderNodeOutputWorld", {"Surface": n.add("ShaderNodeBackground", {"Color": light})})


def make_camera():
    camera = bpy.data.cameras.new("eye")
    camera.sensor_fit = "VERTICAL"
    camera.angle_y = math.radians(FOV)
    thing = bpy.data.objects.new("eye", camera)
    bpy.context.collection.objects.link(thing)
    aim(thing, EYE, LOOK)
    bpy.context.scene.camera = thing


def render():
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device, cycles.samples, cycles.seed = "CPU", int(samples), 0
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.pixel_filter_type = "BOX"
    cycles.max_bounces = cycles.glossy_bounces = cycles.transmission_bounces = 6
    cycles.transparent_max_bounces = 16
    cycles.diffuse_bounces = int(bounces)
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = 0
    cycles.caustics_reflective = cycles.caustics_refractive = False
    r = scene.render
    r.threads_mode, r.threads = "FIXED", int(threads)
    r.resolution_x, r.resolution_y, r.resolution_percentage = int(width), int(height), 100
    r.dither_intensity = 0
    r.image_settings.file_format, r.image_settings.color_mode = "PNG", "RGB"
    scene.view_settings.view_transform, scene.view_settings.look = "Standard", "None"
    r.filepath = name + ".png"
    bpy.ops.render.render(write_still=True)


def write_ppm():
    image = bpy.data.images.load(name + ".png")
    image.colorspace_settings.name = "Non-Color"  # bytes as they are
    across, down = image.size
    rgb = [round(255 * x) for i, x in enumerate(image.pixels[:]) if i % 4 < 3]
    rows = [bytes(rgb[3 * across * y : 3 * across * (y + 1)]) for y in reversed(range(down))]
    with open(name + ".ppm", "wb") as file:
        file.write(b"P6 %d %d 255\n" % (across, down) + b"".join(rows))


for thing in list(bpy.data.objects):
    bpy.data.objects.remove(thing)
make_mesh()
make_lights()
make_camera()
render()
write_ppm()

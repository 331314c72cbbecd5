"""Renders what `bench_peer scene` has written with Blender's Cycles, in the same units (1 W = 1 lm).

Usage: blender -b --factory-startup -P bench/peers/cycles.py -- FOLDER OUT.exr SAMPLES [BOUNCES] [portals] [SIZE]
Prints one line of JSON: the seconds of the render call alone.
"""
import json
import math
import os
import sys
import time

import bpy
import mathutils
import numpy

numpy.bool = bool  # Debian 12's glTF importer still asks for the name that its numpy has given up

words = sys.argv[sys.argv.index("--") + 1:]
folder, out, samples = words[0], words[1], int(words[2])
bounces = int(words[3]) if len(words) > 3 else 8
scene_file = json.load(open(os.path.join(folder, "scene.json")))

bpy.ops.wm.read_factory_settings(use_empty=True)
bpy.ops.import_scene.gltf(filepath=os.path.join(folder, "scene.glb"))
scene = bpy.context.scene
for thing in [o for o in bpy.data.objects if o.type in ("LIGHT", "CAMERA")]:
    bpy.data.objects.remove(thing)


def place(name, data, position, forward, up):
    thing = bpy.data.objects.new(name, data)
    scene.collection.objects.link(thing)
    z = -mathutils.Vector(forward).normalized()
    x = mathutils.Vector(up).cross(z)
    if x.length < 1e-6:
        x = mathutils.Vector((1, 0, 0)).cross(z)
    x.normalize()
    y = z.cross(x)
    thing.matrix_world = mathutils.Matrix((
        (x.x, y.x, z.x, position[0]), (x.y, y.y, z.y, position[1]), (x.z, y.z, z.z, position[2]), (0, 0, 0, 1)))
    return thing


def input_of(node, name):
    return node.inputs[name]


def matte(material):
    """A Lambertian surface in the place of the imported one; colours, opacity and straight transmission kept."""
    tree = material.node_tree
    shader = next(n for n in tree.nodes if n.type == "BSDF_PRINCIPLED")
    output = next(n for n in tree.nodes if n.type == "OUTPUT_MATERIAL")

    def feed(name, socket, fallback=None):
        source = input_of(shader, name)
        if source.is_linked:
            tree.links.new(source.links[0].from_socket, socket)
        else:
            socket.default_value = fallback if fallback is not None else source.default_value

    base = tree.nodes.new("ShaderNodeBsdfDiffuse")
    feed("Base Color", base.inputs["Color"])
    surface = base.outputs[0]
    translucency = material.get("translucency", 0.0)

    def mix(factor, a, b):
        node = tree.nodes.new("ShaderNodeMixShader")
        node.inputs[0].default_value = factor
        tree.links.new(a, node.inputs[1])
        tree.links.new(b, node.inputs[2])
        return node

    if translucency > 0:
        through = tree.nodes.new("ShaderNodeBsdfTranslucent")
        feed("Base Color", through.inputs["Color"])
        surface = mix(translucency, surface, through.outputs[0]).outputs[0]
    transmission = input_of(shader, "Transmission").default_value
    if transmission > 0:
        clear = tree.nodes.new("ShaderNodeBsdfTransparent")
        feed("Base Color", clear.inputs["Color"])
        surface = mix(transmission, surface, clear.outputs[0]).outputs[0]
    strength = input_of(shader, "Emission Strength").default_value
    color = input_of(shader, "Emission").default_value
    if strength > 0 and max(color[:3]) > 0:
        glow = tree.nodes.new("ShaderNodeEmission")
        glow.inputs["Color"].default_value = color
        glow.inputs["Strength"].default_value = strength
        add = tree.nodes.new("ShaderNodeAddShader")
        tree.links.new(surface, add.inputs[0])
        tree.links.new(glow.outputs[0], add.inputs[1])
        surface = add.outputs[0]
    alpha = input_of(shader, "Alpha")
    if alpha.is_linked or alpha.default_value < 1:
        gap = tree.nodes.new("ShaderNodeBsdfTransparent")
        node = mix(1.0, gap.outputs[0], surface)
        feed("Alpha", node.inputs[0])
        surface = node.outputs[0]
    tree.links.new(surface, output.inputs["Surface"])


def pane(material):
    """A sheet of glass as architects make it: straight through or mirrored, so that lamps and sun get in."""
    tree = material.node_tree
    shader = next(n for n in tree.nodes if n.type == "BSDF_PRINCIPLED")
    output = next(n for n in tree.nodes if n.type == "OUTPUT_MATERIAL")
    clear, mirror = tree.nodes.new("ShaderNodeBsdfTransparent"), tree.nodes.new("ShaderNodeBsdfGlossy")
    clear.inputs["Color"].default_value = input_of(shader, "Base Color").default_value
    mirror.inputs["Roughness"].default_value = input_of(shader, "Roughness").default_value
    fresnel, mix = tree.nodes.new("ShaderNodeFresnel"), tree.nodes.new("ShaderNodeMixShader")
    fresnel.inputs["IOR"].default_value = input_of(shader, "IOR").default_value
    tree.links.new(fresnel.outputs[0], mix.inputs[0])
    tree.links.new(clear.outputs[0], mix.inputs[1])
    tree.links.new(mirror.outputs[0], mix.inputs[2])
    tree.links.new(mix.outputs[0], output.inputs["Surface"])


# Blender's importer leaves some of the extensions alone.
raw = open(os.path.join(folder, "scene.glb"), "rb").read()
gltf = json.loads(raw[20:20 + int.from_bytes(raw[12:16], "little")])
for number, described in enumerate(gltf.get("materials", [])):
    extensions = described.get("extensions", {})
    diffuse = extensions.get("KHR_materials_diffuse_transmission")
    material = bpy.data.materials.get(described.get("name", ""))
    if material and diffuse:
        material["translucency"] = diffuse["diffuseTransmissionFactor"]
    if material and "KHR_materials_transmission" in extensions and "KHR_materials_volume" not in extensions:
        material["pane"] = True
for material in bpy.data.materials:
    if not material.use_nodes or not any(n.type == "BSDF_PRINCIPLED" for n in material.node_tree.nodes):
        continue
    if scene_file["matte"]:
        matte(material)
    elif material.get("pane"):
        pane(material)



def bulb(lamp, shines):
    """A ball of the lamp's size that rays pass through and that adds its light to them where they enter it.

    Cycles' own lamps are discs turned to whoever looks, hidden from the camera. Near them their light is not that of
    a ball: at three radii a tenth weaker. shines: whether the ball lights the room as well, in the lamp's place.
    """
    bpy.ops.mesh.primitive_uv_sphere_add(segments=64, ring_count=32, radius=lamp["radius"], location=lamp["position"])
    ball = bpy.context.object
    material = bpy.data.materials.new("bulb")
    material.use_nodes = True
    tree = material.node_tree
    tree.nodes.clear()
    glow, clear = tree.nodes.new("ShaderNodeEmission"), tree.nodes.new("ShaderNodeBsdfTransparent")
    add, output = tree.nodes.new("ShaderNodeAddShader"), tree.nodes.new("ShaderNodeOutputMaterial")
    side, entering = tree.nodes.new("ShaderNodeNewGeometry"), tree.nodes.new("ShaderNodeMath")
    strongest = max(lamp["intensity"])
    glow.inputs["Color"].default_value = [c / strongest for c in lamp["intensity"]] + [1]
    entering.operation = "SUBTRACT"
    entering.inputs[0].default_value = 1
    tree.links.new(side.outputs["Backfacing"], entering.inputs[1])
    strength = tree.nodes.new("ShaderNodeMath")
    strength.operation = "MULTIPLY"
    strength.inputs[0].default_value = strongest / (math.pi * lamp["radius"] ** 2)
    tree.links.new(entering.outputs[0], strength.inputs[1])
    tree.links.new(strength.outputs[0], glow.inputs["Strength"])
    tree.links.new(glow.outputs[0], add.inputs[0])
    tree.links.new(clear.outputs[0], add.inputs[1])
    tree.links.new(add.outputs[0], output.inputs["Surface"])
    ball.data.materials.append(material)
    ball.visible_shadow = False
    for kind in () if shines else ("diffuse", "glossy", "transmission", "volume_scatter"):
        setattr(ball, "visible_" + kind, False)


for lamp in scene_file["lamps"]:
    strongest = max(lamp["intensity"])
    if strongest <= 0:
        continue
    kind = "SPOT" if lamp["beamAngle"] > 0 else "POINT"
    if kind == "POINT" and lamp["radius"] > 0:
        bulb(lamp, shines=scene_file["matte"])
        if scene_file["matte"]:
            continue
    light = bpy.data.lights.new("lamp", kind)
    light.energy = 4 * math.pi * strongest
    light.color = [c / strongest for c in lamp["intensity"]]
    light.shadow_soft_size = lamp["radius"]
    if kind == "SPOT":
        light.spot_size = min(2 * lamp["beamAngle"], math.pi)
        light.spot_blend = 1.0
    place("lamp", light, lamp["position"], lamp["axis"], (0, 1, 0))
sun = scene_file["sun"]
strongest = max(sun["illuminance"])
if strongest > 0:
    light = bpy.data.lights.new("sun", "SUN")
    light.energy = strongest
    light.color = [c / strongest for c in sun["illuminance"]]
    light.angle = 2 * sun["angularRadius"]
    place("sun", light, (0, 0, 0), [-c for c in sun["direction"]], (0, 0, 1))

world = bpy.data.worlds.new("sky")
scene.world = world
world.use_nodes = True
world.node_tree.nodes["Background"].inputs[0].default_value = (0, 0, 0, 1)
if "sky" in scene_file:
    picture = world.node_tree.nodes.new("ShaderNodeTexEnvironment")
    picture.image = bpy.data.images.load(os.path.abspath(os.path.join(folder, scene_file["sky"])))
    picture.image.colorspace_settings.name = "Linear"
    world.node_tree.links.new(picture.outputs[0], world.node_tree.nodes["Background"].inputs[0])
if "portals" in words:
    for number, portal in enumerate(scene_file["portals"]):
        u, v = mathutils.Vector(portal["edgeU"]), mathutils.Vector(portal["edgeV"])
        light = bpy.data.lights.new("portal", "AREA")
        light.shape = "RECTANGLE"
        light.size, light.size_y = u.length, v.length
        light.cycles.is_portal = True
        middle = mathutils.Vector(portal["corner"]) + 0.5 * (u + v)
        for sign in (1, -1):  # towards either side, since a portal has a front
            place("portal", light, middle, sign * u.cross(v), v)

camera = bpy.data.cameras.new("view")
camera.sensor_fit = "HORIZONTAL"
camera.angle = scene_file["horizontalFov"]
camera.clip_start = 0.01
scene.camera = place("view", camera, scene_file["eye"], scene_file["forward"], scene_file["up"])

scene.render.engine = "CYCLES"
scene.render.resolution_x, scene.render.resolution_y = scene_file["width"], scene_file["height"]
scene.render.resolution_percentage = 100
scene.render.threads_mode = "FIXED"
scene.render.threads = 2
scene.render.image_settings.file_format = "OPEN_EXR"
scene.render.image_settings.color_depth = "32"
scene.render.filepath = os.path.abspath(out)
cycles = scene.cycles
cycles.device = "CPU"
cycles.samples = samples
cycles.use_adaptive_sampling = False
cycles.use_denoising = "denoise" in words
cycles.sample_clamp_indirect = 0.0
cycles.sample_clamp_direct = 0.0
cycles.blur_glossy = 0.0
if scene_file["matte"]:  # each pixel by itself, so that blocks of pixels can be set beside each other
    cycles.pixel_filter_type = "BOX"
    cycles.filter_width = 1.0
cycles.light_sampling_threshold = 0.0
cycles.max_bounces = bounces
cycles.diffuse_bounces = cycles.glossy_bounces = cycles.transmission_bounces = bounces
cycles.transparent_max_bounces = max(bounces, 32)
cycles.caustics_reflective = cycles.caustics_refractive = True
start = time.time()
bpy.ops.render.render(write_still=True)
seconds = time.time() - start
paths = samples * scene_file["width"] * scene_file["height"]
print(json.dumps({"seconds": seconds, "samples": samples, "paths_per_s": paths / seconds}))

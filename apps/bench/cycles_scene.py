"""Renders a scene of ours with Blender's Cycles, so that both can be timed side by side.

    steradian info SCENE --json > scene.json
    blender -b --factory-startup --debug-cycles -P cycles_scene.py -- scene.json OUT.exr --spp 64 --size 600x600

Cycles prints `Path Tracing <seconds>`: the time of sampling alone. Settings are those that make the estimators the same:
no adaptive sampling, denoising or clamping, caustics on, box filter of one pixel, the scene's number of bounces.
Needs Blender 3.4 or newer. What Cycles has no equal of is an error: checkers, coats, disks, meshes, instances.
"""
import argparse
import json
import math
import sys

import bmesh
import bpy
from mathutils import Matrix, Quaternion, Vector

SPHERE_SUBDIVISIONS = 6  # icospheres: Cycles traces triangles


def parse_arguments():
    parser = argparse.ArgumentParser(prog="cycles_scene.py")
    parser.add_argument("scene")
    parser.add_argument("output")
    parser.add_argument("--spp", type=int, default=64)
    parser.add_argument("--size", default="600x600")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("--threads", type=int, default=0)
    own = sys.argv[sys.argv.index("--") + 1:] if "--" in sys.argv else []
    return parser.parse_args(own)


class Materials:
    """Cycles materials of the scene's, made when first used."""

    def __init__(self, scene):
        self.scene = scene
        self.made = {}

    def __getitem__(self, index):
        if index not in self.made:
            self.made[index] = self.build(self.scene["materials"][index])
        return self.made[index]

    def colour(self, texture):
        texture = self.scene["textures"][texture]
        if texture["type"] != "constant":
            sys.exit("cycles_scene: only constant textures")
        return (*texture["value"], 1.0)

    def build(self, description):
        material = bpy.data.materials.new(description["name"])
        material.use_nodes = True
        nodes = material.node_tree.nodes
        nodes.clear()
        kind = description["type"]
        if kind == "lambert":
            shader = nodes.new("ShaderNodeBsdfDiffuse")
            shader.inputs["Color"].default_value = self.colour(description["reflectance"])
        elif kind == "absorber":
            shader = nodes.new("ShaderNodeBsdfDiffuse")
            shader.inputs["Color"].default_value = (0, 0, 0, 1)
        elif kind == "metal":
            legacy = bpy.app.version < (4, 0, 0)
            shader = nodes.new("ShaderNodeBsdfGlossy" if legacy else "ShaderNodeBsdfAnisotropic")
            shader.distribution = "BECKMANN"
            shader.inputs["Color"].default_value = self.colour(description["reflectance"])
            # A Beckmann lobe of the same variance as the sphere of radius `fuzz`: fuzz^2/3 an axis = 2 alpha^2.
            shader.inputs["Roughness"].default_value = math.sqrt(description["fuzz"] / math.sqrt(6.0))
        elif kind == "dielectric":
            shader = nodes.new("ShaderNodeBsdfGlass")
            shader.inputs["Roughness"].default_value = 0.0
            shader.inputs["IOR"].default_value = description["eta"]
        else:
            sys.exit(f"cycles_scene: no equal of material {kind}")
        output = nodes.new("ShaderNodeOutputMaterial")
        material.node_tree.links.new(shader.outputs[0], output.inputs["Surface"])
        return material


def link(name, data, matrix=None):
    item = bpy.data.objects.new(name, data)
    if matrix is not None:
        item.matrix_world = matrix
    bpy.context.scene.collection.objects.link(item)
    return item


def mesh_of(name, vertices, faces, materials, face_materials):
    mesh = bpy.data.meshes.new(name)
    mesh.from_pydata(vertices, [], faces)
    for material in materials:
        mesh.materials.append(material)
    mesh.polygons.foreach_set("material_index", face_materials)
    mesh.update()
    link(name, mesh)


def columns(shape, *names):
    return list(zip(*(shape[name] for name in names)))


def material_ids(shape, count):
    return shape.get("primitiveMaterials") or [shape["material"]] * count


def add_patches(shape, materials, patches, faces_each):
    """One mesh of all primitives; `patches` yields (vertices, faces) of each."""
    vertices, faces, slots, face_slots = [], [], [], []
    for (corners, polygons), material in zip(patches, material_ids(shape, len(patches))):
        if material not in slots:
            slots.append(material)
        faces.extend(tuple(len(vertices) + i for i in polygon) for polygon in polygons)
        face_slots.extend([slots.index(material)] * faces_each)
        vertices.extend(corners)
    mesh_of(shape["name"], vertices, faces, [materials[m] for m in slots], face_slots)


def quad_patches(shape):
    for q, u, v in zip(columns(shape, "cornerX", "cornerY", "cornerZ"), columns(shape, "uX", "uY", "uZ"),
                       columns(shape, "vX", "vY", "vZ")):
        q, u, v = Vector(q), Vector(u), Vector(v)
        yield [q, q + u, q + u + v, q + v], [(0, 1, 2, 3)]


def box_patches(shape):
    polygons = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    centers = columns(shape, "centerX", "centerY", "centerZ")
    halves = columns(shape, "halfX", "halfY", "halfZ")
    turns = columns(shape, "rotationW", "rotationX", "rotationY", "rotationZ") if "rotationW" in shape else \
        [(1, 0, 0, 0)] * len(centers)
    for center, half, turn in zip(centers, halves, turns):
        matrix = Quaternion(turn).to_matrix()
        signs = [Vector((half[0] * (i & 1 or -1), half[1] * (i >> 1 & 1 or -1), half[2] * (i >> 2 & 1 or -1)))
                 for i in range(8)]
        yield [Vector(center) + matrix @ s for s in signs], polygons


def add_spheres(shape, materials):
    meshes = {}
    for center, radius, material in zip(columns(shape, "centerX", "centerY", "centerZ"), shape["radius"],
                                        material_ids(shape, len(shape["radius"]))):
        # The ground of the books has a radius of 1000: it needs finer triangles to look round from near by.
        detail = SPHERE_SUBDIVISIONS + (4 if radius > 100 else 0)
        if (material, detail) not in meshes:
            built = bmesh.new()
            bmesh.ops.create_icosphere(built, subdivisions=detail, radius=1.0)
            mesh = bpy.data.meshes.new("sphere")
            built.to_mesh(mesh)
            built.free()
            mesh.materials.append(materials[material])
            mesh.polygons.foreach_set("use_smooth", [True] * len(mesh.polygons))
            meshes[material, detail] = mesh
        link("sphere", meshes[material, detail], Matrix.Translation(Vector(center)) @ Matrix.Scale(radius, 4))


def add_quad_lights(shape, emission):
    if emission["twoSided"]:
        sys.exit("cycles_scene: lights of one side only")
    for corners, _ in quad_patches(shape):
        u, v = corners[1] - corners[0], corners[3] - corners[0]
        x, y = u.normalized(), v.normalized()
        normal = u.cross(v).normalized()
        lamp = bpy.data.lights.new(shape["name"], "AREA")
        lamp.shape, lamp.size, lamp.size_y = "RECTANGLE", u.length, v.length
        peak = max(emission["radiance"])
        lamp.color = [c / peak for c in emission["radiance"]]
        # Radiance is energy / (4 area) before Blender 4, energy / (pi area) since.
        lamp.energy = peak * (4.0 if bpy.app.version < (4, 0, 0) else math.pi) * u.length * v.length
        lamp.spread = math.pi
        lamp.cycles.max_bounces = 1024
        matrix = Matrix((x, -y, -normal)).transposed().to_4x4()  # a lamp emits along its -z
        matrix.translation = corners[0] + u / 2 + v / 2
        link(shape["name"], lamp, matrix).visible_camera = True
        # A lamp does not end rays: a black quad just behind it does.
        behind = [corner - normal * 1e-4 * u.length for corner in corners]
        black = bpy.data.materials.get("behind lamps") or Materials({}).build({"name": "behind lamps",
                                                                              "type": "absorber"})
        mesh_of("behind", behind, [(0, 1, 2, 3)], [black], [0])


def add_shape(shape, scene, materials):
    kind = shape["type"]
    if shape["emission"] is not None:
        if kind != "quad":
            sys.exit("cycles_scene: only quads as lights")
        add_quad_lights(shape, scene["emissions"][shape["emission"]])
    elif kind == "quad":
        add_patches(shape, materials, list(quad_patches(shape)), 1)
    elif kind == "box":
        add_patches(shape, materials, list(box_patches(shape)), 6)
    elif kind == "sphere":
        add_spheres(shape, materials)
    else:
        sys.exit(f"cycles_scene: no equal of shape {kind}")


def add_sky(light):
    world = bpy.data.worlds.new("sky")
    world.use_nodes = True
    tree = world.node_tree
    tree.nodes.clear()
    background = tree.nodes.new("ShaderNodeBackground")
    if light["type"] == "constant sky":
        background.inputs["Color"].default_value = (*light["radiance"], 1.0)
    elif light["type"] == "gradient sky":
        height = tree.nodes.new("ShaderNodeSeparateXYZ")
        half = tree.nodes.new("ShaderNodeMath")
        half.operation = "MULTIPLY_ADD"
        half.inputs[1].default_value = half.inputs[2].default_value = 0.5
        mix = tree.nodes.new("ShaderNodeMixRGB")
        mix.inputs["Color1"].default_value = (*light["nadir"], 1.0)
        mix.inputs["Color2"].default_value = (*light["zenith"], 1.0)
        direction = tree.nodes.new("ShaderNodeTexCoord")
        tree.links.new(direction.outputs["Generated"], height.inputs[0])
        tree.links.new(height.outputs["Y"], half.inputs[0])
        tree.links.new(half.outputs[0], mix.inputs["Fac"])
        tree.links.new(mix.outputs[0], background.inputs["Color"])
    else:
        sys.exit(f"cycles_scene: no equal of light {light['type']}")
    output = tree.nodes.new("ShaderNodeOutputWorld")
    tree.links.new(background.outputs[0], output.inputs["Surface"])
    world.cycles.sampling_method = "NONE"  # smooth skies: measured to be Cycles' best case
    bpy.context.scene.world = world


def add_camera(camera):
    if camera["type"] != "perspective":
        sys.exit("cycles_scene: perspective cameras only")
    origin = Vector(camera["lookFrom"])
    backward = (origin - Vector(camera["lookAt"])).normalized()
    right = Vector(camera["up"]).cross(backward).normalized()
    data = bpy.data.cameras.new("camera")
    data.sensor_fit, data.sensor_height = "VERTICAL", 24.0
    data.lens = 12.0 / math.tan(math.radians(camera["verticalFov"]) / 2.0)
    data.clip_start, data.clip_end = 1e-3, 1e6
    if camera["defocusAngle"] > 0.0:
        radius = camera["focusDistance"] * math.tan(math.radians(camera["defocusAngle"] / 2.0))
        data.dof.use_dof = True
        data.dof.focus_distance = camera["focusDistance"]
        data.dof.aperture_fstop = data.lens * 1e-3 / (2.0 * radius)
        data.dof.aperture_blades = 0
    matrix = Matrix((right, backward.cross(right), backward)).transposed().to_4x4()
    matrix.translation = origin
    bpy.context.scene.camera = link("camera", data, matrix)


def configure(arguments, bounces):
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.samples, cycles.seed = arguments.spp, arguments.seed
    cycles.use_adaptive_sampling = cycles.use_denoising = cycles.use_fast_gi = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0.0
    cycles.light_sampling_threshold = cycles.blur_glossy = 0.0
    cycles.caustics_reflective = cycles.caustics_refractive = True
    for name in ("max", "diffuse", "glossy", "transmission", "volume"):
        setattr(cycles, name + "_bounces", bounces)
    cycles.transparent_max_bounces = bounces
    cycles.min_light_bounces = cycles.min_transparent_bounces = 0
    cycles.pixel_filter_type, cycles.filter_width, cycles.film_exposure = "BOX", 1.0, 1.0
    if hasattr(cycles, "use_guiding"):
        cycles.use_guiding = False
    render = scene.render
    render.resolution_x, render.resolution_y = (int(side) for side in arguments.size.split("x"))
    render.resolution_percentage = 100
    if arguments.threads > 0:
        render.threads_mode, render.threads = "FIXED", arguments.threads
    render.image_settings.file_format = "OPEN_EXR"
    render.image_settings.color_depth = "32"
    render.filepath = arguments.output


def main():
    arguments = parse_arguments()
    with open(arguments.scene, encoding="utf-8") as file:
        scene = json.load(file)
    if scene["instances"]:
        sys.exit("cycles_scene: no instances")
    for item in list(bpy.data.objects):
        bpy.data.objects.remove(item)
    bpy.context.scene.world = None
    materials = Materials(scene)
    for shape in scene["shapes"]:
        add_shape(shape, scene, materials)
    for light in scene["lights"]:
        add_sky(light)
    add_camera(scene["camera"])
    configure(arguments, scene["defaults"]["maxDepth"] + 1)
    bpy.ops.render.render(write_still=True)


main()

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every shader that the mappers put together, with the constants of many settings, through the reference compiler of GLSL: what one
driver takes, another need not. The sources are those that OpenGL was given."""
import ctypes
import ctypes.util
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.offscreen import Window
from nephoscope_testing.transfer import Transfer, constant
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkFiltersSources import vtkSphereSource

STAGES = {0x8B31: "vert", 0x8B30: "frag", 0x8DD9: "geom"}
SHADER_TYPE, SHADER_SOURCE_LENGTH = 0x8B4F, 0x8B88
RAMP = Transfer([(0, 0, 0, 0), (1, 1, 1, 1)], [(0, 1), (1, 2)])
LONG = Transfer([(i / 20, i / 20, 0, 1) for i in range(21)], [(i / 20, 1 + i % 2) for i in range(21)])


def sources(window):
    """(stage, text) of the shaders of a window's context."""
    library = ctypes.CDLL(ctypes.util.find_library("GL") or "libGL.so.1")
    library.glIsShader.restype = ctypes.c_ubyte
    window.MakeCurrent()
    found = set()
    for name in range(1, 4000):
        if not library.glIsShader(name):
            continue
        stage, length = ctypes.c_int(), ctypes.c_int()
        library.glGetShaderiv(name, SHADER_TYPE, ctypes.byref(stage))
        library.glGetShaderiv(name, SHADER_SOURCE_LENGTH, ctypes.byref(length))
        text = ctypes.create_string_buffer(length.value + 1)
        library.glGetShaderSource(name, length.value + 1, None, text)
        found.add((STAGES[stage.value], text.value.decode()))
    return found


def grid(kind):
    lattice = meshes.image((2, 2, 2)) if kind == "image" else meshes.Lattice(2).mesh(kind)
    data = meshes.with_field(lattice, lambda p: p @ (0.2, 0.3, 0.5))
    meshes.add_array(data.GetPointData(), np.arange(27.0), "o")
    meshes.add_array(data.GetPointData(), np.ones((27, 3)), "v")
    meshes.add_array(data.GetCellData(), np.linspace(0, 1, data.GetNumberOfCells()), "c")
    return data


def cells(method, **settings):
    ours = nephoscope.vtkCellCompositingMapper()
    getattr(ours, "SetMethodTo" + method)()
    for name, value in settings.items():
        getattr(ours, "Set" + name)(*value if isinstance(value, tuple) else (value,))
    return ours


def splats(**settings):
    ours = nephoscope.vtkTexturedSplatMapper()
    for name, value in settings.items():
        getattr(ours, "Set" + name)(value)
    return ours


def variants():
    """(mapper, data, transfer function, association and array)"""
    for kind in ("image", "tetra"):
        for transfer in (RAMP, LONG):
            yield cells("Rays"), grid(kind), transfer, ("point", "s")
            yield cells("Projection"), grid(kind), transfer, ("point", "s")
        for method in ("Rays", "Projection"):
            yield cells(method, OpacityArrayName="o"), grid(kind), LONG, ("point", "s")
            yield cells(method), grid(kind), RAMP, ("cell", "c")
            yield cells(method, Integration=1), grid(kind), RAMP, ("point", "s")
            yield cells(method, SplitAtControlPoints=False), grid(kind), LONG, ("point", "s")
    for smooth in (True, False):
        yield cells("Rays", ContourValue=(0, 0.5), SmoothContourNormals=smooth), grid("tetra"), RAMP, ("point", "s")
    yield cells("Rays", ContourValue=(0, 0.5), LayersFromContours=True), grid("image"), RAMP, ("point", "s")
    for method in ("TrianglesLinear", "TrianglesTable", "Faces"):
        yield cells(method), grid("tetra"), constant(), ("point", "s")
    for kernel in (0, 1, 2):
        yield splats(Kernel=kernel), grid("image"), RAMP, ("point", "s")
    for style in (0, 1):
        for placement in (0, 1):
            yield splats(VectorArrayName="v", VectorStyle=style, VectorPlacement=placement), grid("image"), RAMP, ("point", "s")


def draw(window, scene, prepare=lambda scene: None, hazed=False):
    """In every view: from outside, parallel, from inside, with something opaque."""
    if hazed:
        haze = nephoscope.vtkHaze()
        haze.SetPlanetRadius(100)
        nephoscope.vtkHaze.SetHaze(scene.renderer, haze)
    prepare(scene)
    center = np.array([0.5, 0.5, 0.5])
    for position, parallel in ((center + (1, 2, 9), None), (center + (1, 2, 9), 2.0), (center + (0.01, 0.02, 0.03), None)):
        scene.look(position, center, parallel_scale=parallel, near=0.01, far=40)
        window.render()
    ball = vtkSphereSource()
    ball.SetRadius(0.3)
    ball.Update()
    actor = scene.add_opaque(ball.GetOutput(), (1, 0, 0))
    window.render()
    actor.GetProperty().SetOpacity(0.5)
    window.render()


def draw_between_and_cut(window, scene, mapper):
    """Between the translucent surfaces, where the mapper can; cut at a plane as well; cut alone."""
    plane = vtkPlane()
    plane.SetOrigin(0.5, 0.5, 0.5)
    if mapper.IsA("vtkTexturedSplatMapper") or mapper.GetMethod() in (mapper.RAY_METHOD, mapper.PROJECTION_METHOD):
        scene.renderer.SetUseDepthPeeling(True)
        scene.renderer.SetUseDepthPeelingForVolumes(True)
        window.render()
        mapper.AddClippingPlane(plane)
        window.render()
        scene.renderer.SetUseDepthPeeling(False)
        window.render()


class ShaderSources(unittest.TestCase):
    def setUp(self):
        self.compiled = 0
        self.fragments = set()

    def collect(self, window):
        """VTK deletes shaders that its driver rejects, with an error."""
        self.assertEqual(window.messages.errors, [])
        with tempfile.TemporaryDirectory() as folder:
            paths = []
            for stage, text in sorted(sources(window.window)):
                self.fragments |= {text} if stage == "frag" else set()
                paths.append(os.path.join(folder, f"{len(paths)}.{stage}"))
                with open(paths[-1], "w") as file:
                    file.write(text)
            result = subprocess.run([COMPILER, *paths], capture_output=True, text=True)
            self.assertEqual(result.returncode, 0, result.stdout)
            self.compiled += len(paths)

    def test_volumes(self):
        for hazed in (False, True):
            window = Window((16, 16))
            for mapper, data, transfer, (association, array) in list(variants())[::3 if hazed else 1]:
                scene = window.add_scene()
                volume = scene.add_volume(mapper, data, transfer, array, association)
                draw(window, scene, hazed=hazed)
                draw_between_and_cut(window, scene, mapper)
                scene.renderer.RemoveVolume(volume)
                window.window.RemoveRenderer(scene.renderer)
            self.collect(window)
        print(f"  {self.compiled} shaders")
        self.assertGreater(self.compiled, 100)
        self.check_variants()

    def test_several_volumes(self):
        """Walks of every kind in step, and volumes in slices of depth."""
        stretched = meshes.with_field(meshes.rectilinear([np.array([0, 0.3, 1])] * 3), lambda p: p[:, 0])
        bent = meshes.with_field(meshes.structured(2, lambda p: p), lambda p: p[:, 1])
        kinds = {"voxels": (grid("image"), {}), "grid": (bent, {}), "trilinear grid": (stretched, dict(CellInterpolation=1)), "tetrahedra": (grid("tetra"), {}),
                 "hexahedra": (grid("hexahedron"), {}), "trilinear hexahedra": (grid("hexahedron"), dict(CellInterpolation=1))}
        for hazed in (False, True):
            window = Window((16, 16))
            for first, second in list(zip(kinds, list(kinds)[1:])) + [("voxels", "splats"), ("trilinear grid", "splats"), ("tetrahedra", "splats")]:
                scene = window.add_scene()
                mappers = [cells("Automatic", **kinds[first][1]), splats() if second == "splats" else cells("Automatic", **kinds[second][1])]
                scene.add_volume(mappers[0], kinds[first][0], RAMP)
                scene.add_volume(mappers[1], grid("image") if second == "splats" else kinds[second][0], LONG)
                draw(window, scene, hazed=hazed)
                draw_between_and_cut(window, scene, mappers[0])
                scene.renderer.RemoveAllViewProps()
                window.window.RemoveRenderer(scene.renderer)
            self.collect(window)
        print(f"  {self.compiled} shaders")
        for walk in ("float piecesDone_", "bool crossNextCell_", "bool isFound_"):
            self.assertTrue(any(walk in text for text in self.fragments), walk)
        self.assertTrue(any("#define IN_SLICES" in text for text in self.fragments))

    def check_variants(self):
        """Among the shaders is each way of drawing, between peeled surfaces and not, clipped and not."""
        for way, peeling, values in (("vec2 betweenPlanes()", "useDepthRanges", ("false",)),
                                     ("vec2 visibleRange()", "useDepthRanges", ("true", "false")),
                                     ("vec4 seenRanges()", "peeled", ("true", "false"))):
            for peeled in values:
                for clipped in (True, False):
                    found = [text for text in self.fragments if way in text and f"const bool {peeling} = {peeled};" in text
                             and ("#define CLIPPING_PLANES 1" in text) == clipped]
                    self.assertTrue(found, f"no shader with {way}, peeled: {peeled}, clipped: {clipped}")

    def test_cloud_texture(self):
        for thickness in (False, True):
            for hazed in (False, True):
                window = Window((16, 16))
                scene = window.add_scene()
                ball = vtkSphereSource()
                ball.SetCenter(0.5, 0.5, 0.5)
                ball.Update()
                actor = scene.add_opaque(ball.GetOutput(), (1, 1, 1))
                ours = nephoscope.vtkCloudTextureMapper()
                ours.SetInputData(ball.GetOutput())
                ours.SetUseThickness(thickness)
                ours.SetRelief(0.5 if hazed else 0)
                actor.SetMapper(ours)
                actor.GetProperty().SetOpacity(0.7)
                draw(window, scene, hazed=hazed)
                scene.renderer.SetUseDepthPeeling(True)
                window.render()
                self.collect(window)
        print(f"  {self.compiled} shaders")


COMPILER = shutil.which("glslangValidator")
if __name__ == "__main__":
    if not COMPILER:
        print("skipped: no glslangValidator (Debian: glslang-tools)")
        sys.exit(125)
    unittest.main(verbosity=2)

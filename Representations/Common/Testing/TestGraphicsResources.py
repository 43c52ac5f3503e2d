# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What every mapper makes on the GPU is released in the window it was made in, and is made again, whatever becomes of windows.

Names of OpenGL objects begin with 1 in each window: what is released in another one takes away that one's objects.
"""
import ctypes
import ctypes.util
import gc
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.offscreen import Window
from nephoscope_testing.transfer import Transfer
from vtkmodules.vtkCommonDataModel import vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

GL = ctypes.CDLL(ctypes.util.find_library("GL") or "libGL.so.1")
KINDS = ("Buffer", "Texture", "VertexArray", "Framebuffer", "Renderbuffer", "Query")
NAMES = range(1, 300)
TRANSFER = Transfer([(0, 1, 0.2, 0.1), (1, 0.1, 0.3, 1)], [(0, 0.4), (1, 1.6)])


def objects(window):
    """The OpenGL objects of a window: kind and name."""
    window.window.MakeCurrent()
    return {(kind, name) for kind in KINDS for name in NAMES if getattr(GL, "glIs" + kind)(name)}


def sphere():
    source = vtkSphereSource()
    source.SetThetaResolution(24)
    source.SetPhiResolution(12)
    source.SetRadius(0.8)
    source.Update()
    return source.GetOutput()


def grid():
    data = meshes.structured((3, 3, 3), lambda p: 2 * p - 1)
    meshes.add_array(data.GetPointData(), (np.sin(3 * np.arange(data.GetNumberOfPoints())) + 1) / 2)
    return data


def volume_of(mapper):
    def make(scene):
        volume = scene.add_volume(mapper(), grid(), TRANSFER)
        return volume, volume.GetMapper()
    return make


def cells(method):
    def make():
        mapper = nephoscope.vtkCellCompositingMapper()
        getattr(mapper, "SetMethodTo" + method)()
        return mapper
    return volume_of(make)


def surface_of(thickness, blocks):
    def make(scene):
        mapper = nephoscope.vtkCloudTextureMapper()
        data = sphere()
        if blocks:
            data = vtkMultiBlockDataSet()
            data.SetBlock(0, sphere())
        mapper.SetInputDataObject(data)
        mapper.SetUseThickness(thickness)
        actor = vtkActor()
        actor.SetMapper(mapper)
        scene.renderer.AddActor(actor)
        return actor, mapper
    return make


MAKERS = {
    "rays": cells("Rays"),
    "projection": cells("Projection"),
    "triangles": cells("TrianglesLinear"),
    "faces": cells("Faces"),
    "splats": volume_of(lambda: nephoscope.vtkTexturedSplatMapper()),
    "clouds": surface_of(False, False),
    "thick clouds": surface_of(True, False),
    "blocks of clouds": surface_of(True, True),
}


class Drawing:
    """A window with haze and one thing of ours in it, beside a surface of VTK's own."""

    def __init__(self, make, peeling=False, haze=True):
        self.window = Window((40, 40))
        self.options = (peeling, haze)
        self.scene = self.window.add_scene(background=(0.2, 0.1, 0.3))
        self.scene.look((2, 1, 4))
        self.renderer = self.scene.renderer
        self.renderer.SetUseDepthPeeling(peeling)
        self.renderer.SetUseDepthPeelingForVolumes(peeling)
        self.scene.add_opaque(sphere(), (0.2, 0.6, 0.2)).SetScale(0.4)
        if haze:
            add_haze(self.renderer)
        self.window.render()
        self.prop, self.mapper = make(self.scene)

    def draw(self):
        self.window.render()
        return self.window.rgba()

    def close(self):
        self.scene = self.renderer = self.prop = self.mapper = self.window = None
        gc.collect()


def add_haze(renderer):
    haze = nephoscope.vtkHaze()
    haze.SetProjectionToMap()
    haze.SetScaleHeight(2)
    haze.SetVisibility(10)
    nephoscope.vtkHaze.SetHaze(renderer, haze)


def share_prop(drawing):
    """A maker that adds the prop of another drawing."""
    prop, mapper = drawing.prop, drawing.mapper

    def make(scene):
        scene.renderer.AddViewProp(prop)
        return prop, mapper
    return make


def take_mapper(drawing):
    """A maker that gives the mapper to a prop of its own."""
    mapper, properties, kind = drawing.mapper, drawing.prop.GetProperty(), type(drawing.prop)

    def make(scene):
        prop = kind()
        prop.SetProperty(properties)
        prop.SetMapper(mapper)
        scene.renderer.AddViewProp(prop)
        return prop, mapper
    return make


class Bystander(Drawing):
    """A window with surfaces of VTK's own, which nothing of ours may touch."""

    def __init__(self):
        super().__init__(lambda scene: (None, None))
        for i in range(6):
            mapper = vtkPolyDataMapper()
            mapper.SetInputData(sphere())
            actor = vtkActor()
            actor.SetMapper(mapper)
            actor.SetPosition(i - 3, 0, 0)
            self.renderer.AddActor(actor)
        self.picture = self.draw()
        self.objects = objects(self.window)


class Resources(unittest.TestCase):
    def each(self, check):
        """check(drawing, bystander, expected) of every kind of drawing, beside a window that is current and must stay as it is."""
        for name, make in MAKERS.items():
            earlier = name in ("triangles", "faces")  # methods that are drawn neither between peels nor with haze
            for peeling in (False,) if earlier else (False, True):
                with self.subTest(name=name, peeling=peeling):
                    drawing = Drawing(make, peeling, not earlier)
                    expected = drawing.draw()
                    self.assertGreater(np.ptp(expected[..., :3]), 0.1)
                    bystander = Bystander()
                    check(drawing, bystander, expected)
                    self.untouched(bystander)

    def untouched(self, bystander):
        gc.collect()
        self.assertEqual(objects(bystander.window), bystander.objects)
        self.draws(bystander, bystander.picture)

    def draws(self, drawing, expected, steps=0):
        picture = drawing.draw()
        self.assertEqual(drawing.window.gl_errors(), [])
        self.assertEqual(drawing.window.messages.all, [])
        np.testing.assert_allclose(picture, expected, rtol=0, atol=steps / 255 + 1e-9)

    def test_removed_from_the_renderer(self):
        def check(drawing, bystander, expected):
            drawing.renderer.RemoveViewProp(drawing.prop)
            self.untouched(bystander)
            drawing.renderer.AddViewProp(drawing.prop)
            self.draws(drawing, expected)
        self.each(check)

    def test_nothing_is_left(self):
        """Drawn and removed a second time, no more objects are there than after the first."""
        def check(drawing, bystander, expected):
            left = []
            for _ in range(2):
                self.draws(drawing, expected)
                drawing.renderer.RemoveViewProp(drawing.prop)
                drawing.draw()
                left.append(objects(drawing.window))
                drawing.renderer.AddViewProp(drawing.prop)
                bystander.window.window.MakeCurrent()
            self.assertEqual(left[0], left[1])
        self.each(check)

    def test_mapper_goes_first(self):
        """It dies with what it has on the GPU: nobody has asked it to release that."""
        def check(drawing, bystander, _):
            drawing.prop.SetMapper(None)
            drawing.mapper = None
            self.untouched(bystander)
            drawing.renderer.RemoveViewProp(drawing.prop)
            drawing.draw()
            self.assertEqual(drawing.window.gl_errors(), [])
        self.each(check)

    def test_mapper_moves_to_another_prop_and_window(self):
        def check(drawing, bystander, expected):
            make = take_mapper(drawing)
            drawing.prop.SetMapper(None)
            other = Drawing(make, *drawing.options)
            self.draws(other, expected)
            self.untouched(bystander)
            drawing.renderer.RemoveViewProp(drawing.prop)
            drawing.draw()
            self.assertEqual(drawing.window.gl_errors(), [])
        self.each(check)

    def test_window_goes_first(self):
        """With the mapper in it, and with nobody left who knows of the mapper."""
        def check(drawing, bystander, expected):
            make, options = take_mapper(drawing), drawing.options
            if apart:
                drawing.prop.SetMapper(None)
            drawing.close()
            self.untouched(bystander)
            self.draws(Drawing(make, *options), expected)
        for apart in (False, True):
            self.each(check)

    def test_two_windows(self):
        def check(drawing, bystander, expected):
            other = Drawing(share_prop(drawing), *drawing.options)
            for _ in range(2):
                self.draws(other, expected)
                self.draws(drawing, expected)
            bystander.window.window.MakeCurrent()
            other.close()
            self.untouched(bystander)
            self.draws(drawing, expected)
        self.each(check)

    def test_finalized_and_opened_again(self):
        """Translucent surfaces, VTK's own too, are up to two steps of 8 bits off then."""
        def check(drawing, bystander, expected):
            drawing.window.window.Finalize()
            self.untouched(bystander)
            self.draws(drawing, expected, steps=2)
        self.each(check)

    def test_errors_of_others(self):
        """What others leave in OpenGL's list of errors is not taken for an error of ours."""
        window = Window((64, 64))
        scene = window.add_scene()
        volume, mapper = cells("Rays")(scene)
        scene.look_at(volume)
        left = []

        def leave(*_):
            left.append(GL.glEnable(0xffff))

        mapper.AddObserver("ProgressEvent", leave)  # while the first picture is prepared
        window.render()
        self.assertTrue(left)
        ours = [message for message in window.messages.all if "while drawing" in message or "does not draw" in message]
        self.assertEqual(ours, [])  # builds of VTK that look for errors report this one too
        self.assertGreater(window.rgba(alpha=False).max(), 0.2)

    def test_haze_taken_away(self):
        def check(drawing, bystander, expected):
            haze = nephoscope.vtkHaze.GetHaze(drawing.renderer)
            if not haze:
                return
            nephoscope.vtkHaze.SetHaze(drawing.renderer, None)
            self.untouched(bystander)
            drawing.draw()
            self.assertEqual(drawing.window.gl_errors(), [])
            nephoscope.vtkHaze.SetHaze(drawing.renderer, haze)
            self.draws(drawing, expected)
        self.each(check)


if __name__ == "__main__":
    unittest.main(verbosity=2)

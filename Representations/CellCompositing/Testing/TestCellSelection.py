# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""vtkHardwareSelector finds at each pixel what Pick() finds there."""
import unittest

import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase, mapper
from nephoscope_testing.offscreen import Window
from nephoscope_testing.transfer import Transfer, constant
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPlane, vtkSelectionNode
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkHardwareSelector
from vtkmodules.vtkRenderingOpenGL2 import vtkOpenGLHardwareSelector  # noqa: F401

SIZE = (40, 36)
POINTS, CELLS = vtkDataObject.FIELD_ASSOCIATION_POINTS, vtkDataObject.FIELD_ASSOCIATION_CELLS
X = lambda p: 0.5 + 0.1 * p[:, 2] + 0.2 * p[:, 0]  # noqa: E731
DATA = meshes.BOXES
LOOKS = {
    "parallel": lambda s: s.look((0.03, 0.02, 5), (0.03, 0.02, 0), parallel_scale=0.8, near=0.1, far=20),
    "outside": lambda s: s.look((3, 2.5, 4), (0, 0, 0), angle=30, near=0.5, far=40),
    "inside": lambda s: s.look((-0.51, -0.28, 0.26), (1, 0.6, -0.2), angle=50, near=1e-3, far=40),
}


def selector_of(scene, association=CELLS, area=(0, 0, SIZE[0] - 1, SIZE[1] - 1)):
    selector = vtkHardwareSelector()
    selector.SetRenderer(scene.renderer)
    selector.SetFieldAssociation(association)
    selector.SetArea(*area)
    return selector


def numbers(selection):
    """The numbers in each node of a selection, by prop."""
    result = {}
    for i in range(selection.GetNumberOfNodes()):
        node = selection.GetNode(i)
        ids = node.GetSelectionList()
        prop = node.GetProperties().Get(vtkSelectionNode.PROP())
        result[prop] = [int(ids.GetTuple1(k)) for k in range(ids.GetNumberOfTuples())]
    return result


class Selection(ImageTestCase):
    def scene(self, data, transfer=None, look="outside", configure=None, before=None):
        self.window = Window(SIZE)
        scene, ours = self.window.add_scene(), mapper()
        if configure:
            configure(ours)
        scene.add_volume(ours, data, transfer or constant(2.0))
        if before:
            before(scene)
        LOOKS[look](scene)
        self.window.render()
        self.fail_on_messages(self.window)
        return scene, ours

    def check_as_picked(self, scene, ours):
        """At each pixel the cell and the point of Pick(), and nothing else where there is nothing."""
        picked = {}
        self.window.render()
        for x in range(SIZE[0]):
            for y in range(SIZE[1]):
                found = ours.Pick(scene.renderer, x, y)
                picked[x, y] = (ours.GetPickedCell(), ours.GetPickedPoint()) if found else (-1, -1)
        for k, association in enumerate((CELLS, POINTS)):
            expected = {pixel: numbers[k] for pixel, numbers in picked.items()}
            for pixel in ((20, 18), (13, 21), (27, 11), (0, 0)):
                chosen = selector_of(scene, association, (*pixel, *pixel)).Select()
                self.assertEqual([n for ns in numbers(chosen).values() for n in ns], [n for n in [expected[pixel]] if n >= 0])
            selector = selector_of(scene, association)
            self.assertTrue(selector.CaptureBuffers())
            whole = numbers(selector.GenerateSelection(0, 0, SIZE[0] - 1, SIZE[1] - 1))
            self.assertEqual(sorted(n for ns in whole.values() for n in ns), sorted(set(expected.values()) - {-1}))
            for pixel, number in expected.items():
                one = [n for ns in numbers(selector.GenerateSelection(*pixel, *pixel)).values() for n in ns]
                self.assertEqual(one, [number] if number >= 0 else [], f"pixel {pixel}")
        self.assertGreater(len(set(picked.values())), 2)
        self.fail_on_messages(self.window)

    def test_every_kind_of_cell(self):
        transfer = Transfer([(-1, 1, 1, 1), (2, 0, 0, 1)], [(-1, 0), (0.45, 0), (0.6, 2), (1, 0.5)])
        for kind, make in DATA.items():
            for look in LOOKS:
                for trilinear in (False, True):
                    with self.subTest(kind=kind, look=look, trilinear=trilinear):
                        data = meshes.with_field(make(), X)
                        scene, ours = self.scene(data, transfer, look, lambda m: m.SetCellInterpolation(int(trilinear)))
                        self.check_as_picked(scene, ours)

    def test_clipped_with_surfaces_and_in_front_of_what_is_opaque(self):
        def configure(ours):
            plane = vtkPlane()
            plane.SetOrigin(0, 0, 0.25)
            plane.SetNormal(0, 0, -1)
            ours.AddClippingPlane(plane)
            ours.SetContourValue(0, 0.45)
            ours.SetContourOpacity(0, 0.5)

        scene, ours = self.scene(meshes.with_field(DATA["tetrahedra"](), X), constant(0.05), configure=configure)
        self.check_as_picked(scene, ours)

        def ball(scene):
            source = vtkSphereSource()
            source.SetCenter(0.5, 0.5, 1.0)
            source.SetRadius(0.9)
            source.Update()
            self.ball = scene.add_opaque(source.GetOutput(), (1, 0, 0))
        scene, ours = self.scene(meshes.with_field(DATA["grid"](), X), before=ball)
        picked, found = [], numbers(selector_of(scene).Select())
        self.window.render()  # the selector has drawn its own depths
        for x in range(SIZE[0]):
            picked += [ours.GetPickedCell() for y in range(SIZE[1]) if ours.Pick(scene.renderer, x, y)]
        self.assertEqual(len(found), 2, "the volume and the ball")
        volume = scene.renderer.GetVolumes().GetItemAsObject(0)
        self.assertEqual(found[volume], sorted(set(picked)))
        self.assertLess(len(set(picked)), len(numbers_without(scene, volume)), "the ball hides cells")

    def test_layers_of_a_grid(self):
        """Cells of a layer that is left clear are not found."""
        data = meshes.with_field(DATA["grid"](), X)
        layers = np.arange(data.GetNumberOfCells()) // 9
        meshes.add_array(data.GetCellData(), layers.astype(np.int32), "layer")

        def configure(ours):
            ours.SetLayerArrayName("layer")
            ours.SetLayerProperty(2, constant(0.0).volume_property())
        scene, ours = self.scene(data, look="parallel", configure=configure)
        self.check_as_picked(scene, ours)
        (found,) = numbers(selector_of(scene).Select()).values()
        self.assertEqual({cell // 9 for cell in found}, {1})

    def test_another_view_and_other_data(self):
        """No picture need have been drawn since the camera moved."""
        scene, ours = self.scene(meshes.with_field(DATA["hexahedra"](), X))
        selector_of(scene).Select()
        LOOKS["parallel"](scene)
        found = numbers(selector_of(scene).Select())
        self.window.render()
        picked = {ours.GetPickedCell() for x in range(SIZE[0]) for y in range(SIZE[1]) if ours.Pick(scene.renderer, x, y)}
        self.assertEqual([sorted(picked)], list(found.values()))

    def test_numbers_of_other_data(self):
        data = meshes.with_field(DATA["hexahedra"](), X)
        cells, points = data.GetNumberOfCells(), data.GetNumberOfPoints()
        many = 2**24 + 5
        meshes.add_array(data.GetCellData(), np.arange(cells, dtype=np.int64)[::-1] + many, "cells")
        meshes.add_array(data.GetPointData(), np.arange(points, dtype=np.int64)[::-1] + many, "points")
        meshes.add_array(data.GetCellData(), np.full(cells, 7, np.int32), "blocks")
        meshes.add_array(data.GetCellData(), np.full(cells, 3, np.int32), "processes")
        scene, ours = self.scene(data)
        plain = [numbers(selector_of(scene, which).Select()) for which in (CELLS, POINTS)]
        ours.SetCellIdArrayName("cells")
        ours.SetPointIdArrayName("points")
        ours.SetCompositeIdArrayName("blocks")
        ours.SetProcessIdArrayName("processes")
        for which, count, before in ((CELLS, cells, plain[0]), (POINTS, points, plain[1])):
            selector = selector_of(scene, which)
            selector.SetProcessID(1)
            selector.SetUseProcessIdFromData(True)
            selection = selector.Select()
            properties = selection.GetNode(0).GetProperties()
            self.assertEqual(properties.Get(vtkSelectionNode.COMPOSITE_INDEX()), 7)
            self.assertEqual(properties.Get(vtkSelectionNode.PROCESS_ID()), 3)
            (ids,), (was,) = numbers(selection).values(), before.values()
            self.assertEqual(ids, sorted(count - 1 - n + many for n in was))

    def test_what_is_not_pickable_or_clear(self):
        scene, _ = self.scene(meshes.with_field(DATA["image"](), X))
        scene.renderer.GetVolumes().GetItemAsObject(0).PickableOff()
        self.assertEqual(numbers(selector_of(scene).Select()), {})
        scene, _ = self.scene(meshes.with_field(DATA["image"](), X), constant(0.001))
        self.assertEqual(numbers(selector_of(scene).Select()), {})


def numbers_without(scene, volume):
    """Without all other props."""
    for actor in [scene.renderer.GetActors().GetItemAsObject(i) for i in range(scene.renderer.GetActors().GetNumberOfItems())]:
        actor.VisibilityOff()
    return numbers(selector_of(scene).Select())[volume]


if __name__ == "__main__":
    unittest.main(verbosity=2)

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""With the override VTK creates mappers that draw Cell Compositing, and without it its own again. Scripts do not change."""
import os
import subprocess
import sys
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.offscreen import Window
from nephoscope_testing.transfer import Transfer
from vtkmodules import vtkRenderingVolume
from vtkmodules.vtkCommonCore import vtkWeakReference
from vtkmodules.vtkCommonDataModel import vtkPlane

MAPPERS = {"vtkProjectedTetrahedraMapper": "vtkCellCompositingProjectedTetrahedraMapper",
           "vtkUnstructuredGridVolumeRayCastMapper": "vtkCellCompositingRayCastMapper"}
SAY = ("import nephoscope\nfrom vtkmodules import vtkRenderingVolume\n"
       f"print(*[getattr(vtkRenderingVolume, name)().GetClassName() for name in {list(MAPPERS)}])")


def created():
    return [getattr(vtkRenderingVolume, name)().GetClassName() for name in MAPPERS]


def cells():
    """Two tetrahedra with an array on points and one on cells."""
    data = meshes.tetrahedra([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1), (-1.5, 1.5, 1.5)], [(0, 1, 2, 3), (0, 3, 2, 4)])
    meshes.add_array(data.GetPointData(), np.array([0, 0.3, 0.6, 1, 0.2]))
    meshes.add_array(data.GetCellData(), np.array([0.2, 0.9]))
    return data


def picture(mapper, along=(1, 2, 6), data=None, association="point"):
    window = Window((96, 96))
    scene = window.add_scene()
    scene.add_volume(mapper, data or cells(), Transfer([(0, 1, 0, 0), (1, 0, 0.5, 1)], [(0, 0.1), (1, 0.8)]), association=association)
    scene.look(along, (0, 0, 0), angle=30, near=1, far=12)
    window.render()
    window.render()
    return scene.rgb()


class Override(unittest.TestCase):
    def setUp(self):
        self.addCleanup(nephoscope.override_vtk, False)
        self.before = created()

    def overridden(self):
        nephoscope.override_vtk()
        return [getattr(vtkRenderingVolume, name)() for name in MAPPERS]

    def test_classes(self):
        self.assertFalse(set(self.before) & set(MAPPERS.values()), "off by default")
        for _ in range(2):  # twice is once
            nephoscope.override_vtk()
            self.assertEqual(created(), list(MAPPERS.values()))
        nephoscope.override_vtk(False)
        self.assertEqual(created(), self.before)
        nephoscope.override_vtk(False)
        self.assertEqual(created(), self.before)

    def test_they_are_what_was_asked_for(self):
        for mapper, name in zip(self.overridden(), MAPPERS):
            self.assertTrue(mapper.IsA(name))
            self.assertIsInstance(mapper, getattr(nephoscope, MAPPERS[name]))

    def test_mappers_that_exist_stay(self):
        old = vtkRenderingVolume.vtkProjectedTetrahedraMapper()
        before = picture(old)
        nephoscope.override_vtk()
        np.testing.assert_array_equal(picture(old), before)

    def test_pictures(self):
        """Bit by bit those of the mapper itself, along an axis too, with any array and with clipping planes."""
        plane = vtkPlane()
        plane.SetNormal(0, 1, 0)
        pictures = []
        for association, clipped in (("point", False), ("cell", False), ("point", True)):
            for along in ((1, 2, 6), (0, 0, 6)):
                drawn = []
                for mapper in (nephoscope.vtkCellCompositingMapper(), *self.overridden()):
                    if clipped:
                        mapper.AddClippingPlane(plane)
                    drawn.append(picture(mapper, along, association=association))
                self.assertGreater(drawn[0].max(), 0.2)
                for other in drawn[1:]:
                    np.testing.assert_array_equal(other, drawn[0])
                pictures.append(drawn[0])
        self.assertTrue(all(np.abs(a - b).max() > 0.1 for i, a in enumerate(pictures) for b in pictures[:i]), "the changes show")

    def test_input_changes(self):
        """A mapper draws what it is given last."""
        other = meshes.tetrahedra([(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)], [(0, 1, 2, 3)])
        meshes.add_array(other.GetPointData(), np.array([1.0, 0, 0.5, 0.2]))
        for mapper in self.overridden():
            first = picture(mapper)
            second = picture(mapper, data=other)
            self.assertGreater(np.abs(first - second).max(), 0.1)
            np.testing.assert_array_equal(picture(mapper), first)

    def test_data_are_released(self):
        for number in range(len(MAPPERS)):
            data, kept = cells(), vtkWeakReference()
            kept.Set(data)
            picture(self.overridden()[number], data=data)
            del data
            self.assertIsNone(kept.Get(), list(MAPPERS)[number])

    def test_environment(self):
        for value, expected in (("1", list(MAPPERS.values())), ("0", self.before), ("", self.before)):
            run = subprocess.run([sys.executable, "-c", SAY], env={**os.environ, "NEPHOSCOPE_OVERRIDE_VTK": value}, capture_output=True, text=True)
            self.assertEqual(run.stdout.split(), expected, run.stderr)


if __name__ == "__main__":
    unittest.main(verbosity=2)

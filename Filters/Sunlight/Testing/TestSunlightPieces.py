# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pieces of a grid, as ranks ask for them, have the light of the whole: clouds of other pieces cast their shadows."""
import pathlib
import sys
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.messages import Messages
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkFiltersGeneral import vtkImageDataToPointSet
from vtkmodules.vtkImagingCore import vtkRTAnalyticSource

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from lit import beside_sides  # noqa: E402


def sources():
    """Such as can make a part of their grid."""
    image = vtkRTAnalyticSource()
    image.SetWholeExtent(-6, 6, -5, 5, -4, 4)
    structured = vtkImageDataToPointSet()
    structured.SetInputConnection(image.GetOutputPort())
    return {"image": image, "structured": structured}


def sunlight(source):
    filter_ = nephoscope.vtkSunlight()
    filter_.SetInputConnection(source.GetOutputPort())
    filter_.SetExtinctionArrayName("RTData")
    filter_.SetExtinctionScale(2e-3)
    filter_.SetSunDirection(2, 1, 1)
    return filter_


def lights(data):
    """{place: light} of the points."""
    values = vtk_to_numpy(data.GetPointData().GetArray("Sunlight"))
    return dict(zip(map(tuple, np.round(meshes.points_of(data), 6)), values))


class Pieces(unittest.TestCase):
    def test_have_the_light_of_the_whole(self):
        for name, source in sources().items():
            one = sunlight(source)
            one.Update()
            whole = lights(one.GetOutput())
            seen = set()
            for ghosts in (0, 1):
                for piece in range(3):
                    part = sunlight(source)
                    part.UpdatePiece(piece, 3, ghosts)
                    found = lights(part.GetOutput())
                    self.assertLess(len(found), len(whole), f"{name}, piece {piece}")
                    self.assertEqual(found, {place: whole[place] for place in found}, f"{name}, piece {piece}")
                    seen |= set(found)
            self.assertEqual(seen, set(whole), name)

    def test_shadow_of_clouds_of_other_pieces(self):
        """Data of one piece are shaded by the clouds of all."""
        image = sources()["image"]
        clouds, shaded = sunlight(image), sunlight(image)
        shaded.SetExtinctionScale(1e-9)
        shaded.SetInputConnection(1, clouds.GetOutputPort())
        shaded.Update()
        whole = lights(shaded.GetOutput())
        self.assertGreater(np.ptp(list(whole.values())), 0.01)
        for piece in range(3):
            shaded.UpdatePiece(piece, 3, 0)
            found = lights(shaded.GetOutput())
            self.assertLess(len(found), len(whole))
            self.assertEqual(found, {place: whole[place] for place in found}, f"piece {piece}")

    def test_unstructured_ones_say_that_they_have_not(self):
        image, source = sources()["image"], vtkAppendFilter()
        source.AddInputConnection(image.GetOutputPort())
        for piece, messages in ((0, 1), (1, 0)):
            part = sunlight(source)
            with Messages() as told:
                part.UpdatePiece(piece, 2, 0)
            told = beside_sides(told.all)
            self.assertEqual(len(told), messages, told)
            self.assertTrue(all("cast no shadow" in text for text in told))


if __name__ == "__main__":
    unittest.main()

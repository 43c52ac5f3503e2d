# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The small series as cloud surfaces, every quarter of an hour: they move, and no step stands out."""
import os
import unittest

import forecast_modules
import nephoscope
import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject
from vtkmodules.vtkFiltersCore import vtkMassProperties, vtkTriangleFilter
from vtkmodules.vtkFiltersHybrid import vtkTemporalInterpolator
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader

START, HOURS = 6792.0, 6
SMALL = os.path.join(forecast_modules.DATA, "forecast_10deg_6h.nc")


class Surface(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        reader = vtkNetCDFCFReader()
        reader.SetFileName(SMALL)
        reader.UpdateMetaData()
        reader.SphericalCoordinatesOff()
        reader.SetDimensions("(lev, lat, lon)")
        between = vtkTemporalInterpolator()
        between.SetInputConnection(reader.GetOutputPort())
        cls.globe = nephoscope.vtkGlobeGrid()
        cls.globe.SetInputConnection(between.GetOutputPort())
        cls.globe.SetVerticalExaggeration(20)
        cls.surface = nephoscope.vtkCloudSurface()
        cls.surface.SetInputConnection(cls.globe.GetOutputPort())
        cls.surface.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "cloud_fraction")
        cls.surface.SetValue(0, 0.15)
        cls.areas, cls.clouds, cls.winds = [], [], []
        for time in START + np.arange(4 * HOURS + 1) / 4.0:
            cls.surface.UpdateTimeStep(time)
            triangles, measure = vtkTriangleFilter(), vtkMassProperties()
            triangles.SetInputData(cls.surface.GetOutput())
            measure.SetInputConnection(triangles.GetOutputPort())
            measure.Update()
            cls.areas.append(measure.GetSurfaceArea())
            points = cls.globe.GetOutput().GetPointData()
            cls.clouds.append(vtk_to_numpy(points.GetArray("cloud_fraction")).copy())
            cls.winds.append(vtk_to_numpy(points.GetArray("Wind")).copy())

    def test_the_surface_changes_evenly(self):
        areas = np.array(self.areas)
        steps = abs(np.diff(areas)) / areas[:-1]
        print("area of the surface from frame to frame: at most %.4f of itself; over 6 h %.3f" % (steps.max(), areas[-1] / areas[0] - 1.0))
        self.assertGreater(areas.min(), 0.0)
        self.assertLess(steps.max(), 0.02)

    def test_frames_between_two_hours_are_between(self):
        for field in (self.clouds, self.winds):
            np.testing.assert_allclose(field[6], 0.5 * (field[4] + field[8]), atol=2e-4)

    def test_clouds_move(self):
        self.assertGreater(abs(self.clouds[-1] - self.clouds[0]).max(), 0.1)
        self.assertGreater(abs(self.winds[-1] - self.winds[0]).max(), 3.0)


if __name__ == "__main__":
    unittest.main()

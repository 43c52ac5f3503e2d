# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The GFS file through the NetCDF CF reader: arrays, heights, the mask of the ground, filters downstream."""
import os
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkObject, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkPolyData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkContourFilter
from vtkmodules.vtkFiltersFlowPaths import vtkStreamTracer
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader

import globe_fields as gf
import nephoscope

FILE = os.path.join(os.environ["NEPHOSCOPE_DATA"], "gfs_2p5deg_2011101100.nc")


def reader(dimensions, output_type=-1):
    made = vtkNetCDFCFReader()
    made.SetFileName(FILE)
    made.UpdateMetaData()
    made.SetSphericalCoordinates(0)
    made.SetDimensions(dimensions)
    made.SetOutputType(output_type)
    return made


def globe(surface=True, output_type=-1, **settings):
    made = nephoscope.vtkGlobeGrid()
    made.messages = gf.Messages(made)
    volume, flat = reader("(lev, lat, lon)", output_type), reader("(lat, lon)")
    made.SetInputConnection(volume.GetOutputPort())
    if surface:
        made.SetSurfaceConnection(flat.GetOutputPort())
    for name, value in settings.items():
        getattr(made, "Set" + name)(value)
    made.Update()
    return made


class Gfs(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        vtkObject.GlobalWarningDisplayOff()
        cls.made = globe(VerticalExaggeration=50.0)
        vtkObject.GlobalWarningDisplayOn()
        cls.out = cls.made.GetOutput()
        cls.raw = reader("(lev, lat, lon)")
        cls.raw.Update()

    def test_no_complaint_and_positions(self):
        self.assertEqual(self.made.messages, [])
        self.assertEqual(self.out.GetExtent(), (0, 144, 0, 72, 0, 20))
        gh = gf.values(self.out, "gh")
        np.testing.assert_allclose(np.linalg.norm(gf.points(self.out), axis=1), gf.RADIUS + 50.0 * gh, rtol=1e-7)
        self.assertTrue((gf.corner_determinants(self.out)[:, 1:] > 0).all())

    def test_time_passes_through(self):
        volume, made = reader("(lev, lat, lon)"), nephoscope.vtkGlobeGrid()
        made.SetInputConnection(volume.GetOutputPort())
        made.UpdateTimeStep(6792.0)
        self.assertEqual(made.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS()), (6792.0,))
        self.assertEqual(made.GetOutput().GetInformation().Get(self.out.DATA_TIME_STEP()), 6792.0)

    def test_wind_against_numpy(self):
        raw = self.raw.GetOutput()
        u, v, w, t = (gf.values(raw, n).astype(float) for n in "uvwt")
        x, y, z = gf.mesh(np.arange(144) * 2.5, np.linspace(-90, 90, 73),
                          [1000, 975, 950, 925, 900, 850, 800, 750, 700, 650, 600, 550, 500, 450, 400, 350, 300, 250, 200, 150, 100])
        up_speed = -w * 287.0529 * t / (100.0 * z * 9.80665)
        east, north, up = gf.frame(x, y)
        wind = (east * u[:, None] + north * v[:, None] + up * up_speed[:, None]).reshape(21, 73, 144, 3)
        got = gf.cube(self.out, gf.values(self.out, "Wind"))
        np.testing.assert_allclose(got[:, 1:-1, :-1], wind[:, 1:-1], atol=2e-5)
        np.testing.assert_array_equal(got[:, :, -1], got[:, :, 0])

    def test_below_ground(self):
        flat = reader("(lat, lon)")
        flat.Update()
        sp = gf.values(flat.GetOutput(), "sp").reshape(73, 144)
        levels = np.abs(gf.vtk_to_numpy(self.raw.GetOutput().GetZCoordinates()))
        expected = levels[:, None, None] * 100.0 > sp[None]
        below = gf.cube(self.out, gf.values(self.out, "BelowGround"))[..., :-1]
        np.testing.assert_array_equal(below, expected)
        self.assertAlmostEqual(below.mean(), 0.0746, 4)
        np.testing.assert_array_equal(gf.values(self.out, "vtkGhostType") == 2, gf.values(self.out, "BelowGround") == 1)

    def test_cells_are_hidden_where_a_corner_is(self):
        point = gf.cube(self.out, gf.values(self.out, "vtkGhostType") > 0)
        corner = np.zeros((20, 72, 144), bool)
        for k, j, i in np.ndindex(2, 2, 2):
            corner |= point[k:20 + k, j:72 + j, i:144 + i]
        np.testing.assert_array_equal(gf.values(self.out, "vtkGhostType", cells=True).reshape(20, 72, 144) == 32, corner)

    def test_without_surface_by_sea_level(self):
        out = globe(surface=False).GetOutput()
        np.testing.assert_array_equal(gf.values(out, "BelowGround") == 1, gf.values(out, "gh") < 0)
        out = globe(surface=False, MaskBelowGround=False).GetOutput()
        self.assertIsNone(out.GetPointData().GetArray("vtkGhostType"))

    def test_terrain_height_agrees_with_surface_pressure(self):
        """Two independent fields of the file: the pressure and the height of the ground."""
        by_height = globe(SurfacePressureArrayName="").GetOutput()
        differ = gf.values(by_height, "BelowGround") != gf.values(self.out, "BelowGround")
        self.assertLess(differ.mean(), 0.003)

    def test_output_types_of_the_reader(self):
        for output_type in (2, 3):
            out = globe(output_type=output_type, VerticalExaggeration=50.0).GetOutput()
            np.testing.assert_array_equal(gf.points(out), gf.points(self.out))

    def drawn_in_the_ground(self, surface):
        """Points below the ground that polygons use; VTK's contours keep unused points of skipped cells."""
        used = np.unique(gf.vtk_to_numpy(surface.GetPolys().GetConnectivityArray()))
        return int(gf.values(surface, "BelowGround")[used].sum())

    def test_filters_downstream(self):
        """Contours, geometry and appended grids draw nothing in the ground; without the mask they would."""
        append, unmasked = vtkAppendFilter(), globe(MaskBelowGround=False).GetOutput()
        append.AddInputData(self.out)
        append.Update()
        self.assertEqual(append.GetOutput().GetNumberOfPoints(), self.out.GetNumberOfPoints())
        for grid in (self.out, append.GetOutput()):
            contour, geometry = vtkContourFilter(), vtkDataSetSurfaceFilter()
            contour.SetInputArrayToProcess(0, 0, 0, 0, "cloud_fraction")
            contour.SetValue(0, 0.3)
            for maker in (contour, geometry):
                maker.SetInputData(grid)
                maker.Update()
                self.assertGreater(maker.GetOutput().GetNumberOfPolys(), 10000)
                self.assertEqual(self.drawn_in_the_ground(maker.GetOutput()), 0)
        contour.SetInputData(unmasked)
        masked_count = contour.GetOutput().GetNumberOfPolys()
        contour.Update()
        self.assertGreater(contour.GetOutput().GetNumberOfPolys(), masked_count)

    def trace(self, longitude, latitude, level):
        cube = gf.cube(self.out, gf.points(self.out))
        inside = 0.5 * (cube[level, (latitude + 90) * 2 // 5, longitude * 2 // 5] +
                        cube[level + 1, (latitude + 90) * 2 // 5, longitude * 2 // 5 + 1])
        seeds, at = vtkPolyData(), vtkPoints()
        at.InsertNextPoint(*inside)
        seeds.SetPoints(at)
        tracer = vtkStreamTracer()
        tracer.SetInputData(self.out)
        tracer.SetSourceData(seeds)
        tracer.SetInputArrayToProcess(0, 0, 0, 0, "DisplayVelocity")
        tracer.SetMaximumPropagation(1e6)
        tracer.Update()
        return tracer.GetOutput().GetNumberOfPoints()

    def test_no_wind_in_the_ground(self):
        self.assertGreater(self.trace(200, 10, 12), 2)   # the free air over the Pacific
        self.assertLessEqual(self.trace(90, 35, 2), 1)   # under Tibet at 950 hPa


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Terrain: places, a flat sea, normals at their order, texture coordinates, seam, poles, pieces, what is wrong."""
import os
import unittest

import numpy as np
from nephoscope import vtkGlobeTerrain
from nephoscope_testing.messages import Messages
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkRectilinearGrid
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader

RADIUS = 6371000.0


def hill(lon, lat):
    """Metres: smooth round the globe, below 0 in a part."""
    lon, lat = np.radians(lon), np.radians(lat)
    return 2000 * np.cos(lat) ** 2 * np.cos(2 * lon) + 500 * np.sin(lat)


def fields(lons, lats, height=hill, on_cells=False, **arrays):
    """A level of longitudes and latitudes; `height` and the other arrays are functions of both."""
    grid = vtkRectilinearGrid()
    grid.SetDimensions(len(lons), len(lats), 1)
    for values, put in ((lons, grid.SetXCoordinates), (lats, grid.SetYCoordinates), ([0.0], grid.SetZCoordinates)):
        put(numpy_to_vtk(np.asarray(values, float), deep=1))
    middle = lambda x: (np.asarray(x)[1:] + np.asarray(x)[:-1]) / 2  # noqa: E731
    lon, lat = np.meshgrid(*((middle(lons), middle(lats)) if on_cells else (lons, lats)))
    data = grid.GetCellData() if on_cells else grid.GetPointData()
    for name, function in {"orog": height, **arrays}.items():
        array = numpy_to_vtk(np.ascontiguousarray(function(lon, lat).ravel(), float), deep=1)
        array.SetName(name)
        data.AddArray(array)
    return grid


def terrain_of(grid, exaggeration=1.0, land="", projection=vtkGlobeTerrain.GLOBE, **options):
    terrain = vtkGlobeTerrain()
    terrain.SetInputData(grid)
    terrain.SetVerticalExaggeration(exaggeration)
    terrain.SetLandArrayName(land)
    terrain.SetProjection(projection)
    for name, value in options.items():
        getattr(terrain, "Set" + name)(value)
    terrain.Update()
    return terrain.GetOutput()


def points(output):
    return vtk_to_numpy(output.GetPoints().GetData()).astype(float)


def array(output, name):
    return vtk_to_numpy(output.GetPointData().GetArray(name)).astype(float)


def globe(step=5.0, **options):
    return fields(np.arange(0, 360, step), np.arange(-90, 90 + step, step), **options)


def degrees(x):
    return np.degrees(np.arctan2(x[:, 1], x[:, 0])), np.degrees(np.arctan2(x[:, 2], np.hypot(x[:, 0], x[:, 1])))


class GlobeTerrain(unittest.TestCase):
    def test_places(self):
        output = terrain_of(globe(), exaggeration=30)
        radii = np.linalg.norm(points(output), axis=1)
        heights = np.maximum(hill(*degrees(points(output))), 0)
        self.assertGreater((heights > 0).mean(), 0.3)
        np.testing.assert_allclose(radii, RADIUS + 30 * heights, atol=2)
        np.testing.assert_allclose(array(output, "Height"), heights, atol=0.1)
        flat = terrain_of(globe(), exaggeration=30, projection=vtkGlobeTerrain.MAP)
        lon, lat = np.degrees(points(flat)[:, 0] / RADIUS), np.degrees(points(flat)[:, 1] / RADIUS)
        np.testing.assert_allclose(points(flat)[:, 2], 30 * np.maximum(hill(lon, lat), 0), atol=1)

    def test_land_and_sea(self):
        """Land by its fraction: a lake on a plateau is flat and blue, a basin below sea level is land at 0."""
        output = terrain_of(globe(land=lambda lon, lat: np.clip((lon - 90) / 40 + 0.5, 0, 1)), land="land", SeaDepth=800)
        fraction, scale, height = (array(output, name) for name in ("land", "Terrain", "Height"))
        sea = fraction < 0.5
        self.assertEqual((height[sea].min(), height[sea].max()), (0, 0))
        np.testing.assert_allclose(scale[sea], -800 * (1 - 2 * fraction[sea]), atol=1e-3)
        np.testing.assert_allclose(scale[~sea], np.maximum(height[~sea], 0))
        self.assertLess(height[~sea].min(), 0)  # the basin keeps its height
        self.assertEqual(output.GetPointData().GetScalars().GetName(), "Terrain")
        self.assertTrue(output.GetPointData().HasArray("land") and output.GetPointData().HasArray("orog"))

    def test_normals(self):
        """Outwards, of length 1; those of an Earth without mountains are radial; order 2."""
        output = terrain_of(globe(height=lambda lon, lat: 0 * lon))
        outwards = points(output) / RADIUS
        self.assertLess(np.abs(array(output, "Normals") - outwards).max(), 2e-3)
        errors = []
        for step in (4.0, 2.0, 1.0):
            lons, lats = np.arange(10, 70 + step / 2, step), np.arange(-30, 30 + step / 2, step)
            output = terrain_of(fields(lons, lats, height=lambda lon, lat: 4000 + hill(lon, lat)), 50, projection=vtkGlobeTerrain.MAP)
            normals = array(output, "Normals")
            np.testing.assert_allclose(np.linalg.norm(normals, axis=1), 1, atol=1e-6)
            x = points(output)
            lon, lat, h = np.degrees(x[:, 0] / RADIUS), np.degrees(x[:, 1] / RADIUS), 1e-4
            slope = [50 * (hill(lon + h, lat) - hill(lon - h, lat)), 50 * (hill(lon, lat + h) - hill(lon, lat - h))] / (2 * np.radians(h) * RADIUS)
            true = np.stack([-slope[0], -slope[1], np.ones(len(x))], axis=1)
            true /= np.linalg.norm(true, axis=1)[:, None]
            inside = (lon > 11) & (lon < 69) & (lat > -29) & (lat < 29)
            errors.append(np.abs(normals - true)[inside].max())
        self.assertGreater(errors[0] / errors[1], 3.5)
        self.assertGreater(errors[1] / errors[2], 3.5)

    def test_seam_and_poles(self):
        for lons in (np.arange(0, 360, 5.0), np.arange(-180, 180, 5.0), np.arange(0, 365, 5.0)):
            output = terrain_of(fields(lons, np.arange(90, -95, -5.0)), 20)
            size = [0, 0, 0]
            output.GetDimensions(size)
            self.assertEqual(size[:2], [73, 37])
            x, normals, texture = (a.reshape(37, 73, -1) for a in (points(output), array(output, "Normals"), array(output, "TextureCoordinates")))
            np.testing.assert_allclose(x[:, 0], x[:, -1], atol=1)
            np.testing.assert_allclose(normals[:, 0], normals[:, -1], atol=1e-5)
            np.testing.assert_allclose(np.diff(texture[..., 0], axis=1), 1 / 72, atol=1e-5)  # no jump; round the globe once
            np.testing.assert_allclose(texture[:, 0, 1], np.linspace(0, 1, 37), atol=1e-5)
            for row, up in ((0, -1), (-1, 1)):
                np.testing.assert_allclose(normals[row], np.tile((0, 0, up), (73, 1)), atol=0.02)

    def test_texture_coordinates_are_longitude_and_latitude(self):
        for projection in (vtkGlobeTerrain.GLOBE, vtkGlobeTerrain.MAP):
            output = terrain_of(fields(np.arange(100, 260, 4.0), np.arange(-40, 44, 4.0)), projection=projection)
            texture = array(output, "TextureCoordinates").reshape(21, 40, 2)
            np.testing.assert_allclose(texture[0, :, 0] % 1, (np.arange(100, 260, 4.0) / 360 + 0.5) % 1, atol=1e-5)
            np.testing.assert_allclose(texture[:, 0, 1], np.arange(-40, 44, 4.0) / 180 + 0.5, atol=1e-5)

    def test_the_same_from_cells(self):
        """Heights of cells are placed at the centres of the cells; without poles the globe is closed by rows of their own."""
        output = terrain_of(fields(np.arange(0, 365, 5.0), np.arange(-90, 95, 5.0), on_cells=True), 20)
        x = points(output)
        lon, lat = degrees(x)
        inner = np.abs(lat) < 89
        np.testing.assert_allclose(np.linalg.norm(x, axis=1)[inner], (RADIUS + 20 * np.maximum(hill(lon, lat), 0))[inner], atol=2)
        self.assertEqual((lat.min(), lat.max()), (-90, 90))

    def test_pieces(self):
        whole = terrain_of(globe(), 30)
        terrain = vtkGlobeTerrain()
        terrain.SetInputData(globe())
        terrain.SetLandArrayName("")
        terrain.SetVerticalExaggeration(30)
        for piece in range(3):
            terrain.UpdatePiece(piece, 3, 0)
            part = terrain.GetOutput()
            at = [whole.FindPoint(part.GetPoint(i)) for i in range(part.GetNumberOfPoints())]
            np.testing.assert_array_equal(array(part, "Terrain"), array(whole, "Terrain")[at])
            np.testing.assert_allclose(array(part, "Normals"), array(whole, "Normals")[at], atol=1e-6)

    def test_wrong_input(self):
        deep = globe()
        deep.SetDimensions(72, 37, 2)
        deep.SetZCoordinates(numpy_to_vtk(np.array([0.0, 1.0]), deep=1))
        for name in ("orog",):
            both = numpy_to_vtk(np.tile(vtk_to_numpy(deep.GetPointData().GetArray(name)), 2), deep=1)
            both.SetName(name)
            deep.GetPointData().AddArray(both)
        section = globe()  # one latitude, several levels
        section.SetDimensions(72, 1, 37)
        section.SetYCoordinates(numpy_to_vtk(np.array([0.0]), deep=1))
        section.SetZCoordinates(numpy_to_vtk(np.linspace(1000, 100, 37), deep=1))
        for grid, options, expected in ((section, {}, "one level of longitudes and latitudes"), (globe(), {"HeightArrayName": "topo"}, r"no array 'topo' of the height of the ground; arrays: 'orog'\. .* or read the file on"),
                                        (deep, {}, "one level of longitudes and latitudes")):
            terrain = vtkGlobeTerrain()
            terrain.SetInputData(grid)
            for name, value in options.items():
                getattr(terrain, "Set" + name)(value)
            with Messages() as messages:
                terrain.Update()
                terrain.Update()
            self.assertEqual(len(messages.errors), 1, messages.errors)
            self.assertRegex(messages.errors[0], expected)
            self.assertEqual(terrain.GetOutput().GetNumberOfPoints(), 0)

    def test_forecast(self):
        reader = vtkNetCDFCFReader()
        reader.SetFileName(os.path.join(os.environ["NEPHOSCOPE_DATA"], "gfs_2p5deg_2011101100.nc"))
        reader.UpdateMetaData()
        reader.SetSphericalCoordinates(False)
        reader.SetDimensions("(lat, lon)")
        terrain = vtkGlobeTerrain()
        terrain.SetInputConnection(reader.GetOutputPort())
        terrain.Update()
        scale = array(terrain.GetOutput(), "Terrain")
        lon, lat = degrees(points(terrain.GetOutput()))
        self.assertEqual((scale.min(), round(scale.max(), 1)), (-100, 5635.4))
        tibet = (np.abs(lon - 90) < 2) & (np.abs(lat - 32.5) < 2)
        pacific = (np.abs(np.abs(lon) - 150) < 20) & (np.abs(lat - 40) < 1)
        self.assertGreater(scale[tibet].min(), 4000)
        self.assertLess(scale[pacific].max(), 0)


if __name__ == "__main__":
    unittest.main()

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each bad input gets its own message, which names the cause; nothing crashes."""
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkRectilinearGrid
from vtkmodules.vtkFiltersSources import vtkSphereSource

import globe_fields as gf

LON, LAT, LEV = [0.0, 10.0, 20.0], [0.0, 10.0], [0.0, 1000.0]


class BadInput(unittest.TestCase):
    def setUp(self):
        vtkObject.GlobalWarningDisplayOn()

    def expect(self, grid, text, points=0, **settings):
        made = gf.globe(grid, quiet=False, **settings)
        self.assertTrue(any(text in m for m in made.messages), (text, made.messages))
        if points is not None:
            self.assertEqual(made.GetOutput().GetNumberOfPoints(), points)

    def grid(self, lon=LON, lat=LAT, lev=LEV, **arrays):
        size = len(lon) * len(lat) * len(lev)
        return gf.rectilinear(lon, lat, lev, {n: np.full(size, v) for n, v in arrays.items()})

    def test_types(self):
        sphere = vtkSphereSource()
        sphere.Update()
        self.expect(sphere.GetOutput(), "The input is a surface or points. It must be a grid of longitudes")
        self.expect(vtkRectilinearGrid(), "empty")
        image = vtkImageData()
        image.SetDimensions(3, 3, 3)
        image.SetDirectionMatrix(0, 1, 0, 1, 0, 0, 0, 0, 1)
        self.expect(image, "direction matrix")

    def test_axes(self):
        self.expect(self.grid(lat=[0.0], lev=[0.0]), "fewer than two axes")
        self.expect(self.grid(lat=[0.0, 100.0]), "within -90 to 90")
        self.expect(self.grid(lat=[0.0, 20.0, 10.0, 30.0]), "latitude axis must increase or decrease throughout, but does not at index 2")
        self.expect(self.grid(lat=[0.0, np.nan]), "within -90 to 90")
        self.expect(self.grid(lev=[0.0, 0.0]), "level axis must increase or decrease")
        self.expect(self.grid(lev=[np.nan, 1.0]), "level axis must increase or decrease")
        self.expect(self.grid(lon=[0.0, 10.0, 10.0]), "longitude axis must increase or decrease")
        self.expect(self.grid(lon=np.arange(147) * 2.5), "more than one turn", points=None)

    def test_spherical_coordinates(self):
        x, y, _ = gf.mesh(np.arange(12) * 30.0, np.linspace(-90, 90, 7), [0.0])
        p = gf.frame(x, y)[2]
        for radius, text in ((1.0, "unit sphere"), (1000.0, "Spherical Coordinates")):
            self.expect(gf.structured(*(radius * p.T), (12, 7, 1)), text)

    def test_spherical_coordinates_with_fields_on_cells(self):
        """What ParaView's reader gives as it stands: levels as radii, arrays on the cells between them."""
        x, y, z = gf.mesh(np.arange(13) * 30.0, np.linspace(-90, 90, 7), [100.0, 500.0, 1000.0])
        points = gf.frame(x, y)[2] * z[:, None]
        cells = {name: np.ones(12 * 6 * 2) for name in ("u", "v", "w", "gh", "t")}
        self.expect(gf.add(gf.structured(*points.T, (13, 7, 3)), cells, cells=True), "Spherical Coordinates")

    def test_nan_point(self):
        x, y, z = gf.mesh(LON, LAT, LEV)
        x[4] = np.nan
        self.expect(gf.structured(x, y, z, (3, 2, 2)), "Point 4")

    def test_arrays(self):
        grid = self.grid(east=1.0, north=1.0)
        self.expect(grid, "no wind arrays 'u' and 'v'", points=12)
        self.expect(grid, "east, north", points=12)
        self.expect(self.grid(u=1.0), "'v' is missing")
        self.expect(self.grid(u=1.0, v=1.0), "no vertical wind array 'w'", points=12)
        self.assertEqual(gf.globe(self.grid(u=1.0, v=1.0), VerticalWindArrayName="").messages, [])
        self.expect(self.grid(u=1.0, v=1.0, w=0.0), "array 'zz'", points=12, HeightArrayName="zz")
        self.expect(self.grid(u=1.0, v=1.0, w=0.1, t=15.0), "kelvin", points=12)

    def test_what_a_reader_leaves_that_fails_midway(self):
        grid = self.grid(u=1.0)
        grid.GetPointData().AddArray(gf.array("v", np.ones(5)))
        self.expect(grid, "The array 'v' has 5 values for 12 points")
        grid = gf.add(self.grid(u=1.0), {"c": np.ones(3)}, cells=True)
        self.expect(grid, "The array 'c' has 3 values for 2 cells")
        grid = self.grid(u=1.0)
        grid.SetYCoordinates(gf.array("lat", np.zeros(1)))
        self.expect(grid, "The latitude axis has 1 values for 2 places")
        x, y, z = gf.mesh(LON, LAT, LEV)
        self.expect(gf.structured(x[:7], y[:7], z[:7], (3, 2, 2)), "The grid has 7 values for 12 points")

    def test_fill_values(self):
        """Usual fill values are told with array and number, unless they may be data."""
        size = len(LON) * len(LAT) * len(LEV)
        first = np.arange(size) == 0
        for values, told in ((np.where(first, -999.0, 0.5), "1 values of 'x' are -999"), (np.where(~first, -9999.0, -80.0), f"{size - 1} values of 'x' are -9999"),
                             (np.where(first, -999.0, -600.0), ""), (np.where(first, -998.0, 0.5), ""), (np.full(size, -999.0), "")):
            made = gf.globe(gf.rectilinear(LON, LAT, LEV, {"x": values}), quiet=False)
            told_of = [m for m in made.messages if "fill value" in m]
            self.assertEqual(len(told_of), bool(told), made.messages)
            self.assertTrue(not told or told in told_of[0], told_of)

    def test_settings(self):
        self.expect(self.grid(), "PlanetRadius", PlanetRadius=0.0)
        self.expect(self.grid(), "VerticalExaggeration", VerticalExaggeration=-1.0)

    def test_surface(self):
        pressure = self.grid(lev=[1000.0, 500.0], u=1.0, v=1.0, w=0.0)
        other = self.grid(lat=[5.0, 15.0], lev=[0.0], sp=1e5)
        self.expect(pressure, "not those of the first", points=12, SurfaceData=other)
        self.expect(pressure, "neither 'sp'", points=12, SurfaceData=self.grid(lev=[0.0], x=1.0))
        self.expect(pressure, "surface input is not used", points=12, SurfaceData=self.grid(lev=[0.0], lat=[0.0, 99.0]))
        hectopascal = self.grid(lev=[0.0], sp=700.0)
        out = gf.globe(pressure, SurfaceData=hectopascal).GetOutput()
        np.testing.assert_array_equal(gf.values(out, "BelowGround"), np.repeat([1, 0], 6))


if __name__ == "__main__":
    unittest.main()

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Point and cell arrays of every type follow their place; arrays on cells become point arrays."""
import unittest

import numpy as np
from vtkmodules.vtkCommonCore import vtkBitArray, vtkStringArray

import globe_fields as gf

LON, LAT, LEV = np.arange(12) * 30.0, np.linspace(-90.0, 90.0, 7), np.array([0.0, 1000.0, 3000.0])


class Carry(unittest.TestCase):
    def test_fill_values_become_nan(self):
        x, _, _ = gf.mesh(LON, LAT, LEV)
        for kind in ("f4", "f8"):
            values = (0 * x + 1e20).astype(kind)  # large, as number densities are
            values[5], values[6], values[7] = 9.96921e36, -1e30, np.nan
            out = gf.values(gf.globe(gf.rectilinear(LON, LAT, LEV, {"q": values, "number": np.full(len(x), 2**31 - 1, "i4")})).GetOutput(), "q")
            row = out.reshape(3, 7, 13)[0, 0]
            self.assertEqual(np.isnan(row).nonzero()[0].tolist(), [5, 6, 7])
            self.assertEqual(np.isnan(out).sum(), 3)

    def test_every_type_of_array(self):
        x, y, z = gf.mesh(LON, LAT, LEV)
        ids = np.arange(len(x))
        grid = gf.rectilinear(LON, LAT, LEV, {"int": ids.astype("i4"), "pair": np.column_stack([x, y])})
        text, bits = vtkStringArray(), vtkBitArray()
        text.SetName("text")
        bits.SetName("bits")
        for i in ids:
            text.InsertNextValue(str(i))
            bits.InsertNextValue(int(i) % 3 == 0)
        grid.GetPointData().AddArray(text)
        grid.GetPointData().AddArray(bits)
        grid.GetPointData().SetActiveScalars("int")
        data = gf.globe(grid).GetOutput().GetPointData()
        expected = np.concatenate([ids.reshape(3, 7, 12), ids.reshape(3, 7, 12)[..., :1]], axis=2).ravel()
        np.testing.assert_array_equal(gf.vtk_to_numpy(data.GetArray("int")), expected)
        np.testing.assert_array_equal(gf.vtk_to_numpy(data.GetArray("pair"))[:, 1], y[expected])
        self.assertEqual([data.GetAbstractArray("text").GetValue(i) for i in range(len(expected))], [str(i) for i in expected])
        self.assertEqual([data.GetAbstractArray("bits").GetValue(i) for i in range(len(expected))], [int(i % 3 == 0) for i in expected])
        self.assertEqual(data.GetScalars().GetName(), "int")

    def test_cell_arrays_follow_flips_and_the_seam(self):
        cells = np.arange(11 * 6 * 2).reshape(2, 6, 11)
        for flip_lat in (False, True):
            lat = LAT[::-1] if flip_lat else LAT
            grid = gf.rectilinear(LON, lat, LEV, {"keep": np.zeros(12 * 7 * 3)})
            gf.add(grid, {"c": (cells[:, ::-1] if flip_lat else cells).ravel()}, cells=True)
            out = gf.globe(grid).GetOutput()
            got = gf.values(out, "c", cells=True).reshape(2, 6, 12)
            np.testing.assert_array_equal(got[..., :11], cells)
            np.testing.assert_array_equal(got[..., 11], cells[..., 10])  # seam: western neighbour

    def test_cells_become_points_at_their_centres(self):
        edges_lon, edges_lat, edges_lev = np.arange(13) * 30.0 - 15.0, np.linspace(-90, 90, 7), np.array([0.0, 2000, 6000])
        x, y, z = gf.mesh(LON, edges_lat[:-1] + 15.0, [1000.0, 4000.0])
        arrays = {"u": 0 * x + 3.0, "v": 0 * x, "w": 0 * x, "x": x, "y": y, "z": z}
        flat = gf.rectilinear(edges_lon, edges_lat, edges_lev)
        corners = gf.structured(*gf.mesh(edges_lon, edges_lat, edges_lev), (13, 7, 3))
        for grid in (flat, corners):
            out = gf.globe(gf.add(grid, arrays, cells=True), ClosePoles=False).GetOutput()
            self.assertEqual(gf.dimensions(out), (13, 6, 2))  # 12 centres, closed
            place = gf.frame(gf.values(out, "x"), gf.values(out, "y"))[2]
            expected = place * (gf.RADIUS + gf.values(out, "z"))[:, None]
            np.testing.assert_allclose(gf.points(out), expected, atol=1e-5)
            self.assertIsNotNone(out.GetPointData().GetArray("DisplayVelocity"))


if __name__ == "__main__":
    unittest.main()

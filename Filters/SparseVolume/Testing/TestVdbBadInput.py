# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Each bad input gets a message that names the file, the grid or the array, and the remedy; nothing crashes."""
import os
import unittest

import nephoscope
import numpy as np
import vdb_files as vf
from vdb_files import VdbTestCase
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData, vtkRectilinearGrid
from vtkmodules.vtkFiltersSources import vtkSphereSource


@unittest.skipIf(vf.HAS_OPENVDB, "this build has OpenVDB")
class WithoutOpenVDB(VdbTestCase):
    def test_remedy(self):
        with open(self.path, "wb") as file:
            file.write(b" BDV\0\0\0\0")
        self.read(expect=["libopenvdb-dev"])
        self.write(vf.image({"s": np.ones(8, "f4")}, (2, 2, 2)), expect=["libopenvdb-dev"])


class NoFile(VdbTestCase):
    def test_no_such_file(self):
        self.read(expect=["There is no file"])
        self.read(lambda r: r.SetFileName(""), expect=["SetFileName"])
        self.read(path=self.folder, expect=["There is no file"])

    def test_another_format(self):
        with open(self.path, "w") as file:
            file.write("<VTKFile>")
        self.read(expect=["is not a .vdb file"])
        self.assertFalse(nephoscope.vtkSparseVolumeReader.CanReadFile(self.path))


@unittest.skipUnless(vf.HAS_OPENVDB, "this build has no OpenVDB")
class BadFiles(VdbTestCase):
    def test_truncated_anywhere(self):
        """An error each time, and no crash."""
        values = np.random.default_rng(1).random(20 ** 3).astype("f4")
        self.write(vf.image({"s": values}, (20, 20, 20)))
        with open(self.path, "rb") as file:
            whole = file.read()
        short = os.path.join(self.folder, "short.vdb")
        for length in list(range(8, len(whole), max(1, len(whole) // 40))) + [len(whole) - 1]:
            with open(short, "wb") as file:
                file.write(whole[:length])
            out = self.read(path=short, expect=["short.vdb"])
            self.assertTrue(out is None or out.GetNumberOfPoints() == 0, length)

    def test_grid_that_is_not_there(self):
        self.write(vf.image({"s": np.ones(8, "f4")}, (2, 2, 2)))
        choose = lambda r: (r.UpdateInformation(), r.GetGridSelection().EnableArray("rain"))
        self.assertEqual(self.read(choose, ["no grid 'rain'. There are: 's'"]).GetNumberOfPoints(), 8)
        none = lambda r: (r.UpdateInformation(), r.GetGridSelection().DisableAllArrays())
        self.read(none, ["No grid of", "'s'"])

    def test_name_of_many_bytes(self):
        """Bytes that are damaged can give a name of gigabytes, which no message can hold."""
        self.write(vf.image({"s" * 5000: np.ones(8, "f4")}, (2, 2, 2)))
        self.read(expect=["its name has 5000 bytes, more than 1000; the file may be damaged", "ss...' is left out", "No grid of"])

    def test_too_large(self):
        data = vf.particles([[0, 0, 0], [1e6, 1e6, 1e6]])
        self.write(data, lambda w: w.SetVoxelSize(1))
        out = self.read(as_image=True, expect=["bytes", "MemoryLimit"])
        self.assertEqual(out.GetNumberOfPoints(), 0)
        self.assertEqual(self.read().GetNumberOfPoints(), 2)
        self.read(lambda r: r.SetMemoryLimit(1e-9), expect=["2 points would need 72 bytes"])

    def test_no_active_voxels(self):
        self.write(vf.image({"s": np.zeros(8, "f4")}, (2, 2, 2)), expect=["has no active voxels"])
        self.assertEqual(self.read(expect=["has no active voxels"]).GetNumberOfPoints(), 0)


@unittest.skipUnless(vf.HAS_OPENVDB, "this build has no OpenVDB")
class BadData(VdbTestCase):
    def refused(self, data, *parts, setup=lambda w: None):
        self.write(data, setup, expect=parts)
        self.assertFalse(os.path.exists(self.path))

    def test_kinds(self):
        sphere = vtkSphereSource()
        sphere.Update()
        self.refused(sphere.GetOutput(), "other cells than vertices")
        grid = vtkRectilinearGrid()
        grid.SetDimensions(2, 2, 2)
        for axis in "XYZ":
            coordinates = vf.numpy_to_vtk(np.array([0.0, 1.0]), deep=True)
            getattr(grid, f"Set{axis}Coordinates")(coordinates)
        self.refused(grid, "vtkRectilinearGrid")

    def test_empty(self):
        self.refused(vtkImageData(), "has no points")
        self.refused(vtkPolyData(), "has no points")
        self.refused(vf.image({}, (2, 2, 2)), "no arrays")

    def test_arrays(self):
        data = vf.image({"s": np.ones(8, "f4"), "two": np.ones((8, 2))}, (2, 2, 2))
        self.refused(data, "no array 'rain'", setup=lambda w: w.AddArrayName("rain"))
        self.write(data, expect=["'two' is left out: it has 2 components"])
        self.assertEqual(self.read().GetPointData().GetNumberOfArrays(), 1)
        os.remove(self.path)
        data = vf.image({"a": np.ones(8, "f4"), "b": np.ones(8, "f4")}, (2, 2, 2))
        self.refused(data, "Two grids would have the name 'a'", setup=lambda w: w.SetGridName("b", "a"))
        self.refused(vf.particles([[0, 0, 0]]), "no point array 'm'", setup=lambda w: w.SetMassArrayName("m"))

    def test_not_finite(self):
        values = np.ones(8, "f4")
        values[:2] = np.nan, np.inf
        self.write(vf.image({"s": values}, (2, 2, 2)), expect=["'s' has 2 values that are NaN or infinite"])
        self.assertEqual(self.read().GetNumberOfPoints(), 6)
        places = np.array([[0, 0, 0], [np.nan, 0, 0], [1, 0, 0]])
        self.write(vf.particles(places, {"m": np.array([1.0, 1, -1])}), lambda w: w.SetMassArrayName("m"),
                   expect=["2 particles are left out"])
        self.refused_again()

    def refused_again(self):
        os.remove(self.path)
        self.refused(vf.particles([[np.nan, 0, 0]]), "no particles with a finite position")
        for spacing in (1e-9, 0):
            self.refused(vf.image({"s": np.ones(8)}, (2, 2, 2), spacing=(spacing,) * 3), "OpenVDB rejects these voxels", "Scale the data")
        self.refused(vf.particles([[1e12, 0, 0], [0, 0, 0]]), "VoxelSize", setup=lambda w: w.SetVoxelSize(1e-3))

    def test_place(self):
        data = vf.image({"s": np.ones(8, "f4")}, (2, 2, 2))
        self.write(data, path=os.path.join(self.folder, "none", "x.vdb"), expect=["cannot be written"])
        self.write(data, lambda w: w.SetFileName(""), expect=["SetFileName"])
        os.mkdir(self.path)
        self.write(data, expect=["cannot be written"])


if __name__ == "__main__":
    unittest.main()

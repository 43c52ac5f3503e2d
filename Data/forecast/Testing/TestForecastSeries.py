# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The file of a series: what VTK reads of it is what the forecast has; the small one of Data/ can be made again; runs go on."""
import hashlib
import os
import subprocess
import sys
import tempfile
import unittest

import forecast_modules
import numpy as np
from forecast import gfs, model, series
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader

ANALYSIS = os.path.join(forecast_modules.DATA, "gfs_2p5deg_2011101100.nc")
SMALL = os.path.join(forecast_modules.DATA, "forecast_10deg_6h.nc")
SCRIPT = os.path.join(forecast_modules.DATA, "forecast", "make_forecast.py")
LEVELS = [850, 500, 250]


def reader(path, dimensions="(lev, lat, lon)"):
    made = vtkNetCDFCFReader()
    made.SetFileName(path)
    made.UpdateMetaData()
    made.SphericalCoordinatesOff()
    made.SetDimensions(dimensions)
    made.SetOutputType(3)  # VTK_RECTILINEAR_GRID
    made.UpdateInformation()
    return made


def times(made):
    return made.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS())


def fields(made, time):
    made.UpdateTimeStep(time)
    grid = made.GetOutput()
    data = grid.GetPointData()
    arrays = (data.GetArray(i) for i in range(data.GetNumberOfArrays()))
    return {a.GetName(): vtk_to_numpy(a).astype(float).reshape(grid.GetDimensions()[::-1]) for a in arrays}


def content(path):
    with open(path, "rb") as file:
        return file.read()


class Interrupted(Exception):
    pass


class Series(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.analysis = gfs.Analysis(ANALYSIS)

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "series.nc")

    def series(self, hours=3, layout=None, **settings):
        layout = layout or model.even_layout(36, 19, LEVELS, 15, refinement=2)
        return series.Series(self.path, layout, hours, **settings)

    def make(self, made, stop_after=None):
        """Interrupted after so many hours, if at all."""
        def report(line):
            if stop_after and line.startswith("hour %d " % stop_after):
                raise Interrupted
        made.make(self.analysis, report)

    def test_read_by_vtk(self):
        made = self.series()
        self.make(made)
        again = model.Forecast(made.layout)
        again.start(self.analysis)
        read = reader(self.path)
        self.assertEqual(times(read), tuple(self.analysis.time + hour for hour in range(4)))
        for hour in range(4):
            seen = fields(read, self.analysis.time + hour)
            for name, values in again.fields().items():
                np.testing.assert_allclose(seen[name], values.transpose(2, 1, 0), rtol=1e-6, atol=1e-6)
            again.advance_one_hour()
        self.assertGreater(seen["gh"].max(), 10000.0)  # a field without time comes along
        grid = read.GetOutput()
        np.testing.assert_allclose(vtk_to_numpy(grid.GetYCoordinates()), np.linspace(-90, 90, 19), atol=1e-12)
        np.testing.assert_allclose(vtk_to_numpy(grid.GetXCoordinates()), np.arange(36) * 10.0, atol=1e-12)
        self.assertEqual(sorted(fields(reader(self.path, "(lat, lon)"), self.analysis.time)), ["orog", "sp"])

    def test_gaussian_rows(self):
        self.make(self.series(1, model.gaussian_layout(48, 24, LEVELS, 15)))
        read = reader(self.path)
        fields(read, self.analysis.time)
        latitudes = vtk_to_numpy(read.GetOutput().GetYCoordinates())
        np.testing.assert_allclose(np.sin(np.radians(latitudes)), np.polynomial.legendre.leggauss(24)[0], atol=1e-12)

    def test_goes_on_to_the_last_bit(self):
        self.make(self.series())
        whole = content(self.path)
        os.remove(self.path)
        with self.assertRaises(Interrupted):
            self.make(self.series(), stop_after=2)
        self.assertFalse(os.path.exists(self.path))
        self.make(self.series())
        self.assertEqual(content(self.path), whole)
        self.assertEqual(os.listdir(os.path.dirname(self.path)), ["series.nc"])

    def test_other_settings_start_anew(self):
        with self.assertRaises(Interrupted):
            self.make(self.series(hold=3), stop_after=2)
        self.make(self.series())
        other = content(self.path)
        self.make(self.series())
        self.assertEqual(content(self.path), other)

    def test_clouds_keep_their_areas(self):
        """The part of the sphere with more than 15 % cloud, at every level and hour, in what is written."""
        made = self.series(6, model.even_layout(144, 73, LEVELS, 42, refinement=1), names=("cloud_fraction",))
        self.make(made)
        weight = np.cos(np.radians(np.linspace(-90, 90, 73)))[None, :, None] / 144.0
        read, areas, means = reader(self.path), [], []
        for hour in range(7):
            cloud = fields(read, self.analysis.time + hour)["cloud_fraction"]
            areas.append(((cloud > 0.15) * weight).sum(axis=(1, 2)) / weight.sum() / 144.0)
            means.append((cloud * weight).sum(axis=(1, 2)) / weight.sum() / 144.0)
            self.assertTrue(0.0 <= cloud.min() and cloud.max() <= 1.0)
        areas, means = np.array(areas), np.array(means)
        print("6 h: area of more than 15 %% cloud changes by at most %.1e of itself, the mean by %.1e" % (
            abs(areas / areas[0] - 1.0).max(), abs(means / means[0] - 1.0).max()))
        self.assertLess(abs(areas / areas[0] - 1.0).max(), 0.01)
        self.assertLess(abs(means / means[0] - 1.0).max(), 0.01)
        self.assertGreater(abs(fields(read, self.analysis.time + 6)["cloud_fraction"] - fields(read, self.analysis.time)["cloud_fraction"]).max(), 0.5)

    def test_small_series(self):
        """That of Data/ is what its command makes, but for roundings to whole numbers of another machine."""
        with open(os.path.join(forecast_modules.DATA, "SHA256SUMS"), encoding="utf-8") as sums:
            listed = dict(reversed(line.split()) for line in sums)
        self.assertEqual(hashlib.sha256(content(SMALL)).hexdigest(), listed[os.path.basename(SMALL)])
        self.assertLess(os.path.getsize(SMALL), 200000)
        run = subprocess.run([sys.executable, SCRIPT, self.path, "--grid", "test"], capture_output=True, text=True, check=True)
        self.assertIn("hour 6 of 6", run.stdout)
        print("equal bit for bit" if content(SMALL) == content(self.path) else "not equal bit for bit")
        made, kept = reader(self.path), reader(SMALL)
        self.assertEqual(times(made), times(kept))
        for time in times(kept):
            a, b = fields(made, time), fields(kept, time)
            for name, step in (("u", 0.01), ("v", 0.01), ("w", 0.001), ("cloud_fraction", 0.01), ("gh", 1.0)):
                self.assertLessEqual(abs(a[name] - b[name]).max(), 1.01 * step)

    def test_wrong_number_of_hours(self):
        run = subprocess.run([sys.executable, SCRIPT, self.path, "--hours", "0"], capture_output=True, text=True)
        self.assertNotEqual(run.returncode, 0)
        self.assertIn("--hours must be at least 1", run.stderr)


if __name__ == "__main__":
    unittest.main()

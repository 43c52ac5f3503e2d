# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package without PyVista: complete, light, and clear about what it lacks."""
import ast
import contextlib
import hashlib
import importlib.metadata
import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path
from unittest import mock

import nephoscope
from nephoscope._modules import FROM_PYPI as IN_WHEEL

SOURCE = Path(os.environ["NEPHOSCOPE_DATA"]).parent
WITHOUT_PYVISTA = """
import sys
class Absent:
    def find_spec(self, name, path=None, target=None):
        if name.split(".")[0] == "pyvista":
            raise ModuleNotFoundError("No module named 'pyvista'", name="pyvista")
sys.meta_path.insert(0, Absent())
import nephoscope
"""


def declared_classes():
    """Classes that the headers of the module folders declare and export, other than those for C++ alone."""
    pattern = re.compile(r"class\s+VTKNEPHOSCOPE\w+_EXPORT\s+(vtk\w+)")
    headers = [header for kind in ("Filters", "Representations") for module in SOURCE.glob(f"{kind}/*/vtk.module")
               if "EXCLUDE_WRAP" not in module.read_text() for header in module.parent.rglob("*.h")
               if not {"ParaView", "Testing"} & set(header.relative_to(module.parent).parts) and module.parent != SOURCE / "Representations" / "Common"]
    return {name for header in headers for name in pattern.findall(header.read_text())}


def run(code, interpreter=sys.executable):
    return subprocess.run([interpreter, "-c", code], capture_output=True, text=True)


class Package(unittest.TestCase):
    def test_every_declared_class_is_wrapped(self):
        self.assertIn("vtkGlobeGrid", declared_classes())
        wrapped = {name for name in nephoscope.__all__ if name.startswith("vtk")}
        self.assertEqual(declared_classes(), wrapped)
        bases = {base.__name__ for name in wrapped for base in getattr(nephoscope, name).__mro__[1:]}
        for name in wrapped:
            try:
                self.assertEqual(getattr(nephoscope, name)().GetClassName(), name)
            except TypeError as error:  # of an abstract class
                self.assertIn(name, bases, error)

    def test_import_brings_neither_pyvista_nor_numpy(self):
        heavy = "print(sorted({'pyvista', 'numpy', 'matplotlib'} & set(sys.modules)))"
        vtk = run("import sys, vtkmodules.vtkRenderingVolume; " + heavy)  # VTK 9.6 brings numpy by itself
        result = run("import sys, nephoscope; " + heavy)
        self.assertNotIn("pyvista", result.stdout)
        self.assertEqual(result.stdout, vtk.stdout, result.stderr)

    def test_functions_are_listed_without_pyvista(self):
        self.assertLessEqual({"add_cells", "to_globe", "read_cf", "globe_surface"}, set(dir(nephoscope)))

    def test_star(self):
        """It brings the functions where PyVista is installed, and works where it is not."""
        ask = "from nephoscope import *\nprint('vtkGlobeGrid' in dir(), 'add_cells' in dir())"
        result = run(WITHOUT_PYVISTA + ask)
        self.assertIn("True False", result.stdout, result.stderr)
        if importlib.util.find_spec("pyvista") is not None:
            result = run(ask)
            self.assertIn("True True", result.stdout, result.stderr)

    def test_missing_pyvista_is_said_with_the_remedy(self):
        result = run(WITHOUT_PYVISTA + "nephoscope.vtkGlobeGrid()\nnephoscope.add_cells")
        self.assertIn("nephoscope.add_cells needs PyVista", result.stderr)
        remedy = "-m pip install pyvista" if IN_WHEEL else "-m pip install --no-deps -r \\S*Plugins/PyVista/requirements.txt"
        self.assertRegex(result.stderr, remedy)

    @unittest.skipIf(IN_WHEEL, "a wheel has a remedy of its own")
    def test_missing_pyvista_of_a_debian_package(self):
        """The remedy names the installed file, and a virtual environment, since Debian's Python takes no packages from pip."""
        result = run(WITHOUT_PYVISTA + "from nephoscope import samples\nsamples.shared = '/usr/share/nephoscope/{}'.format\nnephoscope.add_cells")
        self.assertIn("-m venv --system-site-packages", result.stderr)
        self.assertIn("--no-deps -r /usr/share/nephoscope/requirements.txt", result.stderr)

    @unittest.skipIf(IN_WHEEL, "a wheel has a remedy of its own")
    def test_missing_weather_packages(self):
        """The reader in ParaView names the packages of the file's format, requirement files that are there (those of the source, or of the Debian package), and ParaView's own reader."""
        weather = nephoscope.sample_data("gfs_2p5deg_2011101100.nc")
        ask = ("from nephoscope import samples\nsamples.shared = {}\nfrom nephoscope.weather import paraview_plugin\n"
               "print(paraview_plugin.missing_packages('{}', {!r}), paraview_plugin.MADE == samples.OWN_PYTHON)")
        bare = Path(self.enterContext(tempfile.TemporaryDirectory()), "python")
        bare.write_text("#!/bin/sh\nexec /usr/bin/python3 -I -S \"$@\"\n")  # without packages
        bare.chmod(0o755)
        own = run(ask.format("samples.shared", bare, weather)).stdout
        self.assertRegex(own, r"packages for NetCDF that .* does not have: nephoscope, pyvista, xarray, netCDF4\. ParaView can draw this file without them: .*'netCDF files generic and CF "
                              r"conventions'.*Spherical Coordinates off.*Globe Grid")
        files = "-r {0}requirements.txt -r {0}requirements-netcdf.txt"
        self.assertRegex(own, f"{bare} -m pip install --no-deps " + files.format("\\S*Plugins/PyVista/") + "\n")
        debian = run(ask.format("'/usr/share/nephoscope/{}'.format", bare, weather)).stdout
        self.assertIn("nephoscope-python/bin/python -m pip install --no-deps " + files.format("/usr/share/nephoscope/") + "\n", debian)
        self.assertIn("apt install python3-venv && python3 -m venv --system-site-packages ~/nephoscope-python", debian)
        self.assertTrue(debian.endswith("True\n"), debian)
        grib = bare.with_name("a.grib2")
        grib.write_bytes(b"GRIB\0\0\0\2" + bytes(99))
        told = run(ask.format("samples.shared", bare, str(grib))).stdout
        self.assertRegex(told, "for GRIB .* nephoscope, pyvista, xarray, eccodes.*requirements-grib.txt\n")
        self.assertNotIn("can draw this file", told)

    @unittest.skipIf(IN_WHEEL, "no requirement files")
    def test_requirements_of_formats(self):
        """The files of the formats are in that of all, and every package has one version."""
        folder = Path(__file__).resolve().parent.parent
        lines = {path.stem: [line for line in path.read_text().splitlines() if line and line[0] != "#"] for path in folder.glob("requirements-*.txt")}
        self.assertLess(len(lines["requirements-netcdf"]), 10)
        self.assertLessEqual({"-r requirements-grib.txt", "-r requirements-zarr.txt"}, {*lines["requirements-data"]})
        named = [line for name in ("data", "grib", "netcdf", "zarr") for line in lines[f"requirements-{name}"] if not line.startswith("-r ")]
        self.assertEqual(len(named), len({*named}))

    def test_help_of_the_command_needs_no_pyvista(self):
        start = WITHOUT_PYVISTA + "import runpy, sys\nsys.argv = ['nephoscope-viewer', {!r}]\nrunpy.run_module('nephoscope', run_name='__main__')"
        self.assertIn("--technique", run(start.format("--help")).stdout)
        self.assertRegex(run(start.format("x.nc")).stderr, "^nephoscope-viewer: nephoscope.viewer needs PyVista[^\n]*\n$")

    def test_pyvista_without_accessors(self):
        if importlib.util.find_spec("pyvista") is not None:
            result = run("import pyvista, nephoscope\ndel pyvista.register_dataset_accessor\nnephoscope.add_cells, nephoscope.add_splats")
            self.assertEqual(result.stderr.count("has no accessors"), 1, result.stderr)

    def test_sample_data(self):
        """They need no PyVista, and are the files that Data has checksums of."""
        sums = dict(line.split()[::-1] for line in Path(os.environ["NEPHOSCOPE_DATA"], "SHA256SUMS").read_text().splitlines())
        for name in ("gfs_2p5deg_2011101100.nc", "forecast_10deg_6h.nc", "blue_marble_2048.jpg"):
            result = run(WITHOUT_PYVISTA + f"print(repr(nephoscope.sample_data({name!r})))")
            self.assertEqual(result.returncode, 0, result.stderr)
            path = ast.literal_eval(result.stdout)
            self.assertIsInstance(path, str)
            self.assertEqual(hashlib.sha256(Path(path).read_bytes()).hexdigest(), sums[name])

    def test_the_command_takes_the_name_of_a_sample(self):
        """A file of that name in the current folder comes first."""
        from nephoscope import __main__
        folder = self.enterContext(tempfile.TemporaryDirectory())
        self.enterContext(contextlib.chdir(folder))
        name = "forecast_10deg_6h.nc"
        for expected in (nephoscope.sample_data(name), name):
            viewer = mock.Mock()
            with mock.patch.dict(vars(nephoscope), viewer=viewer):
                self.assertEqual(__main__.main([name]), 0)
            self.assertEqual(viewer.call_args.args, (expected,))
            Path(name).touch()

    def test_sample_data_of_another_name(self):
        for name in ("SHA256SUMS", "../copyright", "", None):
            with self.assertRaisesRegex(ValueError, "^There are no sample data .*[.] There are: 'gfs_2p5deg_2011101100.nc', 'forecast_10deg_6h.nc', 'blue_marble_2048.jpg'[.]$"):
                nephoscope.sample_data(name)

    def test_unknown_name_is_an_attribute_error(self):
        with self.assertRaisesRegex(AttributeError, "vtkNoSuchClass"):
            nephoscope.vtkNoSuchClass

    def test_metadata(self):
        self.assertEqual(importlib.metadata.version("nephoscope"), nephoscope.__version__)
        points = [p.value for p in importlib.metadata.entry_points(group="pyvista.accessors") if p.name == "nephoscope"]
        self.assertEqual(points, ["nephoscope.accessor"])

    @unittest.skipIf(IN_WHEEL or not shutil.which("pvpython"), "no pvpython, or one with another VTK than the wheel's")
    def test_pvpython(self):
        script = Path(os.environ["NEPHOSCOPE_TEST_OUTPUT"]) / "TestPackagePvpython.py"
        script.write_text("import sys, nephoscope\nprint(nephoscope.vtkGlobeGrid().GetClassName(), 'pyvista' in sys.modules)\n")
        result = subprocess.run(["pvpython", "--dr", str(script)], capture_output=True, text=True)
        self.assertIn("vtkGlobeGrid False", result.stdout, result.stderr)


if __name__ == "__main__":
    unittest.main()

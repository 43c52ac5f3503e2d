# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The accessor is there whichever package is imported first, and without importing nephoscope at all."""
import inspect
import subprocess
import sys
import unittest
from pathlib import Path

import nephoscope
import pyvista
from nephoscope._modules import FROM_PYPI

GRID = "mesh = pyvista.RectilinearGrid([0, 1.0], [0, 1.0], [0, 1.0]); "


class Order(unittest.TestCase):
    def accessor_of(self, imports):
        code = imports + "; " + GRID + "print(type(mesh.nephoscope).__name__)"
        result = subprocess.run([sys.executable, "-W", "error", "-c", code], capture_output=True, text=True)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout.strip()

    def test_pyvista_first(self):
        self.assertEqual(self.accessor_of("import pyvista, nephoscope"), "NephoscopeAccessor")

    def test_nephoscope_first(self):
        self.assertEqual(self.accessor_of("import nephoscope, pyvista"), "NephoscopeAccessor")

    def test_pyvista_alone(self):
        self.assertEqual(self.accessor_of("import pyvista"), "NephoscopeAccessor")

    def test_function_before_pyvista(self):
        self.assertEqual(self.accessor_of("import nephoscope; nephoscope.add_cells; import pyvista"), "NephoscopeAccessor")

    def test_older_pyvista_has_no_accessor_and_no_error(self):
        code = ("import pyvista; del pyvista.register_dataset_accessor; import nephoscope; nephoscope.to_globe; print('ok')")
        result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        self.assertEqual(result.stdout.strip(), "ok", result.stderr)


class Methods(unittest.TestCase):
    def test_signature_and_documentation_are_those_of_the_function(self):
        method = pyvista.ImageData(dimensions=(2, 2, 2)).nephoscope.globe
        expected = list(inspect.signature(nephoscope.to_globe).parameters)[1:]
        self.assertEqual(list(inspect.signature(method).parameters), expected)
        self.assertEqual(method.__doc__, nephoscope.to_globe.__doc__)

    def test_what_else_draws_is_told(self):
        mesh = pyvista.ImageData(dimensions=(2, 2, 2))
        for call, words in ((lambda: mesh.nephoscope.plot("T"), r"no attribute 'plot'.*nephoscope.add_cells\(plotter, mesh, ...\)"),
                            (lambda: mesh.nephoscope.add_splats(), r"nephoscope.add_splats\(plotter, mesh, ...\)"),
                            (lambda: nephoscope.plot, r"no attribute 'plot'.*nephoscope.open\(path\).nephoscope.plot\(...\).*nephoscope.add_cells"),
                            (lambda: nephoscope.describe, r"described by nephoscope.open\(path\).nephoscope.describe\(\)"),
                            (lambda: mesh.nephoscope.nothing, "'NephoscopeAccessor' object has no attribute 'nothing'$")):
            self.assertRaisesRegex(AttributeError, words, call)

    def test_one_vtk_in_the_process(self):
        maps = Path("/proc/self/maps").read_text().splitlines()
        libraries = {line.split()[-1] for line in maps if "libvtkCommonCore" in line}
        self.assertEqual(len(libraries), 1, libraries)
        installed_by_pip = list(Path(sys.prefix).glob("lib/python3*/site-packages/vtkmodules"))
        if FROM_PYPI:
            self.assertEqual([str(Path(library).parent) for library in libraries], list(map(str, installed_by_pip)))
        else:
            self.assertFalse(installed_by_pip, "pip installed a VTK of its own")


if __name__ == "__main__":
    unittest.main()

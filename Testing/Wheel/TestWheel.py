# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The wheel as pip installed it: all that belongs in it is there, nothing of the machine it was made on, and it runs on other systems.

The environment variable WHEEL names the file.
"""
import ast
import importlib.metadata
import os
import re
import subprocess
import sys
import tempfile
import unittest
import zipfile
from pathlib import Path

import nephoscope
from nephoscope import _modules

PACKAGE = Path(nephoscope.__file__).parent
TOP = Path(__file__).resolve().parents[2]
LIBRARIES = sorted(PACKAGE.glob("*.so"))


def output(*command):
    return subprocess.run(list(map(str, command)), check=True, capture_output=True, text=True).stdout


class Wheel(unittest.TestCase):
    def test_it_is_the_wheel(self):
        self.assertTrue(PACKAGE.is_relative_to(sys.prefix), PACKAGE)
        self.assertTrue(_modules.FROM_PYPI)
        self.assertGreater(len(LIBRARIES), 20)

    def test_metadata(self):
        metadata = importlib.metadata.metadata("nephoscope")
        self.assertEqual(metadata["License-Expression"], "BSD-3-Clause AND MPL-2.0 AND Apache-2.0 AND BSD-2-Clause AND MIT")
        self.assertIn(f"vtk=={_modules.VTK_VERSION}", metadata.get_all("Requires-Dist"))
        self.assertIn("Typing :: Typed", metadata.get_all("Classifier"))
        self.assertIn("pip install 'nephoscope[pyvista]'", metadata.get_payload())
        files = {str(file) for file in importlib.metadata.files("nephoscope")}
        licence = next(file for file in files if file.endswith(".dist-info/licenses/LICENSE"))
        licences = {Path(file).name for file in files if "/licenses/" in file}
        self.assertEqual(set(metadata.get_all("License-File")), licences)
        self.assertEqual((PACKAGE.parent / licence).read_text(), (TOP / "LICENSE").read_text())

    def test_sample_data_are_in_it_and_it_stays_small(self):
        for name in ("gfs_2p5deg_2011101100.nc", "blue_marble_2048.jpg"):
            self.assertEqual((PACKAGE / "data" / name).read_bytes(), (TOP / "Data" / name).read_bytes())
            self.assertEqual(nephoscope.sample_data(name), str(PACKAGE.resolve() / "data" / name))
        self.assertLess(Path(os.environ["WHEEL"]).stat().st_size, 25e6)

    def test_pip_finds_nothing_missing(self):
        self.assertIn("No broken requirements", output(sys.executable, "-m", "pip", "check"))

    def test_openvdb_is_in_it_and_keeps_to_itself(self):
        self.assertTrue(nephoscope.vtkSparseVolumeReader.HasOpenVDB())
        library = PACKAGE / "libvtkNephoscopeFiltersSparseVolume.so"
        exported = [line for line in output("readelf", "--dyn-syms", "-W", "-C", library).splitlines()
                    if " UND " not in line and re.search(r"\b(tbb::|blosc_|LZ4_)", line)]
        self.assertEqual(exported, [])
        foreign = [line for line in output("readelf", "--dyn-syms", "-W", library).splitlines() if "7openvdb" in line and "nephoscope" not in line]
        self.assertEqual(foreign, [])

    def test_stubs(self):
        self.assertTrue((PACKAGE / "py.typed").is_file())
        stubs = {stub.stem: ast.parse(stub.read_text()) for stub in PACKAGE.glob("*.pyi")}
        self.assertEqual(set(stubs), {"__init__", *_modules.MODULES})
        methods = {node.name: {item.name for item in node.body if isinstance(item, ast.FunctionDef)}
                   for stub in stubs.values() for node in stub.body if isinstance(node, ast.ClassDef)}
        exported = {alias.name for node in stubs["__init__"].body if isinstance(node, ast.ImportFrom) for alias in node.names}
        for name in nephoscope.__all__:
            self.assertIn(name, exported)
            if name.startswith("vtk"):
                self.assertGreater(len(methods[name]), 3, name)
        self.assertIn("SetMethod", methods["vtkCellCompositingMapper"])
        namespace = {}
        exec(next(line for line in (PACKAGE / "__init__.pyi").read_text().splitlines() if line.startswith("__all__")), namespace)
        self.assertEqual(namespace["__all__"], sorted(nephoscope.__all__))
        for name, stub in stubs.items():  # each class that a stub names is its own, or has its module before it
            own = {node.name for node in ast.walk(stub) if isinstance(node, ast.ClassDef)}
            self.assertEqual(set(re.findall(r"'(vtk\w+|getset\w+)'", (PACKAGE / f"{name}.pyi").read_text())) - own - set(nephoscope.__all__), set(), name)

    def test_libraries_find_vtk_beside_them(self):
        for library in LIBRARIES:
            paths = re.search(r"R(?:UN)?PATH.*\[(.*)\]", output("readelf", "-d", library))[1].split(":")
            self.assertEqual(set(paths), {"$ORIGIN", "$ORIGIN/../vtkmodules"}, library)

    def test_nothing_of_the_build(self):
        for library in LIBRARIES:
            with self.subTest(library=library.name):
                self.assertNotIn(".symtab", output("readelf", "-S", "-W", library))
                named = re.findall(rb"[ -~]*%b[ -~]*" % re.escape(os.fsencode(TOP)), library.read_bytes())
                self.assertEqual(named[:3], [])

    def test_it_runs_on_the_systems_of_its_tag(self):
        """auditwheel's verdict on the symbols, and that no library is missing but VTK's, which its wheel has."""
        wheel = Path(os.environ["WHEEL"])
        tag = re.search(r"manylinux_\d+_\d+_x86_64", wheel.name)[0]
        told = re.sub(r"\s+", " ", output(sys.executable, "-m", "auditwheel", "show", wheel))
        self.assertIn(f'This constrains the platform tag to "{tag}"', told)
        with tempfile.TemporaryDirectory() as folder:
            output(sys.executable, "-m", "auditwheel", "repair", "--exclude", "libvtk*.so", "--plat", tag, "--only-plat", "-w", folder, wheel)
            with zipfile.ZipFile(next(Path(folder).glob(f"*-{tag}.whl"))) as repaired, zipfile.ZipFile(wheel) as made:
                self.assertEqual({name for name in repaired.namelist() if name[-1] != "/"}, set(made.namelist()))


if __name__ == "__main__":
    unittest.main()

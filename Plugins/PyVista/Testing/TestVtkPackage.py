# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The package installed by pip refuses a VTK that it was not built for, and says what to do. Every VTK here is a fake of Python alone."""
import subprocess
import sys
import tempfile
import textwrap
import unittest
from pathlib import Path

PACKAGE = Path(__file__).resolve().parents[1] / "nephoscope"
MODULES = 'MODULES = ()\nVERSION = "0.1.0"\nFROM_PYPI = {}\nVTK_VERSION = "9.6.2"\nVTK_MODULES = ("vtkRenderingCore",)\n'


class VtkPackage(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.installed(True)

    def installed(self, from_pypi):
        """The package as a wheel has it, or as the build tree does, without compiled modules."""
        for source in PACKAGE.glob("*.py"):
            self.write(f"site/nephoscope/{source.name}", source.read_text())
        self.write("site/nephoscope/_modules.py", MODULES.format(from_pypi))

    def write(self, name, text=""):
        path = self.folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(textwrap.dedent(text))

    def vtk(self, version, site="site", library="libvtkCommonCore.so"):
        self.write(f"{site}/vtkmodules/__init__.py")
        self.write(f"{site}/vtkmodules/{library}")
        self.write(f"{site}/vtkmodules/vtkRenderingCore.py", "print('libraries of VTK loaded')")
        self.write(f"{site}/vtkmodules/vtkCommonCore.py",
                   f"class vtkVersion:\n    GetVTKVersion = staticmethod(lambda: '{version}')\n")

    def pyvista(self, backend):
        self.write("site/pyvista.py", f"register_dataset_accessor = None\ndef vtk_backend():\n    return '{backend}'\n")

    def run_code(self, code, **environment):
        """What a Python without site-packages prints."""
        path = ":".join(str(self.folder / site) for site in ("site", "other"))
        result = subprocess.run([sys.executable, "-S", "-c", f"import sys\nsys.path[:0] = {path!r}.split(':')\n" + code], cwd=self.folder,
                                env={"PATH": "/usr/bin:/bin", **environment}, capture_output=True, text=True)
        return result.stdout + result.stderr

    def test_right_version_is_taken(self):
        self.vtk("9.6.2")
        self.assertEqual(self.run_code("import nephoscope; print(nephoscope.__version__)"), "0.1.0\n")

    def test_no_vtk(self):
        answer = self.run_code("import nephoscope")
        self.assertIn("ModuleNotFoundError: nephoscope needs the package vtk 9.6.2, which is not installed.", answer)
        self.assertIn(f'{sys.executable} -m pip install "vtk==9.6.2"', answer)

    def test_other_version(self):
        for version in ("9.7.2", "9.6.20", "9.5.0"):
            self.vtk(version)
            answer = self.run_code("import nephoscope")
            self.assertIn(f"ImportError: nephoscope was built for vtk 9.6.2, but vtk {version} is installed. Run: ", answer)
            self.assertIn('-m pip install "vtk==9.6.2"', answer)

    def test_vtk_from_elsewhere(self):
        self.vtk("9.6.2", library="libvtkCommonCore-9.6.so.1")
        answer = self.run_code("import nephoscope")
        self.assertIn("comes from elsewhere: Debian, conda and ParaView each have their own VTK. Use a virtual environment", answer)
        self.assertIn(str(self.folder / "site" / "vtkmodules"), answer)

    def test_libraries_are_loaded_first_where_vtk_is_not_beside(self):
        self.vtk("9.6.2", site="other")
        self.assertIn("libraries of VTK loaded", self.run_code("import nephoscope"))
        self.vtk("9.6.2")
        self.assertNotIn("libraries of VTK loaded", self.run_code("import nephoscope"))

    def test_build_tree_takes_its_own_vtk(self):
        self.installed(False)
        self.assertEqual(self.run_code("import nephoscope"), "")

    def test_pyvista_with_another_vtk(self):
        self.vtk("9.6.2")
        self.pyvista("cvista")
        for code in ("import pyvista, nephoscope", "import nephoscope\nnephoscope.add_cells", "import nephoscope\nnephoscope.read_cf"):
            answer = self.run_code(code)
            self.assertIn("ImportError: nephoscope works with the package vtk, but PyVista uses cvista, since it is installed.", answer)
            self.assertIn("set the environment variable: PYVISTA_VTK_BACKEND=vtk. Or run: ", answer)
            self.assertIn("-m pip uninstall cvista", answer)
        self.assertIn("since the environment variable PYVISTA_VTK_BACKEND says so",
                      self.run_code("import pyvista, nephoscope", PYVISTA_VTK_BACKEND="cvista"))

    def test_older_pyvista(self):
        """One sentence tells it, whether PyVista has been imported or cannot be."""
        self.vtk("9.6.2")
        self.write("site/pyvista-0.40.1.dist-info/METADATA", "Name: pyvista\nVersion: 0.40.1\n")
        for version, content, code in (("0.40.1", "from vtkmodules.vtkRenderingCore import inner\n", "import nephoscope"),
                                       ("0.46.4", "__version__ = '0.46.4'\n", "import pyvista, nephoscope")):
            self.write("site/pyvista.py", content)
            answer = self.run_code(f"{code}\nnephoscope.read_cf")
            self.assertIn(f"ImportError: nephoscope needs PyVista 0.48 or later with its vtk 9.6.2, but PyVista {version} is installed. Run: {sys.executable} -m pip install \"pyvista>=0.48\"\n", answer)
            self.assertEqual((answer.count("Traceback"), answer.count("Warning"), "inner" in answer), (1, 0, False), answer)

    def test_pyvista_that_does_not_fit_the_vtk_of_a_build(self):
        self.installed(False)
        self.vtk("9.2.0")
        for content, told in (("from vtkmodules.vtkRenderingCore import inner\n", "cannot import name 'inner'"), ("import vtkmodules.inner\n", "No module named 'vtkmodules.inner'")):
            self.write("site/pyvista.py", content)
            answer = self.run_code("import nephoscope\nnephoscope.read_cf")
            self.assertRegex(answer, f"ImportError: PyVista .*does not work with this VTK: {told}.*PyVista must use this VTK.* Run: ")
            self.assertEqual(answer.count("Traceback"), 1, answer)

    def test_no_sample_data(self):
        self.vtk("9.6.2")
        answer = self.run_code("import nephoscope\nnephoscope.sample_data('blue_marble_2048.jpg')")
        self.assertIn("FileNotFoundError: The sample data blue_marble_2048.jpg are not installed: neither in ", answer)
        self.write("site/nephoscope/data/blue_marble_2048.jpg")
        answer = self.run_code("import nephoscope\nprint(nephoscope.sample_data('blue_marble_2048.jpg'))")
        self.assertEqual(answer, f"{self.folder.resolve()}/site/nephoscope/data/blue_marble_2048.jpg\n")

    def test_no_pyvista(self):
        self.vtk("9.6.2")
        answer = self.run_code("import nephoscope\nnephoscope.add_cells")
        self.assertIn("nephoscope.add_cells needs PyVista", answer)
        self.assertIn(f"Run: {sys.executable} -m pip install pyvista", answer)


if __name__ == "__main__":
    unittest.main()

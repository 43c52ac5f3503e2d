# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The parts of CMake/wheel, without network and without making a wheel: what is pinned, what is refused, how CMake files are rewritten."""
import hashlib
import os
import platform
import re
import subprocess
import sys
import tarfile
import tempfile
import unittest
from pathlib import Path
from unittest import mock

TOP = Path(__file__).resolve().parents[2]
BUILD = Path(sys.argv.pop(1))
sys.path.insert(0, str(TOP / "CMake/wheel"))
import cmake_package  # noqa: E402
import inputs  # noqa: E402
import make_sdk  # noqa: E402
import pack  # noqa: E402

TARGETS = """# Create imported target VTK::vtkplatform
add_library(VTK::vtkplatform INTERFACE IMPORTED)

# Create imported target VTK::CommonCore
add_library(VTK::CommonCore SHARED IMPORTED)

set_target_properties(VTK::CommonCore PROPERTIES
  INTERFACE_INCLUDE_DIRECTORIES "${_IMPORT_PREFIX}/include/vtk-9.6"
  INTERFACE_LINK_LIBRARIES "VTK::vtkplatform;TBB::tbb;VTK::IOMPI;Threads::Threads;\\$<LINK_ONLY:dl>"
)

# Create imported target VTK::IOMPI
add_library(VTK::IOMPI SHARED IMPORTED)

# Load information for each installed configuration.
include("VTK-targets-none.cmake")
"""
FILES = "\n".join(f'set_target_properties(VTK::{name} PROPERTIES\n  IMPORTED_LOCATION_NONE "${{_IMPORT_PREFIX}}/lib/libvtk{name}-9.6.so.9.6"\n'
                  f'  IMPORTED_SONAME_NONE "libvtk{name}-9.6.so.1"\n  )\n' for name in ("CommonCore", "IOMPI"))
PROPERTIES = """set_property(TARGET "VTK::CommonCore" PROPERTY "INTERFACE_vtk_module_depends" "VTK::vtkplatform;VTK::IOMPI")
set_property(TARGET "VTK::IOMPI" PROPERTY "INTERFACE_vtk_module_depends" "VTK::CommonCore")
"""
CONFIG = """set("X_AVAILABLE_COMPONENTS" "CommonCore;IOMPI")
set("X_SMP_BACKENDS" "TBB;STDThread;Sequential")
set("X_HAS_VISKORES" "ON")
  include("${CMAKE_CURRENT_LIST_DIR}/VTKPython-targets.cmake")
"""
NEEDS = """Version definition section '.gnu.version_d' contains 1 entry:
  000000: Rev: 1  Flags: none  Index: 2  Cnt: 1  Name: GLIBC_2.99
Version needs section '.gnu.version_r' contains 2 entries:
  000000: Version: 1  File: libm.so.6  Cnt: 2
  0x0010:   Name: GLIBC_2.35  Flags: none  Version: 9
  0x0020:   Name: GLIBC_2.2.5  Flags: none  Version: 8
  0x0030: Version: 1  File: libstdc++.so.6  Cnt: 2
  0x0040:   Name: GLIBCXX_3.4.29  Flags: none  Version: 7
  0x0050:   Name: CXXABI_1.3.14  Flags: none  Version: 6
"""


class Pins(unittest.TestCase):
    def test_every_package_has_a_digest_and_a_version(self):
        for purpose in ("sdk", "cp311", "cp313", "cp314", "openvdb"):
            packages = inputs.debian_packages(purpose)
            self.assertTrue(packages, purpose)
            for digest, path in packages:
                self.assertRegex(digest, "^[0-9a-f]{64}$")
                self.assertRegex(path, r"^pool/main/[a-z0-9.]+/[a-z0-9.-]+/[a-z0-9.-]+_\d[^_/]*(_amd64\.deb|\.orig\.tar\.[gx]z)$")

    def test_one_version_of_vtk(self):
        version = inputs.vtk_version()
        for _, path in inputs.debian_packages("sdk"):
            if "/vtk9/" in path:
                self.assertIn(f"_{version}+", path)
        text = (TOP / "CMake/wheel/vtk.txt").read_text()
        self.assertEqual(len(set(re.findall(r"--hash=sha256:[0-9a-f]{64}\b", text))), len(inputs.PYTHONS))

    def test_pages_name_that_version(self):
        self.assertIn(f"vtk=={inputs.vtk_version()}", (TOP / "Documentation/pip.md").read_text())
        self.assertIn(f"vtk {inputs.vtk_version()}", (TOP / "README.md").read_text())

    def test_sources_of_openvdb_are_those_that_its_build_names(self):
        build = "".join((TOP / "CMake/wheel/openvdb" / name).read_text() for name in ("CMakeLists.txt", "third-party.txt"))
        for _, path in inputs.debian_packages("openvdb"):
            name, version = re.match(r".*/(.*?)_([0-9.]*[0-9])", path).groups()
            if path.endswith(".deb"):
                continue
            self.assertEqual(set(re.findall(rf"{name.replace('onetbb', 'oneTBB')}-(\d+\.[0-9.]*\d)", build)), {version}, name)
            self.assertRegex(build, f" {version} +[A-Z]")


class Fetching(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        self.archive = self.folder / "archive/pool/main/x/x"
        self.archive.mkdir(parents=True)
        digest = hashlib.sha256(b"the package").hexdigest()
        (self.folder / "debian.txt").write_text(f"# comment\n\nsdk  {digest}  pool/main/x/x/x-dev_1-1_amd64.deb\n")
        for change in (mock.patch.object(inputs, "HERE", self.folder),
                       mock.patch.dict(os.environ, NEPHOSCOPE_DEBIAN_ARCHIVE=f"file://{self.folder}/archive/")):
            change.start()
            self.addCleanup(change.stop)

    def test_right_file_is_taken_and_kept(self):
        (self.archive / "x-dev_1-1_amd64.deb").write_bytes(b"the package")
        files = inputs.fetch_debian("sdk", self.folder / "inputs")
        self.assertEqual(files["x-dev"].read_bytes(), b"the package")
        (self.archive / "x-dev_1-1_amd64.deb").unlink()
        self.assertEqual(inputs.fetch_debian("sdk", self.folder / "inputs"), files)

    def test_changed_file_is_refused(self):
        (self.archive / "x-dev_1-1_amd64.deb").write_bytes(b"another")
        with self.assertRaisesRegex(SystemExit, "its SHA-256 is not [0-9a-f]{64}\nSet NEPHOSCOPE_DEBIAN_ARCHIVE"):
            inputs.fetch_debian("sdk", self.folder / "inputs")
        self.assertFalse(list((self.folder / "inputs").iterdir()))

    def test_missing_file_is_named(self):
        with self.assertRaisesRegex(SystemExit, "x-dev_1-1_amd64.deb"):
            inputs.fetch_debian("sdk", self.folder / "inputs")

    def test_python_without_headers(self):
        with mock.patch.dict(os.environ, PATH=str(self.folder)), \
                self.assertRaisesRegex(SystemExit, "Debian has no headers of Python 3.12, and no python3.12 with headers is on the path. Install"):
            inputs.python_headers("3.12", self.folder / "inputs")


class Rewriting(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        for name, text in (("VTK-targets", TARGETS), ("VTK-targets-none", FILES), ("VTK-vtk-module-properties", PROPERTIES),
                           ("vtkmodules-vtk-python-module-properties", ""), ("vtk-config", CONFIG), ("VTKPython-targets", "")):
            (self.folder / f"{name}.cmake").write_text(text)

    def package(self, least=0):
        def file_of(path):
            return Path("wheel/libvtkCommonCore.so") if "CommonCore" in path else None
        return cmake_package.CMakePackage(self.folder, Path("sdk"), file_of, least)

    def text(self, name):
        return (self.folder / f"{name}.cmake").read_text()

    def test_targets_are_those_of_the_wheel(self):
        package = self.package()
        self.assertEqual(package.kept(), ["VTK::vtkplatform", "VTK::CommonCore"])
        package.rewrite("3.13", ["headers", "more"])
        targets = self.text("VTK-targets")
        self.assertIn('INTERFACE_LINK_LIBRARIES "VTK::vtkplatform;Threads::Threads"', targets)
        self.assertIn('set_target_properties(VTK::CommonCore PROPERTIES IMPORTED_LOCATION "wheel/libvtkCommonCore.so" '
                      'IMPORTED_SONAME "libvtkCommonCore.so")', targets)
        self.assertIn("_GLIBCXX_USE_CXX11_ABI=0", targets)
        self.assertNotIn("IOMPI", targets + self.text("VTK-vtk-module-properties") + self.text("vtk-config"))
        self.assertIn('"X_SMP_BACKENDS" "STDThread;Sequential"', self.text("vtk-config"))
        self.assertIn('INTERFACE_INCLUDE_DIRECTORIES "headers;more"', self.text("VTK-vtk-module-find-packages"))

    def test_shaders_are_written_by_one_script_for_all_versions_of_python(self):
        for name in ("vtk-cp311", "vtk-cp313"):
            package = self.folder / name
            package.mkdir()
            (package / "vtkEncodeString.cmake").write_text("script")
            make_sdk.share_encoder(package)
            self.assertEqual((package / "vtkEncodeString.cmake").read_text(), f'include("{self.folder}/vtkEncodeString.cmake")\n')
        self.assertEqual((self.folder / "vtkEncodeString.cmake").read_text(), "script")

    def test_another_layout_is_noticed(self):
        with self.assertRaisesRegex(SystemExit, "is not as expected: 2 targets"):
            self.package(least=3)
        (self.folder / "vtk-config.cmake").write_text("")
        with self.assertRaisesRegex(SystemExit, "vtk-config.cmake is not as expected"):
            self.package().rewrite("3.13", [])


class SourceDistribution(unittest.TestCase):
    def test_sample_data_are_in_it(self):
        """All of Data that the build installs, and no more."""
        installed = set(re.findall(r"[\w.]+[.](?:nc|jpg)", (TOP / "CMake/NephoscopeData.cmake").read_text()))
        self.assertGreaterEqual(installed, {"gfs_2p5deg_2011101100.nc", "blue_marble_2048.jpg"})
        tree = [path.relative_to(TOP).as_posix() for path in [*TOP.glob("Data/*"), *TOP.glob("Data/*/*"), TOP / "CMakeLists.txt"] if path.is_file()]
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([sys.executable, TOP / "CMake/wheel/make_sdist.py", "--output", folder], input="\0".join(tree), check=True, capture_output=True, text=True)
            with tarfile.open(done.stdout.strip()) as archive:
                packed = {name.split("/", 1)[1] for name in archive.getnames()}
        self.assertEqual(packed, {"CMakeLists.txt", "pyproject.toml", "PKG-INFO", *(f"Data/{name}" for name in installed)})


    def test_what_pip_is_told(self):
        """pip asks for VTK's SDK only if the user says so: it cannot find it by itself."""
        sys.path.insert(0, str(TOP / "CMake/wheel/source"))
        import build_backend
        with mock.patch.dict(os.environ), mock.patch.object(build_backend.importlib.metadata, "entry_points", lambda group: []):
            os.environ.pop("VTK_DIR", None)
            with self.assertRaisesRegex(SystemExit, "--extra-index-url https://.* --config-settings vtk=sdk"):
                build_backend.get_requires_for_build_wheel()
            self.assertEqual(build_backend.get_requires_for_build_wheel({"vtk": "sdk"}), [f"vtk-sdk=={inputs.vtk_version()}"])
            os.environ["VTK_DIR"] = "sdk"
            self.assertEqual(build_backend.get_requires_for_build_wheel(), [])
            with tempfile.TemporaryDirectory() as folder:
                Path(folder, "vtk-config.cmake").touch()
                for wrong in (os.path.relpath(folder), folder + "/none"):  # pip builds in another folder
                    os.environ["VTK_DIR"] = wrong
                    with self.assertRaisesRegex(SystemExit, "VTK_DIR is .*; it must be the whole path of a folder that has vtk-config.cmake"):
                        build_backend.find_vtk()
                os.environ["VTK_DIR"] = folder
                self.assertEqual(build_backend.find_vtk(), [f"-DVTK_DIR={folder}"])


class Stubs(unittest.TestCase):
    STUB = "from typing import Any\n\nimport vtkmodules.vtkCommonCore\n\nclass vtkOwn:\n    range:'getset_descriptor'\n    def Get(self, o:'vtkObjectBase') -> 'vtkTable': ...\n" \
           "    def Copy(self) -> 'vtkOwn': ...\n"

    def test_classes_of_vtk_are_imported(self):
        modules = {"vtkObjectBase": "vtkmodules.vtkCommonCore", "vtkTable": "vtkmodules.vtkCommonDataModel"}
        self.assertEqual(pack.with_imports(self.STUB, modules),
                         "from typing import Any\n\nimport vtkmodules.vtkCommonDataModel\nimport vtkmodules.vtkCommonCore\n\nclass vtkOwn:\n    range:Any\n"
                         "    def Get(self, o:'vtkmodules.vtkCommonCore.vtkObjectBase') -> 'vtkmodules.vtkCommonDataModel.vtkTable': ...\n    def Copy(self) -> 'vtkOwn': ...\n")


class Symbols(unittest.TestCase):
    def test_symbols_newer_than_the_platform(self):
        self.assertEqual(pack.newer_versions(NEEDS), ["CXXABI_1.3.14", "GLIBC_2.35"])

    def test_libraries_of_the_wheel(self):
        """On the system where wheels are made: all newer symbols of this build's libraries have a substitute in CMake/wheel."""
        if platform.freedesktop_os_release().get("VERSION_CODENAME") != "bookworm":
            return
        libraries = [path for path in BUILD.glob("lib/libvtkNephoscope*.so") if "ParaView" not in path.name]
        self.assertTrue(libraries)
        substitutes = set(re.findall(r"\.symver \w+,(\w+)@", "".join(path.read_text() for path in TOP.glob("CMake/wheel/older_*.c"))))
        for library in libraries:
            with self.subTest(library=library.name):
                listed = subprocess.run(["readelf", "--dyn-syms", "--wide", library], check=True, capture_output=True, text=True).stdout
                newer = {name for name, version in re.findall(r" UND (\w+)@(\w+_[\d.]+)", listed) if pack.newer_versions(f"Name: {version} ")}
                self.assertLessEqual(newer, substitutes)


if __name__ == "__main__":
    unittest.main()

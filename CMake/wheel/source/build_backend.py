# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The hooks of PEP 517 by which pip builds the source distribution with the project's own CMake.

VTK is the one whose CMake package the environment variable VTK_DIR names or, with `--config-settings vtk=sdk`, that of the package `vtk-sdk`
(https://docs.vtk.org/en/latest/advanced/wheel_sdks.html). It must be the VTK of the `vtk` wheel that the package will meet. pip would only say
that it finds no `vtk-sdk`, because that package is not on the Python package index; so nothing asks for it until the user does.
"""
import importlib.metadata
import importlib.resources
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

TOP = Path(__file__).resolve().parents[3]
sys.path[:0] = [str(TOP / "Plugins/PyVista/packaging"), str(TOP / "CMake/wheel")]
from inputs import vtk_version  # noqa: E402
from nephoscope_wheel import make_wheel  # noqa: E402

INDEX = "https://vtk.org/files/wheel-sdks"


REMEDY = f"""To build Nephoscope from source, pip needs the SDK of VTK {vtk_version()}, which is not on the Python package index. Run
    pip install --extra-index-url {INDEX} --config-settings vtk=sdk FILE
with the name of this source distribution, or set VTK_DIR to the folder of an SDK that has vtk-config.cmake. A wheel for Linux needs neither."""


def get_requires_for_build_wheel(config_settings=None):
    if "VTK_DIR" in os.environ:
        return []
    if (config_settings or {}).get("vtk") == "sdk":
        return [f"vtk-sdk=={vtk_version()}"]
    if not list(importlib.metadata.entry_points(group="cmake.prefix")):
        raise SystemExit(REMEDY)
    return []


def find_vtk():
    """Words for CMake. The SDK tells where it is as packages tell scikit-build-core: by an entry point `cmake.prefix`."""
    if "VTK_DIR" in os.environ:
        folder = os.environ["VTK_DIR"]
        if not (os.path.isabs(folder) and Path(folder, "vtk-config.cmake").is_file()):  # CMake would take another VTK
            raise SystemExit(f"VTK_DIR is {folder!r}; it must be the whole path of a folder that has vtk-config.cmake.")
        return [f"-DVTK_DIR={folder}"]
    prefixes = [str(importlib.resources.files(point.load())) for point in importlib.metadata.entry_points(group="cmake.prefix")]
    if not prefixes:
        raise SystemExit(REMEDY)
    return ["-DCMAKE_PREFIX_PATH=" + ";".join(prefixes)]


def configure(build):
    subprocess.run(["cmake", "-S", TOP, "-B", build, "-C", TOP / "CMake/wheel/options.cmake", "-DBUILD_TESTING=OFF",
                    "-DNEPHOSCOPE_USE_OPENVDB=OFF", f"-DPython3_EXECUTABLE={sys.executable}", *find_vtk()], check=True)


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    """What CMake writes when it configures; without this hook pip would build everything twice."""
    with tempfile.TemporaryDirectory() as build:
        configure(build)
        written = next(Path(build).rglob("nephoscope-*.dist-info/METADATA")).parent
        shutil.copytree(written, Path(metadata_directory) / written.name)
        return written.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    with tempfile.TemporaryDirectory() as build:
        configure(build)
        subprocess.run(["cmake", "--build", build, "--parallel", str(os.cpu_count())], check=True)
        return make_wheel(Path(build), Path(wheel_directory)).name


def build_sdist(sdist_directory, config_settings=None):
    raise SystemExit("A source distribution is made by: ./nephoscope wheel --sdist")

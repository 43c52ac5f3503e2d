# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that VTK is the one for which the classes were compiled; any other is rejected with a sentence that gives the remedy."""
import importlib
import importlib.metadata
import os
import re
import sys
from importlib.util import find_spec
from pathlib import Path

PYVISTA = (0, 48)  # the first with accessors, and the oldest that has been tested with VTK's wheels


def require_wheel(version, modules):
    """Prepare the package ``vtk`` of the Python package index in the required version.

    Parameters
    ----------
    version : str
        The version that the classes were built for.
    modules : sequence of str
        The modules of ``vtkmodules`` whose libraries they need.

    Raises
    ------
    ImportError
        If VTK is missing, has another version, or was installed in another way.
    """
    remedy = f'Run: {sys.executable} -m pip install "vtk=={version}"'
    try:
        spec = find_spec("vtkmodules")
    except (ImportError, ValueError):
        spec = None
    if spec is None or not spec.submodule_search_locations:
        raise ModuleNotFoundError(f"nephoscope needs the package vtk {version}, which is not installed. {remedy}", name="vtkmodules")
    folder = Path(spec.submodule_search_locations[0])
    if not (folder / "libvtkCommonCore.so").is_file():
        raise ImportError(f"nephoscope was installed by pip and needs the package vtk {version} of the Python package index. The VTK in "
                          f"{folder} comes from elsewhere: Debian, conda and ParaView each have their own VTK. Use a virtual environment "
                          f"that does not see it. {remedy}", name="vtkmodules")
    from vtkmodules.vtkCommonCore import vtkVersion
    found = vtkVersion.GetVTKVersion()
    if found != version:
        raise ImportError(f"nephoscope was built for vtk {version}, but vtk {found} is installed. {remedy}", name="vtkmodules")
    if folder.parent != Path(__file__).resolve().parents[1]:  # not at the same time: the loader must find VTK's libraries before ours
        for module in modules:
            importlib.import_module("vtkmodules." + module)


def pyvista_version():
    """The version of PyVista, which need not be imported; "" if it is not known."""
    known = getattr(sys.modules.get("pyvista"), "__version__", None)
    try:
        return known or importlib.metadata.version("pyvista")
    except importlib.metadata.PackageNotFoundError:
        return ""


def require_pyvista(vtk_version):
    """Fail if PyVista is older than those that work with the package ``vtk`` of the Python package index, without importing it.

    Parameters
    ----------
    vtk_version : str
        The version of VTK that the classes were built for.

    Raises
    ------
    ImportError
        If PyVista is too old.
    """
    version = pyvista_version()
    numbers = re.match(r"(\d+)\.(\d+)", version)
    if numbers and tuple(map(int, numbers.groups())) < PYVISTA:
        least = ".".join(map(str, PYVISTA))
        raise ImportError(f"nephoscope needs PyVista {least} or later with its vtk {vtk_version}, but PyVista {version} is installed. "
                          f'Run: {sys.executable} -m pip install "pyvista>={least}"', name="pyvista")


def require_backend():
    """Fail if PyVista uses another VTK: since 0.49 it uses that of ``cvista`` if this is installed.

    Raises
    ------
    ImportError
        If PyVista does not use ``vtkmodules``.
    """
    import pyvista
    backend = pyvista.vtk_backend() if hasattr(pyvista, "vtk_backend") else "vtk"
    if backend == "vtk":
        return
    why = "the environment variable PYVISTA_VTK_BACKEND says so" if os.environ.get("PYVISTA_VTK_BACKEND") else "it is installed"
    raise ImportError(f"nephoscope works with the package vtk, but PyVista uses {backend}, since {why}. Before PyVista is imported, set the "
                      f"environment variable: PYVISTA_VTK_BACKEND=vtk. Or run: {sys.executable} -m pip uninstall {backend}", name="pyvista")

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The VTK that the compiled classes belong to: another one is refused, in a sentence with the remedy."""
import importlib
import os
import sys
from importlib.util import find_spec
from pathlib import Path


def require_wheel(version, modules):
    """Make ready the package ``vtk`` of the Python package index, in one version.

    Parameters
    ----------
    version : str
        The version that the classes were built for.
    modules : sequence of str
        The modules of ``vtkmodules`` whose libraries they need.

    Raises
    ------
    ImportError
        If there is no VTK, it is another version, or it was installed otherwise.
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
                          f"{folder} comes from elsewhere: Debian, conda and ParaView have VTKs of their own. Use a virtual environment "
                          f"that does not see it. {remedy}", name="vtkmodules")
    from vtkmodules.vtkCommonCore import vtkVersion
    found = vtkVersion.GetVTKVersion()
    if found != version:
        raise ImportError(f"nephoscope was built for vtk {version}, and vtk {found} is installed. {remedy}", name="vtkmodules")
    if folder.parent != Path(__file__).resolve().parents[1]:  # not side by side: the loader must meet VTK's libraries before ours
        for module in modules:
            importlib.import_module("vtkmodules." + module)


def require_backend():
    """Fail if PyVista has another VTK than ours: since 0.49 it takes that of ``cvista`` if this is installed.

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

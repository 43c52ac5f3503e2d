# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""VTK's volume mappers for unstructured grids replaced by Cell Compositing, in scripts written without Nephoscope."""
import os as _os
import sys as _sys

from . import _CLASSES

_RAY_CAST = "vtkUnstructuredGridVolumeRayCastMapper"
_PYVISTA_RAY_CAST = "UnstructuredGridVolumeRayCastMapper"


def override_vtk(enabled=True):
    """Let VTK and PyVista draw volumes of unstructured grids with Cell Compositing.

    Scripts need no change: ``vtkProjectedTetrahedraMapper()``, ``vtkUnstructuredGridVolumeRayCastMapper()`` and PyVista's ``add_volume`` of an
    unstructured grid create mappers that derive from the requested class and draw the exact ray integral. Existing mappers do not
    change. Settings of VTK's mappers that concern sampling and sorting have no effect.

    Parameters
    ----------
    enabled : bool, default: True
        ``False`` restores VTK's mappers.

    Notes
    -----
    The environment variable ``NEPHOSCOPE_OVERRIDE_VTK=1`` has the same effect at ``import nephoscope``, and in ParaView when the plugin is loaded.

    VTK's object factories create ``vtkProjectedTetrahedraMapper`` in every language. In most builds of VTK they do not
    create ``vtkUnstructuredGridVolumeRayCastMapper``; this function then replaces the class in the modules of VTK and PyVista. Names that a script imported
    before the call (``from vtkmodules.vtkRenderingVolume import …``) keep VTK's class.

    Examples
    --------
    >>> import nephoscope, pyvista
    >>> nephoscope.override_vtk()
    >>> pyvista.Plotter().add_volume(pyvista.examples.load_hexbeam())
    """
    _CLASSES["vtkCellCompositingOverride"].SetEnabled(bool(enabled))
    ours = _CLASSES["vtkCellCompositingRayCastMapper"]
    theirs = next(base for base in ours.__mro__ if base.__name__ == _RAY_CAST)
    _replace(*((theirs, ours) if enabled else (ours, theirs)))


def read_environment():
    """Call `override_vtk` if ``NEPHOSCOPE_OVERRIDE_VTK`` is set to anything but 0 or an empty string."""
    if _os.environ.get("NEPHOSCOPE_OVERRIDE_VTK", "0") not in ("", "0"):
        override_vtk()


def _replace(old, new):
    """Replace the class `old` by `new` in the modules of VTK, and as the base of PyVista's class that wraps it."""
    for module in _modules_of("vtk", "vtkmodules", "pyvista"):
        if vars(module).get(_RAY_CAST) is old:
            setattr(module, _RAY_CAST, new)
        wrapper = vars(module).get(_PYVISTA_RAY_CAST)
        if isinstance(wrapper, type) and old in wrapper.__bases__:
            setattr(module, _PYVISTA_RAY_CAST, _pyvista_class(wrapper, old, new))


def _pyvista_class(wrapper, old, new):
    bases = tuple(new if base is old else base for base in wrapper.__bases__)

    def __init__(self, theme=None):
        bases[0].__init__(self, theme=theme)

    return type(_PYVISTA_RAY_CAST, bases, {"__init__": __init__, "__doc__": wrapper.__doc__, "__module__": wrapper.__module__})


def _modules_of(*packages):
    return [module for name, module in list(_sys.modules.items()) if name.split(".")[0] in packages and hasattr(module, "__dict__")]

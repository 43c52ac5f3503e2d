# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Converts reports of VTK algorithms to Python exceptions and warnings."""
from __future__ import annotations

import functools
import os
import re
import sys
import warnings
from contextlib import contextmanager
from typing import Any, Iterator, Mapping, Sequence

import pyvista
from vtkmodules.util.misc import calldata_type
from vtkmodules.util.vtkConstants import VTK_STRING
from vtkmodules.vtkCommonCore import vtkObject
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject, vtkDataSet
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm

from ._over_time import follows


def _text(message: str) -> str:
    """The sentence in VTK's "ERROR: In file, line n\\nclass (address): sentence"."""
    return message.split("): ", 1)[-1].strip()


def _is_echo(message: str) -> bool:
    """True for the executive's generic report of a failure: that the request failed, with a dump of it."""
    return "returned failure for request" in message


# ParaView filters that messages recommend, and their equivalents in Python.
_REMEDIES = {"Apply Cell Data to Point Data": "Use mesh.cell_data_to_point_data()", "apply Cell Data to Point Data": "use mesh.cell_data_to_point_data()",
             "(Tetrahedralize)": "(mesh.triangulate)", "(Triangulate)": "(polygon.triangulate)", "(Calculator)": "(a column, or numpy.linalg.norm)",
             "(Merge Vector Components, Calculator)": "(numpy.column_stack((u, v, w)))", "make one with Delaunay 3D": "make one by delaunay_3d",
             "(Cloud Surface, Contour, Delaunay 2D)": "(cloud_surface, contour, delaunay_2d)", "draw them as Textured Splats": "draw them by add_splats",
             "Connect a flow volume": "Pass the smoke that flow_volume has made", "Connect a dataset with cells": "Pass a mesh with cells",
             "Connect a grid with winds": "Pass a grid with winds", "Put the fields through Globe Grid first": "Make one by to_globe first",
             "as Globe Grid makes it": "as to_globe makes it",
             "use a reader or Globe Grid as input, which deliver the whole grid on request": "pass the whole grid",
             "To combine three arrays of one component, use the Calculator: u*iHat + v*jHat + w*kHat": "To combine three arrays of one component, use numpy.column_stack((u, v, w))",
             "use vtkTriangleFilter": "use mesh.triangulate()"}


def _renamed(message: str, names: Mapping[str, str]) -> str:
    """The message, with VTK's terms (the keys of `names`) and ParaView's filters replaced; longer terms come first."""
    names = {**_REMEDIES, **names}
    keys = "|".join(re.escape(key) for key in sorted(names, key=len, reverse=True))
    return re.sub(rf"(?<!\w)({keys})(?!\w)", lambda match: names[match[1]], message)


def level_of_caller(*others: str) -> int:
    """Number of stack frames to the code that called this package (or code in the folders `others`), as `warnings.warn` counts them."""
    folders = (functools.__file__, *(os.path.join(folder, "") for folder in (os.path.dirname(__file__), *others)))  # functools calls cached properties
    frame, level = sys._getframe(1), 1
    while frame.f_back is not None and frame.f_code.co_filename.startswith(folders):
        frame, level = frame.f_back, level + 1
    return level


# Terms in messages of the mappers, and the arguments of the functions that add the mappers to a plotter.
_NAMES_OF_MAPPERS = {
    "Blank such points, or replace the values": "Replace the values (numpy.nan_to_num), hide their cells (mesh.hide_cells), or leave these out: "
    "mesh.threshold(scalars=name, all_scalars=True)",
    "Blank such cells, or replace the values": "Replace the values (numpy.nan_to_num), hide the cells (mesh.hide_cells), or leave these out: mesh.threshold(scalars=name)",
    "Choose an array with SelectScalarArray and SetScalarMode": "Choose an array by scalars",
    "add the volume to this renderer, and render first": "draw the volume with this plotter first, and keep the plotter open: plotter.show(auto_close=False)",
    "render first, without peeling volumes": "draw first, plotter.show(auto_close=False), without peeling volumes",
    "set VectorArrayName and render first": "pass vectors, and draw first: plotter.show(auto_close=False)",
    "ScalarOpacityUnitDistance of the property": "opacity_unit_distance", "ScalarOpacityUnitDistance": "opacity_unit_distance",
    "The scalar opacity function has no points, so that everything is transparent: add some with AddPoint":
        "The scalar opacity function has no points, so that everything is transparent: give opacity",
    "add some with AddRGBPoint": "give cmap", "Set CellInterpolation to Trilinear": "Pass interpolation='trilinear'", "run vtkPolyhedronToTetrahedra first": "divide them by mesh.nephoscope.divide_polyhedra() first",
    "call SetMethodToCells()": "call volume.mapper.SetMethodToCells()", "call SetPolygonsToAll()": "pass polygons='all'",
    "Call its UseDepthPeelingOn(), UseDepthPeelingForVolumesOn() and SetOcclusionRatio(0), and SetMultiSamples(0) of the window (in ParaView: Edit > Settings > "
    "Render View > Depth Peeling, and Depth Peeling for Volumes)":
        "Call plotter.disable_anti_aliasing(), plotter.enable_depth_peeling(10, 0) and plotter.renderer.UseDepthPeelingForVolumesOn()",
    "UseDepthPeelingForVolumesOff() of the renderer": "plotter.renderer.UseDepthPeelingForVolumesOff()",
    "Choose one with SetVectorArrayName": "Choose one by vectors", "Choose one with SetVectorColorArrayName": "Choose one by vectors['scalars']",
    "VectorColorArrayName": "vectors['scalars']", "VectorArrayName": "vectors", "call SetVectorColorFunction": "give vectors['cmap']",
    "set MaximumSpeed": "pass vectors['maximum_speed']",
    "set ErrorTolerance to 0.3": "pass level_of_detail=0.3", "ErrorTolerance": "level_of_detail",
    "Call SetVectorPlacementToMiddle()": "Pass 'middle' as vectors['placement']",
    "LayerAxis (in ParaView, Layer Axis)": "layer_axis", "set it to -1 (Towards the Eye) to ask for these": "pass layer_axis='eye' to ask for these",
    "give its name with SetCellSizeArrayName, or an empty one for sizes from the data": "name it by sizes or volumes, or leave these out",
    "Raise MaximumNumberOfLayers": "Raise layers", "CoverageArrayName": "coverage",
    "make the surface from the volume by Cloud Surface": "make the surface from the volume by cloud_surface", "DensityVolume": "density_volume", "DensityArrayName": "density",
    "TextureScale": "texture_scale", "TextureLength": "texture_length",
}


def warn_when_drawing(mapper: vtkObject) -> None:
    """Turns what a mapper, or the haze, reports while the plotter draws into RuntimeWarnings at the line that made the plotter draw.

    The warnings use argument names instead of VTK's properties. Errors become warnings too, because an exception cannot pass through VTK's rendering.
    """
    name = mapper.GetClassName()

    @calldata_type(VTK_STRING)
    def on_message(caller: Any, _event: str, message: str) -> None:  # without a reference to the mapper: Python would collect both while VTK still uses them
        if "there is nothing to draw" in message and follows(pyvista.wrap(caller.GetInputDataObject(0, 0))):
            return
        warnings.warn(f"{name}: {_renamed(_text(message), _NAMES_OF_MAPPERS)}", RuntimeWarning, stacklevel=level_of_caller(*_drawing_folders()))

    for event in ("ErrorEvent", "WarningEvent"):
        mapper.AddObserver(event, on_message)


def _drawing_folders() -> list[str]:
    return [os.path.dirname(module.__file__) for module in map(sys.modules.get, ("pyvista", "vtkmodules")) if module and module.__file__]


def set_input(algorithm: vtkAlgorithm, data: vtkDataObject, port: int = 0) -> None:
    """Makes the data the input. Ranges that VTK keeps of its arrays are cleared, because numpy changes values in place without informing VTK."""
    for leaf in _leaves(data):
        for attributes in (leaf.GetPointData(), leaf.GetCellData()) if isinstance(leaf, vtkDataSet) else ():
            for i in range(attributes.GetNumberOfArrays()):
                attributes.GetAbstractArray(i).Modified()
    algorithm.SetInputDataObject(port, data)


def _leaves(data: vtkDataObject) -> Iterator[vtkDataObject]:
    if not isinstance(data, vtkCompositeDataSet):
        yield data
        return
    iterator = data.NewIterator()
    iterator.InitTraversal()
    while not iterator.IsDoneWithTraversal():
        yield iterator.GetCurrentDataObject()
        iterator.GoToNextItem()


@contextmanager
def vtk_messages(algorithm: vtkAlgorithm, names: Mapping[str, str] = {}, told: Sequence[str] = (), by_class: bool = True) -> Iterator[None]:
    """Collects the reports of `algorithm` inside the block. `names`: its terms for properties, and their names in Python. `told`: parts of warnings that the
    user does not need. `by_class`: whether messages begin with the name of the class.

    Raises
    ------
    RuntimeError
        At the end of the block, with the text of every error reported.

    Warns
    -----
    RuntimeWarning
        One for each warning reported.
    """
    errors: list[str] = []
    beginning = f"{algorithm.GetClassName()}: " if by_class else ""

    @calldata_type(VTK_STRING)
    def on_error(_caller: object, _event: str, message: str) -> None:
        errors.append(_renamed(_text(message), names))

    @calldata_type(VTK_STRING)
    def on_warning(_caller: object, _event: str, message: str) -> None:
        if any(text in message for text in told):
            return
        warnings.warn(beginning + _renamed(_text(message), names), RuntimeWarning, stacklevel=level_of_caller())

    subjects = (algorithm, algorithm.GetExecutive())
    tags = [(subject, subject.AddObserver(event, observer)) for subject in subjects
            for event, observer in (("ErrorEvent", on_error), ("WarningEvent", on_warning))]
    try:
        yield
    finally:
        for subject, tag in tags:
            subject.RemoveObserver(tag)
    if errors:
        causes = list(dict.fromkeys(text for text in errors if not _is_echo(text)))
        raise RuntimeError(beginning + ("\n".join(causes) or "the request failed without a reason."))

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""NetCDF files that follow the Climate and Forecast conventions, by VTK's own reader."""
from __future__ import annotations

from pathlib import Path
from typing import Sequence

import pyvista
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader

from ._checks import listed
from ._pipeline import vtk_messages


def read_cf(path: str | Path, *, dimensions: Sequence[str] | None = None, variables: Sequence[str] | None = None,
            time_step: int = 0) -> pyvista.DataSet:
    """Read the variables of one shape from a NetCDF file with CF conventions.

    Parameters
    ----------
    path : str or pathlib.Path
        The file, NetCDF classic or NetCDF-4.
    dimensions : sequence of str, optional
        Names of the dimensions of the variables to read, slowest first, as the file has them:
        ``("lev", "lat", "lon")``. Default: the longest combination in the file.
    variables : sequence of str, optional
        Names of the variables to read. Default: all on these dimensions.
    time_step : int, default: 0
        Index of the time step, from 0; negative counts from the end. Ignored if the file has no time.

    Returns
    -------
    pyvista.ImageData or pyvista.RectilinearGrid or pyvista.StructuredGrid
        Points at the coordinates as the file has them: x longitude and y latitude in degrees, z the level (negated by the
        reader where the file says ``positive: down``). One point array per variable, fill values as NaN.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    RuntimeError
        If the file is not NetCDF.
    ValueError
        If the dimensions, a variable or the time step are not in the file; the message lists what is.

    Examples
    --------
    >>> weather = nephoscope.read_cf("Data/gfs_2p5deg_2011101100.nc")  # doctest: +SKIP
    """
    path = Path(path)
    if not path.is_file():
        raise FileNotFoundError(f"No such file: {path}")
    reader = vtkNetCDFCFReader()
    reader.SetFileName(str(path))
    reader.SphericalCoordinatesOff()
    reader.ReplaceFillValueWithNanOn()
    with vtk_messages(reader):
        reader.UpdateInformation()
    _select_variables(reader, path, _shape(reader, path, dimensions), variables)
    with vtk_messages(reader):
        _update(reader, path, time_step)
    return pyvista.wrap(reader.GetOutputDataObject(0))


def _strings(array: object) -> list[str]:
    return [array.GetValue(i) for i in range(array.GetNumberOfValues())]


def _shape(reader: vtkNetCDFCFReader, path: Path, dimensions: Sequence[str] | None) -> str:
    available = _strings(reader.GetAllDimensions())
    if not available:
        raise ValueError(f"{path} has no variable with dimensions.")
    if dimensions is None:
        return max(available, key=lambda text: text.count(","))
    shape = "(" + ", ".join(dimensions) + ")"
    if shape not in available:
        raise ValueError(f"dimensions: no variable of {path} has {shape}. There are: {'; '.join(available)}.")
    return shape


def _select_variables(reader: vtkNetCDFCFReader, path: Path, shape: str, variables: Sequence[str] | None) -> None:
    names, shapes = _strings(reader.GetAllVariableArrayNames()), _strings(reader.GetVariableDimensions())
    here = [name for name, its_shape in zip(names, shapes) if its_shape == shape]
    wanted = here if variables is None else [variables] if isinstance(variables, str) else list(variables)
    missing = [name for name in wanted if name not in here]
    if missing:
        raise ValueError(f"variables: {listed(missing)} not in {path} on {shape}. There are: {listed(here)}.")
    for name in names:  # SetDimensions() is left alone: it would undo the choice at the next update
        reader.SetVariableArrayStatus(name, int(name in wanted))


def _update(reader: vtkNetCDFCFReader, path: Path, time_step: int) -> None:
    times = reader.GetOutputInformation(0).Get(vtkStreamingDemandDrivenPipeline.TIME_STEPS())
    if not times:
        reader.Update()
        return
    if not -len(times) <= time_step < len(times):
        raise ValueError(f"time_step is {time_step}; {path} has {len(times)} time steps, from 0.")
    reader.UpdateTimeStep(times[time_step])

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sparse volumes: .vdb files read as points or images, and images, voxels and particles written to them."""
from __future__ import annotations

from pathlib import Path
from typing import Any, Literal, Mapping, Sequence

import pyvista
from pyvista.core.errors import MissingDataError

from . import vtkSparseVolumeReader, vtkSparseVolumeWriter
from ._checks import arrays_of, choose, listed, require_array, require_number
from ._pipeline import vtk_messages


# What the messages of reader and writer say, and what it is called here.
_NAMES = {"MemoryLimit": "memory_limit", "SplitTiles off": "split_tiles=False", "a VoxelSize": "a voxel_size", "VoxelSize": "voxel_size",
          "SetGridName": "names", "MassArrayName": "masses", "SetFileName": "path"}

def read_vdb(path: str | Path, grids: str | Sequence[str] | None = None, *, image: bool = False, split_tiles: bool = True,
             memory_limit: float = 4.0) -> pyvista.PolyData | pyvista.ImageData:
    """Read the grids of a .vdb file: a point for each active voxel, or an image of their bounding box.

    Parameters
    ----------
    path : str or pathlib.Path
        The file.
    grids : str or sequence of str, optional
        Which grids. Default: all that can be read.
    image : bool, default: False
        An image in place of points. It takes memory for every voxel of the bounding box, and sheared voxels cannot be one.
    split_tiles : bool, default: True
        Points: one for every voxel of a tile, a cube of voxels that is stored with one value; else, if a single grid is read, one for
        the tile, with the point array ``VoxelScale``.
    memory_limit : float, default: 4.0
        More memory than this, in GiB, is refused, > 0.

    Returns
    -------
    pyvista.PolyData or pyvista.ImageData
        One point array for each grid, the first of them active. `add_splats` draws the points in the shape of their voxels.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    ValueError
        If a grid is not in the file; the message lists those that are. If a number is out of range.
    RuntimeError
        If the file is no .vdb file or damaged, the output would be too large, or the package was built without OpenVDB.

    Warns
    -----
    RuntimeWarning
        For grids that cannot be read, and for those without active voxels.

    Examples
    --------
    >>> smoke = nephoscope.read_vdb("smoke.vdb", ["density", "v"])  # doctest: +SKIP
    >>> nephoscope.add_splats(plotter, smoke, "density", vectors="v", color="white")  # doctest: +SKIP
    """
    path = Path(path)
    if not path.is_file():
        raise FileNotFoundError(f"No such file: {path}")
    reader = vtkSparseVolumeReader()
    reader.SetFileName(str(path))
    reader.SetOutputType(reader.IMAGE if image else reader.POINTS)
    reader.SetSplitTiles(split_tiles)
    reader.SetMemoryLimit(require_number(memory_limit, "memory_limit", above=0))
    with vtk_messages(reader, _NAMES):
        reader.UpdateInformation()
    if grids is not None:
        _select(reader, path, [grids] if isinstance(grids, str) else list(grids))
    with vtk_messages(reader, _NAMES):
        reader.Update()
    mesh = pyvista.wrap(reader.GetOutputDataObject(0))
    if mesh.active_scalars_name is None and mesh.point_data.keys():
        mesh.set_active_scalars(mesh.point_data.keys()[0])
    return mesh


def write_vdb(mesh: pyvista.DataSet, path: str | Path, arrays: str | Sequence[str] | None = None, *,
              names: Mapping[str, str] | None = None, tolerance: float = 0.0,
              precision: Literal["input", "single", "half"] = "input", compression: Literal["blosc", "zip", "none"] = "blosc",
              voxel_size: float | None = None, masses: str | None = None) -> None:
    """Write an image, voxels that were read, or particles as a .vdb file, for Blender, Houdini and others.

    Also the accessor method ``mesh.nephoscope.write_vdb(path, ...)``.

    Parameters
    ----------
    mesh : pyvista.ImageData, pyvista.PolyData or pyvista.UnstructuredGrid
        An image becomes a grid for every array; points of `read_vdb` become the same voxels; other points are particles, whose mass over
        volume becomes the grid ``density``, other arrays means weighted with the mass.
    path : str or pathlib.Path
        The file; one that is there is replaced.
    arrays : str or sequence of str, optional
        Which arrays, of one or three components. Default: all.
    names : dict of str to str, optional
        What the grids of arrays are called: Blender looks for ``density``, ``temperature``, ``velocity``, Houdini for ``density``,
        ``temperature``, ``vel``. Default: as the arrays.
    tolerance : float, default: 0.0
        Values of images up to this are background and take no space, >= 0.
    precision : {"input", "single", "half"}, default: "input"
        Precision of floating-point numbers: as they are, 32 bits, or 16 bits.
    compression : {"blosc", "zip", "none"}, default: "blosc"
        Zip is not applied to fog volumes by OpenVDB.
    voxel_size : float, optional
        Particles: edge of a voxel, > 0. Default: their mean spacing.
    masses : str, optional
        Particles: point array of their masses. Default: 1 each.

    Raises
    ------
    TypeError
        If `mesh` is no dataset.
    pyvista.core.errors.MissingDataError
        (a ValueError) If there is no such array; the message lists those that are there.
    ValueError
        If a number or a choice is out of range.
    RuntimeError
        If the mesh is of another kind, the file cannot be written, or the package was built without OpenVDB.

    Warns
    -----
    RuntimeWarning
        What the writer warns of.

    Examples
    --------
    >>> image.nephoscope.write_vdb("clouds.vdb", "cloud_fraction", names={"cloud_fraction": "density"})  # doctest: +SKIP
    """
    if not isinstance(mesh, pyvista.DataSet):
        raise TypeError(f"mesh is a {type(mesh).__name__}; it must be a pyvista dataset.")
    writer = vtkSparseVolumeWriter()
    writer.SetInputData(mesh)
    writer.SetFileName(str(path))
    for name in [arrays] if isinstance(arrays, str) else arrays or ():
        writer.AddArrayName(_array(mesh, name, "arrays"))
    for name, grid in (names or {}).items():
        writer.SetGridName(name if name == "density" and not isinstance(mesh, pyvista.ImageData) else _array(mesh, name, "names"), str(grid))
    writer.SetTolerance(require_number(tolerance, "tolerance", least=0))
    choose({"input": writer.SetPrecisionToInput, "single": writer.SetPrecisionToSingle, "half": writer.SetPrecisionToHalf},
           precision, "precision")
    choose({"blosc": writer.SetCompressionToBlosc, "zip": writer.SetCompressionToZip, "none": writer.SetCompressionToNone},
           compression, "compression")
    if voxel_size is not None:
        writer.SetVoxelSize(require_number(voxel_size, "voxel_size", above=0))
    if masses is not None:
        if masses not in mesh.point_data:
            raise MissingDataError(f"masses: no point array {masses!r}. {arrays_of(mesh)}")
        writer.SetMassArrayName(masses)
    with vtk_messages(writer, _NAMES):
        writer.Write()


def _array(mesh: pyvista.DataSet, name: str, argument: str) -> str:
    require_array(mesh, name, argument)
    return name


def _select(reader: vtkSparseVolumeReader, path: Path, grids: Sequence[str]) -> None:
    there = [reader.GetGridName(i) for i in range(reader.GetNumberOfGrids())]
    missing = [name for name in grids if name not in there]
    if missing or not grids:
        raise ValueError(f"grids: {listed(missing)} not in {path}. There are: {listed(there)}.")
    selection = reader.GetGridSelection()
    selection.DisableAllArrays()
    for name in grids:
        selection.EnableArray(name)

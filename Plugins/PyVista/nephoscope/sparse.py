# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Sparse volumes: reads .vdb files as points or images, and writes images, voxels and particles as .vdb files."""
from __future__ import annotations

from pathlib import Path
from typing import Literal, Mapping, Sequence

import pyvista
from pyvista.core.errors import MissingDataError

from . import vtkSparseVolumeReader, vtkSparseVolumeWriter
from ._checks import arrays_of, choose, listed, require_array, require_number
from ._from_xarray import meshed
from ._pipeline import vtk_messages


# Terms in messages of the reader and the writer, and their names in Python.
_NAMES = {"MemoryLimit": "memory_limit", "SplitTiles off": "split_tiles=False", "a VoxelSize": "a voxel_size", "VoxelSize": "voxel_size",
          "SetGridName": "names", "MassArrayName": "masses", "SetFileName": "path",
          "(in ParaView with Resample To Image)": "(image.sample(mesh), with a pyvista.ImageData)"}

def read_vdb(path: str | Path, grids: str | Sequence[str] | None = None, *, image: bool = False, split_tiles: bool = True,
             memory_limit: float = 4.0) -> pyvista.PolyData | pyvista.ImageData:
    """Read the grids of a .vdb file: a point for each active voxel, or an image of their bounding box.

    Parameters
    ----------
    path : str or pathlib.Path
        The file.
    grids : str or sequence of str, optional
        Names of the grids to read. Default: all readable grids.
    image : bool, default: False
        Returns an image instead of points. It takes memory for every voxel of the bounding box. Sheared voxels cannot become an image.
    split_tiles : bool, default: True
        A tile is a cube of voxels with one stored value. True: one point for every voxel of a tile. False: one point for each tile, with the
        point array ``VoxelScale``, if a single grid is read.
    memory_limit : float, default: 4.0
        Maximum memory of the output, in GiB, > 0. A larger output raises an error.

    Returns
    -------
    pyvista.PolyData or pyvista.ImageData
        One point array for each grid, the first of them active. `add_splats` draws the points in the shape of their voxels.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    ValueError
        If a grid is not in the file; the message lists the grids that are. If a number is out of range.
    RuntimeError
        If the file is damaged or not a .vdb file, the output would be too large, or the package was built without OpenVDB.

    Warns
    -----
    RuntimeWarning
        For grids that cannot be read, and for grids without active voxels.

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
    """Write an image, voxels of `read_vdb`, or particles as a .vdb file, for Blender, Houdini and other programs.

    Also the accessor method ``mesh.nephoscope.write_vdb(path, ...)``.

    Parameters
    ----------
    mesh : pyvista.ImageData, pyvista.PolyData or pyvista.UnstructuredGrid
        Every array of an image becomes a grid. Points of `read_vdb` become the same voxels again. Other points are particles: their mass per
        volume becomes the grid ``density``, and their other arrays become mass-weighted means.
    path : str or pathlib.Path
        The file. An existing file is overwritten.
    arrays : str or sequence of str, optional
        Names of the arrays to write; they have one or three components. Default: all.
    names : dict of str to str, optional
        Names of the grids, by array name. Blender expects ``density``, ``temperature`` and ``velocity``; Houdini expects ``density``,
        ``temperature`` and ``vel``. Default: the names of the arrays.
    tolerance : float, default: 0.0
        Image values up to this one become background, which takes no space, >= 0.
    precision : {"input", "single", "half"}, default: "input"
        Precision of floating-point numbers: that of the input, 32 bits or 16 bits.
    compression : {"blosc", "zip", "none"}, default: "blosc"
        Compression of the file. OpenVDB does not apply zip to fog volumes.
    voxel_size : float, optional
        Particles: edge length of a voxel, > 0. Default: the mean spacing of the particles.
    masses : str, optional
        Particles: point array of their masses. Default: each mass is 1.

    Raises
    ------
    TypeError
        If `mesh` is not a dataset.
    pyvista.core.errors.MissingDataError
        (a ValueError) If an array does not exist; the message lists the arrays that do.
    ValueError
        If a number or a choice is out of range.
    RuntimeError
        If the mesh has another type, the file cannot be written, or the package was built without OpenVDB.

    Warns
    -----
    RuntimeWarning
        The warnings of the writer.

    Examples
    --------
    >>> image.nephoscope.write_vdb("clouds.vdb", "cloud_fraction", names={"cloud_fraction": "density"})  # doctest: +SKIP
    """
    mesh = meshed(mesh)
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

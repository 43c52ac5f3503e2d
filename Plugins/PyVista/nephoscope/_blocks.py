# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The datasets in blocks of any kind, and the choice of those that form a volume."""
from __future__ import annotations

import warnings
from typing import Any, Iterator, Mapping

import numpy as np
import pyvista
from pyvista.core.errors import MissingDataError
from vtkmodules.vtkCommonDataModel import (vtkAMRUtilities, vtkCompositeDataSet, vtkDataSetAttributes, vtkGenericCell, vtkHyperTreeGrid,
                                           vtkOverlappingAMR, vtkUniformGrid)
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

from ._checks import listed
from ._fields import is_helper
from ._pipeline import level_of_caller


def outer_surface(grid: pyvista.DataSet) -> pyvista.PolyData:
    """The outer faces of its cells, and its polygons. PyVista's method for it has other arguments in each version."""
    surface = vtkDataSetSurfaceFilter()
    surface.SetInputData(grid)
    surface.Update()
    return pyvista.wrap(surface.GetOutput())


def named_blocks(data: Any, name: str = "block") -> Iterator[tuple[str, pyvista.DataSet]]:
    """Its datasets with their names, without cells that finer cells cover."""
    if isinstance(data, vtkHyperTreeGrid):
        from vtkmodules.vtkFiltersHyperTree import vtkHyperTreeGridToUnstructuredGrid
        cells = vtkHyperTreeGridToUnstructuredGrid()
        cells.SetInputData(data)
        cells.Update()
        yield name, pyvista.wrap(cells.GetOutput())
    elif isinstance(data, vtkCompositeDataSet):
        amr = isinstance(data, vtkOverlappingAMR)
        if amr:
            data = _with_covered_cells_marked(data)
        blocks = data.NewIterator()
        while not blocks.IsDoneWithTraversal():
            for its_name, block in named_blocks(blocks.GetCurrentDataObject(), _current_name(blocks)):
                yield its_name, _uncovered(block) if amr else block
            blocks.GoToNextItem()
    else:
        data = pyvista.ImageData(data) if isinstance(data, vtkUniformGrid) else pyvista.wrap(data)
        if isinstance(data, pyvista.DataSet):
            yield name, data


def _current_name(blocks: Any) -> str:
    name = blocks.GetCurrentMetaData().Get(vtkCompositeDataSet.NAME()) if blocks.HasCurrentMetaData() else None
    return name or f"block {blocks.GetCurrentFlatIndex()}"


def _with_covered_cells_marked(data: vtkOverlappingAMR) -> vtkOverlappingAMR:
    marked = vtkOverlappingAMR()
    # The method that copies the arrays of every block had another name before CompositeShallowCopy existed.
    (marked.ShallowCopy if hasattr(marked, "CompositeShallowCopy") else marked.RecursiveShallowCopy)(data)
    vtkAMRUtilities.BlankCells(marked)
    return marked


def _uncovered(block: pyvista.DataSet) -> pyvista.DataSet:
    ghosts = block.cell_data.get("vtkGhostType")
    if ghosts is None:
        return block
    return block.extract_cells(np.flatnonzero(ghosts & (vtkDataSetAttributes.REFINEDCELL | vtkDataSetAttributes.HIDDENCELL) == 0))


def cell_dimension(mesh: pyvista.DataSet) -> int:
    """The highest dimension of its cells, 0 if it has none."""
    if not isinstance(mesh, (pyvista.UnstructuredGrid, pyvista.PolyData)):
        return sum(count > 1 for count in getattr(mesh, "dimensions", ()))  # not by a cell, because a hidden cell is an empty cell
    if isinstance(mesh, pyvista.PolyData):
        return 2 if mesh.GetNumberOfPolys() + mesh.GetNumberOfStrips() else 1 if mesh.GetNumberOfLines() else 0
    cell, greatest = vtkGenericCell(), 0
    for cell_type in np.unique(mesh.celltypes):
        cell.SetCellType(int(cell_type))
        greatest = max(greatest, cell.GetCellDimension())
    return greatest


def fitting(blocks: list[tuple[str, pyvista.DataSet]], arrays: Mapping[str, Any], points_fit: bool) -> list[pyvista.DataSet]:
    """The blocks that form one volume with these `arrays` (argument: name); a warning names the others.

    If there are blocks with 3-D cells, others are left out, for example boundary patches; particles stay if `points_fit`.
    Blocks that lack one of the arrays are left out too; blocks without vectors get vectors of length 0. MissingDataError if no block has an array.
    """
    left_out: dict[str, str] = {}
    dimensions = [cell_dimension(block) for _, block in blocks]
    if 3 in dimensions:
        fit = [dimension == 3 or points_fit and dimension == 0 for dimension in dimensions]
        left_out.update({name: "no 3-D cells" for (name, _), fits in zip(blocks, fit) if not fits})
        blocks = [named for named, fits in zip(blocks, fit) if fits]
    elif not points_fit:
        return [block for _, block in blocks]  # the caller reports the error
    default = _array_of_some(blocks) if arrays.get("scalars", "") is None else {}
    for argument, name in {**arrays, **default}.items():
        if not isinstance(name, str):
            continue
        kind = "point_data" if any(name in block.point_data for _, block in blocks) else "cell_data"
        having = [(its_name, block) for its_name, block in blocks if name in getattr(block, kind)]
        if blocks and not having:
            raise MissingDataError(f"{argument}: no block has an array {name!r}. {_arrays_of_all(blocks)}")
        if argument in ("vectors", "vector_scalars"):
            blocks = [(its_name, _with_zeros(block, kind, name, getattr(having[0][1], kind)[name])) for its_name, block in blocks]
            continue
        left_out.update({its_name: _why_without(block, kind, name) for its_name, block in blocks if name not in getattr(block, kind)})
        blocks = having
    if left_out:
        told = ", ".join(f"{name!r} ({why})" for name, why in left_out.items())
        warnings.warn(f"Blocks that are not drawn: {told}.", UserWarning, stacklevel=level_of_caller())
    return [block for _, block in blocks]


def _why_without(block: pyvista.DataSet, kind: str, name: str) -> str:
    """Why the block does not take part in the array `name` of points or cells, and the remedy."""
    if name not in block.array_names:
        return f"no {kind[:-5]} array {name!r}"
    here, remedy = ("cells", "cell_data_to_point_data") if kind == "point_data" else ("points", "point_data_to_cell_data")
    return f"{name!r} is on {here} there, on {kind[:-5]}s in other blocks: use block.{remedy}()"


def matching_arrays(blocks: list[pyvista.DataSet]) -> list[pyvista.DataSet]:
    """The blocks, ready to be combined. Arrays that only some blocks have, or that differ in type, would be lost. Arrays with the same name get
    the same type; if some blocks have ghost flags, the others get flags of 0."""
    blocks = [block.copy(deep=False) for block in blocks]
    for kind in ("point_data", "cell_data"):
        arrays = [getattr(block, kind) for block in blocks]
        if any("vtkGhostType" in data for data in arrays):
            for block, data in zip(blocks, arrays):
                if "vtkGhostType" not in data:
                    data["vtkGhostType"] = np.zeros(block.n_points if kind == "point_data" else block.n_cells, np.uint8)
        for name in set.intersection(*(set(data.keys()) for data in arrays)):
            types = {data[name].dtype for data in arrays}
            if len(types) > 1 and all(np.issubdtype(its, np.number) or its == bool for its in types):
                for data in arrays:
                    data[name] = data[name].astype(np.result_type(*types))
    return blocks


def _with_zeros(block: pyvista.DataSet, kind: str, name: str, model: np.ndarray) -> pyvista.DataSet:
    """`block` with the array; if it lacks the array, with zeros in the shape and type of `model`."""
    if name in getattr(block, kind):
        return block
    block = block.copy(deep=False)
    count = block.n_points if kind == "point_data" else block.n_cells
    getattr(block, kind)[name] = np.zeros((count, *model.shape[1:]), model.dtype)
    return block


def _array_of_some(blocks: list[tuple[str, pyvista.DataSet]]) -> dict[str, str]:
    """The first available array, if none is requested and the blocks have none in common."""
    kinds = ("point_data", "cell_data")
    numbers = [{(kind, name) for kind in kinds for name, values in getattr(block, kind).items() if values.ndim == 1 and not is_helper(name)}
               for _, block in blocks]
    if not numbers or set.intersection(*numbers) or not set.union(*numbers):
        return {}
    _, block = next(one for one, its in zip(blocks, numbers) if its)
    names = [name for kind in kinds for name in getattr(block, kind).keys() if (kind, name) in set.union(*numbers)]
    active = block.active_scalars_name
    return {"scalars": active if active in names else names[0]}


def _arrays_of_all(blocks: list[tuple[str, pyvista.DataSet]]) -> str:
    points, cells = (sorted({name for _, block in blocks for name in getattr(block, kind).keys()}) for kind in ("point_data", "cell_data"))
    return f"Point arrays: {listed(points)}; cell arrays: {listed(cells)}."

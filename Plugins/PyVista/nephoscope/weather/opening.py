# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Opens a file, several files, a Zarr store or a dataset as one lazy xarray.Dataset."""
from __future__ import annotations

import glob
import json
from pathlib import Path
from typing import Any, Sequence

from .._typing import WeatherDataset
from .accessor import register
from .dates import with_dates
from .extras import load_proj, need
from .foreign import first_bytes, format_of, inside, refusal


def open(path: Any, *, grid: int | None = None, mesh: Any = None, chunks: Any = None, **options: Any) -> WeatherDataset:  # noqa: A001
    """Open weather data as an xarray.Dataset whose accessor ``.nephoscope`` draws it.

    ``from nephoscope import *`` does not import this function, because it would hide Python's own ``open``. Call it as ``nephoscope.open``.

    Parameters
    ----------
    path : str, pathlib.Path, sequence of these, or xarray.Dataset
        A GRIB file (edition 1 or 2), a NetCDF file, a Zarr store, a pattern such as ``"wrfout_d01_*"``, several files of one series, or a dataset,
        which is returned unchanged. The first bytes of a file determine its format.
    grid : int, optional
        GRIB only: number of the grid, from 0, in a file with several grids. Default: an error that lists them.
    mesh : str, pathlib.Path or xarray.Dataset, optional
        The mesh file, if the data do not contain the mesh: ICON's grid file, MPAS' init file, UGRID. Its dimensions are matched by their sizes.
    chunks : optional
        As in `xarray.open_dataset`: dask arrays. Default: lazy arrays of xarray, without dask.
    **options
        For NetCDF and Zarr: those of `xarray.open_dataset`, `xarray.open_mfdataset` or `xarray.open_zarr`.

    Returns
    -------
    xarray.Dataset
        Lazy: values are read when they are used. ``.nephoscope.describe()`` lists its contents, ``.nephoscope.globe()`` makes the mesh.

    Raises
    ------
    FileNotFoundError
        If there is no such file.
    ValueError
        If the file has an unknown format or is damaged.
    ModuleNotFoundError
        If a package is missing; the message has the command that installs it.

    Examples
    --------
    >>> forecast = nephoscope.open("forecast.grib2")  # doctest: +SKIP
    >>> print(forecast.nephoscope.describe())  # doctest: +SKIP
    >>> clouds = forecast.nephoscope.globe(vertical_exaggeration=30)  # doctest: +SKIP
    """
    xarray = need("xarray", "opening weather data")
    register()
    if isinstance(path, xarray.Dataset):
        return path
    if isinstance(path, xarray.DataArray):
        return path.to_dataset(name=path.name or "field")
    paths = _paths(path)
    kinds = {_kind(found) for found in paths}
    load_proj()
    if len(kinds) > 1:
        raise ValueError(f"The files have several formats, {', '.join(sorted(kinds))}: open them one by one.")
    dataset = {"GRIB": _open_grib, "NetCDF": _open_netcdf, "Zarr": _open_zarr}[kinds.pop()](paths, grid, chunks, options)
    dataset = with_dates(dataset)
    return dataset if mesh is None else _with_mesh(dataset, open(mesh))


MESH = ("clon", "clat", "clon_vertices", "clat_vertices", "lonCell", "latCell", "lonVertex", "latVertex", "verticesOnCell", "nEdgesOnCell", "zgrid", "z_ifc", "z_mc", "HHL", "HSURF", "topography_c", "grid_center_lon", "grid_center_lat", "grid_corner_lon", "grid_corner_lat",
        "lon_rho", "lat_rho", "h", "hc", "Cs_r", "mask_rho")  # the last ones: ROMS and CROCO


def _with_mesh(dataset, mesh):
    """`dataset` with the variables of `mesh` that define positions and cells; dimensions with other names are matched by their sizes."""
    topology = [name for name, variable in mesh.variables.items() if variable.attrs.get("cf_role") == "mesh_topology"]
    wanted = [name for top in topology for key in ("face_node_connectivity", "node_coordinates", "face_coordinates") for name in str(mesh[top].attrs.get(key, "")).split()]
    found = mesh[[name for name in dict.fromkeys([*MESH, *topology, *wanted]) if name in mesh.variables and name not in dataset.variables]]
    unknown = [dim for dim in dataset.sizes if dim not in found.sizes]
    if not set(found.sizes.values()) & set(dataset.sizes.values()):
        raise ValueError(f"mesh: it has {_sizes(found)}, and the data have {_sizes(dataset)}. No size is the same, so this mesh belongs to other data.")
    other = [dim for dim in found.sizes if dataset.sizes.get(dim, found.sizes[dim]) != found.sizes[dim]]
    if other:
        raise ValueError(f"mesh: {other[0]!r} has {found.sizes[other[0]]} entries in the mesh and {dataset.sizes[other[0]]} in the data, so this mesh belongs to other data.")
    names = {dim: next((own for own in unknown if dataset.sizes[own] == size), dim) for dim, size in found.sizes.items() if dim not in dataset.sizes}
    return dataset.merge(found.reset_coords().rename({dim: own for dim, own in names.items() if own != dim}), compat="override")


def _sizes(dataset) -> str:
    return ", ".join(f"{dim} {size}" for dim, size in dataset.sizes.items()) or "nothing that tells places"


def _paths(path: Any) -> list[Path]:
    if isinstance(path, (list, tuple)):
        return [found for one in path for found in _paths(one)]
    text = str(path)
    if "://" in text:
        raise FileNotFoundError(f"{text} is an address, not a file. Download the file, or pass a dataset: xarray.open_dataset({text!r}), which reads OPeNDAP, or xarray.open_zarr.")
    found = sorted(glob.glob(text)) if any(c in text for c in "*?[") and not Path(text).exists() else [text]
    missing = [one for one in found if not Path(one).exists()]
    if missing or not found:
        raise FileNotFoundError(f"No such file: {(missing or [text])[0]}")
    return [Path(one) for one in found]


def _kind(path: Path) -> str:
    if path.is_dir():
        if _is_zarr_array(path):
            raise ValueError(f"{path} is one array of a Zarr store. Name the store, the folder above it: {path.parent}.")
        if any((path / name).exists() for name in (".zgroup", ".zmetadata", "zarr.json")):
            return "Zarr"
        if (path / "system" / "controlDict").exists():
            raise ValueError(f"{path} is a case of OpenFOAM. Read it by pyvista.OpenFOAMReader, and draw it by nephoscope.add_cells (make an empty file case.foam in the folder, and name that).")
        raise ValueError(f"{path} is a folder, but not a Zarr store (it has no .zgroup and no zarr.json). Name a file or a pattern, {path}/*.nc for example.")
    if path.suffix.lower() == ".zip":
        if told := inside(path):
            raise ValueError(told)
        return "Zarr"
    start = first_bytes(path)
    if found := format_of(start):
        return found
    raise ValueError(refusal(path, start, "`open` reads GRIB, NetCDF and Zarr, and takes xarray.Dataset."))


def _is_zarr_array(path: Path) -> bool:
    if (path / ".zarray").exists():
        return True
    about = path / "zarr.json"  # of edition 3
    return about.exists() and json.loads(about.read_text(encoding="utf-8")).get("node_type") == "array"


def _open_grib(paths: Sequence[Path], grid, chunks, options):
    from .grib import open_grib
    if options:
        raise TypeError(f"open: {', '.join(options)} is not an option for GRIB.")
    datasets = [open_grib(path, grid) for path in paths]
    xarray = need("xarray", "opening weather data")
    whole = datasets[0] if len(datasets) == 1 else xarray.concat(datasets, "time", data_vars="minimal", coords="minimal", compat="override", join="exact") \
        if all("time" in d.coords for d in datasets) and len({str(d.time.values) for d in datasets}) == len(datasets) else xarray.merge(datasets, compat="override", join="exact")
    return whole if chunks is None else whole.chunk(chunks)


def _open_netcdf(paths: Sequence[Path], grid, chunks, options):
    xarray = need("xarray", "opening weather data")
    options = {"decode_timedelta": True, **options}
    if len(paths) > 1:
        need("dask", "opening several files")
        return xarray.open_mfdataset([str(path) for path in paths], chunks=chunks or {}, **options)
    try:
        opened = xarray.open_dataset(paths[0], chunks=chunks, **options)
        if opened.data_vars or "group" in options:
            return opened
        from .groups import with_groups
        return with_groups(paths[0], opened, chunks, options)
    except OSError as problem:
        raise ValueError(f"{paths[0]} cannot be read, probably because it is incomplete or damaged ({problem}). Fetch it again.") from problem
    except ValueError as problem:
        if "found the following matches" in str(problem) or "did not find a match" in str(problem):
            need("netCDF4", "reading NetCDF")
        if "decode" in str(problem) and options["decode_timedelta"]:  # times without a calendar, or in an unknown unit
            return _open_netcdf(paths, grid, chunks, {**options, "decode_timedelta": False})
        if "decode" in str(problem) and options.get("decode_times", True):
            return _open_netcdf(paths, grid, chunks, {**options, "decode_times": False})
        raise


def _open_zarr(paths: Sequence[Path], grid, chunks, options):
    need("zarr", "reading Zarr")
    xarray = need("xarray", "opening weather data")
    return xarray.open_dataset(paths[0], engine="zarr", chunks=chunks, **{"decode_timedelta": True, **options})

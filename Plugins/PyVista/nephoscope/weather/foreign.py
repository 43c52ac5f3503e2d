# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Files that `open` does not read: what they are, and how to get a dataset from them."""
from __future__ import annotations

import re
from pathlib import Path
from zipfile import BadZipFile, ZipFile

# Names of files that PyVista and ParaView read as meshes; NetCDF, HDF5 and GRIB are weather here.
ENDINGS = frozenset(".vtk .vtu .vtp .vts .vtr .vti .vtm .vtmb .pvtu .pvtp .pvts .pvtr .pvti .pvtk .vtkhdf .pvd .case .encas .foam .cgns .e .ex2 .exo .exii "
                    ".msh .cas .inp .ply .stl .obj .xdmf .xmf .hdr .mha .mhd .nrrd".split())
TO_NETCDF = "Convert it to NetCDF"
TABLE = ("For a regular grid make a dataset, pandas.{read}(path).set_index(['lev', 'lat', 'lon']).to_xarray(), with the names of your columns, and pass that. "
         "Draw scattered points by nephoscope.add_splats(plotter, pyvista.PolyData(table[['x', 'y', 'z']].to_numpy())).")
IRIS = TO_NETCDF + " by Iris (pip install scitools-iris): iris.save(iris.load(path), 'file.nc'). Then open that file."
COMPRESSED = ((b"\x1f\x8b", "gzip", "gunzip"), (b"BZh", "bzip2", "bunzip2"), (b"\xfd7zXZ\0", "xz", "unxz"), (b"\x28\xb5\x2f\xfd", "zstd", "unzstd"))
STARTS = (  # first bytes: what they tell, and the remedy
    ((b"\0\0\0\0\0\0\0\x14", b"\x14\0\0\0\0\0\0\0", b"\0\0\0\0\0\0\0\x0f"), "a fields file of the Unified Model", IRIS),
    ((b"II*\0", b"MM\0*", b"II+\0", b"MM\0+"), "a TIFF picture, perhaps GeoTIFF", "Open it by rioxarray (pip install rioxarray): dataset = xarray.open_dataset(path, engine='rasterio'), "
     "and pass the dataset. Without coordinates it is a picture for a surface: plotter.add_mesh(nephoscope.globe_surface(), texture=pyvista.read_texture(path))."),
    ((b"\x0e\x03\x13\x01",), "HDF4, as of MODIS", TO_NETCDF + " by h4tonccf, or read the variables by pyhdf (pip install pyhdf) and put them into an xarray.Dataset."),
    ((b"AR2V", b"ARCHIVE2"), "a radar volume of NEXRAD", "Open it by xradar (pip install xradar): xradar.io.open_nexradlevel2_datatree(path). Put the sweeps on a grid, and pass that dataset."),
    ((b"\x93NUMPY", ), "an array of numpy", "Draw it without coordinates, nephoscope.add_cells(plotter, numpy.load(path)), or put it into an xarray.DataArray with coordinates, and pass that."),
    ((b"PAR1",), "a Parquet table", TABLE.format(read="read_parquet")),
)
PP = (b"\x00\x00\x01\x00", b"\x00\x01\x00\x00")  # the length of a header, before and behind it
GRIB_NAMES = (".grib", ".grib2", ".grb", ".grb2", ".gb2", ".gb", ".grib1", ".grb1")
DAMAGED = (*GRIB_NAMES, ".nc", ".nc4", ".cdf", ".h5", ".he5", ".hdf5")  # if such a file holds text
MESH, TABLE_FILE = "is a mesh", "is neither GRIB nor NetCDF, but a text file, perhaps a table"
PAGE = (b"<!doctype html", b"<html", b"<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<error")


def format_of(start: bytes) -> str:
    """``"NetCDF"``, ``"GRIB"`` or ``""``, from the first bytes of a file. Bulletins have headers before GRIB, in which the edition follows three bytes later."""
    if start[:3] == b"CDF" or start[:8] == b"\x89HDF\r\n\x1a\n":
        return "NetCDF"
    damaged = start.startswith(b"GRIB") and not _is_text(start)
    return "GRIB" if damaged or re.search(rb"GRIB.{3}[\x01\x02]", start, re.DOTALL) else ""


def refusal(path: Path, start: bytes, reads: str) -> str:
    """What a file is that is neither GRIB nor NetCDF, and a remedy. `reads`: a sentence about what is read."""
    if told := described(path, start):
        return f"{told} {reads}"
    return (f"{path} is neither GRIB nor NetCDF: it begins with {start[:8]!r}" + ("; the file is empty." if not start else ".")
            + (" By its name it should be GRIB: it is damaged or incomplete." if path.suffix.lower() in GRIB_NAMES else ""))


def first_bytes(path: Path) -> bytes:
    with path.open("rb") as file:
        return file.read(65536)  # bulletins have headers


def described(path: Path, start: bytes) -> str:
    """A sentence that says what the file is, and one with a remedy; empty if it is not known. `start`: its first bytes."""
    what, remedy = identified(path, start)
    return what and f"{path} {what}. {remedy}"


def identified(path: Path, start: bytes) -> tuple[str, str]:
    """What the file is, for example ``"is a PP file of the Met Office"``, and a remedy in Python; both empty if it is not known."""
    ending = path.suffix.lower()
    compressed = next(((f"is compressed by {name}", f"Unpack it: {program} {path.name}.") for magic, name, program in COMPRESSED if start.startswith(magic)), None)
    if compressed is not None:
        return compressed
    if start.lstrip()[:64].lower().startswith(PAGE):
        return "is a web page, not data", "The download has failed, for example because it needs a login. Look at it in a browser."
    if start[:4] in PP and start[260:264] == start[:4]:
        return "is a PP file of the Met Office", IRIS
    if b"BUFR" in start[:4096]:
        return "is BUFR, which holds observations at single places", ("Read them into a table by pdbufr (pip install pdbufr), and draw them as points: "
                                                                      "nephoscope.add_splats(plotter, pyvista.PolyData(...)).")
    known = next(((f"is {what}", remedy) for magics, what, remedy in STARTS if start.startswith(magics)), None)
    if known is not None:
        return known
    if ending in ENDINGS or start.startswith((b"# vtk DataFile", b"<VTKFile")):
        return MESH, f"Read it by pyvista.read({str(path)!r}), and draw it by nephoscope.add_cells or add_splats."
    return _of_text(start) if _is_text(start) and ending not in DAMAGED else ("", "")


def _is_text(start: bytes) -> bool:
    part = start[:2048]
    return bool(part) and b"\0" not in part and sum(32 <= byte < 127 or byte in b"\t\r\n" or byte >= 128 for byte in part) == len(part)


def _of_text(start: bytes) -> tuple[str, str]:
    text = start.decode("latin-1").lstrip().lower()
    if text.startswith("dset ") or "\ndset " in text:
        return "is a descriptor of GrADS", f"{TO_NETCDF} by CDO: cdo -f nc import_binary file.ctl file.nc. Then open that file."
    if text.startswith("netcdf ") and "{" in text:
        return "is the text form of NetCDF (CDL)", "Make the file: ncgen -o file.nc file.cdl."
    if text.startswith("{"):
        return "is JSON", "If it has the references of kerchunk, open it by xarray.open_dataset(path, engine='kerchunk') (pip install kerchunk), and pass the dataset."
    return TABLE_FILE, TABLE.format(read="read_csv")


def inside(path: Path) -> str:
    """As `described` for an archive of several files; empty for a Zarr store, or if it cannot be read."""
    try:
        names = [name for name in ZipFile(path).namelist() if not name.endswith("/")]
    except BadZipFile:
        return f"{path} is named .zip, but is no archive: it is damaged or incomplete. Fetch it again."
    if any(Path(name).name in (".zgroup", ".zmetadata", "zarr.json", ".zarray") for name in names):
        return ""
    listed = ", ".join(names[:3]) + (", ..." if len(names) > 3 else "")
    return f"{path} is an archive of {listed or 'nothing'}, but no Zarr store. Unpack it: unzip {path.name}. Then open the files in it."

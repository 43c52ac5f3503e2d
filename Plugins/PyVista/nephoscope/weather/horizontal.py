# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Horizontal positions in a dataset: longitudes and latitudes of its points, and the direction of its rows."""
from __future__ import annotations

import re
from dataclasses import dataclass, field

import numpy as np

from .._checks import listed
from .axes import eastward, northward, notes_of_order
from .caps import Caps, find_caps
from .fold import Fold, closed_fold
from .gaps import notes_of_gaps, with_gaps
from .gaussian import Rows, find_rows
from .projections import Projection, find_lost_projection, find_projection, mapping_of, row_angles, vectors

# Spellings of CF 1.11, sections 4.1 and 4.2, in lower case, also as words.
_EAST = re.compile(r"(deg(ree)?s?|°)[\s_]*e(ast)?")
_NORTH = re.compile(r"(deg(ree)?s?|°)[\s_]*n(orth)?")
_LON = ("lon", "longitude", "lons", "long", "xlong", "nav_lon", "glon", "clon", "loncell", "lon_rho", "geolon", "geolon_t", "tlong", "mesh2d_face_x", "xlong_m", "lon2d", "grid_center_lon")
_LAT = ("lat", "latitude", "lats", "xlat", "nav_lat", "glat", "clat", "latcell", "lat_rho", "geolat", "geolat_t", "tlat", "mesh2d_face_y", "xlat_m", "lat2d", "grid_center_lat")
_NUMBERED = re.compile(r"(g\d+_|grid)(lon|lat)(_\d+)?")  # of NCL


class GridError(ValueError):
    """A dataset whose points cannot be placed; the message names what was looked for and what the dataset has."""


@dataclass
class Horizontal:
    """`dims`: the dimensions of the grid, rows first. There is one if the points are a list, and three (face, rows, columns) on a cubed sphere, whose points are a list too."""
    dims: tuple[str, ...]
    longitude: np.ndarray  # degrees; 1-D along the last dimension, 2-D, or 1-D along the only one
    latitude: np.ndarray
    kind: str
    names: tuple[str, str]
    projection: Projection | None = None
    notes: list[str] = field(default_factory=list)
    rows: Rows | None = None  # of a reduced Gaussian grid: converts its list of points to even rows
    columns: np.ndarray | None = None  # the columns of the file that form a closed ring (curvilinear) or run eastward (regular)
    lines: np.ndarray | None = None  # the rows of the file that form a monotonic axis
    fold: Fold | None = None  # of a tripolar grid, after the columns have been closed
    caps: Caps | None = None  # rows added at the poles of closed rings, after the fold
    missing: np.ndarray | None = None  # True where the file has no position for a point; such points are hidden
    gaps: list[str] = field(default_factory=list)  # sentences about lines that are missing inside axes and were added, without values

    @property
    def is_list(self) -> bool:
        return len(self.dims) in (1, 3) and self.rows is None

    @property
    def is_regular(self) -> bool:
        return self.rows is not None or (len(self.dims) == 2 and self.longitude.ndim == 1)

    @property
    def shape(self) -> tuple[int, ...]:
        return (len(self.latitude), len(self.longitude)) if self.is_regular else self.longitude.shape

    def places(self) -> tuple[np.ndarray, np.ndarray]:
        """Longitude and latitude of every point, in the shape of the grid."""
        if self.is_regular:
            return tuple(np.meshgrid(self.longitude, self.latitude))
        return self.longitude, self.latitude

    def angles(self) -> np.ndarray:
        """Angles from east to the rows' direction of growing x, counter-clockwise, in radians."""
        lon, lat = self.places()
        if self.is_regular:
            return np.zeros(lon.shape)
        if self.projection:
            return self.projection.angles(lon, lat)
        if self.columns is None:
            return row_angles(lon, lat)
        rows = slice(None, -1 if self.fold and self.fold.added else None)
        angles = row_angles(beyond_seam(lon[rows]), beyond_seam(lat[rows]))[:, 1:-1]
        return self.fold(angles) if rows.stop else angles


def beyond_seam(field: np.ndarray) -> np.ndarray:
    """Columns of a ring, whose last one repeats the first one, with one more on either side."""
    return np.concatenate([field[..., -2:-1], field, field[..., 1:2]], axis=-1)


def is_longitude(name: str, variable) -> bool:
    return _is_axis(name, variable, "longitude", _EAST, _LON)


def is_latitude(name: str, variable) -> bool:
    return _is_axis(name, variable, "latitude", _NORTH, _LAT)


def _is_axis(name: str, variable, standard: str, units: re.Pattern, names: tuple[str, ...]) -> bool:
    if not np.issubdtype(variable.dtype, np.number):
        return False
    stated = str(variable.attrs.get("standard_name", ""))
    if stated:
        return stated == standard
    numbered = _NUMBERED.fullmatch(name.lower())
    return units.fullmatch(str(variable.attrs.get("units", "")).strip().lower()) is not None or name.lower() in names or bool(numbered and numbered[2] == standard[:3])


def find_horizontal(dataset, variable, used: set[str]) -> Horizontal:
    """The grid of `variable`, whose dimensions `used` are time, levels and the like."""
    dims = tuple(dim for dim in variable.dims if dim not in used)
    least = 3 if len(dims) == 3 else 1  # GEOS' cubed sphere also has one-dimensional axes, which are wrong
    lon = _coordinate(dataset, variable, dims, is_longitude, least)
    lat = _coordinate(dataset, variable, dims, is_latitude, least)
    if len(dims) == 3 and lon is not None and lat is not None:
        return Horizontal(dims, *(np.ravel(_degrees(axis.transpose(*dims))) for axis in (lon, lat)), "cubed sphere", (str(lon.name), str(lat.name)))
    if len(dims) not in (1, 2):
        several = [dim for dim in dims if dataset.sizes[dim] > 1] or list(dims)  # a section gets a longitude or a latitude of one entry
        other = next((dim for dim in several if not any(dim in found.dims for found in (lon, lat) if found is not None)), dims[0] if dims else "")
        raise GridError(f"{variable.name!r} has the dimensions {listed([dim for dim in variable.dims if dim in several or dim not in dims])}: besides time and levels it should have one or two dimensions, but it has "
                        f"{listed(several)}. " + (f"Choose one index along the other dimensions, ds.isel({other}=0), or name the levels: globe(vertical='...')." if dims else "It is a single profile, which cannot be drawn."))
    projection = find_projection(dataset, variable)
    if lon is None and lat is None:
        _refuse_flat(dataset, variable)
    if lon is not None and lat is not None:
        return _given(dataset, dims, lon, lat, projection, variable)
    if len(dims) == 1 and (found := _of_healpix(dataset, dims)) is not None:
        return found
    if len(dims) == 1 and (found := _of_mesh(dataset, dims)) is not None:
        return found
    if projection and len(dims) == 2:
        return _projected(dataset, dims, projection)
    lost, mapping = find_lost_projection(dataset, variable, dims)
    if lost and len(dims) == 2:
        grid = _projected(dataset, dims, lost)
        grid.notes.append(f"{variable.name!r} has no attribute grid_mapping: {mapping!r} was taken")
        return grid
    raise GridError(_why_not(dataset, variable, dims, projection, "longitudes" if lon is None else "latitudes"))


def _refuse_flat(dataset, variable) -> None:
    from .flat import is_flat
    if is_flat(dataset):
        raise GridError(f"The axes of {variable.name!r} are lengths and not positions on the Earth, so the data are flat: use ds.nephoscope.grid() for the mesh. plot() and add_cells() draw "
                        "them flat.")


def _why_not(dataset, variable, dims, projection, missing: str) -> str:
    """Why the points of a variable have no positions, and the remedy."""
    if len(dims) == 1 and (fixed := _fixed(dataset, dims[0])):
        return section(*fixed)
    if projection is None and not mapping_of(dataset, variable) and any(_is_projected(dataset, dim) for dim in dims):
        named = str(variable.attrs.get("grid_mapping", ""))
        why = f"its grid_mapping {named!r} is not in the dataset" if named else "it has no attribute grid_mapping, which arithmetic in xarray drops (xarray.set_options(keep_attrs=True) keeps it)"
        return (f"The axes {listed(list(map(str, dims)))} belong to a projection, but {variable.name!r} does not say to which: {why}. Restore both, the attribute and the variable that it "
                f"names, or give the coordinates lon and lat on ({', '.join(map(str, dims))}).")
    return _unknown(dataset, variable, dims, projection, missing)


def _unknown(dataset, variable, dims, projection, missing: str) -> str:
    return (f"No {missing} were found for {variable.name!r}, whose grid is ({', '.join(dims)}). They are identified by standard_name, by units (degrees_east, "
            f"degrees_north), by grid_mapping and by name. There are: {listed([str(name) for name in dataset.variables])}. "
            "Name them: ds[NAME].attrs['units'] = 'degrees_east'. If the axes are lengths, the data are flat: ds.nephoscope.grid(x='...', y='...', z='...')." + (_remedy_of_list(dataset, dims[0]) if len(dims) == 1 else "")
            + (" If lon_rho and lat_rho are in the grid file of ROMS or CROCO, give it: nephoscope.open(DATA, mesh=GRID)." if any(str(dim).startswith(("xi_", "eta_")) for dim in dims) else "")
            + (f" The grid mapping {mapping!r} is not a known one." if (mapping := mapping_of(dataset, variable)) and projection is None else ""))


def section(kind: str, name: str, value: str = "") -> str:
    """The message for data of one `kind`, "longitude" or "latitude", of the coordinate `name`."""
    return (f"The data are a section at one {kind}{value}, which has no area to draw from outside. Keep at least two {kind}s, for example ds.sel({name}=slice(FIRST, LAST)). "
            "A picture of one time by height: dataset.nephoscope.plot().")


def _fixed(dataset, dim) -> tuple[str, str, str] | None:
    """The coordinate that has one value, if `dim` is the other one."""
    for kind, fits, other in (("longitude", is_longitude, is_latitude), ("latitude", is_latitude, is_longitude)):
        if dim in dataset.variables and other(str(dim), dataset[dim]):
            for name, variable in dataset.variables.items():
                if fits(str(name), variable) and variable.ndim == 0:
                    return kind, str(name), f", {float(variable):g}"
    return None


def _is_projected(dataset, dim) -> bool:
    return str(dim) in ("rlon", "rlat") or (dim in dataset.variables and str(dataset[dim].attrs.get("standard_name", "")).startswith(("grid_l", "projection_")))


def _remedy_of_list(dataset, dim) -> str:
    told = {str(key): value for key, value in dataset.attrs.items() if str(key).lower() in ("number_of_grid_used", "uuidofhgrid", "grid_file_uri", "grid_file", "mesh_file", "grid_name")}
    text = (" If they are in a separate mesh file, give it: nephoscope.open(DATA, mesh=GRID). "
            + ("The data name it: " + ", ".join(f"{key} {value}" for key, value in told.items()) + "." if told else "For ICON it is icon_grid_*.nc, for MPAS the init or static file."))
    nside = round((dataset.sizes[dim] / 12) ** 0.5)
    order = f" If they are pixels of HEALPix: ds[NAME].attrs['healpix_nside'] = {nside}, and ['healpix_order'] = 'nested' or 'ring'."
    return text + (order if nside & (nside - 1) == 0 and 12 * nside * nside == dataset.sizes[dim] else "")


def _of_healpix(dataset, dims) -> Horizontal | None:
    from .healpix import healpix_centres, healpix_of
    found = healpix_of(dataset, dims[0])
    return Horizontal(dims, *healpix_centres(*found), "HEALPix", ("computed", "computed")) if found else None


def _of_mesh(dataset, dims) -> Horizontal | None:
    """The face centres or the nodes of a mesh, if the data have no coordinates themselves."""
    from .polygons import find_polygons
    try:
        found = find_polygons(dataset, Horizontal(dims, np.empty(0), np.empty(0), "", ("", "")))
    except GridError:
        return None
    places = found.corners if found.on_corners else (found.corners[np.maximum(found.faces, 0)] * (found.faces >= 0)[..., None]).sum(1)
    lon, lat = np.degrees(np.arctan2(places[:, 1], places[:, 0])), np.degrees(np.arctan2(places[:, 2], np.hypot(places[:, 0], places[:, 1])))
    return Horizontal(dims, lon, lat, "list of points", ("computed from the mesh",) * 2)


def _coordinate(dataset, variable, dims: tuple[str, ...], fits, least: int):
    """The coordinate that `fits`, on some of `dims`; those of the variable come first."""
    listed_names = str(variable.attrs.get("coordinates", variable.encoding.get("coordinates", ""))).split()
    names = [*variable.coords, *listed_names, *dataset.variables]
    for name in dict.fromkeys(names):
        if name in dataset.variables and fits(str(name), dataset[name]):
            found = dataset[name]
            extra = [dim for dim in found.dims if dim not in dims]
            found = found.isel({dim: 0 for dim in extra})  # WRF's have time
            if found.ndim >= least and set(found.dims) <= set(dims):
                return found
    return None


def _given(dataset, dims, lon, lat, projection, variable) -> Horizontal:
    names = (str(lon.name), str(lat.name))
    x, y = _degrees(lon), _degrees(lat)
    if len(dims) == 1:
        found = find_rows(x, y, variable.attrs.get("GRIB_pl")) if variable.attrs.get("GRIB_gridType") != "healpix" else None
        if found:
            note = f"reduced Gaussian grid, {len(x)} points: rows interpolated to {len(found[0].longitude)} longitudes"
            return Horizontal(dims, found[0].longitude, found[1], "reduced Gaussian", names, notes=[note], rows=found[0])
        return Horizontal(dims, x, y, "list of points", names, projection)
    if lon.ndim == 1 and lat.ndim == 1:
        if lon.dims == lat.dims:
            other = next(dim for dim in dims if dim != lon.dims[0])
            raise GridError(f"{names[0]!r} and {names[1]!r} both lie along {lon.dims[0]!r}, a list of points, and {other!r} is neither time nor levels. Choose one index along it, "
                            f"ds.isel({other}=0), or name the levels: globe(vertical={other!r}).")
        return _regular(lon, lat, x, y, names)
    x = np.broadcast_to(_on(lon, x, dims), _shape(lon, lat, dims))
    y = np.broadcast_to(_on(lat, y, dims), x.shape)
    columns = ring(x, y)
    if columns is not None:
        x, y = x[:, columns], y[:, columns]
    missing = ~_possible(x, y)
    lines, fold = closed_fold(x, y) if not missing[[0, -1]].any() else (None, None)
    if fold:
        x, y, missing = (fold(values if lines is None else values[lines]) for values in (x, y, missing))
        missing[-1] |= fold.hidden
    if missing.all():
        if projection:
            return _projected(dataset, dims, projection)
        raise GridError(f"{names[0]!r} and {names[1]!r} have only fill values, so no point has a longitude and a latitude.")
    kind = projection.name if projection else "curvilinear"
    places = {"columns": columns, "lines": lines, "fold": fold}
    if not missing.any():
        return _capped(Horizontal(dims, x, y, kind, names, projection, **places))
    lost = ~_possible(x, y)
    notes = [f"{lost.sum()} of {lost.size} points have no longitude or latitude: they are hidden"] if lost.any() else []
    notes += ["the northern fold is closed: the last row meets itself"] if fold else []
    return _capped(Horizontal(dims, _filled(x, lost), _filled(y, lost), kind, names, projection, notes=notes, missing=missing, **places))


def _capped(grid: Horizontal) -> Horizontal:
    """`grid` with the holes closed that its rings leave at their poles."""
    grid.caps = find_caps(grid.longitude, grid.latitude)
    if grid.caps:
        grid.longitude, grid.latitude = grid.caps.places(grid.longitude, grid.latitude)
        grid.missing = grid.missing if grid.missing is None else grid.caps(grid.missing)
        grid.notes.append(f"closed at {'its poles' if grid.caps.first and grid.caps.last else 'one of its poles'}: a row is added with the mean of the last one")
    return grid


def _ringed(grid: Horizontal) -> Horizontal:
    """`grid` of a projection, closed at its seam if that goes around the globe, as rotated grids may, and at its poles."""
    around = ring(grid.longitude, grid.latitude)
    if around is not None:
        grid.columns = around if grid.columns is None else grid.columns[around]
        grid.longitude, grid.latitude = grid.longitude[:, around], grid.latitude[:, around]
        grid.missing = grid.missing if grid.missing is None else grid.missing[:, around]
    return _capped(grid)


def _regular(lon, lat, x: np.ndarray, y: np.ndarray, names) -> Horizontal:
    (east, columns), (north, lines) = eastward(x), northward(y)
    if not len(east) or not len(north):
        raise GridError(f"{names[0]!r} or {names[1]!r} has only missing values, so no point has a position.")
    notes = notes_of_order(names[0], len(x), columns) + notes_of_order(names[1], len(y), lines)
    (east, columns, no_column), (north, lines, no_line) = with_gaps(east, columns), with_gaps(north, lines)
    grid = Horizontal((lat.dims[0], lon.dims[0]), east, north, _regular_kind(north), names, notes=notes, columns=columns, lines=lines)
    return _with_gaps(grid, (east, no_column), (north, no_line))


def _with_gaps(grid: Horizontal, *added: tuple[np.ndarray, np.ndarray]) -> Horizontal:
    """`added`: x and y axes, and True for each of their lines that are not in the file."""
    grid.gaps = [text for name, axis in zip(grid.names, added) for text in notes_of_gaps(name, *axis)]
    if grid.gaps:
        missing = added[1][1][:, None] | added[0][1]
        grid.missing = missing if grid.missing is None else grid.missing | missing
        grid.notes += grid.gaps
    return grid


def ring(x: np.ndarray, y: np.ndarray) -> np.ndarray | None:
    """Columns that close a grid around the globe, as in ocean models: the first is repeated after the last, and columns that a halo repeats are left out. None if the grid is not a ring."""
    if x.shape[1] < 8:
        return None
    there = _possible(x, y)
    turn = np.where(there[:, 1:] & there[:, :-1], np.mod(np.diff(x, axis=1) + 180, 360) - 180, 0.0)
    around = np.median(np.abs(turn.sum(axis=1)))
    places = vectors(x, y)
    steps = np.linalg.norm(np.diff(places, axis=1), axis=-1)
    if around < 300 and not _ends_meet(places, steps):
        return None
    step = np.nanmedian(steps)
    apart = lambda i: np.nanmedian(np.linalg.norm(places[:, i] - places[:, 0], axis=-1)) / step
    for halo in (-1, -2, -3):
        if apart(halo) < 0.01:
            return np.arange(x.shape[1] + halo + 1) if halo < -1 else None
    return np.append(np.arange(x.shape[1]), 0) if apart(-1) < 2 else None


def _ends_meet(places: np.ndarray, steps: np.ndarray) -> bool:
    """True if the ends of the rows are neighbours, also where a row does not go around the geographic poles, as on rotated grids. `steps`: along the rows."""
    if not np.isfinite(places).all():
        return False
    usual = np.median(steps, axis=1)
    gap = np.linalg.norm(places[:, -1] - places[:, 0], axis=-1)
    long = usual > 1e-6
    return bool(long.any() and np.quantile(gap[long] / usual[long], 0.9) < 1.5)


def _possible(x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """False where the file has a fill value instead of a longitude or a latitude."""
    with np.errstate(invalid="ignore"):
        return (np.abs(y) <= 90.001) & (np.abs(x) <= 1e4)


def _filled(values: np.ndarray, missing: np.ndarray) -> np.ndarray:
    """Replaces missing values by the value of the previous point in the order of the file."""
    before = np.maximum.accumulate(np.where(missing.ravel(), 0, np.arange(missing.size)))
    start = np.flatnonzero(~missing.ravel())[0]
    return values.ravel()[np.maximum(before, start)].reshape(values.shape)


def _shape(lon, lat, dims) -> tuple[int, ...]:
    return tuple({**lon.sizes, **lat.sizes}[dim] for dim in dims)


def _on(coordinate, values: np.ndarray, dims) -> np.ndarray:
    order = [coordinate.dims.index(dim) for dim in dims if dim in coordinate.dims]
    return values.transpose(order).reshape([coordinate.sizes.get(dim, 1) for dim in dims])


def _degrees(coordinate) -> np.ndarray:
    values = np.asarray(coordinate.values, dtype=float)
    units = str(coordinate.attrs.get("units", "")).lower()
    cells = str(coordinate.name).lower() in ("loncell", "latcell", "clon", "clat") and not units and np.nanmax(np.abs(values)) <= 2 * np.pi + 1e-6
    return np.degrees(values) if units in ("radian", "radians", "rad") or cells else values


def _regular_kind(latitude: np.ndarray) -> str:
    steps = np.diff(latitude)
    return "longitude-latitude" if steps.size == 0 or np.allclose(steps, steps[0], rtol=1e-3) else "longitude-latitude, uneven (Gaussian or another)"


def _projected(dataset, dims, projection: Projection) -> Horizontal:
    axes = {}
    for standard, axis in (("y", "Y"), ("x", "X")):
        names = (f"projection_{standard}_coordinate", f"projection_{standard}_angular_coordinate", "grid_longitude" if axis == "X" else "grid_latitude")
        usual = ("x", "xc", "rlon", "west_east") if axis == "X" else ("y", "yc", "rlat", "south_north")
        axes[axis] = next((dim for dim in dims if dim in dataset.variables and (
            dataset[dim].attrs.get("standard_name") in names or dataset[dim].attrs.get("axis") == axis or str(dim).lower() in usual)), None)
    if None in axes.values() or axes["X"] == axes["Y"]:
        raise GridError(f"The grid ({', '.join(dims)}) has the projection {projection.name}, but its x and y axes were not found. Say which they are: "
                        "ds['...'].attrs['standard_name'] = 'projection_x_coordinate' and 'projection_y_coordinate'.")
    (x, columns, no_column), (y, lines, no_line) = (with_gaps(projection.lengths(dataset[axes[axis]]), None) for axis in "XY")
    lon, lat = projection.to_degrees(*np.meshgrid(x, y))
    grid = Horizontal((axes["Y"], axes["X"]), lon, lat, projection.name, (axes["X"], axes["Y"]), projection, columns=columns, lines=lines)
    missing = ~_possible(lon, lat)
    if missing.all():
        raise GridError(f"The projection {projection.name} puts none of the points of {axes['X']!r} and {axes['Y']!r} on the Earth: their units are {dataset[axes['X']].attrs.get('units', 'none')!r}.")
    if missing.any():
        grid.longitude, grid.latitude, grid.missing = _filled(lon, missing), _filled(lat, missing), missing
        grid.notes.append(f"{missing.sum()} of {missing.size} points are not on the Earth: they are hidden")
    return _ringed(_with_gaps(grid, (x, no_column), (y, no_line)))

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The polygons of unstructured globes: UGRID, MPAS, ICON and other cells with bounds, HEALPix."""
from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from .healpix import healpix_corners, healpix_of
from .horizontal import GridError
from .projections import vectors


@dataclass
class Polygons:
    """`corners`: unit vectors (m, 3); `faces`: their indices (n, k), -1 where a face has fewer, counter-clockwise from above."""
    corners: np.ndarray
    faces: np.ndarray
    source: str
    on_corners: bool = False  # True if the fields are at the corners


def find_polygons(dataset, horizontal) -> Polygons:
    for way in (_cubed, _mpas, _ugrid, _healpix, _bounds, _points):
        found = way(dataset, horizontal)
        if found is not None:
            return _counter_clockwise(found)
    raise GridError(f"The points of ({horizontal.dims[0]}) have no positions. Give the mesh file: nephoscope.open(DATA, mesh=GRID).")


def _degrees(variable) -> np.ndarray:
    values = np.asarray(variable.values, float)
    units = str(variable.attrs.get("units", ""))
    return np.degrees(values) if units.startswith("rad") or (not units and np.nanmax(np.abs(values)) <= 2 * np.pi + 1e-6) else values


def _cubed(dataset, horizontal) -> Polygons | None:
    """Faces of a cubed sphere from the positions of the corners, which have one row and one column more than the centres."""
    if len(horizontal.dims) != 3:
        return None
    shape = tuple(dataset.sizes[dim] + (i > 0) for i, dim in enumerate(horizontal.dims))
    lon, lat = (next((v for name, v in dataset.variables.items() if v.shape == shape and v.dims[0] == horizontal.dims[0] and word in str(name).lower()), None) for word in ("lon", "lat"))
    if lon is None or lat is None:
        raise GridError(f"The cubed sphere ({', '.join(horizontal.dims)}) has cell centres, but no longitudes and latitudes of the cell corners, {shape} as corner_lons and corner_lats "
                        f"of GEOS. Add them, or choose one face: ds.isel({horizontal.dims[0]}=0).")
    corners = vectors(_degrees(lon), _degrees(lat))
    around = [corners[:, :-1, :-1], corners[:, :-1, 1:], corners[:, 1:, 1:], corners[:, 1:, :-1]]
    return merged(np.stack([part.reshape(-1, 3) for part in around], 1), "the corners of a cubed sphere")


def _mpas(dataset, horizontal) -> Polygons | None:
    if not {"verticesOnCell", "nEdgesOnCell", "lonVertex", "latVertex"} <= set(dataset.variables) or dataset["verticesOnCell"].dims[0] != horizontal.dims[0]:
        return None
    faces, count = dataset["verticesOnCell"].values.astype(int) - 1, dataset["nEdgesOnCell"].values
    faces = np.where(np.arange(faces.shape[1]) < count[:, None], faces, -1)
    places = [np.degrees(dataset[name].values.astype(float)) for name in ("lonVertex", "latVertex")]
    return Polygons(vectors(*places), faces, "MPAS, verticesOnCell")


def _ugrid(dataset, horizontal) -> Polygons | None:
    for name, variable in dataset.variables.items():
        if variable.attrs.get("cf_role") != "mesh_topology" or "face_node_connectivity" not in variable.attrs:
            continue
        connectivity = dataset[variable.attrs["face_node_connectivity"]]
        x, y = (dataset[node] for node in variable.attrs["node_coordinates"].split()[:2])
        if str(x.attrs.get("standard_name", x.name)).lower().startswith("lat"):
            x, y = y, x
        faces = connectivity.values
        if connectivity.dims and dataset.sizes[connectivity.dims[0]] < 9 < dataset.sizes[connectivity.dims[-1]]:
            faces = faces.T
        start = int(connectivity.attrs.get("start_index", 0))
        faces = np.where(np.isfinite(faces) & (np.nan_to_num(faces) >= start) & (np.nan_to_num(faces) < start + x.size), np.nan_to_num(faces) - start, -1).astype(int)
        dim = horizontal.dims[0]
        if dim not in (*connectivity.dims, *x.dims):
            raise GridError(f"The fields are on {dim!r}, and the mesh {name!r} has faces on {connectivity.dims[0]!r} and nodes on {x.dims[0]!r}: fields on edges are not drawn. Average them to faces.")
        return Polygons(vectors(_degrees(x), _degrees(y)), faces, f"UGRID, {connectivity.name}", on_corners=dim in x.dims)
    return None


_BOUNDS = (("clon_vertices", "clat_vertices"), ("clon_bnds", "clat_bnds"), ("lon_vertices", "lat_vertices"), ("lon_bnds", "lat_bnds"), ("lon_bounds", "lat_bounds"), ("grid_corner_lon", "grid_corner_lat"))


def _bounds(dataset, horizontal) -> Polygons | None:
    stated = tuple(dataset[name].attrs.get("bounds", "") if name in dataset.variables else "" for name in horizontal.names)
    for x, y in (stated, *_BOUNDS):
        if x in dataset.variables and y in dataset.variables and dataset[x].ndim == 2 and dataset[x].dims[0] == horizontal.dims[0]:
            return merged(vectors(_degrees(dataset[x]), _degrees(dataset[y])), f"bounds {x}, {y}")
    return None


def _points(dataset, horizontal) -> Polygons | None:
    """Where there is no mesh: triangles between the points, with the fields at their corners."""
    from .triangles import triangulated
    if not horizontal.longitude.size:
        return None
    places = vectors(horizontal.longitude, horizontal.latitude)
    return Polygons(np.nan_to_num(places), triangulated(places, horizontal.dims[0]), f"triangles between the {len(places)} points, since there is no mesh", on_corners=True)


def merged(corners: np.ndarray, source: str) -> Polygons:
    """From the corners of each face (n, k, 3); corners within about a metre become one, and corners that a face repeats are left out."""
    flat = np.nan_to_num(corners.reshape(-1, 3), nan=9.0)
    _, first, inverse = np.unique(np.round(flat * 5e6).astype(np.int64), axis=0, return_index=True, return_inverse=True)
    faces = inverse.reshape(corners.shape[:2])
    gone = (faces == np.roll(faces, 1, axis=1)) | ~np.isfinite(corners).all(-1)
    order = np.argsort(gone, axis=1, kind="stable")
    faces = np.take_along_axis(np.where(gone, -1, faces), order, axis=1)
    return Polygons(flat[first], faces, source)


def _counter_clockwise(polygons: Polygons) -> Polygons:
    """Turns the faces that are clockwise from above."""
    faces = polygons.faces
    count = (faces >= 0).sum(axis=1)
    corners = polygons.corners[np.maximum(faces, 0)] * (faces >= 0)[..., None]
    middle = corners.sum(1) / np.maximum(count, 1)[:, None]
    following = np.where(np.arange(faces.shape[1]) + 1 < count[:, None], np.roll(np.arange(faces.shape[1]), -1)[None], 0)
    after = np.take_along_axis(corners, following[..., None], axis=1)
    area = (np.cross(corners, after) * middle[:, None]).sum((1, 2))
    place = np.arange(faces.shape[1])[None]
    turned = np.where(place < count[:, None], count[:, None] - 1 - place, place)
    polygons.faces = np.where((area < 0)[:, None], np.take_along_axis(faces, turned, axis=1), faces)
    return polygons


def _healpix(dataset, horizontal) -> Polygons | None:
    found = healpix_of(dataset, horizontal.dims[0])
    return None if found is None else merged(healpix_corners(*found), f"HEALPix, nside {found[0]}, {'nested' if found[1] else 'ring'}" + ("" if found[2] is None else ", by the numbers of the pixels"))

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The light that arrives at the ground below lit clouds."""
from __future__ import annotations

import warnings

import numpy as np
import pyvista
from vtkmodules.vtkCommonDataModel import vtkCellLocatorStrategy, vtkStaticCellLocator
from vtkmodules.vtkFiltersCore import vtkProbeFilter
from vtkmodules.vtkFiltersGeometry import vtkDataSetSurfaceFilter

from .light import sunlight
from .light_image import clear_irradiance, planet_radius, sag, zenith_cosine


def irradiance(clouds: pyvista.DataSet, places: np.ndarray, sky_light: float) -> np.ndarray:
    """At places on the ground, (..., 3): the sun's beam, with the shadows of the clouds, and the diffuse light that leaves them below; beside them that of the sky."""
    there = np.isfinite(places).all(axis=-1)
    ground = pyvista.PolyData(places[there])
    ground.GetFieldData().PassData(clouds.GetFieldData())
    cosine = zenith_cosine(clouds, places[there])
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", ".*The sun is below the horizon", RuntimeWarning)  # the light of the clouds has told it
        direct = np.maximum(cosine, 0) * sunlight(ground, clouds=clouds).point_data["SunTransmittance"] if ground.n_points else cosine
    sky = clear_irradiance(cosine, sky_light) - np.maximum(cosine, 0)
    result = np.full(there.shape, np.nan)
    result[there] = direct + _diffuse(clouds, places[there], sky)
    return result


def _diffuse(clouds: pyvista.DataSet, places: np.ndarray, otherwise: np.ndarray) -> np.ndarray:
    """The diffuse light at the lower side of the mesh above or below the places."""
    points, triangles, light = _lower_side(clouds)
    if not len(triangles) or not len(places):
        return otherwise
    if planet_radius(clouds) > 0:
        points, places = (x / np.linalg.norm(x, axis=1, keepdims=True) for x in (points, places))
        low, high = (1 - 1e-4) * points, (1 + 2 * sag(clouds) + 1e-4) * points  # facets lie below the sphere
    else:
        points, places = points * (1, 1, 0), places * (1, 1, 0)
        high = points + (0, 0, 1e-3 * np.ptp(points, axis=0).max())
        low = 2 * points - high
    columns = pyvista.UnstructuredGrid({pyvista.CellType.WEDGE: np.hstack([triangles, triangles + len(points)])}, np.concatenate([low, high]))
    columns.point_data["Light"] = np.tile(light, 2)
    probe, strategy = vtkProbeFilter(), vtkCellLocatorStrategy()
    strategy.SetCellLocator(vtkStaticCellLocator())
    probe.SetFindCellStrategy(strategy)
    probe.SetInputData(pyvista.PolyData(places))
    probe.SetSourceData(columns)
    probe.Update()
    found = pyvista.wrap(probe.GetOutput()).point_data
    return np.where(found["vtkValidPointMask"] > 0, found["Light"], otherwise)


def _lower_side(clouds: pyvista.DataSet) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Points, triangles that face downwards, and the diffuse light at the points."""
    extract = vtkDataSetSurfaceFilter()
    extract.SetInputData(clouds)
    extract.Update()
    surface = pyvista.wrap(extract.GetOutput()).triangulate()
    points, triangles = surface.points.astype(float), surface.faces.reshape(-1, 4)[:, 1:]
    a, b, c = points[triangles].transpose(1, 0, 2)
    normals = np.cross(b - a, c - a)
    normals *= np.sign(np.nansum(normals * (a - np.array(clouds.center))))  # outwards, also where all cells are mirrored
    up = a / np.linalg.norm(a, axis=1, keepdims=True) if planet_radius(clouds) > 0 else np.array([0.0, 0.0, 1.0])
    down = (normals * up).sum(axis=1) < -0.01 * np.linalg.norm(normals, axis=1)
    light = surface.point_data["Irradiance"] - np.maximum(zenith_cosine(clouds, points), 0) * surface.point_data["SunTransmittance"]
    return points, triangles[down], np.maximum(light, 0)

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The light that reaches a camera from lit clouds and the ground below, in floating point. It needs only VTK.

A light of 1 is that of a white surface facing the sun. Rows of an image begin at the top.
"""
from __future__ import annotations

from typing import Any, Sequence

import numpy as np
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataSet, vtkImageData, vtkPiecewiseFunction, vtkPointSet, vtkStructuredGrid, vtkUnstructuredGrid
from vtkmodules.vtkFiltersSources import vtkPlaneSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (vtkActor, vtkCamera, vtkColorTransferFunction, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkVolume)

from . import vtkCellCompositingMapper

SKY_BELOW = 0.1  # cosine of the zenith angle below the horizon at which the sky is dark, as in vtkSunlight


def planet_radius(data: vtkDataSet) -> float:
    """The radius of the planet below a globe of Globe Grid; 0 for other data."""
    def value(name: str, otherwise: float) -> float:
        array = data.GetFieldData().GetArray(name)
        return array.GetComponent(0, 0) if array and array.GetNumberOfTuples() else otherwise
    return value("PlanetRadius", 0.0) if value("GlobeGridProjection", 1) == 0 else 0.0


def sun_of(data: vtkDataSet) -> np.ndarray:
    """The direction towards the sun that vtkSunlight recorded."""
    return np.array(data.GetFieldData().GetArray("SunDirection").GetTuple(0))


def light_upwards(data: vtkDataSet) -> np.ndarray:
    """The light that each point of a globe sends straight up, if it was computed with `FollowCamera`; otherwise the mean over all directions."""
    arrays = data.GetPointData()
    mean = vtk_to_numpy(arrays.GetArray("Sunlight"))
    if not arrays.HasArray("DiffuseSecondMoment"):
        return mean
    flux, moment, single = (vtk_to_numpy(arrays.GetArray(name)) for name in ("DiffuseFlux", "DiffuseSecondMoment", "SingleScattering"))
    places = np.array([data.GetPoint(p) for p in range(data.GetNumberOfPoints())])
    up = places / np.linalg.norm(places, axis=1, keepdims=True)
    factors = vtk_to_numpy(data.GetFieldData().GetArray("PhaseFunction"))
    angles = np.arccos(np.clip(-up @ sun_of(data), -1, 1)) / np.pi * (len(factors) - 1)
    scattered = sum((np.interp(angles, np.arange(len(factors)), factors[:, kind]) - 1) * single[:, kind] for kind in (0, 1))
    return np.maximum(mean + (flux * up).sum(axis=1) + moment + scattered, 0)


def light_of_clouds(data: vtkDataSet, camera: vtkCamera, size: Sequence[int], arrays: Sequence[str] = ("Sunlight",)) -> tuple[np.ndarray, np.ndarray]:
    """For each array of source functions, the light that reaches the camera through the clouds, (height, width, arrays), and the
    opacity of the clouds, (height, width)."""
    window, renderer, volume = _scene(data, camera, size)
    mapper, light, alpha = volume.GetMapper(), [], None
    for name in arrays:
        follows = name == "Sunlight" and data.GetPointData().HasArray("SingleScattering")
        brightest = mapper.GetBrightestCameraLight() if follows else max(float(np.nanmax(vtk_to_numpy(data.GetPointData().GetArray(name)))), 1e-30)
        colours = vtkColorTransferFunction()
        colours.AddRGBPoint(0, 0, 0, 0)
        colours.AddRGBPoint(brightest, 1, 1, 1)
        volume.GetProperty().SetColor(colours)
        mapper.SelectScalarArray(name)
        window.Render()
        rgba = _float_image(mapper)
        light.append(brightest * rgba[..., 0])
        alpha = rgba[..., 3]
    window.Finalize()
    return np.stack(light, axis=-1), alpha


def _scene(data: vtkDataSet, camera: vtkCamera, size: Sequence[int]) -> tuple[vtkRenderWindow, vtkRenderer, vtkVolume]:
    window, renderer = vtkRenderWindow(), vtkRenderer()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(*size)
    window.AddRenderer(renderer)
    renderer.AddActor(_ground_actor(data))
    volume = vtkVolume()
    mapper = vtkCellCompositingMapper()
    mapper.SetInputData(data)
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SetOpacityArrayName("ScaledExtinction")
    volume.SetMapper(mapper)
    densest = max(float(vtk_to_numpy(data.GetPointData().GetArray("ScaledExtinction")).max()), 1e-30)
    opacity = vtkPiecewiseFunction()
    opacity.AddPoint(0, 0)
    opacity.AddPoint(densest, 1)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().SetScalarOpacityUnitDistance(1 / densest)
    renderer.AddVolume(volume)
    renderer.SetActiveCamera(camera)
    _set_clipping_range(renderer, data.GetBounds())
    return window, renderer, volume


def _set_clipping_range(renderer: vtkRenderer, bounds: Sequence[float]) -> None:
    """Around all that is there; but as the ground reaches far, that alone would cut clouds near the camera."""
    camera = renderer.GetActiveCamera()
    renderer.ResetCameraClippingRange()
    near, far = camera.GetClippingRange()
    renderer.ResetCameraClippingRange(bounds)
    camera.SetClippingRange(min(near, camera.GetClippingRange()[0]), max(far, camera.GetClippingRange()[1]))


def _ground_actor(data: vtkDataSet) -> vtkActor:
    """The actor that hides clouds behind the planet or below the ground."""
    radius = planet_radius(data)
    if radius > 0:
        source = vtkSphereSource()
        source.SetRadius(radius * (1 - sag(data)))
        source.SetThetaResolution(720)
        source.SetPhiResolution(360)
    else:
        x0, x1, y0, y1, z, _ = data.GetBounds()
        reach = 50 * (x1 - x0 + y1 - y0)
        source = vtkPlaneSource()
        source.SetOrigin(x0 - reach, y0 - reach, z)
        source.SetPoint1(x1 + reach, y0 - reach, z)
        source.SetPoint2(x0 - reach, y1 + reach, z)
    mapper = vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().LightingOff()
    actor.GetProperty().SetColor(0, 0, 0)
    return actor


def sag(data: vtkDataSet) -> float:
    """How far flat cells lie below the sphere through their corners, at most, as a fraction of its radius: that of the middle of the longest diagonal."""
    places = vtk_to_numpy(data.GetPoints().GetData()).astype(float) if isinstance(data, vtkPointSet) else np.zeros((0, 3))
    lengths = np.linalg.norm(places, axis=1)
    places = np.divide(places, lengths[:, None], out=np.full_like(places, np.nan), where=lengths[:, None] > 0)
    if isinstance(data, vtkStructuredGrid):
        size = [0, 0, 0]
        data.GetDimensions(size)
        level = places[:size[0] * size[1]].reshape(size[1], size[0], 3)
        diagonals = np.concatenate([(level[1:, 1:] - level[:-1, :-1]).reshape(-1, 3), (level[1:, :-1] - level[:-1, 1:]).reshape(-1, 3)])
    elif isinstance(data, vtkUnstructuredGrid) and data.GetNumberOfCells():
        cells = data.GetCells()
        starts, corners = vtk_to_numpy(cells.GetOffsetsArray()), places[vtk_to_numpy(cells.GetConnectivityArray())]
        diagonals = np.maximum.reduceat(corners, starts[:-1]) - np.minimum.reduceat(corners, starts[:-1])
    else:
        return 0.0
    longest = np.nanmax(np.linalg.norm(diagonals, axis=-1), initial=0)
    return float(1 - np.sqrt(1 - min(longest / 2, 0.8)**2))


def _float_image(mapper: Any) -> np.ndarray:
    image = vtkImageData()
    if not mapper.CopyFloatImage(image):
        raise RuntimeError("The clouds could not be drawn in floating point.")
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetArray("RGBA")).reshape(height, width, 4)[::-1].astype(np.float64)


def rays(camera: vtkCamera, size: Sequence[int]) -> tuple[np.ndarray, np.ndarray]:
    """Origins and unit directions of the rays through the pixel centres, (height, width, 3)."""
    ahead, up = np.array(camera.GetDirectionOfProjection()), np.array(camera.GetViewUp())
    right = np.cross(ahead, up)
    right /= np.linalg.norm(right)
    up = np.cross(right, ahead)
    width, height = size
    half = camera.GetParallelScale() if camera.GetParallelProjection() else np.tan(np.radians(camera.GetViewAngle()) / 2)
    x = half * (2 * np.arange(width) + 1 - width)[None, :, None] / height
    y = half * (height - 1 - 2 * np.arange(height))[:, None, None] / height
    origin = np.broadcast_to(np.array(camera.GetPosition()), (height, width, 3))
    if camera.GetParallelProjection():
        return origin + x * right + y * up, np.broadcast_to(ahead, (height, width, 3))
    direction = ahead + x * right + y * up
    return origin, direction / np.linalg.norm(direction, axis=-1, keepdims=True)


def meet_ground(data: vtkDataSet, origin: np.ndarray, direction: np.ndarray) -> np.ndarray:
    """Positions where rays meet the ground, (height, width, 3); NaN where they miss it."""
    radius = planet_radius(data)
    if radius > 0:
        middle = (origin * direction).sum(-1)
        root = middle**2 - (origin**2).sum(-1) + radius**2
        along = -middle - np.sqrt(np.where(root >= 0, root, np.nan))
    else:
        with np.errstate(divide="ignore", invalid="ignore"):
            along = (data.GetBounds()[4] - origin[..., 2]) / direction[..., 2]
    return origin + np.where(along > 0, along, np.nan)[..., None] * direction


def longitudes_latitudes(places: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Longitudes and latitudes (degrees) of positions on a globe."""
    return np.degrees(np.arctan2(places[..., 1], places[..., 0])), np.degrees(np.arctan2(places[..., 2], np.hypot(places[..., 0], places[..., 1])))


def zenith_cosine(data: vtkDataSet, places: np.ndarray) -> np.ndarray:
    """Cosine of the angle between the sun and the vertical."""
    sun = sun_of(data)
    if planet_radius(data) > 0:
        return (places @ sun) / np.linalg.norm(places, axis=-1)
    return np.where(np.isfinite(places[..., 2]), sun[2], np.nan)


def clear_irradiance(cosine: np.ndarray, sky_light: float) -> np.ndarray:
    """The light that reaches the ground without clouds."""
    return np.maximum(cosine, 0) + sky_light * np.clip((cosine + SKY_BELOW) / (1 + SKY_BELOW), 0, 1)

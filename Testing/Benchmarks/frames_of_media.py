# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times frames of two volumes that are composited as one medium against those of each alone.

    ./nephoscope bench

Seconds are processor time of the whole process, software OpenGL included: the median of frames of a moving camera. `passes` is the number of
rounds, as often as rays entered one of the meshes. The GFS globe's clouds are clear below 0.05.
"""
import sys
import time

import numpy as np

import nephoscope
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindow

from nephoscope_testing import meshes
from nephoscope_testing.weather import cloud_volume, forecast_globe

SIZE = int(sys.argv[1]) if len(sys.argv) > 1 else 512
MOVES = 4


def hexahedra(data):
    append = vtkAppendFilter()
    append.AddInputData(data)
    append.Update()
    return append.GetOutput()


def block(low, high, cells=40):
    """An image with the array of the globe."""
    size = np.subtract(high, low)
    data = meshes.image((cells,) * 3, size / cells, low)
    values = 0.4 + 0.3 * np.sin(9e-7 * meshes.points_of(data)).sum(axis=1) / 3
    meshes.add_array(data.GetPointData(), values, "cloud_fraction")
    return data


def smoke(globe):
    """From a polygon in the storm off Mexico, a day long; with the clouds' array."""
    longitude, latitude = np.radians((-106.4, 12.2))
    flow = nephoscope.vtkFlowVolume()
    flow.SetInputData(globe)
    flow.SetCenter(*(6.45e6 * np.array((np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)))))
    flow.SetRadius(2e5)
    flow.SetDuration(24 * 3600)
    flow.SetMaximumNumberOfTetrahedra(50000)
    flow.Update()
    return flow.GetOutput()


def window_of(media):
    renderer, window = vtkRenderer(), vtkRenderWindow()
    mappers = []
    for data, unit in media:
        mapper = nephoscope.vtkCellCompositingMapper()
        mapper.SetInputData(data)
        mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectScalarArray("cloud_fraction")
        renderer.AddVolume(cloud_volume(mapper, unit))
        mappers.append(mapper)
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(SIZE, SIZE)
    window.AddRenderer(renderer)
    return renderer, window, mappers


def frames(media, bounds):
    renderer, window, mappers = window_of(media)
    renderer.ResetCamera(bounds)
    window.Render()
    moving = []
    renderer.GetActiveCamera().Elevation(35)
    for _ in range(MOVES):
        renderer.GetActiveCamera().Azimuth(7)
        renderer.ResetCameraClippingRange(bounds)
        start = time.process_time()
        window.Render()
        moving.append(time.process_time() - start)
    return sorted(moving)[MOVES // 2], mappers[0].GetNumberOfRayLayers()


def main():
    globe = forecast_globe()
    bounds = globe.GetBounds()
    box = block((1e6, -3e6, -3e6), (8e6, 3e6, 3e6))
    pairs = [("globe, box of voxels in it", (globe, 2e5), (box, 4e6)), ("globe as hexahedra, box", (hexahedra(globe), 2e5), (box, 4e6)),
             ("globe, smoke in it", (globe, 2e5), (smoke(globe), 4e4)), ("globe twice", (globe, 4e5), (globe, 4e5)), ("two boxes", (box, 4e6), (block((-4e6, -2e6, -2e6), (5e6, 4e6, 2e6)), 4e6))]
    print(f"| media ({SIZE} x {SIZE}) | one alone s | other alone s | as one medium s | times the sum | passes |")
    print("|---|---|---|---|---|---|", flush=True)
    for name, first, second in pairs:
        alone = [frames([medium], bounds)[0] for medium in (first, second)]
        together, passes = frames([first, second], bounds)
        print(f"| {name} | {alone[0]:.2f} | {alone[1]:.2f} | {together:.2f} | {together / sum(alone):.1f} | {passes} |", flush=True)


main()

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times frames of clouds with light against frames of the same clouds without.

    ./nephoscope bench
    PYTHONPATH=$PWD/Testing/Python NEPHOSCOPE_DATA=$PWD/Data ./nephoscope python Testing/Benchmarks/frames_with_light.py 512

Seconds are processor time of the whole process, software OpenGL included: the median of frames of a moving camera, in which the kinds alternate. All kinds have the same extinction, so
rays end at the same depth. `plain`: coloured by the extinction. `two arrays`: coloured by another array, without light. `lit`: one light for all directions. `camera`: Follow Camera.
The argument is the side of the picture in pixels.
"""
import sys
import time

import nephoscope
import numpy as np
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401  the factory
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from nephoscope_testing import meshes
from nephoscope_testing.weather import forecast_globe
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkFiltersCore import vtkAppendFilter
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkRenderer, vtkRenderWindow, vtkVolume

SIZE = int(sys.argv[1]) if len(sys.argv) > 1 else 512
MOVES = 9
KINDS = {"plain": ("ScaledExtinction", False), "two arrays": ("SunTransmittance", False), "lit": ("Sunlight", False), "camera": ("Sunlight", True)}


def globe():
    optics = nephoscope.vtkCloudOptics()
    optics.SetInputData(forecast_globe())
    optics.Update()
    return optics.GetOutput()


def image(cells=80):
    """Smooth lumps whose optical depths across are up to about 40."""
    data = meshes.image((cells,) * 3, (1 / cells,) * 3, (0, 0, 0))
    x, y, z = 2 * np.pi * meshes.points_of(data).T
    meshes.add_array(data.GetPointData(), 80 * np.maximum(np.sin(3 * x) * np.sin(2 * y + z) * np.sin(z / 2) - 0.3, 0), "Extinction")
    return data


def unstructured(data):
    append = vtkAppendFilter()
    append.AddInputData(data)
    append.Update()
    made = append.GetOutput()
    made.SetFieldData(data.GetFieldData())
    return made


def lit(data, follow):
    light = nephoscope.vtkSunlight()
    light.SetInputData(data)
    light.SetSunDirection(0.8, -0.6, 0.3)
    light.SetFollowCamera(follow)
    light.Update()
    return light.GetOutput()


class Scene:
    def __init__(self, data, array):
        self.mapper, volume = nephoscope.vtkCellCompositingMapper(), vtkVolume()
        self.mapper.SetInputData(data)
        self.mapper.SetScalarModeToUsePointFieldData()
        self.mapper.SelectScalarArray(array)
        if array != "ScaledExtinction":
            self.mapper.SetOpacityArrayName("ScaledExtinction")
        densest = data.GetPointData().GetArray("ScaledExtinction").GetRange()[1]
        top = data.GetPointData().GetArray(array).GetRange()[1]
        colour, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
        for end in (0, 1):
            colour.AddRGBPoint(end * top, *3 * (end,))
            opacity.AddPoint(end * densest, end)
        volume.SetMapper(self.mapper)
        volume.GetProperty().SetColor(colour)
        volume.GetProperty().SetScalarOpacity(opacity)
        volume.GetProperty().SetScalarOpacityUnitDistance(1 / densest)
        self.renderer, self.window = vtkRenderer(), vtkRenderWindow()
        self.renderer.AddVolume(volume)
        self.window.SetOffScreenRendering(1)
        self.window.SetMultiSamples(0)
        self.window.SetSize(SIZE, SIZE)
        self.window.AddRenderer(self.renderer)
        self.window.Render()
        self.renderer.GetActiveCamera().Elevation(35)

    def frame(self):
        self.renderer.GetActiveCamera().Azimuth(7)
        self.renderer.ResetCameraClippingRange()
        start = time.process_time()
        self.window.Render()
        return time.process_time() - start


def main():
    print(f"| clouds ({SIZE} x {SIZE}) | " + " | ".join(f"{kind} s" for kind in KINDS) + " | lit / plain | camera / plain |")
    print("|---" * (3 + len(KINDS)) + "|", flush=True)
    sky = image()
    for name, data in (("globe, structured", globe()), ("globe, hexahedra", unstructured(globe())), ("image of 80³ cells", sky), ("the same as hexahedra", unstructured(sky))):
        scenes = [Scene(lit(data, follow), array) for array, follow in KINDS.values()]
        taken = np.median([[scene.frame() for scene in scenes] for _ in range(MOVES)], axis=0)
        print(f"| {name} | " + " | ".join(f"{seconds:.3f}" for seconds in taken) + f" | {taken[2] / taken[0]:.2f} | {taken[3] / taken[0]:.2f} |", flush=True)


main()

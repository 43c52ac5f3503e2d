# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 3: winds and clouds of a weather forecast composited over the globe, winds coloured by altitude.

After figure 3 of Max, Crawfis and Becker (1993). Layer by layer of the forecast, from the ground up, the clouds are drawn and then the winds, as
line segments: winds below clouds shine through, winds above lie on top. Both are left out on the far side of the planet. Writes the
picture (1920 x 1080).
"""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import globe_scene  # noqa: E402
import pictures  # noqa: E402
import splat_scene  # noqa: E402
import vtk_globe  # noqa: E402

EXAGGERATION = 25
PRESSURES = (850, 250)  # hPa: winds below most clouds and above most
HORIZON = 0.12  # least cosine between the vertical and the direction of the eye
GREATEST_SPEED = 32  # metres per second, at which segments are longest
# Cloud fraction and opacity: little below a quarter. Metres of the display over which opacity 1 gives optical depth 1.
CLOUD_OPACITY = ((0, 0), (0.2, 0), (0.5, 0.3), (1, 1))
UNIT_DISTANCE = 1.8e5
ALTITUDE = 2  # the axis of the grid whose index counts layers
EYE = globe_scene.on_globe(-105, 25, 3.0)


def main():
    forecast, pressures = splat_scene.read_forecast(EXAGGERATION)
    splat_scene.choose_winds(forecast, splat_scene.level_numbers(pressures, PRESSURES), EYE, HORIZON)
    splat_scene.hide_clouds(forecast, EYE, HORIZON)
    window, renderer = splat_scene.make_window(
        (1920, 1080), EYE, [0, 0, 0], [0, 0, 1], 41.5, globe_scene.on_globe(-92, 32, 10))
    renderer.AddActor(vtk_globe.terrain(ambient=0.55, diffuse=0.5))
    weather = splat_scene.splats(forecast, CLOUD_OPACITY, UNIT_DISTANCE, color=(0.88, 0.90, 0.93))
    splat_scene.show_segments(weather.GetMapper(), GREATEST_SPEED, opacity=4, length=4.5, pixels=2, unit=2.0e5)
    weather.GetMapper().SetVectorPlacementToLayers()
    weather.GetMapper().SetLayerAxis(ALTITUDE)
    renderer.AddVolume(weather)
    renderer.ResetCameraClippingRange()
    splat_scene.add_altitude_bar(renderer)
    splat_scene.add_caption(renderer, "Clouds, and winds at 850 hPa\n(orange) and 250 hPa (blue)\n"
                            "Line segments, longer where\nfaster, longest from %d m/s\n"
                            "Heights exaggerated %d times\n"
                            "GFS forecast for 2011-10-11 00 UTC" % (GREATEST_SPEED, EXAGGERATION))
    window.Render()
    pictures.write(window, os.path.join(os.environ["NEPHOSCOPE_GALLERY"], "03_winds_and_clouds.png"))


main()

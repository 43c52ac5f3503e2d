# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Smoke Puffs in ParaView's animation: a forecast of one time step, in days, makes one loop, and the smoke is computed once."""
import math

from paraview import simple as pvs

from PluginTesting import GFS, check, load_plugin, new_view

DAY = 86400.0
RADIUS, EXAGGERATION = 6371000.0, 45


def on_globe(longitude, latitude, height):
    lon, lat, r = math.radians(longitude), math.radians(latitude), RADIUS + EXAGGERATION * height
    return [r * math.cos(lat) * math.cos(lon), r * math.cos(lat) * math.sin(lon), r * math.sin(lat)]


def executions(filter_proxy, log, name):
    filter_proxy.SMProxy.GetClientSideObject().AddObserver("StartEvent", lambda *_: log.append(name))


load_plugin()
forecast = pvs.NetCDFReader(FileName=[GFS], SphericalCoordinates=0)
forecast.Dimensions = "(lev, lat, lon)"
scene = pvs.GetAnimationScene()
scene.UpdateAnimationUsingDataTimeSteps()
MODE_OF_ONE_STEP = scene.PlayMode  # without puffs: Sequence before ParaView 6.1, which snaps to a single step too
wind = pvs.GlobeGrid(Input=forecast, VerticalExaggeration=EXAGGERATION)
smoke = pvs.FlowVolume(Input=wind, Center=on_globe(-105, 12.5, 1100), Radius=3.2e4, Duration=36000, TimeStep=3600)
both = pvs.AppendDatasets(Input=[smoke])  # as where smoke comes from several polygons
puffs = pvs.SmokePuffs(Input=both, Period=DAY / 4, TimeScale=DAY)
log = []
executions(smoke, log, "smoke")
executions(puffs, log, "puffs")
view = new_view()
pvs.Show(puffs, view)
pvs.Render(view)
check(log == ["smoke", "puffs"], f"at first: {log}")

step = forecast.TimestepValues[0] if hasattr(forecast.TimestepValues, "__len__") else forecast.TimestepValues
scene.UpdateAnimationUsingDataTimeSteps()
check(scene.PlayMode == MODE_OF_ONE_STEP, f"play mode {scene.PlayMode}")
scene.PlayMode = "Sequence"
check((scene.StartTime, scene.EndTime) == (step, step + 0.25), f"times {scene.StartTime} to {scene.EndTime}")

log.clear()
for time in (step + 0.05, step + 0.1, step + 0.25):
    view.ViewTime = time
    pvs.Render(view)
check(log == ["puffs"] * 3, f"in three frames: {log}")
print("NEPHOSCOPE-PASSED")

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""In place of the cylinder that Flow Volume's widget is for ParaView, its polygon is drawn: across the flow, also where it is dragged to."""
import numpy as np
from PluginTesting import check, image, load_plugin, new_view, passed, pvs, save_image, servermanager
from vtkmodules.util.numpy_support import vtk_to_numpy


def widget_of(filter_, view):
    """What the panel makes."""
    proxy = servermanager.ProxyManager().NewProxy("representations", "ImplicitCylinderWidgetRepresentation")
    widget = servermanager._getPyProxy(proxy)
    for name in ("Center", "Radius"):
        setattr(widget, name, getattr(filter_, name))
    widget.WidgetBounds = [-6, 6] * 3
    widget.Visibility = 1
    hidden(view).AddProxy(widget.SMProxy)
    view.UpdateVTKObjects()
    return widget


def hidden(view):
    return view.SMProxy.GetProperty("HiddenRepresentations")


def remove(view):
    hidden(view).RemoveAllProxies()
    view.UpdateVTKObjects()


def polygon_in(view):
    """Points of the line that is drawn over the view, or None."""
    actors = view.GetClientSideObject().GetNonCompositedRenderer().GetActors()
    for actor in (actors.GetItemAsObject(i) for i in range(actors.GetNumberOfItems())):
        if actor.GetMapper() and actor.GetProperty().GetColor() == (1.0, 0.5, 0.0) and actor.GetVisibility():
            actor.GetMapper().Update()
            return vtk_to_numpy(actor.GetMapper().GetInput().GetPoints().GetData()).astype(float)
    return None


def check_polygon(view, center, radius, across, what):
    points = polygon_in(view)
    check(points is not None and len(points) == 12, f"{what}: no polygon of 12 sides: {points}")
    arms = points - center
    check(np.allclose(np.linalg.norm(arms, axis=1), radius, rtol=1e-4), f"{what}: not around {center}")
    tilt = np.abs(arms @ across).max() / (radius * np.linalg.norm(across))
    check(tilt < 1e-3, f"{what}: not across the flow, sine {tilt}")


def main():
    flow = pvs.Calculator(Input=pvs.Wavelet(WholeExtent=[-6, 6] * 3), ResultArrayName="v", Function="-coordsY*iHat+coordsX*jHat+3*kHat")
    flow.UpdatePipeline()
    smoke = pvs.FlowVolume(Input=flow)
    view = new_view()
    pvs.Show(flow, view).SetRepresentationType("Outline")
    pvs.ResetCamera(view)
    before = image(view)
    widget = widget_of(smoke, view)

    def velocity(place):
        return np.array([-place[1], place[0], 3.0])
    check_polygon(view, smoke.Center, smoke.Radius, velocity(smoke.Center), "at first")
    picture = image(view)
    save_image(picture, "FlowVolumePolygon")
    changed = np.abs(picture - before).max(axis=2) > 8
    check(0.0005 < changed.mean() < 0.02, f"{changed.mean():.2%} of the picture is the widget: a cylinder")
    executed = smoke.GetClientSideObject().GetMTime()
    widget.Center = [2, -1, 3]  # dragged, not yet applied
    check_polygon(view, np.array([2, -1, 3]), smoke.Radius, velocity([2, -1, 3]), "dragged")
    check(smoke.GetClientSideObject().GetMTime() == executed, "the filter has been modified by dragging")
    smoke.NormalToFlow = 0
    widget.Axis = [1, 0, 0]
    check_polygon(view, np.array([2, -1, 3]), smoke.Radius, np.array([1.0, 0, 0]), "with a normal")
    widget.Visibility = 0
    check(polygon_in(view) is None, "a hidden polygon is drawn")
    remove(view)

    smoke.NormalToFlow = 1
    display = pvs.Show(smoke, view)
    widget = widget_of(smoke, view)
    pvs.Render(view)
    widget.Center = [-2, 1, 2]
    drawn = display.GetClientSideObject().GetActiveRepresentation()
    check(not drawn.GetNeedsUpdate(), "smoke vanishes from ParaView's window while its polygon is dragged: its data are dropped until Apply")
    remove(view)

    plain = pvs.Clip(Input=flow, ClipType="Cylinder")  # the cylinder of another filter stays one
    other = widget_of(plain.ClipType, view)
    check(polygon_in(view) is None, "the widget of another filter has a polygon")
    remove(view)
    check(other is not None, "no widget")


load_plugin()
pvs._DisableFirstRenderCameraReset()
main()
passed()

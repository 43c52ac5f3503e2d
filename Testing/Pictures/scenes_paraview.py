# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""For the snippets that run in ParaView: what a page takes as given (BEFORE), and how what it makes is shown (AFTER).

The view is made beforehand, so that no default of a version of ParaView is in the picture: background, antialiasing, axes.
"""
import os

import nephoscope_testing.quick_paraview  # noqa: F401
from paraview import simple as pvs

SIZE = [400, 300]


def plugin():
    from paraview import servermanager
    if not servermanager.ProxyManager().GetProxyDefinitionManager().HasDefinition("filters", "GlobeGrid"):
        pvs.LoadPlugin(os.path.join(os.environ["PV_PLUGIN_PATH"].split(":")[0], "Nephoscope.so"), remote=False, ns=vars(pvs))


plugin()


def new_view():
    view = pvs.CreateRenderView(ViewSize=SIZE, OrientationAxesVisibility=0)
    view.UseColorPaletteForBackground, view.UseFXAA, view.MultiSamples = 0, 0, 1
    if hasattr(view, "BackgroundColorMode"):
        view.BackgroundColorMode = "Single Color"
    view.Background = [0.32, 0.34, 0.43]
    return view


view = new_view()


def keep_picture(_names, file="picture.png"):
    """Seen from the side, with the whole in view."""
    view = pvs.GetActiveView()
    for display in view.Representations:
        if hasattr(display, "SetScalarBarVisibility") and display.Visibility:
            display.SetScalarBarVisibility(view, False)
    view.CameraPosition, view.CameraFocalPoint, view.CameraViewUp = [-3, -5, 3.4], [0, 0, 0], [0, 0, 1]
    pvs.ResetCamera(view)
    pvs.SaveScreenshot(file, view, ImageResolution=SIZE)


def globe_grid():
    weather = pvs.NetCDFReader(FileName=["Data/gfs_2p5deg_2011101100.nc"], SphericalCoordinates=0)
    grid = pvs.GlobeGrid(Input=weather, VerticalExaggeration=50)
    grid.UpdatePipeline()
    return grid


def globe(names):
    names.update(vars(pvs))
    names["view"] = view
    names["globe"] = globe_grid()


def earth(names):
    globe(names)
    shown = pvs.Show(pvs.Sphere(Radius=6371000, ThetaResolution=90, PhiResolution=60), view)
    shown.DiffuseColor = shown.AmbientColor = [0.15, 0.35, 0.3]


def sparse(names):
    import nephoscope
    pvs.GetColorTransferFunction("RTData").ApplyPreset("Cool to Warm", True)  # its first colours depend on the version of ParaView
    wavelet = pvs.Wavelet(WholeExtent=[-10, 10] * 3)
    pvs.RenameSource("Wavelet1", wavelet)
    wavelet.UpdatePipeline()
    writer = nephoscope.vtkSparseVolumeWriter()
    writer.SetFileName("smoke.vdb")
    writer.SetInputData(pvs.servermanager.Fetch(wavelet))
    writer.AddArrayName("RTData")
    writer.SetTolerance(150)
    writer.Write()


def show(name):
    def after(names):
        pvs.Show(names[name], view)
        keep_picture(names)
    return after


BEFORE = {"haze-2": earth, "light-2": globe, "paraview-2": globe, "paraview-3": globe, "paraview-4": lambda names: names.update(vars(pvs)),
          "sparse-volume-2": sparse}
AFTER = {"paraview-2": show("dense"), "paraview-3": show("clouds")}


def prepare(name, names):
    BEFORE.get(name, lambda names: None)(names)

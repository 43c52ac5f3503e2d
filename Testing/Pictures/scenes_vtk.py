# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""For the snippets that run in Python: how what they make is drawn (AFTER).

A snippet that draws by itself leaves a file, a plotter or a list of frames, and needs no entry.
"""
import glob

import nephoscope
import numpy as np
import PIL.Image
import PIL.ImageSequence
import pyvista
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (vtkActor, vtkColorTransferFunction, vtkDataSetMapper, vtkPolyDataMapper, vtkRenderer,
                                         vtkRenderWindow, vtkVolume, vtkWindowToImageFilter)

pyvista.OFF_SCREEN = True
SKY = (0.25, 0.4, 0.6)


# ---- drawing

def save_window(window):
    grabber, writer = vtkWindowToImageFilter(), vtkPNGWriter()
    grabber.SetInput(window)
    grabber.ReadFrontBufferOff()
    writer.SetInputConnection(grabber.GetOutputPort())
    writer.SetFileName("picture.png")
    writer.Write()


def show(*props, renderer=None, look=(-3, -5, 3.4), up=(0, 0, 1), zoom=1.3):
    renderer = renderer or vtkRenderer()
    for prop in props:
        renderer.AddViewProp(prop)
    renderer.SetBackground(*SKY)
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(0)
    window.SetSize(400, 300)
    window.AddRenderer(renderer)
    camera = renderer.GetActiveCamera()
    camera.SetFocalPoint(0, 0, 0)
    camera.SetPosition(*look)
    camera.SetViewUp(*up)
    renderer.ResetCamera()
    camera.Zoom(zoom)
    renderer.ResetCameraClippingRange()
    window.Render()
    save_window(window)


def keep_picture(names):
    """Keeps the picture of a snippet that draws: its frames, its open plotter, its file or its window."""
    files = [file for file in glob.glob("*.png") if file != "picture.png"]
    if "frames" in names:
        names["frames"][-1].save("picture.png")
    elif getattr(names.get("plotter"), "render_window", None):
        names["plotter"].screenshot("picture.png")
    elif files:
        pyvista.wrap(pyvista.read(files[0])).save("picture.png")
    elif "window" in names:
        save_window(names["window"])


def surface_actor(port, color=(1, 1, 1), array=None, kind=vtkPolyDataMapper):
    mapper, actor = kind(), vtkActor()
    mapper.SetInputConnection(port)
    mapper.SetScalarVisibility(array is not None)
    if array is not None:
        mapper.SetScalarModeToUseCellFieldData() if array[0] == "cell" else mapper.SetScalarModeToUsePointFieldData()
        mapper.SelectColorArray(array[1])
        mapper.SetScalarRange(*array[2])
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    return actor


def earth():
    actor = surface_actor(producer(pyvista.Sphere(radius=6371000, theta_resolution=90, phi_resolution=60)).GetOutputPort(), (0.15, 0.35, 0.3))
    actor.GetProperty().SetSpecular(0)
    return actor


def medium(mapper=None, high=1.0, distance=1.0, colors=((0.0, 1, 1, 1), (1.0, 1, 1, 1))):
    volume, function, opacity = vtkVolume(), vtkColorTransferFunction(), vtkPiecewiseFunction()
    for color in colors:
        function.AddRGBPoint(*color)
    opacity.AddPoint(0, 0)
    opacity.AddPoint(high, 1)
    volume.GetProperty().SetColor(function)
    volume.GetProperty().SetScalarOpacity(opacity)
    volume.GetProperty().SetScalarOpacityUnitDistance(distance)
    if mapper:
        volume.SetMapper(mapper)
    return volume


ALIVE = []  # an output port does not keep its algorithm


def producer(data):
    made = vtkTrivialProducer()
    made.SetOutput(data)
    ALIVE.append(made)
    return made


# ---- before

def prepare(_name, _names):
    """Plotters keep the picture that their window shows. Nothing else: a snippet must run where it is pasted."""
    show_plotter = pyvista.Plotter.show
    pyvista.Plotter.show = lambda plotter, **options: show_plotter(plotter, **{**options, "screenshot": options.get("screenshot") or "plot.png"})


# ---- after

def smoke_volume(port, array):
    mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetInputConnection(port)
    mapper.SetScalarModeToUseCellFieldData()
    mapper.SelectScalarArray(array)
    mapper.Update()
    return mapper


def show_smoke(names):
    show(medium(smoke_volume(names["smoke"].GetOutputPort(), "Density"), distance=2.0), look=(-2, -5, 1))


def show_puffs(names):
    show(medium(smoke_volume(names["puffs"].GetOutputPort(), "SmokeDensity"), distance=2e5), earth(), look=names["place"].GetCenter())


def show_layers(names):
    """Cut open, coloured by layer."""
    from vtkmodules.vtkCommonDataModel import vtkPlane
    actor = surface_actor(names["splitter"].GetOutputPort(), array=("cell", "Layer", (0, 3)), kind=vtkDataSetMapper)
    plane = vtkPlane()
    plane.SetNormal(0, 1, 0)
    actor.GetMapper().AddClippingPlane(plane)
    show(actor, look=(-1, -4, 2))


def show_globe(names):
    """The field that is nearest to the eye: the top of the atmosphere, coloured by its temperature."""
    names["globe"].Update()
    grid = pyvista.wrap(names["globe"].GetOutput())
    show(surface_actor(producer(grid).GetOutputPort(), array=("point", "t", tuple(grid["t"][np.isfinite(grid["t"])].min() + [0, 60])),
                       kind=vtkDataSetMapper))


def show_points(names):
    actor = surface_actor(names["reader"].GetOutputPort(), array=("point", "density", (0, 1)))
    actor.GetProperty().SetPointSize(4)
    show(actor)


def show_advected(names):
    surface, mapper, actor = nephoscope.vtkCloudSurface(), nephoscope.vtkCloudTextureMapper(), vtkActor()
    surface.SetInputData(names["texture"].GetOutput())
    surface.SetInputArrayToProcess(0, 0, 0, 0, "cloud_fraction")
    surface.SetValue(0, 0.15)
    mapper.SetInputConnection(surface.GetOutputPort())
    mapper.ScalarVisibilityOff()
    actor.SetMapper(mapper)
    renderer = vtkRenderer()
    renderer.UseDepthPeelingOn()
    show(actor, earth(), renderer=renderer)


def show_polyhedron(names):
    show(medium(names["mapper"], distance=0.5, colors=((0.0, 1, 0.9, 0.6), (1.0, 0.9, 0.2, 0.1))))


# ---- films

def film(file):
    """Its frames, and the mean change of each to the next."""
    with PIL.Image.open(file) as images:
        frames = [np.asarray(image.convert("RGB"), float) for image in PIL.ImageSequence.Iterator(images)]
    assert len(frames) == 8, f"{len(frames)} frames"
    return frames, [np.abs(a - b).mean() for a, b in zip(frames, frames[1:] + frames[:1])]


def keep_moving_winds(names):
    frames, changes = film("winds.gif")
    assert np.mean(frames[0].min(axis=2) > 120) > 0.03, "no clouds are to be seen"
    assert 0.2 < min(changes) and max(changes) < 2 * min(changes), f"the winds stand still or jump: changes {np.round(changes, 2)}"
    keep_picture(names)


def keep_moving_clouds(names):
    frames, changes = film("clouds.gif")
    white = [np.mean(frame.min(axis=2) > 128) for frame in frames]
    assert max(white) < 1.1 * min(white), f"the cover changes: {np.round(white, 3)}"
    assert min(changes[:-1]) > 2, f"the clouds stand still: changes {np.round(changes, 2)}"
    keep_picture(names)


AFTER = {
    "cloud-surface-1": lambda names: show(surface_actor(names["clouds"].GetOutputPort()), earth()),
    "contour-cell-splitter-1": show_layers,
    "flow-volumes-2": show_smoke,
    "globe-grid-1": show_globe,
    "polyhedra-1": show_polyhedron,
    "pyvista-1": keep_moving_winds,
    "pyvista-2": keep_moving_clouds,
    "smoke-puffs-1": show_puffs,
    "sparse-volume-1": show_points,
    "texture-advection-1": show_advected,
}

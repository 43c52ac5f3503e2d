# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""For the snippets that run in Python: what a page takes as given (BEFORE), and how what it makes is drawn (AFTER).

A snippet that draws by itself leaves a file, a window or a list of frames, and needs no entry.
"""
import glob
import os

import nephoscope
import numpy as np
import pyvista
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
import vtkmodules.vtkRenderingVolumeOpenGL2  # noqa: F401
from vtkmodules.vtkCommonDataModel import vtkPiecewiseFunction
from vtkmodules.vtkCommonExecutionModel import vtkTrivialProducer
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkIONetCDF import vtkNetCDFCFReader
from vtkmodules.vtkRenderingCore import (vtkActor, vtkColorTransferFunction, vtkDataSetMapper, vtkPolyDataMapper, vtkRenderer,
                                         vtkRenderWindow, vtkVolume, vtkWindowToImageFilter)

pyvista.OFF_SCREEN = True
GFS = "Data/gfs_2p5deg_2011101100.nc"
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
    """Keeps the picture of a snippet that draws: its frames, its file or its window."""
    if "frames" in names:
        names["frames"][-1].save("picture.png")
        return
    files = [file for file in glob.glob("*.png") if file != "picture.png"]
    if files:
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


# ---- data

ALIVE = []  # an output port does not keep its algorithm


def producer(data):
    made = vtkTrivialProducer()
    made.SetOutput(data)
    ALIVE.append(made)
    return made


def reader(file=GFS):
    made = vtkNetCDFCFReader()
    made.SetFileName(file)
    made.UpdateMetaData()
    made.SetSphericalCoordinates(False)
    made.SetDimensions("(lev, lat, lon)")
    ALIVE.append(made)
    return made


def globe(exaggeration=50, file=GFS):
    made = nephoscope.vtkGlobeGrid()
    made.SetInputConnection(reader(file).GetOutputPort())
    made.SetVerticalExaggeration(exaggeration)
    ALIVE.append(made)
    return made


def cloud_surface():
    made = nephoscope.vtkCloudSurface()
    made.SetInputConnection(globe(30).GetOutputPort())
    made.SetInputArrayToProcess(0, 0, 0, 0, "cloud_fraction")
    made.SetValue(0, 0.3)
    return made


def ball():
    """Tetrahedra, say, with what the pages name: a cloud in the middle, warmer below, in a wind that turns."""
    grid = pyvista.ImageData(dimensions=(25,) * 3, spacing=(1 / 12,) * 3, origin=(-1,) * 3)
    x, y, z = grid.points.T
    grid["cloud_fraction"] = np.exp(-3 * (x ** 2 + y ** 2 + 2 * z ** 2))
    grid["Temperature"] = 0.5 - 0.5 * z
    grid["Wind"] = np.column_stack([-y, x, 0 * x])
    grid.cell_data["Density"] = grid.point_data_to_cell_data()["cloud_fraction"] ** 2
    return grid


def ball_mapper(names, distance=0.3):
    names["mapper"] = mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetInputData(ball())
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("cloud_fraction")
    names["volume"] = medium(mapper, distance=distance, colors=((0.0, 0.1, 0.3, 1), (0.5, 1, 1, 1), (1.0, 1, 0.3, 0.1)))


# ---- before

def clouds_source(names):
    names["source"] = globe(50)
    names["volume"] = medium(distance=2e5)


def peeling(names):
    ball_mapper(names)
    names["renderer"], names["window"] = vtkRenderer(), vtkRenderWindow()
    sphere = surface_actor(producer(pyvista.Sphere(radius=0.6)).GetOutputPort(), (0.2, 0.9, 0.3))
    sphere.GetProperty().SetOpacity(0.5)
    names["renderer"].AddActor(sphere)


def textured(names):
    names["clouds"], names["renderer"], names["window"] = cloud_surface(), vtkRenderer(), vtkRenderWindow()
    names["mapper"] = mapper = nephoscope.vtkCloudTextureMapper()
    mapper.SetInputConnection(names["clouds"].GetOutputPort())
    mapper.ScalarVisibilityOff()
    mapper.SetTextureScale(6)


def columns(names):
    """Winds and levels of a page on arrays."""
    longitudes, latitudes, levels = np.arange(0, 360, 10.0), np.arange(-90, 91, 10.0), np.array([1000, 850, 700, 500, 300, 100.0])
    shape = (len(levels), len(latitudes), len(longitudes))
    names.update(nephoscope=nephoscope, pyvista=pyvista, longitudes=longitudes, latitudes=latitudes, levels=levels,
                 u=np.broadcast_to(30 * np.sin(np.radians(2 * latitudes))[:, None] ** 2, shape), v=np.zeros(shape))
    plot = pyvista.DataSet.plot if hasattr(pyvista.DataSet, "plot") else None
    assert plot
    pyvista.global_theme.show_scalar_bar = False
    keep_shown()


def keep_shown():
    """Plotters keep the picture that their window shows."""
    show_plotter = pyvista.Plotter.show
    pyvista.Plotter.show = lambda plotter, **options: show_plotter(plotter, **{**options, "screenshot": "plot.png"})


def forecast(_names):
    """The user's file of the page for PyPI."""
    os.symlink(GFS, "forecast.nc")
    keep_shown()


def polyhedra(names):
    from vtkmodules.vtkCommonCore import vtkIdList, vtkPoints
    from vtkmodules.vtkCommonDataModel import VTK_POLYHEDRON, vtkUnstructuredGrid
    # A star: an octahedron with a dent in each face is not convex.
    points, faces = vtkPoints(), vtkIdList()
    corners = np.array([(1, 0, 0), (-1, 0, 0), (0, 1, 0), (0, -1, 0), (0, 0, 1), (0, 0, -1)], float)
    for corner in corners:
        points.InsertNextPoint(*corner)
    triangles = []
    for a in (0, 1):
        for b in (2, 3):
            for c in (4, 5):
                middle = points.InsertNextPoint(*(0.12 * (corners[a] + corners[b] + corners[c])))
                triangles += [(a, b, middle), (b, c, middle), (c, a, middle)]
    faces.InsertNextId(len(triangles))
    for triangle in triangles:
        faces.InsertNextId(3)
        for corner in triangle:
            faces.InsertNextId(int(corner))
    grid = vtkUnstructuredGrid()
    grid.SetPoints(points)
    grid.InsertNextCell(VTK_POLYHEDRON, faces)
    wrapped = pyvista.wrap(grid)
    wrapped["value"] = np.linalg.norm(wrapped.points, axis=1)
    names["reader"] = producer(wrapped)
    names["mapper"] = mapper = nephoscope.vtkCellCompositingMapper()
    mapper.SetScalarModeToUsePointFieldData()
    mapper.SelectScalarArray("value")


def flow(names):
    names["smoke"] = made = nephoscope.vtkFlowVolume()
    data = globe(50)
    data.Update()
    place = nephoscope.vtkFlowVolumePlacement()
    place.Find(data.GetOutput())
    made.SetInputConnection(data.GetOutputPort())
    made.SetCenter(place.GetCenter())
    made.SetRadius(place.GetRadius())


def sparse(names):
    image = ball()
    image["density"], image["temperature"] = image["cloud_fraction"], image["Temperature"]
    writer = nephoscope.vtkSparseVolumeWriter()
    writer.SetFileName("smoke.vdb")
    writer.SetInputData(image)
    for name in ("density", "temperature"):
        writer.AddArrayName(name)
    writer.SetTolerance(0.05)
    writer.Write()
    names["image"] = image


def grib_of_gfs(names):
    """forecast.grib2: the fields of the sample file, as GRIB."""
    import sys
    from pathlib import Path
    sys.path.insert(0, str(Path(__file__).resolve().parents[2] / "Plugins" / "PyVista" / "Testing"))
    from weather_data import write_grib
    gfs, ground = nephoscope.read_cf(GFS), nephoscope.read_cf(GFS, dimensions="(lat, lon)")
    keys = {"gridType": "regular_ll", "Ni": 144, "Nj": 73, "latitudeOfFirstGridPointInDegrees": -90, "latitudeOfLastGridPointInDegrees": 90,
            "longitudeOfFirstGridPointInDegrees": 0, "longitudeOfLastGridPointInDegrees": 357.5, "iDirectionIncrementInDegrees": 2.5, "jDirectionIncrementInDegrees": 2.5,
            "jScansPositively": 1}
    order = np.argsort(gfs.x % 360)
    of = lambda mesh, array, level=0: np.asarray(mesh[array]).reshape(-1, 73, 144)[level][:, order]
    fields = [(short, "isobaricInhPa", int(round(abs(pressure))), of(gfs, array, k)) for short, array in (("gh", "gh"), ("u", "u"), ("v", "v"), ("cc", "cloud_fraction"))
              for k, pressure in enumerate(gfs.z)]
    fields += [(name, "surface", 0, of(ground, name)) for name in ("sp", "orog", "lsm")]
    write_grib("forecast.grib2", fields, keys)


BEFORE = {
    "weather-1": grib_of_gfs,
    "weather-2": grib_of_gfs,
    "cell-compositing-1": clouds_source,
    "cell-compositing-2": ball_mapper,
    "cell-compositing-3": lambda names: ball_mapper(names, 2.0),
    "cell-compositing-4": peeling,
    "cloud-surface-1": lambda names: names.update(globe=globe(30)),
    "cloud-texture-1": textured,
    "cloud-texture-2": textured,
    "cloud-texture-3": textured,
    "description-1": forecast,
    "contour-cell-splitter-1": lambda names: names.update(source=producer(ball())),
    "globe-grid-2": columns,
    "haze-1": lambda names: names.update(renderer=vtkRenderer()),
    "polyhedra-1": polyhedra,
    "smoke-puffs-1": flow,
    "sparse-volume-1": sparse,
    "texture-advection-1": lambda names: names.update(nephoscope=nephoscope, globe=globe(40, "Data/forecast_10deg_6h.nc")),
}


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
    show(medium(smoke_volume(names["puffs"].GetOutputPort(), "SmokeDensity"), distance=2e5), earth(), look=(-1, -5, 4))


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
    show(actor, earth(), renderer=peeled())


def peeled():
    renderer = vtkRenderer()
    renderer.UseDepthPeelingOn()
    return renderer


def show_texture(names):
    actor = vtkActor()
    actor.SetMapper(names["mapper"])
    names["renderer"].UseDepthPeelingOn()
    show(actor, earth(), renderer=names["renderer"])


def show_polyhedron(names):
    show(medium(names["mapper"], distance=0.5, colors=((0.0, 1, 0.9, 0.6), (1.0, 0.9, 0.2, 0.1))))


AFTER = {
    "cell-compositing-1": lambda names: show(names["volume"], earth()),
    "cell-compositing-2": lambda names: show(names["volume"]),
    "cell-compositing-3": lambda names: show(names["volume"]),
    "cell-compositing-4": lambda names: show(names["volume"], renderer=names["renderer"]),
    "cloud-surface-1": lambda names: show(surface_actor(names["clouds"].GetOutputPort()), earth()),
    "cloud-texture-1": show_texture,
    "cloud-texture-2": show_texture,
    "cloud-texture-3": show_texture,
    "contour-cell-splitter-1": show_layers,
    "flow-volumes-2": show_smoke,
    "globe-grid-1": show_globe,
    "haze-1": lambda names: show(earth(), renderer=names["renderer"], look=(-6.9e6, 0, 2e6), zoom=1),
    "polyhedra-1": show_polyhedron,
    "smoke-puffs-1": show_puffs,
    "sparse-volume-1": show_points,
    "texture-advection-1": show_advected,
}

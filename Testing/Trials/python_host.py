# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Trials in Python: the functions of the package and the wrapped classes, each with its defaults, one line each."""
import os
import tempfile

import nephoscope
import numpy as np
import pyvista as pv
from cameras import cameras, mirrored
from capture import Capture, opengl_errors
from judge import Verdict
from mirror import mirror
from vtkmodules.vtkCommonDataModel import vtkPlane
from vtkmodules.vtkRenderingCore import vtkColorTransferFunction, vtkVolume

SIZE = 80
FUNCTIONS = {}


class Function:
    def __init__(self, name, needs, draw, checks, scenery, vtk, few):
        self.name, self.needs, self.draw, self.checks, self.scenery, self.vtk, self.few = name, needs, draw, checks.split(), scenery, vtk, few

    def is_served_by(self, dataset, data):
        return self.needs(data) if callable(self.needs) else set(self.needs) <= dataset.shows


def add(name, needs, draw, checks="", scenery=None, vtk=False, few=False):
    """few: with the datasets of the fast subset alone. needs: see datasets.py, or a function of the data. draw(plotter, data): adds to the plotter, and returns what it added. checks: functions of this file
    after `check_`. scenery(plotter, data): what stands in the plotter before. vtk: messages of VTK are what a user reads."""
    FUNCTIONS[name] = Function(name, needs, draw, checks, scenery, vtk, few)


def shown(plotter, mesh):
    """A mesh that a filter gave, as a surface."""
    if isinstance(mesh, pv.MultiBlock):
        mesh = mesh.combine() if mesh.n_blocks else pv.PolyData()
    if mesh is not None and mesh.n_points:
        if scalars_of(mesh) is None:  # VTK 9.2 aborts at the colours of an array without a finite value
            mesh = mesh.copy(deep=False)
            mesh.set_active_scalars(None)
        plotter.add_mesh(mesh, show_scalar_bar=False, scalars=scalars_of(mesh))
    return mesh


def scalars_of(mesh):
    for data in (mesh.point_data, mesh.cell_data):
        for name in data:
            if data[name].ndim == 1 and data[name].dtype.kind in "iuf" and np.isfinite(data[name]).any():
                return name
    return None


def filtered(function):
    def draw(plotter, data):
        result = function(data)
        if isinstance(data, pv.DataSet) and np.isfinite(data.points).all() and not np.isfinite(result.points).all():
            raise ArithmeticError("the result has points that are not finite")
        return shown(plotter, result)
    return draw


def numbers(data):
    return [a for a in data.values() if a.ndim == 1 and a.dtype.kind in "iufb" and np.isfinite(a).any()]


def is_structured(data):
    """With a point array of numbers, and not all hidden."""
    return isinstance(data, (pv.ImageData, pv.RectilinearGrid, pv.StructuredGrid)) and bool(numbers(data.point_data)) and not (
        "vtkGhostType" in data.point_data and data.point_data["vtkGhostType"].all())


def is_lonlat(data):
    """On longitudes and latitudes in degrees, as far as numbers tell."""
    if not isinstance(data, (pv.ImageData, pv.RectilinearGrid, pv.StructuredGrid)) or data.n_points == 0:
        return False
    return sorted(data.dimensions)[1] > 1 and max(map(abs, data.bounds[2:4])) <= 90 and max(map(abs, data.bounds[:2])) <= 720


def is_flow(data):
    """One grid with a velocity."""
    return isinstance(data, pv.DataSet) and not isinstance(data, pv.PolyData) and data.n_cells > 0 and "v" in data.point_data and data.point_data["v"].ndim == 2 and np.isfinite(data.points).all()


def is_volume_file(data):
    """Equal voxels, or points; with an array of numbers that is not all background."""
    if isinstance(data, pv.ImageData):
        fits = max(data.spacing) < 1e6 * min(data.spacing)
    else:
        fits = isinstance(data, pv.PolyData) and data.n_verts == data.n_cells
    return fits and bool(numbers(data.point_data) or numbers(data.cell_data)) and data.n_points > 0 and min(getattr(data, "spacing", (1,))) > 1e-8


def wrapped(name):
    """A VTK class as it is: input, update, output."""
    def draw(plotter, data):
        algorithm = getattr(nephoscope, name)()
        algorithm.SetInputDataObject(0, data)
        algorithm.Update()
        output = algorithm.GetOutputDataObject(0)
        return shown(plotter, pv.wrap(output) if output is not None else None)
    return draw


def mapped(name):
    """A VTK mapper as it is, in a vtkVolume with its own property."""
    def draw(plotter, data):
        mapper = getattr(nephoscope, name)()
        mapper.SetInputDataObject(0, data)
        volume = vtkVolume()
        volume.SetMapper(mapper)
        colors = vtkColorTransferFunction()
        colors.AddRGBPoint(0.0, 1, 1, 1)
        volume.GetProperty().SetColor(colors)
        volume.GetProperty().SetScalarOpacityUnitDistance(getattr(data, "length", 0) / 10 or 1)
        plotter.renderer.AddVolume(volume)
        return mapper
    return draw


def smoke(plotter, data, later=lambda volume: volume):
    return nephoscope.add_smoke(plotter, later(nephoscope.flow_volume(data)))


def dragged_smoke(plotter, data):
    """The ball goes out of the data and back to where it was, and is hidden, so that smoke and polygon are judged."""
    made = nephoscope.add_smoke_widget(plotter, data)
    start = np.array(made.ball.GetCenter())
    for place in (start + 20 * max(made.volume.mapper.dataset.length, 1e-3), start):
        made.ball.SetCenter(place)
        made.ball.InvokeEvent("InteractionEvent")
    made.ball.Off()
    return made.volume


def vdb(data):
    name = os.path.join(tempfile.mkdtemp(), "trial.vdb")
    nephoscope.write_vdb(data, name)
    return nephoscope.read_vdb(name)


def surface(plotter, data):
    """The data, or where they have no surface a sphere."""
    if isinstance(data, pv.MultiBlock) and data.n_blocks:
        data = data.combine()
    return shown(plotter, data if getattr(data, "n_cells", 0) else pv.Sphere())


def translucent(plotter, data):
    plotter.render_window.SetMultiSamples(0)  # VTK 9.2 peels nothing into several samples, and complains
    plotter.enable_depth_peeling(8)
    plotter.add_mesh(pv.Box(bounds=data.bounds) if getattr(data, "n_points", 0) else pv.Box(), opacity=0.3, color="red")


def clipped(plotter, data, add_volume):
    volume = add_volume(plotter, data)
    b = np.array(data.bounds)
    clip = vtkPlane()
    clip.SetOrigin((b[::2] + b[1::2]) / 2)
    clip.SetNormal(1, 0, 0)
    volume.mapper.AddClippingPlane(clip)
    return volume


def after_screenshot(plotter, data, draw):
    draw(plotter, data)
    plotter.screenshot()
    return draw(plotter, data)


cells = lambda p, d: nephoscope.add_cells(p, d, name="it", show_scalar_bar=False)  # noqa: E731
splats = lambda p, d: nephoscope.add_splats(p, d, name="it", show_scalar_bar=False)  # noqa: E731
texture = lambda p, d: nephoscope.add_cloud_texture(p, d, name="it", show_scalar_bar=False)  # noqa: E731

add("add_cells", "c", cells, "mirror methods unstructured cameras")
add("add_splats", "p", splats, "mirror cameras")
add("add_splats-vectors", "pw", lambda p, d: nephoscope.add_splats(
    p, d, vectors="DisplayVelocity" if "DisplayVelocity" in getattr(d, "array_names", ()) else "v", show_scalar_bar=False))
add("add_cells-contours", "f", lambda p, d: nephoscope.add_cells(p, d, contours=3, show_scalar_bar=False), "mirror methods unstructured")
add("add_cloud_texture", "s", texture)
add("add_haze", "", lambda p, d: nephoscope.add_haze(p, d if isinstance(d, pv.DataSet) else None), "not_erased", scenery=surface)
add("add_smoke", "v", smoke, "methods")
add("add_smoke-puffs", "v", lambda p, d: smoke(p, d, nephoscope.smoke_puffs), "methods")
add("add_smoke_widget", "v", dragged_smoke, "methods")
add("to_globe", is_lonlat, filtered(nephoscope.to_globe))
add("split_cells", "f", filtered(nephoscope.split_cells))
add("smooth", is_structured, filtered(nephoscope.smooth))
add("cloud_surface", "g", filtered(nephoscope.cloud_surface))
add("advect_texture", is_flow, filtered(nephoscope.advect_texture))
add("flow_volume", "v", filtered(nephoscope.flow_volume))
add("write_vdb", is_volume_file, filtered(vdb))
# Combinations
add("cells-beside-translucent", "c", cells, scenery=translucent, few=True)
add("splats-beside-translucent", "p", splats, scenery=translucent, few=True)
add("cells-and-splats", "c", splats, scenery=cells, few=True)
add("cells-clipped", "c", lambda p, d: clipped(p, d, cells), "half", few=True)
add("splats-clipped", "p", lambda p, d: clipped(p, d, splats), "half", few=True)
add("cells-replaced", "c", lambda p, d: after_screenshot(p, d, cells), few=True)
add("splats-replaced", "p", lambda p, d: after_screenshot(p, d, splats), few=True)
add("texture-replaced", "s", lambda p, d: after_screenshot(p, d, texture), few=True)
# Wrapped classes
for name, needs in (("vtkGlobeGrid", is_lonlat), ("vtkContourCellSplitter", "f"), ("vtkStructuredSmoothing", is_structured), ("vtkCloudSurface", "g"),
                    ("vtkTextureCoordinateAdvection", is_flow), ("vtkFlowVolume", "v"), ("vtkSmokePuffs", "never"), ("vtkPolyhedronToTetrahedra", "c")):
    add(name, needs, wrapped(name), vtk=True, few=True)
for name, needs in (("vtkCellCompositingMapper", "c"), ("vtkTexturedSplatMapper", "p")):
    add(name, needs, mapped(name), vtk=True, few=True)


# --- one trial --------------------------------------------------------------------------------------------------------

class Stage:
    """One plotter with data and a function in it."""

    def __init__(self, function, data, view=None):
        self.plotter = pv.Plotter(off_screen=True, window_size=(SIZE, SIZE), theme=pv.themes.DarkTheme())
        self.plotter.set_background("black")
        if function.scenery:
            function.scenery(self.plotter, data)
            self.frame(view)
            self.scenery = self.picture()
        else:
            self.scenery = np.zeros((SIZE, SIZE, 3), np.uint8)
        self.added = function.draw(self.plotter, data)
        self.frame(view)

    def frame(self, view=None):
        if view is None:
            self.plotter.view_isometric()
        else:
            position, focus, up, parallel = view
            self.plotter.camera.parallel_projection = parallel
            self.plotter.camera_position = [tuple(position), tuple(focus), tuple(up)]
            if parallel:
                self.plotter.camera.parallel_scale = np.linalg.norm(np.subtract(position, focus)) / 3
        self.plotter.renderer.ResetCameraClippingRange()

    def view(self):
        c = self.plotter.camera
        return np.array(c.position), np.array(c.focal_point), np.array(c.up), c.parallel_projection

    def picture(self):
        self.plotter.render()
        return np.ascontiguousarray(self.plotter.screenshot(return_img=True)[..., :3])

    def opengl_errors(self):
        return opengl_errors(self.plotter.render_window.MakeCurrent)


def trial(function, dataset):
    """(verdict, picture or None)"""
    function, verdict, stage, image = FUNCTIONS[function], Verdict(), None, None
    data = dataset.make()
    with Capture() as said:
        stage = Stage(function, data)
        image = stage.picture()
    told = verdict.words(said, function.vtk)
    scenery = stage.scenery if stage else None
    ready = bool(function.is_served_by(dataset, data))
    if function.vtk and (not getattr(data, "n_points", 0) or not ready or image is not None and told):
        told, ready = True, False  # a VTK class may say what it lacks, and does nothing with nothing
    may_draw = told or not function.name.startswith("add_")  # a filter may pass on what it was given
    visible = verdict.picture(ready, told, bool(said.raised), scenery, image, may_draw)
    if stage and image is not None:
        if codes := stage.opengl_errors():
            verdict.find("opengl", codes)
        verdict.same("unsteady", image, stage.picture(), exact=True)
        if ready and visible:
            with Capture() as later:
                for check in function.checks:
                    globals()["check_" + check](verdict, function, dataset, stage, image)
            if later.raised:
                verdict.find("check", later.raised)
            if codes := stage.opengl_errors():
                verdict.find("opengl", f"{codes} after the checks")
    for plotter in list(pv.plotting.plotter._ALL_PLOTTERS.values()):
        plotter.close()
    pv.close_all()
    return verdict, image


# --- checks -----------------------------------------------------------------------------------------------------------

def check_mirror(verdict, function, dataset, stage, image):
    """Behind a mirror at x = 0, as a matrix of the volume; and as data of its own where the cells are divided in one way alone."""
    view = mirrored(stage.view())
    stage.added.user_matrix = np.diag([-1.0, 1, 1, 1])
    before = stage.view()
    stage.frame(view)
    verdict.same("mirror", image, stage.picture()[:, ::-1])
    stage.added.user_matrix = np.eye(4)
    stage.frame(before)
    data = dataset.make()
    if isinstance(data, pv.UnstructuredGrid) and set(data.celltypes) == {pv.CellType.TETRA}:
        verdict.same("mirror", image, Stage(function, mirror(data), view).picture()[:, ::-1])


def check_unstructured(verdict, function, dataset, stage, image):
    data = dataset.make()
    if isinstance(data, pv.StructuredGrid) and not data.n_arrays == 0 and "vtkGhostType" not in data.array_names:
        data = data.cast_to_unstructured_grid()
    elif isinstance(data, (pv.ImageData, pv.RectilinearGrid)):
        data = data.cast_to_structured_grid().cast_to_unstructured_grid()
    else:
        return
    verdict.alike("unstructured", image, Stage(function, data, stage.view()).picture())


def by_rays_and_projected(stage):
    """Two pictures in one colour, which needs no order: projection has none that is exact for every mesh."""
    mapper, prop = stage.added.mapper, stage.added.prop
    method, color, one = mapper.GetMethod(), prop.GetRGBTransferFunction(), vtkColorTransferFunction()
    one.AddRGBPoint(0, 1, 0.8, 0.6)
    prop.SetColor(one)
    by_rays = stage.picture()
    mapper.SetMethodToProjection()
    projected = stage.picture()
    mapper.SetMethod(method)
    prop.SetColor(color)
    return by_rays, projected


def check_methods(verdict, function, dataset, stage, image):
    verdict.same("rays-projection", *by_rays_and_projected(stage))


def check_cameras(verdict, function, dataset, stage, image):
    if not dataset.views:
        return
    for name, view in cameras(dataset.make()).items():
        stage.frame(view)
        image = stage.picture()
        if name != "far" and not image.any():
            verdict.find("camera", f"{name}: nothing is drawn")
        step = 1e-5 * np.linalg.norm(view[1] - view[0]) * np.array([0.6, -0.5, 0.62])
        beside = view[0] + step, view[1] + step, view[2], view[3]
        pairs = [("beside", lambda: (image, (stage.frame(beside), stage.picture())[1]))]
        if "methods" in function.checks:
            pairs.insert(0, ("projection", lambda: by_rays_and_projected(stage)))
        for kind, both in pairs:
            found = Verdict()
            found.same("camera", *both())
            verdict.findings += [(k, f"{name}, {kind}: {text}") for k, text in found.findings]


def check_half(verdict, function, dataset, stage, image):
    """A clipping plane through the middle takes about half of the picture."""
    stage.added.mapper.RemoveAllClippingPlanes()
    verdict_of_all = stage.picture()
    if not (np.abs(verdict_of_all.astype(int) - image).max() > 6):
        verdict.find("not-clipped", "the clipping plane changes nothing")


def check_not_erased(verdict, function, dataset, stage, image):
    mesh = stage.scenery.max(axis=2) > 0
    before, after = stage.scenery[mesh].astype(float).std(axis=0).max(), image[mesh].astype(float).std(axis=0).max()
    if before > 10 and after < 0.15 * before:
        verdict.find("erased", f"the mesh's contrast falls from {before:.0f} to {after:.0f}")

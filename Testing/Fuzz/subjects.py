# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What is fuzzed: every filter and mapper that the package wraps, and files. A case is made from its number alone, so that it can be repeated."""
import hashlib
import inspect

import damaged_files
import nephoscope
import numpy as np
import random_calls
import random_data
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkCompositeDataSet, vtkDataObject, vtkDataSet, vtkPiecewiseFunction, vtkPointSet, vtkPolyData, vtkUnstructuredGrid
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm
from vtkmodules.vtkRenderingCore import (vtkAbstractVolumeMapper, vtkActor, vtkColorTransferFunction, vtkMapper, vtkRenderer, vtkRenderWindow,
                                         vtkVolume, vtkWindowToImageFilter)


class Finding(Exception):
    """What a case must not do."""


def can_be_made(cls):
    try:
        return bool(cls())
    except TypeError:  # of an abstract class
        return False


def classes(kind):
    return {name: cls for name, cls in vars(nephoscope).items()
            if name.startswith("vtk") and inspect.isclass(cls) and issubclass(cls, kind) and not hasattr(cls, "SetFileName") and can_be_made(cls)}


# ---- results

def leaves(data):
    if not isinstance(data, vtkCompositeDataSet):
        return [data] if data is not None else []
    iterator, found = data.NewIterator(), []
    while not iterator.IsDoneWithTraversal():
        found.append(iterator.GetCurrentDataObject())
        iterator.GoToNextItem()
    return found


def arrays_of(data):
    for association in (vtkDataObject.POINT, vtkDataObject.CELL):
        attributes = data.GetAttributes(association)
        for i in range(attributes.GetNumberOfArrays()):
            yield association, attributes.GetAbstractArray(i)


def check(data):
    """Arrays as long as their points or cells, and cells of points that are there."""
    counts = {vtkDataObject.POINT: data.GetNumberOfPoints(), vtkDataObject.CELL: data.GetNumberOfCells()}
    for association, array in arrays_of(data):
        if array.GetNumberOfTuples() != counts[association]:
            raise Finding(f"array {array.GetName()!r} has {array.GetNumberOfTuples()} tuples for {counts[association]}")
    lists = [data.GetCells()] if isinstance(data, vtkUnstructuredGrid) else [data.GetVerts(), data.GetLines(), data.GetPolys()] if isinstance(data, vtkPolyData) else []
    for cells in lists:
        ids = vtk_to_numpy(cells.GetConnectivityArray()) if cells and cells.GetNumberOfCells() else np.zeros(0)
        if ids.size and (ids.min() < 0 or ids.max() >= counts[vtkDataObject.POINT]):
            raise Finding(f"a cell of point {ids.max()} of {counts[vtkDataObject.POINT]}")


def digest(data):
    result = hashlib.sha1()
    for one in leaves(data):
        if isinstance(one, vtkDataSet):
            check(one)
            points = one.GetPoints() if isinstance(one, vtkPointSet) else None
            result.update(vtk_to_numpy(points.GetData()).tobytes() if points and points.GetNumberOfPoints() else b"")
            for _, array in arrays_of(one):
                result.update((array.GetName() or "").encode())
                if array.IsNumeric() and array.GetNumberOfTuples():
                    result.update(np.ascontiguousarray(vtk_to_numpy(array)).tobytes())
    return result.hexdigest()


# ---- filters

KINDS = {"vtkCloudSurface": random_data.GRIDS, "vtkStructuredSmoothing": random_data.GRIDS, "vtkGlobeGrid": (random_data.rectilinear,),
         "vtkGlobeTerrain": (random_data.rectilinear,), "vtkCloudTextureMapper": (random_data.polygons,)}


def run_filter(cls, seed, made):
    dice = random_data.Dice(seed)
    filter_, first = cls(), random_data.dataset(dice, KINDS.get(cls.__name__, random_data.SOLIDS))
    for port in range(filter_.GetNumberOfInputPorts()):
        if port == 0 or dice.rng.random() < 0.3:
            filter_.SetInputDataObject(port, random_data.dataset(dice, random_data.ALL) if port else first)
    if dice.rng.random() < 0.3:
        filter_.SetInputArrayToProcess(0, 0, 0, int(dice.rng.integers(2)), random_data.array_name(dice, first))
    made += random_calls.call(dice, filter_, first, 5)
    filter_.Update()
    return [digest(filter_.GetOutputDataObject(port)) for port in range(filter_.GetNumberOfOutputPorts())]


# ---- mappers

class Scene:
    """One window for all cases."""

    def __init__(self):
        self.window = vtkRenderWindow()
        self.window.OffScreenRenderingOn()
        self.window.SetMultiSamples(0)
        self.window.SetSize(48, 40)

    def start(self, dice):
        for renderer in list(self.window.GetRenderers()):
            self.window.RemoveRenderer(renderer)
        self.renderer = vtkRenderer()
        self.renderer.SetUseDepthPeeling(bool(dice.rng.random() < 0.3))
        self.renderer.SetUseDepthPeelingForVolumes(self.renderer.GetUseDepthPeeling())
        self.window.AddRenderer(self.renderer)

    def look(self, dice):
        camera = self.renderer.GetActiveCamera()
        self.renderer.ResetCamera()
        kind = dice.rng.integers(4)
        if kind == 0:
            camera.SetPosition(*camera.GetFocalPoint()[:2], camera.GetFocalPoint()[2] + camera.GetDistance())
        elif kind == 1:
            camera.Zoom(3)
        elif kind == 2:
            camera.Azimuth(float(dice.rng.uniform(0, 360)))
            camera.Elevation(float(dice.rng.uniform(-80, 80)))
        camera.SetParallelProjection(int(dice.rng.random() < 0.3))
        self.renderer.ResetCameraClippingRange()

    def picture(self):
        self.window.Render()
        grabber = vtkWindowToImageFilter()
        grabber.SetInput(self.window)
        grabber.ReadFrontBufferOff()
        grabber.ShouldRerenderOff()
        grabber.Update()
        return vtk_to_numpy(grabber.GetOutput().GetPointData().GetScalars()).copy()


SCENES = []


def transfer(dice, prop):
    colours, opacity = vtkColorTransferFunction(), vtkPiecewiseFunction()
    for x in np.sort(dice.rng.normal(size=0 if dice.odd(0.3) else dice.rng.integers(2, 5))):
        colours.AddRGBPoint(float(x), *dice.rng.random(3))
        opacity.AddPoint(float(x), float(dice.rng.random()))
    prop.SetColor(colours)
    prop.SetScalarOpacity(opacity)
    if dice.rng.random() < 0.3:
        prop.SetScalarOpacityUnitDistance(float(dice.pick([1e-6, 0.1, 1, 100])))


def prop_of(dice, mapper):
    if isinstance(mapper, vtkAbstractVolumeMapper):
        volume = vtkVolume()
        transfer(dice, volume.GetProperty())
    else:
        volume = vtkActor()
        volume.GetProperty().SetOpacity(float(dice.pick([1, 0.5])))
    volume.SetMapper(mapper)
    if dice.odd(0.3):
        volume.SetScale(*dice.rng.choice([1, -1, 2, 1e-3], size=3))
    return volume


def run_mapper(cls, seed, made):
    """A mapper through some changes of data, settings and views; each picture is drawn twice."""
    dice = random_data.Dice(seed)
    SCENES or SCENES.append(Scene())
    scene, mapper = SCENES[0], cls()
    scene.start(dice)
    data = random_data.dataset(dice, KINDS.get(cls.__name__, random_data.SOLIDS))
    mapper.SetInputDataObject(0, data)
    scene.renderer.AddViewProp(prop_of(dice, mapper))
    result = []
    for _ in range(dice.rng.integers(1, 5)):
        if dice.rng.random() < 0.3:
            data = random_data.dataset(dice, KINDS.get(cls.__name__, random_data.SOLIDS))
            mapper.SetInputDataObject(0, data)
        if dice.rng.random() < 0.3:
            getattr(mapper, str(dice.rng.choice(["SetScalarModeToUsePointFieldData", "SetScalarModeToUseCellFieldData", "SetScalarModeToDefault"])))()
            getattr(mapper, "SelectScalarArray" if hasattr(mapper, "SelectScalarArray") else "SelectColorArray")(random_data.array_name(dice, data))
        made += random_calls.call(dice, mapper, data, 4)
        scene.look(dice)
        made.append("render")
        first = scene.picture()
        if not (first == scene.picture()).all() and "SetPhase" not in " ".join(made):
            raise Finding("two renderings of one scene differ")
        result.append(hashlib.sha1(first.tobytes()).hexdigest())
    return result


FILTERS = {name: cls for name, cls in classes(vtkAlgorithm).items() if not issubclass(cls, (vtkMapper, vtkAbstractVolumeMapper))}
MAPPERS = {**classes(vtkAbstractVolumeMapper), **classes(vtkMapper)}
NAMES = sorted([*FILTERS, *MAPPERS, *damaged_files.READERS])


def run_reader(name, seed, made):
    return [digest(damaged_files.run(name, seed, made))]


def run(name, seed, made):
    """Runs a case twice; results must not differ. `made` gets the calls as text."""
    run_one, subject = ((run_filter, FILTERS[name]) if name in FILTERS else (run_mapper, MAPPERS[name]) if name in MAPPERS
                        else (run_reader, name))
    first = run_one(subject, seed, made)
    if first != run_one(subject, seed, []):
        raise Finding("run twice, the results differ")

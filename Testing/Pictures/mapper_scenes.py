# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""One small picture of every way in which the mappers draw, in plain VTK.

A scene is a function that fills a nephoscope_testing.offscreen.Scene. The first word of its name is its group.
"""
import sys

import nephoscope
import numpy as np
import pictures
from nephoscope_testing import meshes
from nephoscope_testing.offscreen import Window
from nephoscope_testing.transfer import Transfer
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws text)
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkPlane
from vtkmodules.vtkFiltersCore import vtkCellCenters
from vtkmodules.vtkFiltersGeneral import vtkDataSetTriangleFilter
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor, vtkPolyDataMapper

SIZE = (200, 150)
BACKGROUND = (0.2, 0.3, 0.45)
WARM = [(0, 0.1, 0.3, 1), (0.5, 1, 1, 1), (1, 1, 0.3, 0.1)]
CLOUD = Transfer(WARM, [(0.1, 0), (1, 2.0)])
CLEAR = Transfer(WARM, [(0, 0)])
SCENES = {}


def scene(name, **look):
    """Registers the function that fills a scene; `look` says from where it is seen."""
    def register(fill):
        SCENES[name] = (fill, look)
        return fill
    return register


def draw(name):
    """(height, width, 3), 0 to 255, top row first."""
    fill, look = SCENES[name]
    window = Window(SIZE)
    made = window.add_scene(background=BACKGROUND)
    fill(made)
    made.look_at((-1, 1, -1, 1, -1, 1), **{"direction": (-0.5, -0.75, 0.45), "up": (0, 0, 1), "zoom": 1.25, **look})
    window.render()
    if window.messages.all or window.gl_errors():
        raise RuntimeError(f"{name}: {window.messages.all or window.gl_errors()}")
    return np.rint(255 * window.rgba()[::-1, :, :3])


# ---- data

def values(p):
    """Two clouds, one above the other."""
    x, y, z = p.T
    return np.exp(-2.5 * (x ** 2 + y ** 2 + (z - 0.35) ** 2)) + 0.8 * np.exp(-4 * ((x - 0.4) ** 2 + (y + 0.3) ** 2 + (z + 0.5) ** 2))


def image(count=16):
    return meshes.with_field(meshes.image((count,) * 3, (2 / count,) * 3, (-1, -1, -1)), values)


def tetrahedra(count=8):
    divide = vtkDataSetTriangleFilter()
    divide.SetInputData(image(count))
    divide.Update()
    return divide.GetOutput()


def cells_of(kind, count=8):
    return meshes.with_field(meshes.Lattice(count).mesh(kind, lambda p: 2 * p - 1 + 0.06 * np.sin(6 * p[:, [1, 2, 0]])), values)


def winds(count=18):
    data = image(count)
    x, y, z = meshes.points_of(data).T
    meshes.add_array(data.GetPointData(), np.column_stack([-y, x, 0.2 * z]), "wind")
    return data


def ball(radius=0.45, color=(0.9, 0.6, 0.2), opacity=1.0):
    source, mapper, actor = vtkSphereSource(), vtkPolyDataMapper(), vtkActor()
    source.SetRadius(radius)
    source.SetThetaResolution(48)
    source.SetPhiResolution(32)
    mapper.SetInputConnection(source.GetOutputPort())
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(*color)
    actor.GetProperty().SetOpacity(opacity)
    return actor


# ---- cells

def clip(mapper):
    plane = vtkPlane()
    plane.SetNormal(0.3, 1, 0.2)
    mapper.AddClippingPlane(plane)


def cells(made, data, configure=None, transfer=CLOUD, **options):
    mapper = nephoscope.vtkCellCompositingMapper()
    if configure:
        configure(mapper)
    made.add_volume(mapper, data, transfer, **options)
    return mapper


@scene("cells-image")
def _(made):
    cells(made, image())


@scene("cells-tetrahedra")
def _(made):
    cells(made, tetrahedra())


@scene("cells-mixed")
def _(made):
    cells(made, cells_of("mixed"))


@scene("cells-of-cell-data")
def _(made):
    cells(made, meshes.with_field(meshes.image((10,) * 3, (0.2,) * 3, (-1, -1, -1)), values, "cell"), association="cell")


@scene("cells-projection")
def _(made):
    cells(made, cells_of("wedge"), lambda m: m.SetMethodToProjection())


@scene("cells-triangles")
def _(made):
    cells(made, tetrahedra(), lambda m: m.SetMethodToTrianglesTable())


@scene("cells-faces")
def _(made):
    cells(made, tetrahedra(6), lambda m: m.SetMethodToFaces())


def contours(mapper, opacity=0.6):
    mapper.SetNumberOfContourValues(2)
    for i, value in enumerate((0.3, 0.7)):
        mapper.SetContourValue(i, value)
        mapper.SetContourOpacity(i, opacity)


@scene("cells-average-integration")
def _(made):
    cells(made, tetrahedra(), lambda m: m.SetIntegrationToAverage())


@scene("cells-contours")
def _(made):
    cells(made, image(), contours)


@scene("cells-contours-alone")
def _(made):
    """So thin that 2 % more opacity is 2 % more light."""
    cells(made, image(), lambda m: contours(m, 0.15), CLEAR)


@scene("cells-layers")
def _(made):
    thin, thick = Transfer([(0, 0.2, 0.9, 0.4), (1, 0.2, 0.9, 0.4)], [(0, 0.4), (1, 0.4)]), CLOUD

    def layered(mapper):
        contours(mapper)
        mapper.SetLayersFromContours(True)
        mapper.SetLayerProperty(1, thin.volume_property())
    cells(made, image(), layered, thick)


@scene("cells-layers-alone")
def _(made):
    def layered(mapper):
        contours(mapper, 0)
        mapper.SetLayersFromContours(True)
        mapper.SetLayerProperty(1, Transfer([(0, 0.2, 0.9, 0.4)], [(0, 0.2)]).volume_property())
    cells(made, image(), layered, Transfer(WARM, [(0, 0), (1, 0.3)]))


def pieces():
    """Pieces of cells, and the surfaces between them."""
    splitter = nephoscope.vtkContourCellSplitter()
    splitter.SetInputData(cells_of("tetra", 6))
    splitter.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, "s")
    splitter.SetNumberOfContours(2)
    splitter.SetValue(0, 0.3)
    splitter.SetValue(1, 0.7)
    splitter.Update()
    return splitter.GetOutput()


@scene("cells-polygons")
def _(made):
    def polygons(mapper):
        mapper.SetPolygonOpacity(0, 0.4)
        mapper.SetPolygonOpacity(1, 0.8)
        mapper.SetPolygonColor(1, 1, 0.9, 0.3)
    cells(made, pieces(), polygons)


@scene("cells-polygons-alone")
def _(made):
    cells(made, pieces(), lambda m: m.SetPolygonOpacity(0.15), CLEAR)


@scene("cells-smoke")
def _(made):
    """Opacity from an array of the cells, as of smoke; colour from another of the points."""
    data = cells_of("tetra", 6)
    centers = vtkCellCenters()
    centers.SetInputData(data)
    centers.Update()
    meshes.add_array(data.GetCellData(), values(meshes.points_of(centers.GetOutput())), "density")
    cells(made, data, lambda m: m.SetOpacityArrayName("density"))


@scene("cells-from-inside", zoom=8.0, direction=(-1, 0, 0))
def _(made):
    cells(made, image(), transfer=Transfer(WARM, [(0, 0.05), (1, 1.5)]))


@scene("cells-clipped")
def _(made):
    cells(made, image(), clip)


@scene("cells-around-a-ball")
def _(made):
    cells(made, image(), transfer=Transfer(WARM, [(0, 0.3), (1, 1.0)]))
    made.renderer.AddActor(ball())


@scene("cells-of-two-media")
def _(made):
    """A plume of unstructured cells in and behind a cloud on a grid."""
    divide = vtkDataSetTriangleFilter()
    divide.SetInputData(meshes.image((6, 6, 12), (1 / 6,) * 3, (-0.5, -0.1, -1)))
    divide.Update()
    plume = meshes.with_field(divide.GetOutput(), lambda p: np.exp(-9 * ((p[:, 0] - 0.2 * p[:, 2]) ** 2 + (p[:, 1] - 0.4) ** 2)))
    cells(made, image(), transfer=Transfer([(0, 1, 1, 1)], [(0.1, 0), (1, 2.0)]))
    cells(made, plume, transfer=Transfer([(0, 1, 0.3, 0)], [(0.2, 0), (1, 5.0)]))


@scene("cells-among-peels")
def _(made):
    made.renderer.SetUseDepthPeeling(1)
    made.renderer.SetUseDepthPeelingForVolumes(1)
    cells(made, image(), transfer=Transfer(WARM, [(0, 0.3), (1, 1.0)]))
    made.renderer.AddActor(ball(0.6, (0.2, 0.9, 0.3), 0.5))


# ---- splats

def splats(made, data, configure=None, transfer=CLOUD):
    mapper = nephoscope.vtkTexturedSplatMapper()
    if configure:
        configure(mapper)
    made.add_volume(mapper, data, transfer)
    return mapper


@scene("splats-image")
def _(made):
    splats(made, image())


@scene("splats-cells")
def _(made):
    splats(made, cells_of("tetra", 6))


@scene("splats-particles")
def _(made):
    rng = np.random.default_rng(3)
    data = meshes.with_field(meshes.particles(rng.uniform(-1, 1, (1500, 3))), values)
    splats(made, data, lambda m: m.SetCellSize(0.18))


@scene("splats-gaussian")
def _(made):
    splats(made, image(10), lambda m: m.SetKernelToGaussian())


@scene("splats-quadratic")
def _(made):
    splats(made, image(10), lambda m: m.SetKernelToQuadratic())


@scene("splats-clipped")
def _(made):
    splats(made, image(), clip)


@scene("splats-hierarchy")
def _(made):
    splats(made, image(24), lambda m: m.SetErrorTolerance(0.05))


def streaks(mapper):
    mapper.SetVectorArrayName("wind")
    mapper.SetPhase(0.3)


@scene("splats-streaks")
def _(made):
    splats(made, winds(), streaks)


@scene("splats-segments")
def _(made):
    def segments(mapper):
        streaks(mapper)
        mapper.SetVectorStyleToSegments()
    splats(made, winds(), segments)


@scene("splats-streaks-alone")
def _(made):
    """So thin that 2 % more is 2 % more light; also below."""
    splats(made, winds(), lambda m: (streaks(m), m.SetVectorOpacity(0.2)), CLEAR)


@scene("splats-segments-alone")
def _(made):
    splats(made, winds(), lambda m: (streaks(m), m.SetVectorStyleToSegments(), m.SetVectorOpacity(0.2)), CLEAR)


@scene("splats-speed-key")
def _(made):
    """Segments at true speed, with their legend."""
    def moving(mapper):
        streaks(mapper)
        mapper.SetVectorStyleToSegments()
        mapper.TrueSpeedOn()
        mapper.SetFilmTime(0.4)
    mapper = splats(made, winds(), moving)
    key = nephoscope.vtkSplatSpeedKey()
    key.SetVolume(next(volume for volume in made.renderer.GetVolumes() if volume.GetMapper() is mapper))
    key.SetSpeedUnit("m/s")
    key.GetTextProperty().SetFontSize(9)
    made.renderer.AddViewProp(key)


@scene("splats-in-layers")
def _(made):
    def layers(mapper):
        streaks(mapper)
        mapper.SetVectorPlacementToLayers()
    splats(made, winds(), layers)


@scene("splats-around-a-ball")
def _(made):
    splats(made, image(), transfer=Transfer(WARM, [(0, 0.3), (1, 1.0)]))
    made.renderer.AddActor(ball())


# ---- cloud texture and haze

def cloud(made, configure=None, radius=0.8):
    mapper, actor, source = nephoscope.vtkCloudTextureMapper(), vtkActor(), vtkSphereSource()
    source.SetRadius(radius)
    source.SetThetaResolution(64)
    source.SetPhiResolution(48)
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.ScalarVisibilityOff()
    if configure:
        configure(mapper)
    actor.SetMapper(mapper)
    made.renderer.SetUseDepthPeeling(1)
    made.renderer.AddActor(actor)
    return mapper


@scene("clouds-layer")
def _(made):
    cloud(made)
    made.renderer.AddActor(ball(0.6, (0.1, 0.35, 0.25)))


@scene("clouds-thickness")
def _(made):
    cloud(made, lambda m: m.UseThicknessOn())
    made.renderer.AddActor(ball(0.4))


@scene("clouds-relief")
def _(made):
    def relief(mapper):
        mapper.SetRelief(0.04)
        mapper.SetCoverage(0.7)
    cloud(made, relief)


@scene("clouds-colours")
def _(made):
    def colours(mapper):
        mapper.SetThinColor(0.9, 0.35, 0.2)
        mapper.SetThickColor(1, 1, 0.7)
        mapper.SetColorRange(1.0)
    cloud(made, colours)


@scene("clouds-added-thickness")
def _(made):
    def added(mapper):
        mapper.UseThicknessOn()
        mapper.SetThicknessEffectToAddToTexture()
        mapper.SetCoverage(0.05)
    cloud(made, added)


@scene("clouds-threshold")
def _(made):
    def threshold(mapper):
        mapper.UseThresholdOn()
        mapper.SetThreshold(1.0)
    cloud(made, threshold)


@scene("clouds-waves-paper")
def _(made):
    cloud(made, lambda m: m.SetWavesToPaper())


@scene("clouds-waves-printed")
def _(made):
    cloud(made, lambda m: m.SetWavesToPrinted())


@scene("clouds-waves-gardner")
def _(made):
    cloud(made, lambda m: m.SetWavesToGardner())


@scene("clouds-altitude")
def _(made):
    cloud(made, lambda m: m.UseAltitudeOn())


def haze(made, configure):
    veil = nephoscope.vtkHaze()
    configure(veil)
    nephoscope.vtkHaze.SetHaze(made.renderer, veil)


def thick(veil):
    veil.SetVisibility(3.0)
    veil.SetColor(0.8, 0.85, 0.9)


def even(*color):
    """As dense everywhere, with an optical depth above 1 before what is drawn: what is seen of that changes by more than 2 % where haze does by 2 %."""
    def configure(veil):
        veil.SetProjectionToMap()
        veil.SetBaseLevel(-1000)
        veil.SetScaleHeight(1e5)
        veil.SetExtinction(0.25)
        veil.SetColor(*color)
    return configure


def balls(made):
    for x in (-0.6, 0.0, 0.6):
        actor = ball(0.35)
        actor.SetPosition(x, 2 * x, 0)
        made.renderer.AddActor(actor)


@scene("haze-surfaces")
def _(made):
    balls(made)
    haze(made, thick)


@scene("haze-cells")
def _(made):
    cells(made, image())
    haze(made, thick)


@scene("haze-splats")
def _(made):
    splats(made, image())
    haze(made, thick)


@scene("haze-even-surfaces")
def _(made):
    balls(made)
    haze(made, even(0.2, 0.4, 1))


@scene("haze-even-cells")
def _(made):
    cells(made, image())
    haze(made, even(0.4, 0.4, 0.4))


@scene("haze-even-splats")
def _(made):
    splats(made, image())
    haze(made, even(0.4, 0.4, 0.4))


@scene("haze-sky")
def _(made):
    """Above a planet that is not drawn, so thin that its light is in proportion to it."""
    def shell(veil):
        veil.SetProjectionToGlobe()
        veil.SetPlanetRadius(0.8)
        veil.SetScaleHeight(0.08)
        veil.SetExtinction(0.5)
    made.renderer.AddActor(ball(0.1))
    haze(made, shell)


if __name__ == "__main__":
    pictures.save(draw(sys.argv[1]), "picture.png")

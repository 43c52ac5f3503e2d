# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of textured splats."""
import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.transfer import Transfer
from scene_book import scene
from scene_data import CLEAR, CLOUD, WARM, ball, cells_of, clip, image, values, winds
import vtkmodules.vtkRenderingFreeType  # noqa: F401  (draws text)


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

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of cloud texture."""
import nephoscope
from scene_book import scene
from scene_data import ball
from vtkmodules.vtkFiltersSources import vtkSphereSource
from vtkmodules.vtkRenderingCore import vtkActor


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

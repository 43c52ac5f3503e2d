# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scenes of haze, in front of surfaces and of what the other mappers draw."""
import nephoscope
from cell_scenes import cells
from scene_book import scene
from scene_data import ball, image
from splat_scenes import splats


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

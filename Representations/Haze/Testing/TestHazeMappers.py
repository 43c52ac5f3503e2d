# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Whatever is made of vtkOpenGLPolyDataMapper is hazed: behind thick haze nothing of its own colour is left."""
import unittest

import nephoscope
import numpy as np
from haze_scenes import STEP, HazeTestCase
from nephoscope_testing.haze import Haze
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkFiltersSources import vtkConeSource, vtkLineSource, vtkSphereSource
from vtkmodules.vtkRenderingCore import (vtkActor, vtkAssembly, vtkCompositePolyDataMapper, vtkGlyph3DMapper, vtkPointGaussianMapper,
                                         vtkPolyDataMapper, vtkTexture)

try:
    from vtkmodules.vtkRenderingLOD import vtkLODActor
except ImportError:
    vtkLODActor = None

LOOK = {"position": (0, 0, 6), "focus": (0, 0, 0), "up": (0, 1, 0), "angle": 30, "near": 1, "far": 20}
THICK = Haze(1e3, 1e3, up=(0, 1, 0), color=(0.2, 0.6, 0.4))


def output(source):
    source.Update()
    return source.GetOutput()


def surface(data, mapper=None, actor=None):
    mapper = mapper or vtkPolyDataMapper()
    mapper.SetInputDataObject(data)
    mapper.ScalarVisibilityOff()
    actor = actor or vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(1, 0.3, 0.2)
    actor.GetProperty().SetAmbient(0.5)
    return actor


def looks():
    """An actor for each of the ways to draw."""
    ball = output(vtkSphereSource())
    result = {name: surface(ball) for name in ("lit", "flat", "wireframe", "points", "point spheres", "edges", "textured", "translucent",
                                               "unlit", "physically based")}
    result["flat"].GetProperty().SetInterpolationToFlat()
    result["wireframe"].GetProperty().SetRepresentationToWireframe()
    for name in ("points", "point spheres"):
        result[name].GetProperty().SetRepresentationToPoints()
        result[name].GetProperty().SetPointSize(6)
    result["point spheres"].GetProperty().RenderPointsAsSpheresOn()
    result["edges"].GetProperty().EdgeVisibilityOn()
    result["edges"].GetProperty().SetEdgeColor(0.3, 0.3, 1)
    result["translucent"].GetProperty().SetOpacity(0.999)
    result["unlit"].GetProperty().LightingOff()
    result["physically based"].GetProperty().SetInterpolationToPBR()
    chess = vtkImageData()
    chess.SetDimensions(2, 2, 1)
    chess.AllocateScalars(3, 3)
    texture = vtkTexture()
    texture.SetInputData(chess)
    result["textured"].SetTexture(texture)
    result["tubes"] = surface(output(vtkLineSource()))
    result["tubes"].GetProperty().SetLineWidth(8)
    result["tubes"].GetProperty().RenderLinesAsTubesOn()
    glyphs = vtkGlyph3DMapper()
    glyphs.SetSourceData(output(vtkConeSource()))
    glyphs.SetScaleFactor(0.2)
    result["glyphs"] = surface(ball, glyphs)
    gaussians = vtkPointGaussianMapper()
    gaussians.SetScaleFactor(0.0)
    gaussians.EmissiveOff()  # else points add up, with haze as without
    result["gaussian points"] = surface(ball, gaussians)
    blocks = vtkMultiBlockDataSet()
    blocks.SetBlock(0, ball)
    blocks.SetBlock(1, output(vtkConeSource()))
    result["composite data"] = surface(blocks, vtkCompositePolyDataMapper())
    assembly = vtkAssembly()
    assembly.AddPart(surface(ball))
    result["assembly"] = assembly
    if vtkLODActor:
        result["levels of detail"] = surface(ball, actor=vtkLODActor())
    return result


class Mappers(HazeTestCase):
    def test_nothing_of_their_own_colour_is_left(self):
        for name, actor in looks().items():
            with self.subTest(name):
                window, scene = self.window([], look=LOOK, blend=True)
                scene.renderer.AddActor(actor)
                window.render()
                drawn = scene.rgb().max(axis=2) > 0.02
                self.assertGreater(drawn.sum(), 5)
                haze = THICK.make(nephoscope.vtkHaze)
                haze.BackgroundOff()
                nephoscope.vtkHaze.SetHaze(scene.renderer, haze)
                window.render()
                self.assertEqual(window.messages.all, [])
                hazed = scene.rgb()
                np.testing.assert_allclose(hazed[drawn], np.tile(THICK.color, (drawn.sum(), 1)), atol=2 * STEP)
                self.assertEqual(hazed[~drawn].max(), 0)


if __name__ == "__main__":
    unittest.main()

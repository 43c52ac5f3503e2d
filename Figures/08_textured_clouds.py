# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Figure 8: the surface of figure 7 with a texture of broken cloud: the same time, levels and camera.

After figure 8 of Max, Crawfis and Becker (1993). As in the paper, thickness is added to the texture before the threshold, so that thin
edges break up and deep clouds close. Writes the picture and the ParaView state that shows it again.
"""
import os
import sys

from paraview import simple as pvs

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "common"))
import cloud_surface_scene  # noqa: E402

TEXTURE = {
    "TextureScale": 14, "Softness": 0.5,
    "UseThickness": 1, "ThicknessEffect": "Is Added To Texture",
    "Extinction": 1e-5,  # per metre of the display
    "Coverage": 0.07,  # without thickness
}


def show_texture(surface, view):
    shown = pvs.Show(surface, view)
    shown.SetRepresentationType("Cloud Texture")
    shown.ColorArrayName = ["POINTS", ""]
    shown.DiffuseColor = shown.AmbientColor = [1.0, 1.0, 1.0]
    shown.Ambient, shown.Diffuse = 0.3, 0.78
    for name, value in TEXTURE.items():
        setattr(shown, "CloudTexture" + name, value)
    return shown


cloud_surface_scene.picture("08_textured_clouds", "Textured clouds", "15 % cloud cover, smoothed once and textured", 1, show_texture)

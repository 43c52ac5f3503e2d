# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The scenes of the mappers by their names, and how one is drawn."""
import numpy as np
from nephoscope_testing.offscreen import Window

SIZE = (200, 150)
BACKGROUND = (0.2, 0.3, 0.45)
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

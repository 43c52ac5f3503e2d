# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""One small picture of every way in which the mappers draw, in plain VTK: cell_scenes.py, splat_scenes.py, cloud_scenes.py and haze_scenes.py.

A scene is a function that fills a nephoscope_testing.offscreen.Scene. The first word of its name is its group.
"""
import sys

import cell_scenes  # noqa: F401  (registers its scenes, as the next three)
import cloud_scenes  # noqa: F401
import haze_scenes  # noqa: F401
import pictures
import splat_scenes  # noqa: F401
from scene_book import SCENES, draw

__all__ = ["SCENES", "draw"]

if __name__ == "__main__":
    pictures.save(draw(sys.argv[1]), "picture.png")

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""break_shaders.py [FAMILY...]: which stored pictures notice that a shader is off by 2 %, as a table.

Mesa tells the shaders that it is given (MESA_SHADER_DUMP_PATH) and takes others in their place (MESA_SHADER_READ_PATH). Nothing in the tree changes.
Run it by ./nephoscope python (CONTRIBUTING.md). Exits with 1 if there is a change that no picture notices.
"""
import os
import sys
import tempfile
from pathlib import Path

import render
from snippets import ROOT

os.environ["PYTHONPATH"] = os.pathsep.join([os.environ.get("PYTHONPATH", ""), str(ROOT / "Testing" / "Python")])
FACTORS = ("0.98", "1.02")
CELLS = "cells-image cells-tetrahedra cells-mixed cells-around-a-ball"
# family, what is off, pictures, text of a shader in which the factor stands in the place of @
BREAKS = [
    ("cells, rays", "optical depth", CELLS, "opticalLength = @opticalScale;"),
    ("cells, rays", "colour", CELLS, "vec4 accumulatedLight()\n{\n  return @light;"),
    ("cells, projection", "optical depth", "cells-projection", "float opticalScale = @(uFront - uBack)"),
    ("cells, projection", "light", "cells-projection", "return @integrateSegment(front, back, opticalScale);"),
    ("cells, mean colour", "optical depth", "cells-average-integration", "float tau = @0.5"),
    ("cells, triangles", "optical depth", "cells-triangles", "lookUpOpacity(@mean.a"),
    ("contours", "opacity", "cells-contours cells-contours-alone", "return @vec4(surface.a * surface.rgb, surface.a);"),
    ("contours", "light", "cells-contours", "surface.rgb = @light(surface.rgb, unit(normal)"),
    ("polygons", "opacity", "cells-polygons cells-polygons-alone", "surface = @vec4(surface.a * surface.rgb, surface.a);"),
    ("polygons", "light", "cells-polygons", "surface.rgb = @light(surface.rgb, unit(gradientMatrix"),
    ("layers", "optical depth of all", "cells-layers cells-layers-alone", "integrateSegment(start, end, @(to - from)"),
    ("smoke", "optical depth", "cells-smoke", "value.a = @evaluateOpacity("),
    ("splats of scalars", "optical depth", "splats-image splats-cells splats-particles splats-hierarchy", "opticalDepth *= @footprint(q);"),
    ("splats of scalars", "colour", "splats-image splats-cells splats-particles splats-hierarchy", "vec4(@alpha * colorVSOutput.rgb, alpha)"),
    ("splats, gaussian", "optical depth", "splats-gaussian", "opticalDepth *= @footprint(q);"),
    ("splats, quadratic", "optical depth", "splats-quadratic", "opticalDepth *= @footprint(q);"),
    ("splats before a surface", "optical depth", "splats-around-a-ball splats-clipped", "opticalDepth *= @footprint(q);"),
    ("splats of vectors, streaks", "optical depth", "splats-streaks-alone splats-streaks", "opticalDepth = @vectorScale"),
    ("splats of vectors, segments", "opacity", "splats-segments-alone splats-segments", "* @(1.0 - exp(-vectorScale))"),
    ("cloud texture", "opacity", "clouds-layer clouds-colours clouds-altitude clouds-threshold", "look.a *= @cloudShare("),
    ("cloud texture", "colour", "clouds-colours", "look.rgb = @mix(thinColor"),
    ("thickness", "optical depth", "clouds-added-thickness clouds-thickness", "return @part * lengthPerDepth"),
    ("haze", "optical depth", "haze-surfaces haze-even-surfaces haze-even-cells haze-even-splats", "return exp(-@hazeExtinction"),
    ("haze", "colour", "haze-even-surfaces haze-even-splats", "mix(@hazeTint, rgb"),
    ("haze", "colour before cells", "haze-even-cells", "mix(@light.a * hazeTint"),
    ("haze before the sky", "optical depth", "haze-sky", "1.0 - exp(-@hazeExtinction"),
]


def shaders_of(name, folder):
    os.environ["MESA_SHADER_DUMP_PATH"] = str(folder)
    picture, why = render.render(name)
    del os.environ["MESA_SHADER_DUMP_PATH"]
    if why or render.problem(name, picture, render.baseline(name)):
        sys.exit(f"{name} is not as stored, before anything is changed: {why}")
    return {file.name: file.read_text(encoding="utf-8") for file in folder.glob("*.glsl")}


def notices(name, text, factor, shaders):
    """Whether the test of a picture fails with a factor in its shaders; None if the text is in none of them."""
    old, new = text.replace("@", ""), text.replace("@", factor + " * ")
    changed = {file: shader.replace(old, new) for file, shader in shaders.items() if old in shader}
    if not changed:
        return None
    with tempfile.TemporaryDirectory() as folder:
        for file, shader in changed.items():
            (Path(folder) / file).write_text(shader, encoding="utf-8")
        os.environ["MESA_SHADER_READ_PATH"] = folder
        picture, why = render.render(name)
        del os.environ["MESA_SHADER_READ_PATH"]
    return why is not None or render.problem(name, picture, render.baseline(name)) is not None  # mappers also try the driver, and tell


def main(families):
    shaders, missed = {}, 0
    print("| shader | off by 2 % | pictures that fail | that do not |\n|---|---|---|---|", flush=True)
    for family, what, names, text in BREAKS:
        if families and not any(family.startswith(chosen) for chosen in families):
            continue
        verdicts = {}
        for name in names.split():
            if name not in shaders:
                with tempfile.TemporaryDirectory() as folder:
                    shaders[name] = shaders_of(name, Path(folder))
            verdicts[name] = {notices(name, text, factor, shaders[name]) for factor in FACTORS}
        fail = [name for name, found in verdicts.items() if found == {True}]
        missed += not fail
        others = [name + (" (not in its shaders)" if None in found else "") for name, found in verdicts.items() if name not in fail]
        print(f"| {family} | {what} | {', '.join(fail) or '**none**'} | {', '.join(others)} |", flush=True)
    return 1 if missed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

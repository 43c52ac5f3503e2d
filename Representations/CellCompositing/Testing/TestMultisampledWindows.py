# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""In multisampled windows rays end where the opaque geometry lies at the centre of their pixel, as in others: a thin layer over a slope stays."""
import unittest

import nephoscope
import numpy as np
from nephoscope_testing import meshes
from nephoscope_testing.checks import ImageTestCase, mapper
from nephoscope_testing.offscreen import Window, float_image
from nephoscope_testing.transfer import constant
from TestCellCompositingOpaque import plane

SIZE = 60


class MultisampledWindows(ImageTestCase):
    def picture(self, samples, towards, kind, height=0.004):
        """A layer that is much thinner than the slope rises in half a pixel, on an opaque plane right below it."""
        window = Window((SIZE, SIZE))
        window.window.SetMultiSamples(samples)
        scene = window.add_scene()
        scene.add_opaque(plane((0, 0, -1e-4), 4, (0, 0, 1)), (1, 0, 0))
        data = meshes.with_field(meshes.image((8, 8, 1), (0.25, 0.25, height), (-1, -1, 0)), lambda p: p[:, 2])
        ours = mapper() if kind == "cells" else nephoscope.vtkTexturedSplatMapper()
        scene.add_volume(ours, data, constant(2 / height))
        scene.look((3 * towards[0], 3 * towards[1], 0.8), (0, 0, 0), (0, 0, 1), parallel_scale=0.3, near=0.1, far=10)
        window.render()
        self.fail_on_messages(window)
        self.assertEqual(window.gl_errors(), [])
        return float_image(ours)

    def test_a_thin_layer_over_a_slope(self):
        for kind in ("cells", "splats"):
            for turn in np.arange(8) * np.pi / 4 + 0.1:
                towards = np.cos(turn), np.sin(turn)
                plain, multisampled = (self.picture(samples, towards, kind)[..., 3] for samples in (0, 4))
                self.assertGreater(np.median(plain), 0.5)
                error = np.abs(plain - multisampled)[5:-5, 5:-5].max()
                print(f"  {kind} from {np.degrees(turn):.0f} degrees: {error * 255:.2f}/255", flush=True)
                self.assertLessEqual(error, 4 / 255)


if __name__ == "__main__":
    unittest.main()

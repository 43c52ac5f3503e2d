# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Textured clouds in the wind, frame by frame through half a day and more: nothing pops when a set of coordinates is born, the cover does not
pulse, and the cut of the longitudes does not show."""
import unittest

import numpy as np
from moving_texture import COLUMNS, Clouds, Layer

SCALE = 12
BIRTHS = (12, 24, 36)  # of the two sets by turns; the first one's first is at hour 0
FRAMES = np.arange(11, 25.01, 0.25)  # of 15 minutes, from a birth of one set to one of the other, with an hour before and after
SECOND = 1 / 3600
KEY_FRAMES = {"every frame": 0, "one frame in four": 3600}


class Frames(unittest.TestCase):
    def layer(self, cover=0.4, **settings):
        layer = Layer(**settings)
        layer.mapper.SetTextureScale(SCALE)
        layer.mapper.SetCoverage(cover)
        return layer

    def draw(self, layer, hour):
        picture = layer.draw(hour)
        self.assertEqual(layer.window.messages.all, [])
        return picture

    def test_births_do_not_show(self):
        """A set is born with weight 0 and dies with weight 0. In 2 seconds about a birth weights change by 5e-5, air moves 150 m at the most:
        nothing that 8 bits show but by rounding."""
        for name, interval in KEY_FRAMES.items():
            layer = self.layer(KeyFrameInterval=interval)
            for birth in BIRTHS:
                before, at, after = (self.draw(layer, birth + s * SECOND) for s in (-1, 0, 1))
                self.assertGreater(np.ptp(at), 0.8)
                for other in (before, after):
                    self.assertLess(np.abs(other - at).max(), 1.5 / 255, msg=f"{name}, birth at hour {birth}")

    def test_no_frame_stands_out(self):
        """What changes from a frame to the next is no more than what changes in the hour before or after it."""
        for name, interval in KEY_FRAMES.items():
            layer = self.layer(KeyFrameInterval=interval)
            pictures = np.array([self.draw(layer, hour) for hour in FRAMES])
            change = np.abs(np.diff(pictures, axis=0)).mean(axis=(1, 2))
            others = [np.r_[change[max(0, i - 4):i], change[i + 1:i + 5]] for i in range(change.size)]
            ratio = np.array([c / o.max() for c, o in zip(change, others)])
            births = [r for r, hour in zip(ratio, FRAMES) if hour in BIRTHS or hour + 0.25 in BIRTHS]
            print(f"  {name}: change at births {max(births):.3f}, elsewhere {ratio.max():.3f} of the greatest near it")
            self.assertGreater(change.min(), 0.005)  # the clouds do move
            self.assertLess(ratio.max(), 1.05)

    def test_cover_and_contrast_do_not_pulse(self):
        """Every frame shows the whole world: the drawn cover is the one asked for, and clouds are as distinct while one set fades into the
        other as they are by one set alone."""
        layer = self.layer(size=(256, 128), KeyFrameInterval=3600)
        for cover in (0.15, 0.5, 0.85):
            layer.mapper.SetCoverage(cover)
            pictures = np.array([self.draw(layer, hour) for hour in FRAMES[::4]])
            drawn, contrast = pictures.mean(axis=(1, 2)), pictures.std(axis=(1, 2))
            print(f"  cover {cover}: {drawn.min():.4f} to {drawn.max():.4f}, contrast {contrast.min():.4f} to {contrast.max():.4f}")
            self.assertLess(np.abs(drawn - cover).max(), 0.01)
            self.assertLess(np.ptp(drawn), 0.01)
            self.assertLess(contrast.max() / contrast.min(), 1.1)

    def test_the_cut_does_not_show(self):
        """The planet seen where its longitudes are cut is that of fields turned by half a round, seen from the other side. The texture is
        repeated an even number of times, so half a round further it is the same. At the poles, where longitudes end, it is not."""
        for hour in (9, 24, 31.75):
            pictures = []
            for columns in (0, COLUMNS // 2):
                clouds = Clouds((192, 192), columns)
                clouds.mapper.SetTextureScale(SCALE)
                pictures.append(self.draw(clouds, hour)[16:-16])  # without the polar caps
            middle = pictures[0][:, 92:100]  # where the cut is
            self.assertGreater(np.ptp(middle), 0.9)
            difference = np.abs(pictures[1] - pictures[0])
            print(f"  hour {hour}: {100 * np.mean(difference > 2 / 255):.3f} % of the pixels differ, mean {255 * difference.mean():.4f}/255")
            self.assertLess(np.mean(difference > 2 / 255), 0.001)


if __name__ == "__main__":
    unittest.main()

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""All pairs of what can be in one view: one in front of the other, behind it, in it; in both orders of adding; with and without peeling."""
import itertools
import unittest

import numpy as np
import together
from nephoscope_testing.haze import Haze
from together import Clouds, CloudTops, Contours, Label, Smoke, Splats, Surface, Terrain, Winds

STEP = 1 / 255
PEELED = 3 * STEP  # VTK keeps peels in 8 bits
PLAIN = 2.1 * STEP
MEDIA = (Smoke, Clouds, Contours, Splats, Winds)
OPAQUE, SHEETS = ((Terrain,), (Surface, CloudTops, Label)) if together.text_is_translucent() else ((Terrain, Label), (Surface, CloudTops))
PLACES = ((2, -2), (-2, 2), (0.13, 0))
AIR = Haze(0.05, 1e7, color=(0.6, 0.6, 0.7))


def name(elements):
    return " and ".join(f"{type(e).__name__} at {e.at}" for e in elements)


class Pairs(unittest.TestCase):
    worst = 0

    def compare(self, elements, peels, messages=0, **options):
        expected = None
        for order in (1, -1):
            scene = together.picture(elements[::order], peels, renders=1 + messages, **options)  # a message comes once
            self.assertEqual(len(scene.messages), messages, (name(elements), scene.messages))
            if messages:
                self.assertIn("translucent surface", str(scene.messages[0]))
                continue
            expected = together.light_of(elements, scene.view(), **options) if expected is None else expected
            error = np.abs(scene.image - expected).max()
            Pairs.worst = max(Pairs.worst, error)
            with self.subTest(pair=name(elements), peels=peels, order=order):
                self.assertLessEqual(error, PEELED if peels else PLAIN)

    def pairs(self, firsts, seconds, peels, places=PLACES, **options):
        for first, second in itertools.product(firsts, seconds):
            for a, b in places:
                self.compare([first(a), second(b)], peels, **options)

    def test_media(self):
        """Volumes of every kind need no peeling to be in order."""
        for first, second in itertools.combinations(MEDIA, 2):
            for a, b in PLACES:
                for peels in (False, True):
                    self.compare([first(a), second(b)], peels)

    def test_two_of_a_kind(self):
        for kind in (Contours, Splats, Winds):
            self.pairs([kind], [kind], False, PLACES[:1])

    def test_surfaces_and_media(self):
        self.pairs(SHEETS, MEDIA, True)

    def test_surfaces(self):
        self.pairs(SHEETS[:1], SHEETS[1:], True, PLACES[:2])

    def test_opaque(self):
        for peels in (False, True):
            self.pairs(OPAQUE[:1], SHEETS + OPAQUE[1:], peels, PLACES[:2])
            self.pairs(OPAQUE, MEDIA, peels)

    def test_without_peeling_a_wrong_order_is_told_once(self):
        self.pairs(SHEETS, MEDIA, False, (PLACES[0], PLACES[2]), messages=1)
        self.pairs(SHEETS, MEDIA, False, PLACES[1:2])

    def test_in_haze(self):
        self.pairs((Clouds, Splats), (Smoke, Winds), False, haze=AIR)
        self.pairs(SHEETS, (Clouds, Splats), True, haze=AIR)

    def test_everything(self):
        """Eight things, in three orders of adding."""
        scene_of = [Terrain(-4), Clouds(-2), CloudTops(-1.9), Smoke(-1.6), Splats(0.5), Contours(1), Surface(1.2), Winds(2.5)]
        for elements in (scene_of, scene_of[::-1], scene_of[::2] + scene_of[1::2]):
            scene = together.picture(elements, True)
            self.assertEqual(scene.messages, [])
            error = np.abs(scene.image - together.light_of(elements, scene.view())).max()
            print(f"  everything: {error / STEP:.1f}/255")
            self.assertLessEqual(error, 4 * STEP)

    @classmethod
    def tearDownClass(cls):
        print(f"  largest difference of a pair {cls.worst / STEP:.1f}/255", flush=True)


if __name__ == "__main__":
    unittest.main(verbosity=2)

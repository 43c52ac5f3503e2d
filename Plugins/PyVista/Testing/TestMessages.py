# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a user of Python reads when a filter fails or warns: one sentence, in the words of the function that was called."""
import re
import unittest
import warnings

import nephoscope
import numpy as np
import pyvista


def weather(lat=(0.0, 10.0), lev=(0.0, 1000.0), **arrays):
    grid = pyvista.RectilinearGrid([0.0, 10.0, 20.0], lat, lev)
    for name, value in arrays.items():
        grid[name] = np.full(grid.n_points, value, float)
    return grid


FAILURES = {
    "latitudes": lambda: weather(lat=(0.0, 100.0), q=1).nephoscope.globe(),
    "one of two winds": lambda: weather(u=1.0).nephoscope.globe(wind=("u", "q")),
    "a flat grid": lambda: nephoscope.cloud_surface(weather(lev=[0.0], q=1.0), 0.5, "q"),
    "no mesh": lambda: nephoscope.read_cf(__file__),
}


class Messages(unittest.TestCase):
    def test_no_dumps(self):
        for what, call in FAILURES.items():
            with self.subTest(what), self.assertRaises((RuntimeError, ValueError)) as caught:
                call()
            text = str(caught.exception)
            self.assertLess(len(text), 400, text)
            self.assertNotRegex(text, r"0x[0-9a-f]{6}|Debug:|Modified Time|returned failure|vtkInformation")
            self.assertEqual(len(set(text.splitlines())), len(text.splitlines()), text)

    def test_own_words(self):
        """Names of properties that Python does not have are not in what it says."""
        z = weather(lev=np.array([100000.0, 50000.0, 10000.0]))
        z["z"] = np.repeat([1000.0, 55000.0, 160000.0], 6)
        indices = weather(lev=np.arange(1.0, 9), q=1.0)
        for call, words in ((lambda: z.nephoscope.globe(height="z"), ["height_units"]),
                            (lambda: indices.nephoscope.globe(), ["level_units", "height"]),
                            (lambda: weather(u=1.0, v=1.0).nephoscope.globe(wind=("u", "v"), height=False), [])):
            with warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                call()
            text = " ".join(str(w.message) for w in caught)
            for word in words:
                self.assertIn(word, text)
            self.assertIsNone(re.search(r"HeightUnits|LevelUnits|ArrayName|WindComponents|VerticalWindIsOmega", text), text)
            self.assertTrue(all(w.filename == __file__ for w in caught), [w.filename for w in caught])


if __name__ == "__main__":
    unittest.main()

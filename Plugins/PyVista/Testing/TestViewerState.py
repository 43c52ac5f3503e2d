# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The viewer's state and its link, without trame, PyVista and a browser."""
import random
import subprocess
import sys
import unittest
from dataclasses import replace

from nephoscope.viewer_state import LIMITS, Choices, View, checked, from_mapping, from_query, to_query

CHOICES = Choices(fields=("cloud_fraction", "t & q=1?#ü", "u"), techniques=("cells", "winds"), presets=("clouds", "wind speed"),
                  times=tuple(f"hour {i}" for i in range(7)), globe=True, terrain=True)


class Links(unittest.TestCase):
    def test_link_shows_the_same_again(self):
        random.seed(1)
        for _ in range(300):
            camera = tuple(float(f"{random.uniform(-3e7, 3e7):.6g}") for _ in range(9)) if random.random() < 0.7 else ()
            view = View(random.choice(CHOICES.fields), random.choice(CHOICES.techniques), random.randrange(7), random.randint(1, 100),
                        round(random.uniform(0.1, 5), 1), random.choice(("", *CHOICES.presets)), random.random() < 0.5, camera)
            self.assertEqual(from_query(to_query(view, CHOICES), View()), (view, []))
            self.assertEqual(checked(view, CHOICES), (view, []))

    def test_link_has_only_what_the_data_allow(self):
        plain = Choices(fields=("q",), techniques=("cells",))
        self.assertEqual(to_query(View("q", "cells"), plain), "?field=q&technique=cells&opacity=1")
        self.assertEqual(to_query(View("q", "cells"), replace(plain, globe=True, times=("a", "b"))),
                         "?field=q&technique=cells&opacity=1&time=0&exaggeration=10")

    def test_what_a_link_leaves_out_stays(self):
        start = View("u", "winds", 3, 50, 2.0, "clouds", False, tuple(range(9)))
        for query in ("", "?", "?other=1&utm=x"):
            self.assertEqual(from_query(query, start), (start, []))
        self.assertEqual(from_query("?time=4", start), (replace(start, time=4), []))
        self.assertEqual(from_query("?camera=&preset=", start), (replace(start, camera=(), preset=""), []))

    def test_links_that_cannot_be_read(self):
        for name, values in {"time": ("", "1.5", "one"), "exaggeration": ("", "nan", "inf", "1e999"), "opacity": ("x",), "terrain": ("2", "yes"),
                             "camera": ("1 2 3", "a b c d e f g h i", "1 1 1 1 1 1 0 0 1", "0 0 0 1 1 1 0 0 0", "nan 0 0 1 1 1 0 0 1")}.items():
            for value in values:
                with self.subTest(name=name, value=value):
                    view, problems = from_query(f"?{name}={value}", View("u", "cells"))
                    self.assertEqual(view, View("u", "cells"))
                    self.assertEqual(len(problems), 1)
                    self.assertRegex(problems[0], rf"^{name} cannot be '.*': .* expected.*\.$")

    def test_values_of_widgets(self):
        given = {"field": "u", "technique": None, "time": 2, "exaggeration": 42, "terrain": False}
        self.assertEqual(from_mapping(given, View()), (View("u", "", 2, 42.0, terrain=False), []))


class Checks(unittest.TestCase):
    def test_what_is_shown_at_first(self):
        self.assertEqual(checked(View(), CHOICES), (View("cloud_fraction", "cells"), []))
        self.assertEqual(checked(View(), Choices((), ("mesh",))), (View("", "mesh"), []))

    def test_what_the_data_do_not_allow(self):
        wrong = {"field": "no such", "technique": "smoke", "preset": "snow", "time": 7, "exaggeration": 101.0, "opacity": 0.0}
        for name, value in wrong.items():
            with self.subTest(name):
                view, problems = checked(replace(View(), **{name: value}), CHOICES)
                self.assertEqual(view, View("cloud_fraction", "cells"))
                self.assertEqual(len(problems), 1)
                self.assertIn(name if name != "time" else "time step", problems[0])
        self.assertIn("There are: cloud_fraction, ", checked(View("no such"), CHOICES)[1][0])
        self.assertEqual(len(checked(View("x", "y", -1, -1.0, float("nan"), "z"), CHOICES)[1]), 6)
        for name, (least, most) in LIMITS.items():
            for edge in (least, most):
                self.assertEqual(checked(replace(View(), **{name: edge}), CHOICES)[1], [])


class Alone(unittest.TestCase):
    def test_needs_no_other_package(self):
        code = "import sys, nephoscope.viewer_state; assert not {'pyvista', 'trame', 'wslink'} & set(sys.modules)"
        subprocess.run([sys.executable, "-c", code], check=True)


if __name__ == "__main__":
    unittest.main()

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Properties that are set between frames: the picture must be that of a mapper that had them from the start."""
import numpy as np


class AnyTime:
    """For a unittest.TestCase with scene(), which returns a Window and an object with a setter `Set...` for every property."""
    expected = ()  # what messages say that are no mistakes

    def draw(self, window, why):
        window.render()
        self.assertEqual([m for m in window.messages.all if not any(words in m for words in self.expected)], [], why)
        self.assertEqual(window.gl_errors(), [], why)
        return window.rgba()[..., :3]

    def fresh(self, settings, why):
        window, target = self.scene()
        for (name, _), value in settings.items():
            set_property(target, name, value)
        return self.draw(window, why)

    def play(self, steps):
        """steps: (name, value) pairs, set one after another, a frame after each."""
        window, target = self.scene()
        settings, said = {}, []
        self.draw(window, "nothing set")
        for name, value in steps:
            set_property(target, name, value)
            settings[name, value[0] if isinstance(value, tuple) else None] = value  # an index is part of the name
            said.append(f"{name}={value}")
            why = ", ".join(said)
            difference = np.abs(self.draw(window, why) - self.fresh(settings, why)).max()
            self.assertLessEqual(255 * difference, 1.01, why)

    def play_at_random(self, values, seed, plays, steps):
        """values: {name: possible values}."""
        rng = np.random.default_rng(seed)
        for _ in range(plays):
            names = [str(name) for name in rng.choice(list(values), steps)]
            self.play([(name, values[name][rng.integers(len(values[name]))]) for name in names])


def set_property(target, name, value):
    setter = getattr(target, "Set" + name)
    setter(*value) if isinstance(value, tuple) else setter(value)

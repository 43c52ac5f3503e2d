# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Two fields, or one field at two times, in sub-plots and in one view: colours can be compared, and scalar bars do not overlap."""
import unittest
import warnings

import nephoscope  # noqa: F401 (the accessor)
import numpy as np
import pyvista
from weather_data import isothermal

LON, LAT = np.arange(0, 360, 6.0), np.arange(-90, 91, 6.0)


def field(low, high, levels=slice(None)):
    first = isothermal(LON, LAT)
    values = np.broadcast_to(np.linspace(low, high, len(LAT))[:, None], first.ta.shape)
    return first.assign(ta=first.ta.copy(data=values), cl=(first.ta.dims, np.abs(np.sin(values)), {"units": "1"})).isel(plev=levels)


class SideBySide(unittest.TestCase):
    def plotter(self, shape):
        plotter = pyvista.Plotter(shape=shape, off_screen=True, window_size=(400 * shape[1], 400), theme=pyvista.themes.DarkTheme())
        self.addCleanup(plotter.close)
        return plotter

    def ranges(self, *calls):
        """Colour ranges of the scalar bars of sub-plots, which are those of what is drawn there."""
        plotter = self.plotter((1, len(calls)))
        for column, (dataset, name, options) in enumerate(calls):
            plotter.subplot(0, column)
            dataset.nephoscope.plot(name, plotter=plotter, **options)
        bars, drawn = [], []
        for renderer in plotter.renderers:
            bars += [tuple(bar.GetLookupTable().GetRange()) for bar in plotter.scalar_bars.values() if renderer.HasViewProp(bar)]
            mappers = [getattr(actor, "mapper", None) for actor in renderer.actors.values()]
            drawn += [tuple(mapper.scalar_range) for mapper in mappers if getattr(mapper, "array_name", None) in ("ta", "cl") or hasattr(mapper, "SetIntegrationToExact")]
        for bar, colours in zip(bars, drawn):
            np.testing.assert_allclose(bar, colours)
        return bars

    def test_one_field_at_two_times(self):
        """They have one range. Temperatures far apart, other fields, and those with a given range have their own."""
        level, volume = {"levels": 0}, {}
        for form, options in ((level, {}), (volume, {"opacity": "linear"}), (level, {"projection": "map"})):
            with self.subTest(form, **options):
                self.assertEqual(self.ranges((field(240, 300, **form), "ta", options), (field(250, 310, **form), "ta", options)), [(240, 310)] * 2)
        near, far = field(240, 300, 0), field(180, 220, 0)
        self.assertEqual(self.ranges((near, "ta", {}), (far, "ta", {}), (field(230, 290, 0), "ta", {})), [(230, 300), (180, 220), (230, 300)])
        self.assertEqual(self.ranges((near, "ta", {"clim": (250, 300)}), (field(242, 302, 0), "ta", {})), [(250, 300), (242, 302)])
        self.assertEqual(self.ranges((near, "ta", {}), (field(242, 302, 0), "ta", {"clim": (250, 300)})), [(240, 300), (250, 300)])
        celsius = near.assign(ta=(near.ta + 5).assign_attrs(units="degC", long_name="Temperature"))
        self.assertEqual(self.ranges((near, "ta", {}), (celsius, "ta", {})), [(240, 300), (245, 305)])

    def test_bars_in_one_view(self):
        """No bar hides another, and all are in the picture."""
        for options in ({}, {"projection": "map"}):
            for count in (2, 3):
                plotter = self.plotter((1, 1))
                with warnings.catch_warnings():
                    warnings.simplefilter("error")
                    for dataset, name in ((field(240, 300, 0), "ta"), (field(240, 300), "cl"), (field(240, 300), "potential_temperature"))[:count]:
                        dataset.nephoscope.plot(name, plotter=plotter, **options)
                    plotter.screenshot()  # there would be a warning if the opaque surface were taken for a translucent one
                boxes = np.array([(*bar.GetPosition(), *np.add(bar.GetPosition(), bar.GetPosition2())) for bar in plotter.scalar_bars.values()])
                self.assertEqual(len(boxes), count)
                self.assertTrue((boxes[:, :2] >= 0).all() and (boxes[:, 2:] <= 1).all())
                for i in range(count):
                    for j in range(i):
                        self.assertTrue((boxes[i, 2:] <= boxes[j, :2]).any() or (boxes[j, 2:] <= boxes[i, :2]).any(), boxes)

    def test_a_bar_of_the_user(self):
        """It keeps its title, and its place unless a new bar needs it."""
        for options, args, moves in (({}, {}, False), ({"projection": "map"}, {}, True), ({}, {"vertical": True, "position_x": 0.05}, False), ({}, {"vertical": True, "position_x": 0.86, "position_y": 0.3}, True)):
            plotter = self.plotter((1, 1))
            globe = nephoscope.globe_surface()
            globe["lat"] = globe.points[:, 2] * 1.0
            plotter.add_mesh(globe, scalars="lat", scalar_bar_args={"fmt": "%.2g", **args})
            place = plotter.scalar_bars["lat"].GetPosition()
            field(240, 300, 0).nephoscope.plot("ta", plotter=plotter, **options)
            self.assertEqual(plotter.scalar_bars["lat"].GetTitle(), "lat")
            self.assertEqual(plotter.scalar_bars["lat"].GetLabelFormat(), "%.2g")
            self.assertEqual(plotter.scalar_bars["lat"].GetPosition() != place, moves)


if __name__ == "__main__":
    unittest.main()

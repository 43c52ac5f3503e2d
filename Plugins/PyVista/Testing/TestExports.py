# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A plotter that exports says what it leaves out, each time, and what it shows is as before."""
import functools
import gc
import inspect
import os
import tempfile
import unittest
import warnings
import weakref
from unittest import mock

import nephoscope
import numpy as np
import pyvista
from vtkmodules.vtkCommonCore import vtkObject


def grid():
    data = pyvista.ImageData(dimensions=(4, 4, 4))
    data["a"] = np.arange(data.n_points, dtype=float)
    return data


class Exports(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def plotter(self, *adds):
        plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(plotter.close)
        plotter.add_mesh(pyvista.Sphere())
        for add in adds:
            add(plotter)
        return plotter

    def said(self, plotter, kind, name=None, by=None):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            try:
                getattr(by or plotter, f"export_{kind}")(name or os.path.join(self.folder.name, f"scene.{kind}"))
            except ImportError:
                self.assertIn(kind, ("html", "vtksz"))  # without trame
        ours = [w for w in caught if "leaves out" in str(w.message)]
        self.assertTrue(all(w.filename == __file__ for w in ours))
        return [str(w.message) for w in ours]

    def test_every_kind(self):
        plotter = self.plotter(lambda p: nephoscope.add_cells(p, grid()))
        for kind in ("gltf", "obj", "vrml", "html", "vtksz"):
            for _ in range(2):
                with self.subTest(kind):
                    said = self.said(plotter, kind)
                    self.assertEqual(len(said), 1)
                    self.assertRegex(said[0], f"^export_{kind} leaves out 1 volume of cells or splats, ")
        self.assertTrue(os.path.exists(os.path.join(self.folder.name, "scene.obj")))

    def test_accessor_of_trame(self):
        """plotter.trame, which PyVista 0.49 has, warns as the plotter does, once, whichever method calls which."""
        def calls(plotter, kinds):
            for kind in kinds:
                for adds, expected in (([lambda p: nephoscope.add_cells(p, grid())], 1), ([], 0)):
                    drawn = plotter(*adds)
                    for by in (drawn.trame, drawn) if hasattr(drawn, f"export_{kind}") else (drawn.trame,):
                        with self.subTest(kind, by=type(by).__name__):
                            said = self.said(drawn, kind, by=by)
                            self.assertEqual(len(said), expected, said)
                            for text in said:
                                self.assertRegex(text, f"^export_{kind} leaves out 1 volume of cells or splats, .* or nephoscope.serve")
        calls(self.with_trame, ("html", "vtksz", "wasm_html", "wazex"))
        if hasattr(pyvista.Plotter, "trame"):
            calls(self.plotter, ("html", "vtksz"))  # the others need a network

    def with_trame(self, *adds):
        """A plotter with an accessor like that of PyVista 0.49, to which methods of the plotter pass their calls."""
        class Trame:
            def __init__(self, plotter):
                self.plotter, self.calls = plotter, []

            def export_html(self, filename):
                self.calls.append("html")
                return self.export_vtksz(None)

            def export_vtksz(self, filename=None):
                self.calls.append("vtksz")

            def export_wasm_html(self, filename):
                self.calls.append("wasm_html")

            def export_wazex(self, filename=None):
                self.calls.append("wazex")

            def show(self, **options):
                self.calls.append("show")
                return self.export_html(None)

        class Plotter(pyvista.Plotter):
            trame = functools.cached_property(Trame)

            def export_html(self, filename):
                return self.trame.export_html(filename)

            def export_vtksz(self, filename):
                return self.trame.export_vtksz(filename)

        plotter = Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(plotter.close)
        for add in adds:
            add(plotter)
        return plotter

    def test_accessor_of_trame_shows(self):
        for mode, expected in (("client", 1), ("html", 1), ("server", 0), ("trame", 0)):
            plotter = self.with_trame(lambda p: nephoscope.add_splats(p, grid()))
            with self.subTest(mode), warnings.catch_warnings(record=True) as caught:
                warnings.simplefilter("always")
                plotter.trame.show(mode=mode)
            self.assertEqual(plotter.trame.calls, ["show", "html", "vtksz"])
            ours = [str(w.message) for w in caught if f"The notebook backend {mode!r} draws in the browser and leaves out 1 volume" in str(w.message)]
            self.assertEqual(len(ours), expected, caught)

    def test_plotter_with_the_accessor_is_freed(self):
        plotter = self.with_trame(lambda p: nephoscope.add_cells(p, grid()))
        reference = weakref.ref(plotter)
        self.doCleanups()
        del plotter
        gc.collect()
        self.assertIsNone(reference())

    def test_warnings_of_pyvista_name_the_line_of_the_user(self):
        """PyVista 0.49 warns about exports itself, at the line that called it, and others warn at their own."""
        class Plotter(pyvista.Plotter):
            def export_vtksz(self, filename):
                warnings.warn("Use another method.", FutureWarning, stacklevel=2)
                warnings.warn_explicit("Elsewhere.", UserWarning, "elsewhere.py", 3)

        plotter = Plotter(off_screen=True)
        self.addCleanup(plotter.close)
        nephoscope.add_cells(plotter, grid())
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            line = inspect.currentframe().f_lineno + 1
            plotter.export_vtksz("a.vtksz")
        self.assertEqual([(w.filename, w.lineno) for w in caught], [(__file__, line), (__file__, line), ("elsewhere.py", 3)], caught)
        with warnings.catch_warnings(), self.assertRaises(FutureWarning):
            warnings.simplefilter("error", FutureWarning)
            plotter.export_vtksz("a.vtksz")

    def test_pages_name_the_server(self):
        plotter = self.plotter(lambda p: nephoscope.add_cells(p, grid()))
        self.assertIn("or nephoscope.serve(plotter) for a page in the browser", self.said(plotter, "html")[0])
        self.assertNotIn("serve", self.said(plotter, "obj")[0])

    def test_notebooks_that_draw_in_the_browser(self):
        """The sentence says what to do, once, and only where something is missing."""
        adds = {"volume": [lambda p: nephoscope.add_splats(p, grid())], "haze": [lambda p: nephoscope.add_haze(p, render=False)], "nothing": []}
        for told, add in adds.items():
            for backend, theme in (("html", None), ("client", None), ("server", "html"), ("trame", None), (None, "html"), (None, "server")):
                with self.subTest(told, backend=backend, theme=theme), warnings.catch_warnings(record=True) as caught:
                    plotter = self.plotter(*add)
                    plotter.notebook = True
                    plotter.theme._jupyter_backend = theme
                    warnings.simplefilter("always")
                    export = lambda plotter, backend, **_: plotter.export_html("x.html") if backend == "html" else None  # noqa: E731
                    with mock.patch("pyvista.jupyter.notebook.handle_plotter", export), mock.patch.object(pyvista.Plotter, "export_html"):
                        plotter.show(jupyter_backend=backend, return_viewer=True)
                    ours = [str(w.message) for w in caught if "leaves out" in str(w.message)]
                    self.assertEqual(len(ours), int(told != "nothing" and (backend or theme) in ("html", "client")), ours)
                    for text in ours:
                        self.assertRegex(text, f"^The notebook backend '{backend or theme}' draws in the browser and leaves out .*{told}")
                        self.assertIn("plotter.show(jupyter_backend='server')", text)

    def test_what_is_left_out(self):
        cells, splats = (lambda p: nephoscope.add_cells(p, grid())), (lambda p: nephoscope.add_splats(p, grid()))
        clouds, haze = (lambda p: nephoscope.add_cloud_texture(p, pyvista.Sphere())), (lambda p: nephoscope.add_haze(p, render=False))
        for adds, words in (((cells, splats), "2 volumes of cells or splats"), ((clouds,), "the textures of clouds"), ((haze,), "the haze"),
                            ((haze, splats), "1 volume of cells or splats and the haze")):
            self.assertRegex(self.said(self.plotter(*adds), "obj")[0], f"leaves out {words}, which")

    def test_nothing_else(self):
        """Without any geometry there is no file, and no error of VTK after the warning. A plotter without anything has VTK's error as before."""
        for kind in ("obj", "vrml"):
            for alone in (True, False):
                plotter = pyvista.Plotter(off_screen=True, window_size=(60, 60))
                self.addCleanup(plotter.close)
                nephoscope.add_cells(plotter, grid())
                if not alone:
                    plotter.add_mesh(pyvista.Sphere())
                path = os.path.join(self.folder.name, f"alone{alone}.{kind}")
                with self.subTest(kind, alone=alone), self.assertNoLogs(level="ERROR"):  # where PyVista puts errors of VTK
                    said = self.said(plotter, kind, path)
                    self.assertEqual([text.endswith(" There is nothing else, so no file is written.") for text in said], [alone])
                    self.assertEqual(os.path.exists(path), not alone)
                    self.assertTrue(vtkObject.GetGlobalWarningDisplay())
        empty = pyvista.Plotter(off_screen=True, window_size=(60, 60))
        self.addCleanup(empty.close)
        nephoscope.add_cells(empty, grid(), name="x")
        empty.remove_actor("x")
        with self.assertLogs(level="ERROR"):
            self.assertEqual(self.said(empty, "obj"), [])

    def test_nothing_is_left_out(self):
        self.assertEqual(self.said(self.plotter(), "obj"), [])
        plotter = self.plotter(lambda p: nephoscope.add_cells(p, grid(), name="x"))
        plotter.remove_actor("x")
        self.assertEqual(self.said(plotter, "obj"), [])

    def test_plotter_is_as_before(self):
        """PyVista puts the surfaces of all data into their mappers for export_gltf."""
        plotter = self.plotter(lambda p: nephoscope.add_cells(p, grid()), lambda p: nephoscope.add_splats(p, grid()))
        plotter.camera_position = [(9, 9, 9), (1, 1, 1), (0, 0, 1)]
        plotter.show(auto_close=False)
        before = plotter.screenshot(return_img=True)
        self.said(plotter, "gltf")
        plotter.render()
        np.testing.assert_allclose(plotter.screenshot(return_img=True), before.astype(int), atol=2)

    def test_plotter_is_freed(self):
        plotter = pyvista.Plotter(off_screen=True)
        nephoscope.add_cells(plotter, grid())
        reference = weakref.ref(plotter)
        plotter.close()
        del plotter
        gc.collect()
        self.assertIsNone(reference())


if __name__ == "__main__":
    unittest.main()

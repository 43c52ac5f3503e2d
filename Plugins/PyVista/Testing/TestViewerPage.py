# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The viewer and serve() in a headless Chromium: what the page shows is what is drawn off screen, within the limits of the stored pictures.

The server runs as the command does, in a process of its own; the page is used with the mouse, and by its links.
"""
import os
import re
import signal
import subprocess
import sys
import tempfile
import threading
import unittest
from pathlib import Path

import nephoscope
import numpy as np
import pyvista
from browser import Browser, wait_for

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "Testing/Pictures"))
import pictures  # noqa: E402

nephoscope.read_cf  # the accessor and PyVista's part are there
from nephoscope.viewer_scene import Scene, camera_of, draw  # noqa: E402
from nephoscope.viewer_state import View, checked, from_query  # noqa: E402

FORECAST = Path(os.environ["NEPHOSCOPE_DATA"], "forecast_10deg_6h.nc")
OUTPUT = Path(os.environ["NEPHOSCOPE_TEST_OUTPUT"])
SIZE = (900, 600)
VIEW = "(() => { const r = document.querySelector('img').getBoundingClientRect(); return [r.x, r.y, r.width, r.height] })()"
SCROLLED = "(e => [getComputedStyle(e).overflowY, e.scrollHeight])(document.documentElement)"
DRAWING = "!!document.querySelector('.drawing')?.offsetWidth"
PLACE = """(() => { const r = [...document.querySelectorAll('%s')].find(e => e.offsetWidth && e.innerText.includes('%s'))?.getBoundingClientRect();
           return r?.width ? [r.x + r.width / 2, r.y + r.height / 2] : null })()"""


class Server:
    """A context: a Python program that serves, its address, what it told, and what it says on standard error."""

    def __init__(self, *arguments, **environment):
        self.process = subprocess.Popen([sys.executable, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True,
                                        env={**os.environ, **environment})
        self.told, self.errors = [], []
        self.listener = threading.Thread(target=lambda: self.errors.extend(self.process.stderr), daemon=True)
        self.listener.start()

    def __enter__(self):
        for line in self.process.stdout:
            self.told.append(line)
            found = re.search(r"http://127\.0\.0\.1:\d+/", line)
            if found:
                self.address = found[0]
                return self
        raise RuntimeError("".join(self.errors))

    def __exit__(self, *_):
        self.process.send_signal(signal.SIGINT)
        self.process.wait(60)
        self.listener.join()
        self.told.extend(self.process.stdout)
        self.process.stdout.close()
        self.process.stderr.close()


class PageTestCase(unittest.TestCase):
    def seen(self, browser):
        """The view in the page as it is now."""
        x, y, width, height = (round(number) for number in browser.run(VIEW))
        return np.asarray(browser.picture()[y:y + height, x:x + width], float)

    def shows(self, browser, expected, name):
        """Waits until the page shows the picture that `expected` gives for a size; the last difference if it does not come."""
        drawn = {}

        def difference():
            if not browser.run("!!document.querySelector('img')?.naturalWidth"):
                return "there is no picture"
            picture = self.seen(browser)
            size = picture.shape[1::-1]
            if min(size) < 100:
                return f"the view has {size} pixels"
            if size not in drawn:
                drawn[size] = np.asarray(expected(size), float)
                self.assertIsNone(pictures.emptiness(drawn[size]))
            self.last = np.concatenate([drawn[size], picture])
            return pictures.disagreement(picture, drawn[size])

        try:
            wait_for(lambda: difference() is None, name, 90)
        except TimeoutError:
            pictures.save(self.last, OUTPUT / f"{name}.png")
            self.fail(f"{name}: {difference()}. Kept, expected above seen: {OUTPUT / name}.png")


class Viewer(PageTestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = Scene(FORECAST)
        cls.server = cls.enterClassContext(Server("-m", "nephoscope", FORECAST, "--port", "0", "--no-browser"))

    def setUp(self):
        self.browser = self.enterContext(Browser(*SIZE))

    def off_screen(self, query):
        view, problems = from_query(query, View())
        view, more = checked(view, self.scene.choices)
        self.assertEqual(problems + more, [])

        def expected(size):
            plotter = pyvista.Plotter(off_screen=True, window_size=size, theme=pyvista.themes.DarkTheme())
            self.addCleanup(plotter.close)
            draw(plotter, self.scene, view)
            return plotter.screenshot()
        return expected

    def open(self, query):
        self.browser.open(self.server.address + query)
        wait_for(lambda: self.browser.run("!!document.querySelector('img')?.naturalWidth"), "no picture comes")

    def click(self, kind, text):
        """Where it stands still: menus move while they open."""
        places = [None]

        def place():
            places.append(self.browser.run(PLACE % (kind, text)))
            return places[-1] if places[-1] == places[-2] else None
        self.browser.press(*wait_for(place, f"there is no {text}", 20))

    def choose(self, select, item):
        self.click(".v-select", select)
        self.click(".v-list-item", item)
        wait_for(lambda: not self.browser.run("!!document.querySelector('.v-overlay--active .v-list-item')"), "the menu stays open", 20)

    def link(self):
        return self.browser.run("location.search")

    def test_links_show_the_same(self):
        for number, query in enumerate(("?field=cloud_fraction&technique=cells&time=0&exaggeration=30&opacity=1&terrain=1&preset=&camera=",
                                        "?field=u&technique=splats&time=4&exaggeration=60&opacity=0.5&terrain=0&preset=&camera=",
                                        "?field=cloud_fraction&technique=surface&time=2&exaggeration=40&opacity=1&terrain=1&preset="
                                        "&camera=0 -3e7 1e7 0 0 0 0 0 1")):
            with self.subTest(query):
                self.open(query.replace(" ", "%20"))
                self.shows(self.browser, self.off_screen(query), f"TestViewerPage-link-{number}")
                self.assertEqual(from_query(self.link(), View()), from_query(query, View()))

    def test_page_is_as_high_as_its_window(self):
        """All of the picture is seen, and there is no scroll bar."""
        for width, height in ((1200, 800), (900, 450)):
            self.browser.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)
            self.open("")
            wait_for(lambda: self.browser.run(VIEW) == [300, 0, width - 300, height], f"{width} x {height}: {self.browser.run(VIEW)}", 20)
            self.assertEqual(self.browser.run(SCROLLED), ["auto", height])

    def test_side_bar(self):
        self.open("?field=cloud_fraction&technique=cells&time=0&exaggeration=30&opacity=1&terrain=1&preset=&camera=")
        self.choose("Technique", "Splats")
        wait_for(lambda: "technique=splats" in self.link(), "technique=splats", 20)
        self.choose("Field", "gh")
        wait_for(lambda: "field=gh" in self.link(), "field=gh", 20)
        self.click(".v-switch label", "Terrain")
        wait_for(lambda: "terrain=0" in self.link(), "terrain=0", 20)
        self.shows(self.browser, self.off_screen(self.link()), "TestViewerPage-side-bar")

    def test_camera_stays(self):
        """With another technique, field or time the data stay where they are."""
        start = "?field=cloud_fraction&technique=cells&time=0&exaggeration=30&opacity=1&terrain=1&preset=&camera="
        self.open(start)
        self.shows(self.browser, self.off_screen(start), "TestViewerPage-camera-before")
        plotter = pyvista.Plotter(off_screen=True, theme=pyvista.themes.DarkTheme())
        self.addCleanup(plotter.close)
        draw(plotter, self.scene, from_query(start, View())[0])
        camera = camera_of(plotter)
        for select, item, part in (("Technique", "Splats", "technique=splats"), ("Field", "gh", "field=gh"), ("Technique", "Cells (volume)", "technique=cells"), ("Field", "cloud_fraction", "field=cloud_fraction")):
            self.choose(select, item)
            wait_for(lambda: part in self.link() and not self.browser.run(DRAWING), part, 30)  # noqa: B023
            np.testing.assert_allclose(from_query(self.link(), View())[0].camera, camera, rtol=1e-4, atol=100)
        self.shows(self.browser, self.off_screen(start), "TestViewerPage-camera-after")

    def test_what_is_being_drawn_is_told(self):
        self.browser.open(self.server.address + "?technique=cells&camera=")
        wait_for(lambda: self.browser.run("!!document.body?.innerText.includes('Drawing ...') && !document.querySelector('img')?.naturalWidth"), "nothing is told of the first picture", 30)
        wait_for(lambda: self.browser.run("!!document.querySelector('img')?.naturalWidth") and not self.browser.run(DRAWING), "the first picture", 60)
        self.browser.run(f"void (window.told = [], setInterval(() => window.told.push({DRAWING}), 20))")
        self.choose("Technique", "Splats")
        wait_for(lambda: self.browser.run("window.told.includes(true) && !window.told.at(-1)"), "nothing is told of a change, or for ever", 60)

    def test_mouse_turns_and_a_second_browser_sees_it(self):
        start = "?field=cloud_fraction&technique=cells&time=0&exaggeration=30&opacity=1&terrain=1&preset=&camera="
        self.open(start)
        self.shows(self.browser, self.off_screen(start), "TestViewerPage-before")
        before = self.seen(self.browser)
        self.browser.press(600, 300, (560, 310), (500, 330), (480, 340))
        wait_for(lambda: "camera=" in self.link(), "the link has no camera", 30)
        query = self.link()
        self.shows(self.browser, self.off_screen(query), "TestViewerPage-turned")
        self.assertIsNotNone(pictures.disagreement(self.seen(self.browser), before))
        self.click("button", "RESET CAMERA")
        self.shows(self.browser, self.off_screen(start), "TestViewerPage-reset")
        with Browser(*SIZE) as other:
            other.open(self.server.address + query)
            wait_for(lambda: other.run("!!document.querySelector('img')?.naturalWidth"), "no picture comes")
            self.shows(other, self.off_screen(query), "TestViewerPage-second")
            self.assertEqual(other.run("location.search"), query)

    def test_link_is_copied(self):
        self.browser.call("Browser.grantPermissions", permissions=["clipboardReadWrite", "clipboardSanitizedWrite"], origin=self.server.address)
        self.open("?time=3")
        wait_for(lambda: "field=" in self.link(), "the address has no link", 20)
        self.click("button", "COPY LINK")
        wait_for(lambda: self.browser.run(PLACE % ("button", "COPIED")), "nothing is copied", 20)
        self.assertEqual(self.browser.run("navigator.clipboard.readText()"), self.browser.run("location.href"))

    def test_problems_are_told(self):
        self.open("?field=nonsense&exaggeration=1000")
        told = wait_for(lambda: self.browser.run("document.querySelector('.v-alert')?.parentElement.innerText"), "the page tells nothing", 20)
        for problem in ("There is no field 'nonsense'. There are: cloud_fraction, ", "exaggeration is 1000. It must be 1 to 100."):
            self.assertIn(problem, told)
            wait_for(lambda: any(line.startswith(f"Nephoscope: {problem}") for line in self.server.errors), f"{self.server.errors}", 20)


class Serve(PageTestCase):
    CODE = """
import nephoscope, pyvista
def scene(**options):
    plotter = pyvista.Plotter(off_screen=True, **options)
    nephoscope.add_cells(plotter, pyvista.Wavelet(), cmap="viridis")
    plotter.view_isometric()
    return plotter
"""

    def test_plotter(self):
        names = {}
        exec(self.CODE, names)
        with Server("-c", self.CODE + "nephoscope.serve(scene(), port=0, open_browser=False)") as server, Browser(*SIZE) as browser:
            browser.open(server.address)
            self.shows(browser, lambda size: names["scene"](window_size=size).screenshot(), "TestViewerPage-serve")
            self.assertEqual(browser.run("document.title"), "Nephoscope")
        self.assertEqual((server.process.returncode, server.errors), (0, []))

    def test_browser_is_opened_and_nothing_else_is_told(self):
        folder = Path(self.enterContext(tempfile.TemporaryDirectory()))
        opener = folder / "opener"
        opener.write_text('#!/bin/sh\necho "$1" > "$0.part"\nmv "$0.part" "$0.url"\n')
        opener.chmod(0o755)
        with Server("-m", "nephoscope", FORECAST, "--port", "0", BROWSER=f"{opener} %s &") as server:
            wait_for((folder / "opener.url").is_file, "no browser is opened", 60)
        self.assertEqual((folder / "opener.url").read_text(), f"{server.address}\n")
        self.assertEqual((server.told, server.errors), ([f"Nephoscope: {server.address} (Ctrl-C stops it)\n"], []))

    def test_port_in_use(self):
        with Server("-c", self.CODE + "nephoscope.serve(scene(), port=0, open_browser=False)") as server:
            port = re.search(r":(\d+)/", server.address)[1]
            done = subprocess.run([sys.executable, "-m", "nephoscope", FORECAST, "--port", port, "--no-browser"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, rf"^nephoscope-viewer: Port {port} of 127\.0\.0\.1 cannot be used: .*\n$")


if __name__ == "__main__":
    unittest.main()

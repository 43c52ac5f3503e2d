# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The notebook with the snippet of the README: run by Jupyter, and seen and turned in JupyterLab in a headless Chromium."""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import urllib.request
from pathlib import Path

import nbclient
import nbformat
import numpy as np
from browser import Browser, wait_for

sys.path.insert(0, str(Path(__file__).resolve().parents[3] / "Testing/Pictures"))
import pictures  # noqa: E402

TOP = Path(os.environ["NEPHOSCOPE_DATA"]).parent
OUTPUT = Path(os.environ["NEPHOSCOPE_TEST_OUTPUT"])
NOTEBOOK = TOP / "Plugins/PyVista/examples/clouds.ipynb"
SIZE = (1500, 1150)
BAR = 60  # pixels at the top that PyVista's tool bar covers
FRAME = "(() => { const r = document.querySelector('iframe.pyvista').getBoundingClientRect(); return [r.x, r.y, r.width, r.height] })()"
KERNEL = "[...(window.jupyterapp?.shell.widgets('main') ?? [])].find(one => one.sessionContext)?.sessionContext.session?.kernel?.status"
SHOW = "document.querySelector('iframe.pyvista').scrollIntoView({block: 'center'})"


def snippet():
    text = (TOP / "README.md").read_text()
    return re.search(r"<!-- snippet: begin -->\s*```python\n(.*?)```", text, re.DOTALL)[1].rstrip().splitlines()


def answers(address):
    try:
        return urllib.request.urlopen(f"{address}api").status == 200
    except OSError:
        return False


class Notebook(unittest.TestCase):
    def setUp(self):
        self.folder = Path(self.enterContext(tempfile.TemporaryDirectory(ignore_cleanup_errors=True)))
        (self.folder / "examples").mkdir()
        self.copy = self.folder / "examples" / NOTEBOOK.name
        shutil.copy(NOTEBOOK, self.copy)

    def expected(self, size):
        """The snippet's picture, drawn off screen."""
        names = {}
        exec("\n".join(snippet()[:-1]), names)
        plotter = names["plotter"]
        plotter.off_screen, plotter.window_size = True, size
        return np.asarray(plotter.screenshot(), float)

    def test_run(self):
        done = nbclient.NotebookClient(nbformat.read(self.copy, 4), timeout=200, resources={"metadata": {"path": self.copy.parent}}).execute()
        outputs = [output for one in done.cells for output in one.get("outputs", [])]
        self.assertEqual([output for output in outputs if output.output_type == "error"], [])
        shown = [output.data for output in outputs if "application/vnd.jupyter.widget-view+json" in output.get("data", {})]
        self.assertEqual(len(shown), 1, outputs)

    def test_lab(self):
        lab = subprocess.Popen([sys.executable, "-m", "jupyterlab", "--no-browser", "--allow-root", "--ServerApp.ip=127.0.0.1", "--ServerApp.port=0",
                                "--LabApp.expose_app_in_browser=True", "--IdentityProvider.token=", "--ServerApp.disable_check_xsrf=True", f"--ServerApp.root_dir={self.folder}"],
                               cwd=self.folder, env={**os.environ, "JUPYTER_RUNTIME_DIR": f"{self.folder}/run", "JUPYTER_CONFIG_DIR": f"{self.folder}/config"},
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        try:
            servers = wait_for(lambda: list(self.folder.glob("run/jpserver-*.json")), "JupyterLab does not start")
            address = json.loads(servers[0].read_text())["url"]
            wait_for(lambda: answers(address), "JupyterLab does not answer")
            self.look(address)
        finally:
            lab.terminate()
            lab.wait(60)

    def look(self, address):
        with Browser(*SIZE) as browser:
            browser.open(f"{address}lab/tree/examples/{NOTEBOOK.name}")
            wait_for(lambda: browser.run(KERNEL) == "idle", "the notebook does not open, or its kernel does not start")
            browser.run("void window.jupyterapp.commands.execute('notebook:run-all-cells')")
            try:
                wait_for(lambda: browser.run("!!document.querySelector('iframe.pyvista')"), "no picture is shown")
            finally:
                pictures.save(browser.picture(), OUTPUT / "TestNotebook.png")
            browser.run(SHOW)
            self.compare(browser)
            before = self.seen(browser)
            x, y, width, height = browser.run(FRAME)
            middle = (x + width / 2, y + height / 2)
            browser.press(*middle, *((middle[0] - step, middle[1] + step / 4) for step in (30, 80, 120)))
            wait_for(lambda: pictures.disagreement(self.seen(browser), before), "the mouse does not turn the picture", 60)
            pictures.save(browser.picture(), OUTPUT / "TestNotebook.png")

    def seen(self, browser):
        x, y, width, height = (round(number) for number in browser.run(FRAME))
        return np.asarray(browser.picture()[y + 1:y + height - 1, x + 1:x + width - 1], float)  # without the border

    def compare(self, browser):
        expected = self.expected(self.seen(browser).shape[1::-1])
        self.assertIsNone(pictures.emptiness(expected))
        try:
            wait_for(lambda: pictures.disagreement(self.seen(browser)[BAR:], expected[BAR:]) is None, "the picture", 120)
        except TimeoutError:
            seen = self.seen(browser)
            pictures.save(np.concatenate([expected, seen], axis=1), OUTPUT / "TestNotebook-lab.png")
            self.fail(f"JupyterLab: {pictures.disagreement(seen[BAR:], expected[BAR:])}. Kept, expected beside seen: {OUTPUT / 'TestNotebook-lab.png'}")


if __name__ == "__main__":
    unittest.main()

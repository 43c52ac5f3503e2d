# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A headless Chromium, steered by its DevTools protocol; the program is named by NEPHOSCOPE_CHROMIUM."""
import base64
import io
import json
import os
import subprocess
import tempfile
import time
import urllib.request
from pathlib import Path

import numpy as np
import PIL.Image
import websocket

OPTIONS = ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--no-first-run", "--hide-scrollbars",
           "--remote-debugging-port=0", "--remote-allow-origins=*", "--force-device-scale-factor=1")


class Browser:
    """A context: with Browser(1280, 800) as browser: browser.open(url)."""

    def __init__(self, width, height):
        self.folder = tempfile.TemporaryDirectory(ignore_cleanup_errors=True)
        environment = {name: value for name, value in os.environ.items() if name not in ("LD_PRELOAD", "LD_LIBRARY_PATH")}
        self.process = subprocess.Popen([os.environ["NEPHOSCOPE_CHROMIUM"], *OPTIONS, f"--window-size={width},{height}",
                                         f"--user-data-dir={self.folder.name}", "about:blank"], env=environment,
                                        stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        port_file = Path(self.folder.name, "DevToolsActivePort")
        wait_for(lambda: port_file.is_file() and port_file.read_text().strip(), "Chromium does not start")
        pages = json.load(urllib.request.urlopen(f"http://127.0.0.1:{port_file.read_text().split()[0]}/json"))
        page = next(page for page in pages if page["type"] == "page")
        self.socket = websocket.create_connection(page["webSocketDebuggerUrl"], timeout=120, max_size=None)
        self.number = 0
        self.call("Emulation.setDeviceMetricsOverride", width=width, height=height, deviceScaleFactor=1, mobile=False)

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.close()
        self.process.terminate()
        self.process.wait(30)
        self.folder.cleanup()

    def call(self, method, **parameters):
        self.number += 1
        self.socket.send(json.dumps({"id": self.number, "method": method, "params": parameters}))
        while True:
            answer = json.loads(self.socket.recv())
            if answer.get("id") == self.number:
                if "error" in answer:
                    raise RuntimeError(f"{method}: {answer['error']}")
                return answer["result"]

    def open(self, url):
        self.call("Page.navigate", url=url)

    def run(self, script):
        """The value of a JavaScript expression."""
        result = self.call("Runtime.evaluate", expression=script, returnByValue=True, awaitPromise=True)
        if "exceptionDetails" in result:
            raise RuntimeError(f"{script}: {result['exceptionDetails']}")
        return result["result"].get("value")

    def picture(self):
        """Pixels of the page, row 0 at the top, 0 to 255."""
        png = base64.b64decode(self.call("Page.captureScreenshot", format="png")["data"])
        return np.asarray(PIL.Image.open(io.BytesIO(png)).convert("RGB"))

    def press(self, x, y, *through):
        """The left button at a place, held through others."""
        for kind, (px, py) in (("mouseMoved", (x, y)), ("mousePressed", (x, y)), *(("mouseMoved", place) for place in through),
                               ("mouseReleased", (through or [(x, y)])[-1])):
            self.call("Input.dispatchMouseEvent", type=kind, x=px, y=py, button="left" if kind != "mouseMoved" or through else "none",
                      buttons=int(kind != "mouseReleased"), clickCount=1)


def wait_for(condition, message, seconds=120):
    """What the condition gives when it is true; an error with the message after some time."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        found = condition()
        if found:
            return found
        time.sleep(0.2)
    raise TimeoutError(message)

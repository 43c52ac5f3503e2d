# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the snippet of the README as it stands and compares its picture with the Earth and with the weather.

A place on the visible hemisphere is projected to its pixel by the plotter's camera; the sky above it is clear or overcast by the
cloud fractions in the file. Clear places must look like Blue Marble in the light of the sun at the snippet's time, and less like its mirror images;
overcast places must be brighter than clear ones.
"""
import datetime
import json
import os
import re
import tempfile
import unittest
from pathlib import Path

import nephoscope
import numpy as np
import pyvista

DATA = Path(os.environ["NEPHOSCOPE_DATA"])
OUTPUT = Path(os.environ["NEPHOSCOPE_TEST_OUTPUT"])
R = 6371000.0
TIME = re.compile(r'sun="([^"]+)"')
SNIPPET = re.compile(r"<!-- snippet: begin -->\s*```python\n(.*?)```\s*<!-- snippet: end -->", re.DOTALL)


def snippets():
    """{text: README it is in}, each text once."""
    readmes = [DATA.parent / "README.md", DATA.parent / "Plugins" / "PyVista" / "README.md"]
    return {match[1]: path for path in readmes[::-1] if path.is_file() for match in SNIPPET.finditer(path.read_text())}


def run(text):
    """Run the text in an empty folder; the picture, 0 to 1, and the camera it was taken with."""
    cameras = []
    show = pyvista.Plotter.show

    def show_and_note(plotter, **options):
        return show(plotter, before_close_callback=lambda p: cameras.append(camera_of(p)), **options)

    previous = os.getcwd()
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        pyvista.OFF_SCREEN, pyvista.Plotter.show = True, show_and_note
        try:
            exec(compile(text, "README.md", "exec"), {"__name__": "snippet"})
        finally:
            pyvista.Plotter.show = show
            os.chdir(previous)
        picture = pyvista.read(Path(folder) / "clouds.png")
    width, height, _ = picture.dimensions
    pixels = np.asarray(picture.active_scalars).reshape(height, width, -1)[..., :3] / 255.0  # row 0 at the bottom
    pyvista.wrap(picture).save(OUTPUT / "TestSnippet.png")
    return pixels, cameras[0]


def camera_of(plotter):
    camera = plotter.camera
    return {"position": np.array(camera.position), "focus": np.array(camera.focal_point), "up": np.array(camera.up),
            "angle": np.radians(camera.view_angle)}


def direction(longitude, latitude):
    longitude, latitude = np.radians(longitude), np.radians(latitude)
    return np.stack([np.cos(latitude) * np.cos(longitude), np.cos(latitude) * np.sin(longitude), np.sin(latitude)], axis=-1)


def sun_direction(time):
    """Towards the sun, in the Earth's frame; the low-precision formulas of the Astronomical Almanac, 0.01 degrees from 1950 to 2050."""
    days = (time - datetime.datetime(2000, 1, 1, 12)).total_seconds() / 86400
    anomaly = np.radians(357.528 + 0.9856003 * days)
    ecliptic = np.radians(280.460 + 0.9856474 * days + 1.915 * np.sin(anomaly) + 0.020 * np.sin(2 * anomaly))
    obliquity = np.radians(23.439 - 0.0000004 * days)
    ascension = np.degrees(np.arctan2(np.cos(obliquity) * np.sin(ecliptic), np.cos(ecliptic)))
    sidereal = 15 * (18.697374558 + 24.06570982441908 * days)
    return direction(ascension - sidereal, np.degrees(np.arcsin(np.sin(obliquity) * np.sin(ecliptic))))


def project(points, camera, shape):
    """Rows and columns of world points in a picture of that shape: the perspective of a pinhole."""
    forward = camera["focus"] - camera["position"]
    forward /= np.linalg.norm(forward)
    right = np.cross(forward, camera["up"])
    right /= np.linalg.norm(right)
    offset = points - camera["position"]
    scale = shape[0] / 2 / np.tan(camera["angle"] / 2) / (offset @ forward)
    rows = shape[0] / 2 + offset @ np.cross(right, forward) * scale
    columns = shape[1] / 2 + offset @ right * scale
    return np.rint(rows - 0.5).astype(int), np.rint(columns - 0.5).astype(int)


def visible_places(camera, facing=0.75):
    """Longitudes and latitudes, degrees, on the data's columns that look towards the camera."""
    longitude, latitude = (a.ravel() for a in np.meshgrid(np.arange(0, 360, 2.5), np.arange(-85, 85.1, 2.5)))
    normal = direction(longitude, latitude)
    to_camera = camera["position"] - R * normal
    cosine = np.sum(normal * to_camera, axis=1) / np.linalg.norm(to_camera, axis=1)
    return longitude[cosine > facing], latitude[cosine > facing]


def cloud_thickness(longitude, latitude):
    """Kilometres of full cloud above a place and its eight neighbours: least and greatest."""
    weather = nephoscope.read_cf(DATA / "gfs_2p5deg_2011101100.nc", variables=["cloud_fraction", "gh"])
    shape = weather.dimensions[::-1]
    fraction = np.asarray(weather.point_data["cloud_fraction"], float).reshape(shape)
    height = np.asarray(weather.point_data["gh"], float).reshape(shape) / 1000
    column = np.sum((fraction[1:] + fraction[:-1]) / 2 * np.abs(np.diff(height, axis=0)), axis=0)
    j, i = np.rint((latitude + 90) / 2.5).astype(int), np.rint(longitude / 2.5).astype(int)
    near = np.stack([column[np.clip(j + dj, 0, 72), (i + di) % 144] for dj in (-1, 0, 1) for di in (-1, 0, 1)])
    return near.min(axis=0), near.max(axis=0)


def blue_marble(longitude, latitude):
    """Mean colour, 0 to 1, of the map around places."""
    marble = pyvista.read(DATA / "blue_marble_2048.jpg")
    width, height, _ = marble.dimensions
    pixels = np.asarray(marble.active_scalars).reshape(height, width, 3) / 255.0  # row 0 is the South Pole
    column, row = ((longitude + 180) % 360) / 360 * width, (latitude + 90) / 180 * height
    return np.mean([pixels[np.clip((row + dy).astype(int), 0, height - 1), (column + dx).astype(int) % width]
                    for dy in (-2, 0, 2) for dx in (-2, 0, 2)], axis=0)


class Snippet(unittest.TestCase):
    def test_picture(self):
        self.assertTrue(snippets(), "no README has the markers of a snippet")
        for text, readme in snippets().items():
            with self.subTest(readme=str(readme)):
                lines = [line for line in text.splitlines() if line.strip()]
                self.assertLessEqual(len(lines), 8)
                self.check(*run(text), datetime.datetime.fromisoformat(TIME.search(text)[1]))

    def test_notebook(self):
        """The notebook has the README's snippet, and no results."""
        cells = json.loads((DATA.parent / "Plugins/PyVista/examples/clouds.ipynb").read_text())["cells"]
        text = SNIPPET.search((DATA.parent / "README.md").read_text())[1]
        (shown,) = ["".join(cell["source"]) for cell in cells if cell["id"] == "snippet"]
        self.assertEqual(shown.splitlines(), [*text.rstrip().splitlines()[:-1], "plotter.show()"])
        for cell in cells:
            self.assertEqual((cell.get("outputs", []), cell.get("execution_count")), ([], None))

    def check(self, pixels, camera, time):
        longitude, latitude = visible_places(camera)
        rows, columns = project(R * direction(longitude, latitude), camera, pixels.shape)
        seen = np.mean([pixels[rows + dr, columns + dc] for dr in (-1, 0, 1) for dc in (-1, 0, 1)], axis=0)
        least, most = cloud_thickness(longitude, latitude)
        sunshine = direction(longitude, latitude) @ sun_direction(time)
        clear, overcast = (most < 0.1) & (sunshine > 0.1), (least > 1) & (sunshine > 0.1)
        self.assertGreater(clear.sum(), 30)
        self.assertGreater(overcast.sum(), 30)

        def likeness(x, y):
            there = (blue_marble(x, y) * sunshine[:, None])[clear]
            return np.mean([np.corrcoef(seen[clear][:, c], there[:, c])[0, 1] for c in range(3)])

        true = likeness(longitude, latitude)
        mirrored = {"east-west": likeness(-longitude, latitude), "north-south": likeness(longitude, -latitude),
                    "half a turn": likeness(longitude + 180, latitude), "30 degrees": likeness(longitude + 30, latitude)}
        luminance = seen @ (0.2126, 0.7152, 0.0722)
        print(f"places: {clear.sum()} clear, {overcast.sum()} overcast; likeness to Blue Marble {true:.3f}, displaced {mirrored}; "
              f"luminance {luminance[clear].mean():.3f} clear, {luminance[overcast].mean():.3f} overcast")
        self.assertGreater(true, 0.8)
        self.assertGreater(true, max(mirrored.values()) + 0.3)
        self.assertGreater(luminance[overcast].mean(), luminance[clear].mean() + 0.2)


if __name__ == "__main__":
    unittest.main()

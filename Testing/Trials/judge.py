# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The verdict on one trial. Pictures are arrays (height, width, 3) of bytes."""
import numpy as np

from capture import plain

VISIBLE = 6    # of 255: a pixel differs
FAINT = 20     # of 255: nobody sees less
APART = 12     # of 255, and of the pixels:
FEW = 0.01
ALIKE = 0.08   # of all light: pictures of cells divided in two ways


def difference(a, b):
    return np.abs(a.astype(int) - b.astype(int)).max(axis=2)


def apart(a, b):
    """The share of the pixels that differ, and by how much at most."""
    d = difference(a, b)
    return float((d > APART).mean()), int(d.max())


class Verdict:
    """findings: (kind, text). said: what a user reads."""

    def __init__(self):
        self.findings, self.said = [], ""

    def find(self, kind, text=""):
        self.findings.append((kind, " ".join(str(text).split())[:300]))

    def same(self, kind, a, b, exact=False):
        share, most = apart(a, b)
        if most > VISIBLE if exact else share > FEW:
            self.find(kind, f"{100 * share:.1f} % of the pixels differ, by up to {most}/255")

    def alike(self, kind, a, b):
        """For pictures of the same data divided into tetrahedra in two ways: between the points they differ a little everywhere."""
        light = max(int(a.astype(int).sum()), int(b.astype(int).sum()), 1)
        share = float(np.abs(a.astype(int) - b).sum()) / light
        if share > ALIKE:
            self.find(kind, f"{100 * share:.0f} % of the light is elsewhere, up to {difference(a, b).max()}/255 in a pixel")

    def words(self, said, messages_of_vtk_count):
        """Judges what was said; returns whether a user was told anything."""
        vtk = [plain(text) for text in said.vtk]
        told = ([said.raised] if said.raised else []) + said.warnings + (vtk if messages_of_vtk_count else [])
        self.said = " | ".join(dict.fromkeys(told))[:400]
        if said.accidental:
            self.find("accident", said.raised)
        if "vtkInformation" in said.raised or "Algorithm vtk" in said.raised:
            self.find("dump", said.raised)
        if not messages_of_vtk_count and (vtk or said.stderr):
            self.find("noise", vtk[0] if vtk else said.stderr[-300:])
        return bool(told)

    def picture(self, ready, told, failed, scenery, image, may_draw=False):
        """ready: the dataset has all the function needs. may_draw: what is drawn without that is no finding."""
        most = int(difference(scenery, image).max()) if image is not None else 0
        shown = most > VISIBLE
        if failed:
            if ready:
                self.find("refused", self.said)
        elif shown:
            if not ready and not may_draw:
                self.find("drawn", "drawn, though it should have nothing to show")
            elif ready and most < FAINT:
                self.find("faint", f"no pixel is further than {most}/255 from the background")
        elif ready:
            self.find("blank", "nothing is drawn" + (": " + self.said if told else ", without a word"))
        elif not told:
            self.find("silent", "nothing is drawn, without a word")
        return shown

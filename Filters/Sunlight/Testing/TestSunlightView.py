#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""The light that leaves level clouds towards an eye, compared with an exact solution: from above, towards the sun, from the side and away from the sun, in cells much wider than deep."""
import pathlib
import sys
import unittest

import numpy as np
from nephoscope import vtkSunlight
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from doubling import reflected  # noqa: E402

LEVELS = 41
ASYMMETRY = 0.85
DEPTHS = (0.3, 1, 3, 10)
SUNS = (1.0, 0.5, 0.2)  # cosines of zenith angles
NADIR, AHEAD, ASIDE, BEHIND = (1.0, 0.0), (0.5, 0.0), (0.5, np.pi / 2), (0.5, np.pi)  # as in `reflected`; behind: the sun is behind the eye
VIEWS = (NADIR, AHEAD, ASIDE, BEHIND)


def slab(depth, width):
    """A level cloud of thickness 1, with a horizontal distance of `width` between points."""
    data = vtkImageData()
    data.SetDimensions(5, 5, LEVELS)
    data.SetSpacing(width, width, 1 / (LEVELS - 1))
    extinction = numpy_to_vtk(np.full(data.GetNumberOfPoints(), float(depth)), deep=1)
    extinction.SetName("Extinction")
    data.GetPointData().AddArray(extinction)
    return data


class Column:
    """Light in the middle column of a slab, computed with FollowCamera."""

    def __init__(self, depth, sun, width=20.0):
        self.sun = np.array((np.sqrt(1 - sun**2), 0, sun))
        self.light = vtkSunlight()
        self.light.SetInputData(slab(depth, width))
        self.light.SetSunDirection(self.sun)
        self.light.SetAsymmetry(ASYMMETRY)
        self.light.SetSkyLight(0)
        self.light.SetGroundAlbedo(0)
        self.light.FollowCameraOn()
        self.light.Update()
        self.phase = vtk_to_numpy(self.light.GetOutput().GetFieldData().GetArray("PhaseFunction")).astype(float)

    def values(self, name):
        array = vtk_to_numpy(self.light.GetOutput().GetPointData().GetArray(name)).astype(float)
        return array.reshape(LEVELS, 25, -1)[:, 12].squeeze()

    def radiance(self, cosine, azimuth):
        """pi times the radiance that leaves the top."""
        sine = np.sqrt(1 - cosine**2)
        way = np.array((-sine * np.cos(azimuth), sine * np.sin(azimuth), cosine))
        angle = np.arccos(-way @ self.sun) / np.pi * (len(self.phase) - 1)
        factors = [np.interp(angle, np.arange(len(self.phase)), self.phase[:, c]) - 1 for c in (0, 1)]
        source = self.values("Sunlight") + self.values("DiffuseFlux") @ way + (1.5 * cosine**2 - 0.5) * self.values("DiffuseSecondMoment") + self.values("SingleScattering") @ factors
        height = np.linspace(0, 1, 2001)
        known = np.linspace(0, 1, LEVELS)
        source, extinction = np.interp(height, known, source), np.interp(height, known, self.values("ScaledExtinction"))
        depth = np.append(0, np.cumsum((extinction[1:] + extinction[:-1]) / 2)) / 2000 / cosine
        sent = source * extinction / cosine * np.exp(depth - depth[-1])
        return np.sum((sent[1:] + sent[:-1]) / 2) / 2000


def phase_function(asymmetry, cosine):
    return (1 - asymmetry**2) / (1 + asymmetry**2 - 2 * asymmetry * cosine) ** 1.5


def corrected(depth, sun):
    """The exact light of the scaled medium for VIEWS, its single scattering replaced by that of the whole phase function."""
    forward, smooth = ASYMMETRY**2, ASYMMETRY / (1 + ASYMMETRY)
    thin = depth * (1 - forward)
    light = reflected(thin, smooth, sun, VIEWS)
    for v, (cosine, azimuth) in enumerate(VIEWS):
        angle = np.sqrt((1 - sun**2) * (1 - cosine**2)) * np.cos(azimuth) - sun * cosine
        single = sun / 4 / (sun + cosine) * (1 - np.exp(-thin * (1 / sun + 1 / cosine)))
        light[v] += single * (phase_function(ASYMMETRY, angle) / (1 - forward) - phase_function(smooth, angle))
    return light


class Exact(unittest.TestCase):
    def test_reference(self):
        """A thin slab scatters once. A deep one with isotropic scattering reflects H(1)^2 / 8, where Chandrasekhar's H function (1950) is 2.9078."""
        for cosine, azimuth in VIEWS:
            angle = np.sqrt(0.51 * (1 - cosine**2)) * np.cos(azimuth) - 0.7 * cosine
            expected = phase_function(ASYMMETRY, angle) / 4 * 0.7 / (0.7 + cosine) * (1 - np.exp(-1e-3 * (1 / 0.7 + 1 / cosine)))
            self.assertAlmostEqual(reflected(1e-3, ASYMMETRY, 0.7, [(cosine, azimuth)])[0], expected, delta=0.01 * expected)
        self.assertAlmostEqual(reflected(1000, 0.0, 1.0, [NADIR], orders=1)[0], 2.9078**2 / 8, delta=5e-3)

    def test_all_views(self):
        """About as good as the exact light of the scaled medium, with single scattering corrected (Nakajima and Tanaka 1988)."""
        errors, scaled = [], []
        for depth in DEPTHS:
            for sun in SUNS:
                column = Column(depth, sun)
                exact = reflected(depth, ASYMMETRY, sun, VIEWS)
                errors.append([column.radiance(*view) / light - 1 for view, light in zip(VIEWS, exact)])
                scaled.append(corrected(depth, sun) / exact - 1)
        errors, scaled = np.array(errors), np.array(scaled)
        for name, column, other in zip(("nadir", "towards the sun", "aside", "away from the sun"), errors.T, scaled.T):
            print(f"{name}: mean {100 * column.mean():.1f} %, rms {100 * np.sqrt(np.mean(column**2)):.1f} %, largest {100 * np.abs(column).max():.0f} %; "
                  f"scaled medium: rms {100 * np.sqrt(np.mean(other**2)):.1f} %")
        self.assertLess(np.sqrt(np.mean(errors**2)), 0.11)
        self.assertLess(np.sqrt(np.mean(errors**2)), np.sqrt(np.mean(scaled**2)))
        self.assertLess(np.sqrt(np.mean(errors[:, 0] ** 2)), 0.07)  # nadir
        self.assertLess(np.abs(errors[:, 2:]).mean(), 0.05)
        self.assertLess(np.abs(errors).max(), 0.32)

    def test_width_of_cells(self):
        """The light that leaves the cloud does not depend on the width of its cells."""
        for depth in (0.3, 3):
            narrow, wide, very = (Column(depth, 0.5, width) for width in (4, 20, 2000))
            for view in VIEWS:
                for other in (wide, very):
                    self.assertAlmostEqual(other.radiance(*view), narrow.radiance(*view), delta=0.05 * narrow.radiance(*view))

    def test_flux_is_possible(self):
        """The flux of diffuse light is not larger than its fluence. When it was, thin clouds were black with the sun behind the eye."""
        for depth in DEPTHS:
            column = Column(depth, 0.5)
            diffuse = column.values("Sunlight") - column.values("SingleScattering").sum(axis=1)
            flux = np.linalg.norm(column.values("DiffuseFlux"), axis=1) / (3 * ASYMMETRY / (1 + ASYMMETRY))
            self.assertLess((flux - diffuse).max(), 0.02 * diffuse.max())


if __name__ == "__main__":
    unittest.main()

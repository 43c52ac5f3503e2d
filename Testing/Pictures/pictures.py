# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures made small, compared, and laid side by side. Pixels are floats from 0 to 255.

Two pictures agree if all of these hold:

- VTK's own comparison, vtkImageDifference with its usual threshold of 16, has an error of at most ERROR. It allows edges to move by a pixel.
- The mean difference of blocks of 4 x 4 pixels is at most MEAN, and that of all but FEW of them at most LARGE. The means do not see where
  within a block an edge is: that differs between OpenGL drivers and versions of VTK. A medium that is missing, mirrored, of another
  colour or half as thick is off by far more than MEAN.
- For scenes before a plain background: their light, which is the sum of the differences from the background, differs by at most LIGHT. Errors at
  edges cancel there; a shader that is off by 2 % does not.
"""
import numpy as np
from PIL import Image
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkImagingCore import vtkImageDifference

SIZE = (200, 150)
MEAN, LARGE, FEW = 2.0, 24.0, 0.01
ERROR = 15.0  # as vtkTesting
LIGHT = 0.008
EMPTY = 0.01  # of the pixels of a picture must differ from its most frequent colour


def load(path):
    with Image.open(path) as image:
        flat = image.convert("RGB")
        flat.thumbnail(SIZE, Image.Resampling.BOX)
        return np.asarray(flat, float)


def save(values, path):
    Image.fromarray(np.rint(np.clip(values, 0, 255)).astype(np.uint8)).save(path, optimize=True)


def store(values, path):
    """In the 256 colours that suit it best, a few kB, unless that alone takes a quarter of what is allowed."""
    image = Image.fromarray(np.rint(values).astype(np.uint8))
    few = image.quantize(256, method=Image.Quantize.MEDIANCUT, kmeans=4, dither=Image.Dither.NONE)
    lost = np.abs(blocks(np.asarray(few.convert("RGB"), float)) - blocks(values)).max(axis=2).mean()
    dimmed = abs(light(np.asarray(few.convert("RGB"), float)) / max(light(values), 1e-9) - 1)
    (image if lost > MEAN / 4 or dimmed > LIGHT / 8 else few).save(path, optimize=True)


def blocks(values):
    height, width = (4 * (n // 4) for n in values.shape[:2])
    return values[:height, :width].reshape(height // 4, 4, width // 4, 4, 3).mean(axis=(1, 3))


def emptiness(values):
    """The sentence that says why it is no picture; None if it is one."""
    colours, counts = np.unique(np.rint(values).astype(int).reshape(-1, 3), axis=0, return_counts=True)
    shown = np.mean(np.abs(values - colours[counts.argmax()]).max(axis=2) > 12)
    return None if shown > EMPTY else f"it is blank: {shown:.2%} of its pixels are not of the colour {tuple(int(c) for c in colours[counts.argmax()])}"


def vtk_image(values):
    image = vtkImageData()
    image.SetDimensions(values.shape[1], values.shape[0], 1)
    flat = np.ascontiguousarray(np.rint(np.clip(values, 0, 255)).astype(np.uint8).reshape(-1, 3))
    image.GetPointData().SetScalars(numpy_to_vtk(flat, deep=True))
    return image


def vtk_error(values, baseline):
    """The thresholded error of vtkImageDifference."""
    compare = vtkImageDifference()
    compare.SetInputData(vtk_image(values))
    compare.SetImageData(vtk_image(baseline))
    compare.Update()
    return compare.GetThresholdedError()


def light(values):
    """Sum of the differences from the background, which the upper left pixel shows."""
    return np.abs(values - values[0, 0]).sum()


def light_disagreement(values, baseline):
    """The sentence that says how much brighter or darker a scene is; None if it is not."""
    ratio = light(values) / max(light(baseline), 1e-9)
    if abs(ratio - 1) <= LIGHT:
        return None
    return f"it differs from the background by {ratio:.4f} times as much as the baseline does (at most {LIGHT:.1%} more or less)"


def disagreement(values, baseline):
    """The sentence that says how they differ; None if they agree."""
    if values.shape != baseline.shape:
        return f"it has {values.shape[1]} x {values.shape[0]} pixels, the baseline {baseline.shape[1]} x {baseline.shape[0]}"
    error = vtk_error(values, baseline)
    if error > ERROR:
        return f"vtkImageDifference finds an error of {error:.1f} (at most {ERROR:.0f})"
    differences = np.abs(blocks(values) - blocks(baseline)).max(axis=2)
    mean, large = differences.mean(), np.mean(differences > LARGE)
    if mean <= MEAN and large <= FEW:
        return None
    return f"it differs from the baseline by {mean:.2f} of 255 on average (at most {MEAN}), by more than {LARGE:.0f} in {large:.2%} of its blocks (at most {FEW:.0%})"


def difference(values, baseline):
    """What to look at: five times the difference."""
    if baseline is None or values.shape != baseline.shape:
        return np.zeros_like(values)
    return np.clip(5 * np.abs(values - baseline), 0, 255)


def side_by_side(values, baseline):
    """Old, new, difference."""
    old = np.zeros_like(values) if baseline is None or baseline.shape != values.shape else baseline
    return np.concatenate([old, values, difference(values, baseline)], axis=1)

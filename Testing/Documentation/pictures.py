# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures made small, compared, and laid side by side. Pixels are floats from 0 to 255.

Two pictures are compared in blocks of 4 x 4 pixels, whose means do not see where within a block an edge is: that differs between
OpenGL drivers and versions of VTK. They agree if the mean difference of the blocks is at most MEAN and that of all but FEW of them at most
LARGE. Two runs on one machine agree to 1 of 255; a medium that is missing, mirrored, of another colour or half as thick is off by far more
than MEAN, unless it is too small to be a picture of anything.
"""
import numpy as np
from PIL import Image

SIZE = (200, 150)
MEAN, LARGE, FEW = 2.0, 24.0, 0.01
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
    (image if lost > MEAN / 4 else few).save(path, optimize=True)


def blocks(values):
    height, width = (4 * (n // 4) for n in values.shape[:2])
    return values[:height, :width].reshape(height // 4, 4, width // 4, 4, 3).mean(axis=(1, 3))


def emptiness(values):
    """The sentence that says why it is no picture; None if it is one."""
    colours, counts = np.unique(np.rint(values).astype(int).reshape(-1, 3), axis=0, return_counts=True)
    shown = np.mean(np.abs(values - colours[counts.argmax()]).max(axis=2) > 12)
    return None if shown > EMPTY else f"it is blank: {shown:.2%} of its pixels are not of the colour {tuple(int(c) for c in colours[counts.argmax()])}"


def disagreement(values, baseline):
    """The sentence that says how they differ; None if they agree."""
    if values.shape != baseline.shape:
        return f"it has {values.shape[1]} x {values.shape[0]} pixels, the baseline {baseline.shape[1]} x {baseline.shape[0]}"
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

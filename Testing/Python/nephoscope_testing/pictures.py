# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arrays to PNG files."""
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter


def image_data(rgb):
    """vtkImageData of bytes from (height, width, 3) floats in [0, 1], bottom row first."""
    pixels = (np.clip(np.nan_to_num(rgb), 0, 1) * 255 + 0.5).astype(np.uint8)
    image = vtkImageData()
    image.SetDimensions(pixels.shape[1], pixels.shape[0], 1)
    image.GetPointData().SetScalars(numpy_to_vtk(np.ascontiguousarray(pixels).reshape(-1, 3), deep=True))
    return image


def write_png(path, rgb):
    """rgb: (height, width, 3) floats in [0, 1], bottom row first."""
    writer = vtkPNGWriter()
    writer.SetFileName(path)
    writer.SetInputData(image_data(rgb))
    writer.Write()

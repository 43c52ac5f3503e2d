# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
"""A source that is a time series of velocities on an image, and counts what is read of it."""
import numpy as np
from vtkmodules.util.vtkAlgorithm import VTKPythonAlgorithmBase
from vtkmodules.vtkCommonDataModel import vtkDataObject, vtkImageData
from vtkmodules.vtkCommonExecutionModel import vtkStreamingDemandDrivenPipeline as SDDP

from .meshes import add_array, points_of


class TimeSeries(VTKPythonAlgorithmBase):
    """velocity(points, time) gives three components, one row for all points or for each. `reads`: the times, in the order in which they were read.

    times: None for no time, or a list. arrays: more point arrays, as {name: function(points, time)}.
    """

    def __init__(self, times, velocity, bounds=(-1, 1, -1, 1, -0.5, 1.5), dimensions=(5, 5, 5), arrays=None):
        super().__init__(nInputPorts=0, nOutputPorts=1, outputType="vtkImageData")
        self.times = None if times is None else [float(t) for t in times]
        self.velocity, self.arrays = velocity, arrays or {}
        self.bounds, self.dimensions, self.reads = np.array(bounds, float), np.array(dimensions), []

    def RequestInformation(self, request, inputs, outputs):
        information = outputs.GetInformationObject(0)
        information.Set(SDDP.WHOLE_EXTENT(), 0, int(self.dimensions[0]) - 1, 0, int(self.dimensions[1]) - 1, 0, int(self.dimensions[2]) - 1)
        if self.times is not None:
            information.Set(SDDP.TIME_STEPS(), self.times or [0.0], len(self.times))
            if len(self.times):
                information.Set(SDDP.TIME_RANGE(), [self.times[0], self.times[-1]], 2)
        return 1

    def RequestData(self, request, inputs, outputs):
        information = outputs.GetInformationObject(0)
        time = information.Get(SDDP.UPDATE_TIME_STEP()) if self.times and information.Has(SDDP.UPDATE_TIME_STEP()) else 0.0
        if self.times:
            time = min(self.times, key=lambda t: abs(t - time))
        self.reads.append(time)
        output = vtkImageData.GetData(outputs)
        low, high = self.bounds[::2], self.bounds[1::2]
        output.SetDimensions(*map(int, self.dimensions))
        output.SetOrigin(*low)
        output.SetSpacing(*((high - low) / (self.dimensions - 1)))
        points = points_of(output)
        add_array(output.GetPointData(), np.array(np.broadcast_to(self.velocity(points, time), points.shape), float), "v")
        for name, function in self.arrays.items():
            add_array(output.GetPointData(), function(points, time), name)
        output.GetInformation().Set(vtkDataObject.DATA_TIME_STEP(), time)
        return 1

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudShadow.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProbeFilter.h"

namespace nephoscope
{
std::vector<float> cloudShadow(vtkDataSet* clouds, const std::vector<std::array<double, 3>>& places)
{
  if (!clouds->GetPointData()->HasArray("SunTransmittance"))
  {
    return {};
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const auto& place : places)
  {
    points->InsertNextPoint(place.data());
  }
  vtkNew<vtkPolyData> cloudless;
  cloudless->SetPoints(points);
  vtkNew<vtkProbeFilter> probe;
  probe->SetInputData(cloudless);
  probe->SetSourceData(clouds);
  probe->Update();
  vtkPointData* probed = probe->GetOutput()->GetPointData();
  vtkDataArray* transmittance = probed->GetArray("SunTransmittance");
  vtkDataArray* valid = probed->GetArray(probe->GetValidPointMaskArrayName());
  std::vector<float> shadow(places.size(), 1.0f);
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    const auto i = static_cast<vtkIdType>(p);
    if (valid->GetComponent(i, 0) > 0)
    {
      shadow[p] = static_cast<float>(transmittance->GetComponent(i, 0));
    }
  }
  return shadow;
}
}

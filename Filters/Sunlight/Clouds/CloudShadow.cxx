// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CloudShadow.h"

#include "EntryFaces.h"
#include "OwnThreads.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFloatArray.h"
#include "vtkGeometryFilter.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProbeFilter.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace nephoscope
{
namespace
{
const char* const fractionName = "SunTransmittance";
const char* const irradianceName = "Irradiance";
const char* const depthName = "SunDepth";
constexpr float unknown = -1;
constexpr float darkest = 1e-9f;

// Depths are interpolated, not fractions: through even clouds, or along a side of them, the depth
// is linear.
float DepthOf(vtkDataArray* fraction, vtkIdType i)
{
  return -std::log(std::max(static_cast<float>(fraction->GetComponent(i, 0)), darkest));
}

vtkSmartPointer<vtkDataSet> WithDepths(vtkDataSet* clouds)
{
  vtkDataArray* fraction = clouds->GetPointData()->GetArray(fractionName);
  vtkNew<vtkFloatArray> depths;
  depths->SetName(depthName);
  depths->SetNumberOfTuples(clouds->GetNumberOfPoints());
  InParallel(clouds->GetNumberOfPoints(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      depths->SetValue(i, DepthOf(fraction, i));
    }
  });
  vtkSmartPointer<vtkDataSet> copy;
  copy.TakeReference(clouds->NewInstance());
  copy->ShallowCopy(clouds);
  copy->GetPointData()->AddArray(depths);
  return copy;
}

float ValueOf(vtkDataArray* array, vtkIdType i)
{
  return array ? static_cast<float>(array->GetComponent(i, 0)) : unknown;
}

void TakeInside(vtkDataSet* clouds, const std::vector<Place>& places, CloudShadow& shadow)
{
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
  vtkDataArray* depth = probed->GetArray(depthName);
  vtkDataArray* irradiance = probed->GetArray(irradianceName);
  vtkDataArray* valid = probed->GetArray(probe->GetValidPointMaskArrayName());
  for (std::size_t p = 0; p < places.size(); ++p)
  {
    const auto i = static_cast<vtkIdType>(p);
    if (valid->GetComponent(i, 0) > 0)
    {
      shadow.Fraction[p] = std::exp(-ValueOf(depth, i));
      shadow.Irradiance[p] = ValueOf(irradiance, i);
    }
  }
}

bool HasDiffuseLight(vtkDataSet* clouds)
{
  vtkDataArray* upward = clouds->GetPointData()->GetArray("UpwardIrradiance");
  return upward && upward->GetRange(0)[1] > 0;
}

/** The boundary of clouds, as the sun sees it. */
class CloudBase
{
public:
  CloudBase(vtkDataSet* clouds, const Place& towardsSun, const Loop& loop)
  {
    vtkNew<vtkGeometryFilter> geometry;
    geometry->SetInputData(clouds);
    geometry->Update();
    vtkPolyData* boundary = geometry->GetOutput();
    vtkDataArray* depth = boundary->GetPointData()->GetArray(depthName);
    vtkDataArray* irradiance = boundary->GetPointData()->GetArray(irradianceName);
    std::vector<Place> places(static_cast<std::size_t>(boundary->GetNumberOfPoints()));
    std::vector<Fields> fields(places.size());
    for (std::size_t p = 0; p < places.size(); ++p)
    {
      const auto i = static_cast<vtkIdType>(p);
      boundary->GetPoint(i, places[p].data());
      fields[p] = { { ValueOf(depth, i), ValueOf(irradiance, i) } };
    }
    this->Points = SunPoints(places, fields, {}, towardsSun, loop);
    this->Faces = EntryFaces(this->Points, trianglesOf(boundary));
  }

  /**
   * The fraction and the irradiance where the ray from this place enters; 1 and unknown: nowhere.
   */
  std::array<double, 2> LightAt(const SunPoint& place) const
  {
    SunRay ray(place, 0, 0);
    std::array<std::int32_t, 3> ignored;
    const bool enters =
      this->Faces.Next(this->Points, std::numeric_limits<double>::lowest(), ray, ignored) >= 0;
    const std::array<double, 2> values = ray.Values();
    return enters ? std::array<double, 2>{ { std::exp(-values[0]), values[1] } }
                  : std::array<double, 2>{ { 1.0, unknown } };
  }

private:
  static std::vector<EntryFaces::Face> trianglesOf(vtkPolyData* boundary)
  {
    std::vector<EntryFaces::Face> triangles;
    auto polygons = vtk::TakeSmartPointer(boundary->GetPolys()->NewIterator());
    for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal(); polygons->GoToNextCell())
    {
      vtkIdType size;
      const vtkIdType* p;
      polygons->GetCurrentCell(size, p);
      for (vtkIdType k = 2; k < size; ++k)
      {
        triangles.push_back(
          { { { std::int32_t(p[0]), std::int32_t(p[k - 1]), std::int32_t(p[k]) } }, 0 });
      }
    }
    return triangles;
  }

  std::vector<SunPoint> Points;
  EntryFaces Faces;
};
}

CloudShadow FindCloudShadow(
  vtkDataSet* clouds, const std::vector<Place>& places, const Place& towardsSun)
{
  CloudShadow shadow;
  if (!clouds->GetPointData()->HasArray(fractionName))
  {
    return shadow;
  }
  const Loop loop = [](std::int64_t count, const auto& body) {
    InParallel(count, [&body](vtkIdType begin, vtkIdType end) { body(begin, end); });
  };
  shadow.Fraction.assign(places.size(), unknown);
  shadow.Irradiance.assign(places.size(), unknown);
  const vtkSmartPointer<vtkDataSet> source = WithDepths(clouds);
  TakeInside(source, places, shadow);
  const CloudBase base(source, towardsSun, loop);
  const std::vector<SunPoint> points =
    SunPoints(places, std::vector<Fields>(places.size()), {}, towardsSun, loop);
  loop(static_cast<std::int64_t>(places.size()), [&](std::int64_t begin, std::int64_t end) {
    for (std::int64_t p = begin; p < end; ++p)
    {
      if (shadow.Fraction[p] == unknown)
      {
        const std::array<double, 2> light = base.LightAt(points[p]);
        shadow.Fraction[p] = static_cast<float>(light[0]);
        shadow.Irradiance[p] = static_cast<float>(light[1]);
      }
    }
  });
  if (!HasDiffuseLight(clouds))
  {
    shadow.Irradiance.clear();
  }
  return shadow;
}
}

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SunlightMap.h"

#include "DataSets.h"

#include "vtkBoundingBox.h"
#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkDataSetTriangleFilter.h"
#include "vtkFloatArray.h"
#include "vtkGeometryFilter.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkProbeFilter.h"
#include "vtkRectilinearGrid.h"
#include "vtkTransform.h"
#include "vtkTransformFilter.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace nephoscope
{
namespace
{
const char* const fractionName = "SunTransmittance";
constexpr double samples = 1 << 19; // of the lattice, about
constexpr double unknown = -1;
constexpr double rounding = 1e-6; // of places in the lattice

void Darken(double& fraction, double found)
{
  if (found >= 0) // which NaN is not
  {
    fraction = fraction < 0 ? found : std::min(fraction, found);
  }
}

// The fractions of a dataset and its hidden cells, without its other arrays.
vtkSmartPointer<vtkDataSet> FractionsOf(vtkDataSet* data)
{
  auto bare = vtk::TakeSmartPointer(data->NewInstance());
  bare->CopyStructure(data);
  const auto share = [](vtkDataSetAttributes* from, vtkDataSetAttributes* to, const char* name) {
    if (vtkDataArray* array = from->GetArray(name))
    {
      to->AddArray(array);
    }
  };
  share(data->GetPointData(), bare->GetPointData(), fractionName);
  share(data->GetPointData(), bare->GetPointData(), vtkDataSetAttributes::GhostArrayName());
  share(data->GetCellData(), bare->GetCellData(), vtkDataSetAttributes::GhostArrayName());
  return bare;
}

// Fast where a cell is found from the coordinates alone.
vtkSmartPointer<vtkDataSet> PlacesIn(vtkImageData* lattice, vtkMatrix4x4* toData)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(lattice->GetNumberOfPoints());
  for (vtkIdType i = 0; i < lattice->GetNumberOfPoints(); ++i)
  {
    double place[4] = { 0, 0, 0, 1 };
    lattice->GetPoint(i, place);
    toData->MultiplyPoint(place, place);
    points->SetPoint(i, place);
  }
  auto places = vtkSmartPointer<vtkPolyData>::New();
  places->SetPoints(points);
  return places;
}

// Voxels have faces across the axes, which they lose where they are turned.
bool HasVoxels(vtkDataSet* data)
{
  for (vtkIdType cell = 0; data->IsA("vtkUnstructuredGrid") && cell < data->GetNumberOfCells();
       ++cell)
  {
    if (data->GetCellType(cell) == VTK_VOXEL)
    {
      return true;
    }
  }
  return false;
}

vtkSmartPointer<vtkDataSet> Moved(vtkDataSet* data, vtkMatrix4x4* matrix)
{
  vtkNew<vtkDataSetTriangleFilter> tetrahedra;
  if (HasVoxels(data))
  {
    tetrahedra->SetInputData(data);
    tetrahedra->Update();
    data = tetrahedra->GetOutput();
  }
  vtkNew<vtkTransform> transform;
  transform->SetMatrix(matrix);
  vtkNew<vtkTransformFilter> filter;
  filter->SetTransform(transform);
  filter->SetInputData(data);
  filter->Update();
  return vtkDataSet::SafeDownCast(filter->GetOutputDataObject(0));
}
}

SunlightMap::SunlightMap(
  const std::vector<LitClouds>& clouds, const double towardsSun[3], const MaximumOfRanks& maximum)
{
  this->FindFrame(towardsSun);
  if (!this->FindLattice(clouds, maximum))
  {
    return;
  }
  std::vector<double> fractions(
    static_cast<std::size_t>(this->Image->GetNumberOfPoints()), unknown);
  for (const LitClouds& each : clouds)
  {
    const vtkSmartPointer<vtkDataSet> bare = FractionsOf(each.Data);
    vtkNew<vtkMatrix4x4> toSun;
    vtkMatrix4x4::Multiply4x4(this->ToSun, each.ToWorld, toSun);
    this->SampleInside(bare, toSun, fractions);
    this->SampleFaces(bare, toSun, fractions);
  }
  maximum(fractions.data(), static_cast<int>(fractions.size()));
  const int* size = this->Image->GetDimensions();
  const std::size_t layer = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]);
  std::vector<double> light(layer, 1.0); // of the beam on its way
  vtkNew<vtkFloatArray> array;
  array->SetNumberOfValues(this->Image->GetNumberOfPoints());
  for (std::size_t i = fractions.size(); i-- > 0;)
  {
    double& beam = light[i % layer];
    beam = fractions[i] < 0 ? beam : std::min(beam, fractions[i]);
    array->SetValue(static_cast<vtkIdType>(i), static_cast<float>(beam));
  }
  this->Image->GetPointData()->SetScalars(array);
}

void SunlightMap::FindFrame(const double towardsSun[3])
{
  double across[3], up[3];
  vtkMath::Perpendiculars(towardsSun, across, up, 0);
  for (int c = 0; c < 3; ++c)
  {
    this->ToSun->SetElement(0, c, across[c]);
    this->ToSun->SetElement(1, c, up[c]);
    this->ToSun->SetElement(2, c, towardsSun[c]);
  }
}

bool SunlightMap::FindLattice(const std::vector<LitClouds>& clouds, const MaximumOfRanks& maximum)
{
  constexpr double none = std::numeric_limits<double>::lowest();
  std::array<double, 6> reach = { { none, none, none, none, none,
    none } }; // of each axis: -least, most
  for (const LitClouds& each : clouds)
  {
    const vtkBoundingBox box = FiniteBounds(each.Data);
    if (!box.IsValid())
    {
      continue;
    }
    double bounds[6];
    box.GetBounds(bounds);
    vtkNew<vtkMatrix4x4> toSun;
    vtkMatrix4x4::Multiply4x4(this->ToSun, each.ToWorld, toSun);
    for (int corner = 0; corner < 8; ++corner)
    {
      double place[4] = { bounds[corner & 1], bounds[2 + (corner >> 1 & 1)],
        bounds[4 + (corner >> 2)], 1 };
      toSun->MultiplyPoint(place, place);
      for (std::size_t c = 0; c < 3; ++c)
      {
        reach[2 * c] = std::max(reach[2 * c], -place[c]);
        reach[2 * c + 1] = std::max(reach[2 * c + 1], place[c]);
      }
    }
  }
  maximum(reach.data(), 6);
  double lengths[3], volume = 1;
  for (std::size_t c = 0; c < 3; ++c)
  {
    lengths[c] = reach[2 * c] + reach[2 * c + 1];
    volume *= lengths[c];
  }
  if (!(volume > 0) || !std::isfinite(volume))
  {
    return false;
  }
  this->Image = vtkSmartPointer<vtkImageData>::New();
  this->Image->SetOrigin(-reach[0], -reach[2], -reach[4]);
  int size[3];
  double spacing[3];
  for (int c = 0; c < 3; ++c)
  {
    size[c] = std::min(256, 2 + static_cast<int>(lengths[c] * std::cbrt(samples / volume)));
    spacing[c] = lengths[c] / (size[c] - 1);
    const double scale = 1 / (spacing[c] * size[c]);
    for (int k = 0; k < 4; ++k)
    {
      this->FromWorld->SetElement(c, k, scale * this->ToSun->GetElement(c, k));
    }
    this->FromWorld->SetElement(c, 3,
      this->FromWorld->GetElement(c, 3) +
        (0.5 - this->Image->GetOrigin()[c] / spacing[c]) / size[c]);
  }
  this->Image->SetDimensions(size);
  this->Image->SetSpacing(spacing);
  return true;
}

// Grids of another kind are moved into the frame of the sun, where a lattice is sampled cell by
// cell.
void SunlightMap::SampleInside(
  vtkDataSet* clouds, vtkMatrix4x4* toSun, std::vector<double>& fractions) const
{
  vtkNew<vtkProbeFilter> probe;
  if (clouds->IsA("vtkImageData") || clouds->IsA("vtkRectilinearGrid"))
  {
    vtkNew<vtkMatrix4x4> toData;
    vtkMatrix4x4::Invert(toSun, toData);
    probe->SetInputData(PlacesIn(this->Image, toData));
    probe->SetSourceData(clouds);
  }
  else
  {
    probe->SetInputData(this->Image);
    probe->SetSourceData(Moved(clouds, toSun));
  }
  probe->Update();
  vtkPointData* probed = probe->GetOutput()->GetPointData();
  vtkDataArray* fraction = probed->GetArray(fractionName);
  vtkDataArray* valid = probed->GetArray(probe->GetValidPointMaskArrayName());
  for (std::size_t i = 0; fraction && valid && i < fractions.size(); ++i)
  {
    const auto at = static_cast<vtkIdType>(i);
    if (valid->GetComponent(at, 0) > 0)
    {
      Darken(fractions[i], fraction->GetComponent(at, 0));
    }
  }
}

// A mesh that is thin for the lattice has few nodes in it, or none: every face darkens the next
// node behind it.
void SunlightMap::SampleFaces(
  vtkDataSet* clouds, vtkMatrix4x4* toSun, std::vector<double>& fractions) const
{
  vtkNew<vtkGeometryFilter> geometry;
  geometry->SetInputData(clouds);
  geometry->Update();
  vtkPolyData* faces = geometry->GetOutput();
  vtkDataArray* fraction = faces->GetPointData()->GetArray(fractionName);
  if (!fraction || !faces->GetPolys())
  {
    return;
  }
  std::vector<Corner> corners(static_cast<std::size_t>(faces->GetNumberOfPoints()));
  for (std::size_t p = 0; p < corners.size(); ++p)
  {
    const auto at = static_cast<vtkIdType>(p);
    corners[p] = this->InLattice(faces->GetPoint(at), toSun);
    corners[p][3] = fraction->GetComponent(at, 0);
  }
  auto polygons = vtk::TakeSmartPointer(faces->GetPolys()->NewIterator());
  for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal(); polygons->GoToNextCell())
  {
    vtkIdType size;
    const vtkIdType* points;
    polygons->GetCurrentCell(size, points);
    for (vtkIdType k = 2; k < size; ++k)
    {
      this->Shade({ { corners[static_cast<std::size_t>(points[0])],
                    corners[static_cast<std::size_t>(points[k - 1])],
                    corners[static_cast<std::size_t>(points[k])] } },
        fractions);
    }
  }
}

// In nodes of the lattice.
SunlightMap::Corner SunlightMap::InLattice(const double place[3], vtkMatrix4x4* toSun) const
{
  double moved[4] = { place[0], place[1], place[2], 1 };
  toSun->MultiplyPoint(moved, moved);
  Corner corner{};
  for (std::size_t c = 0; c < 3; ++c)
  {
    corner[c] = (moved[c] - this->Image->GetOrigin()[c]) / this->Image->GetSpacing()[c];
  }
  return corner;
}

void SunlightMap::Shade(const std::array<Corner, 3>& triangle, std::vector<double>& fractions) const
{
  const Corner &a = triangle[0], &b = triangle[1], &c = triangle[2];
  const double area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  const int* size = this->Image->GetDimensions();
  int low[2], high[2];
  for (std::size_t k = 0; k < 2; ++k)
  {
    const auto ends = std::minmax({ a[k], b[k], c[k] });
    if (!(ends.second - ends.first < size[k])) // NaN
    {
      return;
    }
    low[k] = std::max(0, static_cast<int>(std::ceil(ends.first - rounding)));
    high[k] = std::min(size[k] - 1, static_cast<int>(std::floor(ends.second + rounding)));
  }
  if (!(std::abs(area) > 0))
  {
    return;
  }
  for (int j = low[1]; j <= high[1]; ++j)
  {
    for (int i = low[0]; i <= high[0]; ++i)
    {
      const double ofB = ((i - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (j - a[1])) / area;
      const double ofC = ((b[0] - a[0]) * (j - a[1]) - (i - a[0]) * (b[1] - a[1])) / area;
      if (std::min({ ofB, ofC, 1 - ofB - ofC }) < -rounding)
      {
        continue;
      }
      const double height = a[2] + ofB * (b[2] - a[2]) + ofC * (c[2] - a[2]);
      const int behind = std::clamp(static_cast<int>(std::floor(height)), 0, size[2] - 1);
      Darken(fractions[static_cast<std::size_t>(i) +
               static_cast<std::size_t>(size[0]) *
                 (static_cast<std::size_t>(j) +
                   static_cast<std::size_t>(size[1]) * static_cast<std::size_t>(behind))],
        a[3] + ofB * (b[3] - a[3]) + ofC * (c[3] - a[3]));
    }
  }
}

} // namespace nephoscope

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplitPoints.h"

#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cstring>

namespace nephoscope
{
namespace
{
// An array of whole numbers cannot hold the value at a cut.
int TypeForScalars(vtkDataArray* scalars)
{
  const int type = scalars->GetDataType();
  return type == VTK_FLOAT ? VTK_FLOAT : VTK_DOUBLE;
}

// A writable array of the same kind, whatever class the source has.
vtkSmartPointer<vtkAbstractArray> MakeLike(vtkAbstractArray* from, int type)
{
  auto to = vtkSmartPointer<vtkAbstractArray>::Take(vtkAbstractArray::CreateArray(type));
  to->SetName(from->GetName());
  to->SetNumberOfComponents(from->GetNumberOfComponents());
  to->CopyComponentNames(from);
  if (from->HasInformation())
  {
    to->CopyInformation(from->GetInformation(), 1);
  }
  return to;
}
}

SplitPoints::SplitPoints(vtkDataSet* input, vtkDataArray* scalars, const ContourScalars& values,
  const std::vector<SplitBatch>& batches, const std::vector<PointCut>& cuts)
  : Input(input)
  , Scalars(scalars)
  , Values(values)
  , NumberOfPoints(input->GetNumberOfPoints())
  , Edges(cuts.size())
{
  for (const SplitBatch& batch : batches)
  {
    this->Centres.insert(this->Centres.end(), batch.Centres.begin(), batch.Centres.end());
  }
  vtkSMPTools::For(0, static_cast<vtkIdType>(cuts.size()), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      this->Edges[i] = this->MakeEdge(cuts[i]);
    }
  });
}

vtkIdType SplitPoints::CentreNumber(vtkIdType cell) const
{
  const auto found = std::lower_bound(this->Centres.begin(), this->Centres.end(), cell,
    [](const CellCentre& centre, vtkIdType wanted) { return centre.Cell < wanted; });
  return this->NumberOfPoints + static_cast<vtkIdType>(found - this->Centres.begin());
}

vtkIdType SplitPoints::FirstCut() const
{
  return this->NumberOfPoints + static_cast<vtkIdType>(this->Centres.size());
}

double SplitPoints::ScalarAt(vtkIdType outputPoint) const
{
  return outputPoint < this->NumberOfPoints
    ? this->Values.Value(outputPoint)
    : this->Centres[outputPoint - this->NumberOfPoints].Scalar;
}

SplitPoints::Edge SplitPoints::MakeEdge(const PointCut& cut) const
{
  Edge edge;
  edge.Low = cut.First;
  edge.High = cut.Second < this->NumberOfPoints
    ? cut.Second
    : this->CentreNumber(cut.Second - this->NumberOfPoints);
  if (this->ScalarAt(edge.High) < this->ScalarAt(edge.Low))
  {
    std::swap(edge.Low, edge.High);
  }
  const double low = this->ScalarAt(edge.Low);
  const double high = this->ScalarAt(edge.High);
  // Halved, so that the difference of two huge numbers does not overflow.
  edge.Parameter =
    (0.5 * this->Values.Levels().Value(cut.Level) - 0.5 * low) / (0.5 * high - 0.5 * low);
  edge.Level = cut.Level;
  return edge;
}

void SplitPoints::Place(vtkPoints* points) const
{
  const vtkIdType first = this->FirstCut();
  points->SetNumberOfPoints(first + static_cast<vtkIdType>(this->Edges.size()));
  const auto placeOf = [this](vtkIdType point, double x[3]) {
    if (point < this->NumberOfPoints)
    {
      this->Input->GetPoint(point, x);
    }
    else
    {
      std::copy_n(this->Centres[point - this->NumberOfPoints].Place.begin(), 3, x);
    }
  };
  vtkSMPTools::For(0, points->GetNumberOfPoints(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      double x[3];
      if (i < first)
      {
        placeOf(i, x);
      }
      else
      {
        const Edge& edge = this->Edges[i - first];
        double y[3];
        placeOf(edge.Low, x);
        placeOf(edge.High, y);
        for (int axis = 0; axis < 3; ++axis)
        {
          x[axis] = (1 - edge.Parameter) * x[axis] + edge.Parameter * y[axis];
        }
      }
      points->SetPoint(i, x);
    }
  });
}

void SplitPoints::CarryArrays(vtkDataSetAttributes* output) const
{
  vtkDataSetAttributes* input = this->Input->GetPointData();
  for (int a = 0; a < input->GetNumberOfArrays(); ++a)
  {
    vtkAbstractArray* from = input->GetAbstractArray(a);
    const int attribute = input->IsArrayAnAttribute(a);
    const bool areIds = attribute == vtkDataSetAttributes::GLOBALIDS ||
      attribute == vtkDataSetAttributes::PEDIGREEIDS;
    auto to =
      MakeLike(from, from == this->Scalars ? TypeForScalars(this->Scalars) : from->GetDataType());
    to->SetNumberOfTuples(this->FirstCut() + static_cast<vtkIdType>(this->Edges.size()));
    to->InsertTuples(0, this->NumberOfPoints, 0, from);
    this->CarryArray(from, to, areIds);
    output->AddArray(to);
    if (attribute >= 0 && !areIds) // new points have no id
    {
      output->SetActiveAttribute(from->GetName(), attribute);
    }
  }
}

void SplitPoints::CarryArray(vtkAbstractArray* from, vtkAbstractArray* to, bool areIds) const
{
  auto* numbers = vtkDataArray::SafeDownCast(to);
  const bool isGhost =
    from->GetName() && std::strcmp(from->GetName(), vtkDataSetAttributes::GhostArrayName()) == 0;
  if (isGhost && vtkUnsignedCharArray::SafeDownCast(to))
  {
    this->CombineGhosts(from, to);
  }
  else if (areIds)
  {
    this->MarkAsNew(from, to);
  }
  else if (numbers && !vtkBitArray::SafeDownCast(to))
  {
    this->Interpolate(vtkDataArray::SafeDownCast(from), numbers);
  }
  else
  {
    this->CopyNearest(from, to);
  }
  if (from == this->Scalars)
  {
    this->WriteScalars(numbers);
  }
}

void SplitPoints::Interpolate(vtkDataArray* from, vtkDataArray* to) const
{
  vtkNew<vtkIdList> corners;
  std::vector<double> weights;
  for (std::size_t i = 0; i < this->Centres.size(); ++i)
  {
    this->Input->GetCellPoints(this->Centres[i].Cell, corners);
    weights.assign(static_cast<std::size_t>(corners->GetNumberOfIds()),
      1.0 / static_cast<double>(corners->GetNumberOfIds()));
    to->InterpolateTuple(
      this->NumberOfPoints + static_cast<vtkIdType>(i), corners, from, weights.data());
  }
  const vtkIdType first = this->FirstCut();
  vtkSMPTools::For(
    0, static_cast<vtkIdType>(this->Edges.size()), [&](vtkIdType begin, vtkIdType end) {
      for (vtkIdType i = begin; i < end; ++i)
      {
        const Edge& edge = this->Edges[i];
        to->InterpolateTuple(first + i, edge.Low, to, edge.High, to, edge.Parameter);
      }
    });
}

// Text, bits, variants: not for threads.
void SplitPoints::CopyNearest(vtkAbstractArray* from, vtkAbstractArray* to) const
{
  vtkNew<vtkIdList> corners;
  for (std::size_t i = 0; i < this->Centres.size(); ++i)
  {
    this->Input->GetCellPoints(this->Centres[i].Cell, corners);
    to->SetTuple(this->NumberOfPoints + static_cast<vtkIdType>(i), corners->GetId(0), from);
  }
  vtkIdType next = this->FirstCut();
  for (const Edge& edge : this->Edges)
  {
    to->SetTuple(next++, edge.Parameter < 0.5 ? edge.Low : edge.High, to);
  }
}

// No point of the input is where a new one is: -1; text stays empty.
void SplitPoints::MarkAsNew(vtkAbstractArray*, vtkAbstractArray* to) const
{
  auto* numbers = vtkDataArray::SafeDownCast(to);
  for (vtkIdType i = this->NumberOfPoints; numbers && i < to->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < to->GetNumberOfComponents(); ++c)
    {
      numbers->SetComponent(i, c, -1);
    }
  }
}

// A cut is a ghost if both ends are; then all cells about it are ghosts. The centre of a cell has
// no flags.
void SplitPoints::CombineGhosts(vtkAbstractArray*, vtkAbstractArray* to) const
{
  auto* flags = vtkUnsignedCharArray::SafeDownCast(to);
  for (std::size_t i = 0; i < this->Centres.size(); ++i)
  {
    flags->SetValue(this->NumberOfPoints + static_cast<vtkIdType>(i), 0);
  }
  vtkIdType next = this->FirstCut();
  for (const Edge& edge : this->Edges)
  {
    flags->SetValue(
      next++, static_cast<unsigned char>(flags->GetValue(edge.Low) & flags->GetValue(edge.High)));
  }
}

// Exactly the value, where interpolation rounds.
void SplitPoints::WriteScalars(vtkDataArray* to) const
{
  for (vtkIdType point : this->Values.Snapped())
  {
    to->SetComponent(point, 0, this->Values.Value(point));
  }
  for (std::size_t i = 0; i < this->Centres.size(); ++i)
  {
    to->SetComponent(this->NumberOfPoints + static_cast<vtkIdType>(i), 0, this->Centres[i].Scalar);
  }
  vtkIdType next = this->FirstCut();
  for (const Edge& edge : this->Edges)
  {
    to->SetComponent(next++, 0, this->Values.Levels().Value(edge.Level));
  }
}

} // namespace nephoscope

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "UnboundedField.h"

#include "NearestPlace.h"

#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkRectilinearGrid.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
bool IsBox(vtkDataSet* data)
{
  if (auto* image = vtkImageData::SafeDownCast(data))
  {
    return image->GetDirectionMatrix()->IsIdentity();
  }
  return vtkRectilinearGrid::SafeDownCast(data) != nullptr;
}

std::size_t CornerCount(const FaceCorners& face)
{
  return face[3] < 0 ? 3 : 4;
}

NearestPlace NearestOn(vtkDataSet* data, const FaceCorners& face, const Vector3& position)
{
  Vector3 corners[4]{};
  for (std::size_t i = 0; i < CornerCount(face); ++i)
  {
    data->GetPoint(face[i], corners[i].data());
    for (std::size_t c = 0; c < 3; ++c)
    {
      corners[i][c] -= position[c];
    }
  }
  NearestPlace place;
  CornerCount(face) == 3 ? place.OnTriangle(corners) : place.OnQuadrilateral(corners);
  return place;
}
}

UnboundedField::UnboundedField(
  vtkDataSet* data, vtkDataArray* velocity, std::unique_ptr<VelocityField> inner)
  : Data(data)
  , Velocity(velocity)
  , Inner(std::move(inner))
  , FillsBounds(IsBox(data) && HasVelocityEverywhere(data, velocity))
{
  data->GetBounds(this->Bounds);
}

void UnboundedField::Sample(const SampleBatch& batch) const
{
  if (this->FillsBounds)
  {
    this->SampleClamped(batch);
    return;
  }
  this->Inner->Sample(batch);
  for (std::size_t i = 0; i < batch.Count; ++i)
  {
    batch.Inside[i] =
      batch.Inside[i] || this->SampleBorder(batch.Positions[i], batch.Velocities[i]);
  }
}

void UnboundedField::SampleClamped(const SampleBatch& batch) const
{
  std::vector<Vector3> positions(batch.Positions, batch.Positions + batch.Count);
  for (Vector3& p : positions)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      p[c] = std::min(std::max(p[c], this->Bounds[2 * c]), this->Bounds[2 * c + 1]);
    }
  }
  SampleBatch clamped = batch;
  clamped.Positions = positions.data();
  this->Inner->Sample(clamped);
}

bool UnboundedField::SampleBorder(const Vector3& position, Vector3& velocity) const
{
  if (!std::isfinite(position[0] + position[1] + position[2]))
  {
    return false;
  }
  std::call_once(this->BorderOnce, [this]() { this->FindBorder(); });
  NearestPlace nearest;
  FaceCorners face{};
  this->Tree.ForEachNear(position, [&](std::int64_t i) {
    const FaceCorners& other = this->Faces[static_cast<std::size_t>(i)];
    const NearestPlace place = NearestOn(this->Data, other, position);
    if (place.Distance2() < nearest.Distance2())
    {
      nearest = place;
      face = other;
    }
    return nearest.Distance2();
  });
  velocity = Vector3{};
  for (std::size_t corner = 0; !this->Faces.empty() && corner < CornerCount(face); ++corner)
  {
    double value[3];
    this->Velocity->GetTuple(face[corner], value);
    for (std::size_t c = 0; c < 3; ++c)
    {
      velocity[c] += nearest.Weight(corner) * value[c];
    }
  }
  return !this->Faces.empty();
}

void UnboundedField::FindBorder() const
{
  this->Faces = BorderFaces(this->Data, this->Velocity);
  std::vector<Box> boxes(this->Faces.size());
  for (std::size_t i = 0; i < boxes.size(); ++i)
  {
    for (std::size_t corner = 0; corner < CornerCount(this->Faces[i]); ++corner)
    {
      double place[3];
      this->Data->GetPoint(this->Faces[i][corner], place);
      boxes[i].AddPoint(place);
    }
  }
  this->Tree.Build(boxes);
}
}

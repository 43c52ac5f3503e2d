// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A velocity field that goes on beyond its dataset.
#ifndef nephoscope_UnboundedField_h
#define nephoscope_UnboundedField_h

#include "BorderFaces.h"
#include "CellTree.h"
#include "VelocityFields.h"

#include "vtkSmartPointer.h"

#include <mutex>
#include <vector>

class vtkDataArray;
class vtkDataSet;

namespace nephoscope
{
// Where the field of the dataset has no velocity (beyond its border, in holes, in hidden cells and
// in those whose velocity is not finite), the velocity is that at the nearest place that has one.
// On an image that place is the position, clamped to the bounds.
class UnboundedField : public VelocityField
{
public:
  // `velocity`: on the points of the dataset; `inner`: its field.
  UnboundedField(vtkDataSet* data, vtkDataArray* velocity, std::unique_ptr<VelocityField> inner);

  void Sample(const SampleBatch& batch) const override;

private:
  void SampleClamped(const SampleBatch& batch) const;
  bool SampleBorder(const Vector3& position, Vector3& velocity) const;
  void FindBorder() const;

  vtkSmartPointer<vtkDataSet> Data;
  vtkSmartPointer<vtkDataArray> Velocity;
  std::unique_ptr<VelocityField> Inner;
  bool FillsBounds;
  double Bounds[6];
  mutable std::once_flag BorderOnce; // found when it is needed first
  mutable std::vector<FaceCorners> Faces;
  mutable CellTree Tree;
};
}

#endif

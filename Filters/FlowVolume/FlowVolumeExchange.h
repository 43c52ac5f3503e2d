// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What the ranks of a parallel program tell each other, so that all of them build the same flow volume.
#ifndef nephoscope_FlowVolumeExchange_h
#define nephoscope_FlowVolumeExchange_h

#include "SmokeMesh.h"
#include "VelocityFields.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <string>

class vtkBoundingBox;
class vtkDataObject;
class vtkMultiProcessController;
class vtkPolyData;

namespace nephoscope
{
// Every rank knows the whole front of smoke and asks for its velocities together with the others (DistributedField), so
// every rank makes the whole mesh, and then writes its share of it (MeshSlice.h).
//
// All functions but Speaks are to be called by all ranks, in the same order. With one rank, or no controller, they
// return at once what they are given.
class FlowVolumeExchange
{
public:
  explicit FlowVolumeExchange(vtkMultiProcessController* controller);

  // Whether errors and warnings, which are the same on all ranks, are printed by this one.
  bool Speaks() const { return this->Rank == 0; }

  // The problem of the lowest rank that has one; empty if none has. `importance` lets a rank that knows more speak.
  std::string AgreeOnProblem(const std::string& problem, int importance = 0) const;

  bool AllTrue(bool here) const;
  bool AnyTrue(bool here) const;

  // The lowest rank where it is true; the number of ranks if there is none.
  int FirstTrue(bool here) const;

  void Unite(vtkBoundingBox& box) const;

  // The choice of the lowest rank whose data have cells.
  void AgreeOnVelocity(VelocityArray& array, bool hasCells) const;

  // The field of the data of all ranks; ranks may be without cells. Null, and the same problem on all ranks, if the data
  // of any rank have none, or nobody has cells.
  std::unique_ptr<DataSetField> MakeField(
    vtkDataObject* data, const VelocityArray& array, std::string& problem) const;

  // The polygons of all ranks in one, points at the same place merged, polygons that several ranks have once. `polygon`
  // may be null or empty. Its arrays are left behind.
  vtkSmartPointer<vtkPolyData> GatherPolygon(vtkPolyData* polygon) const;

  // Progress as before; stops on all ranks when any wants to.
  ProgressFunction StopTogether(const ProgressFunction& progress) const;

  // The share of this rank.
  SmokeMesh ShareOf(const SmokeMesh& mesh) const;

private:
  bool IsAlone() const { return this->Ranks == 1; }

  vtkMultiProcessController* Controller;
  int Rank = 0;
  int Ranks = 1;
};
}

#endif

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The data that the ranks of a parallel program exchange, so that all of them build the same flow
// volume.
#ifndef nephoscope_FlowVolumeExchange_h
#define nephoscope_FlowVolumeExchange_h

#include "SmokeMesh.h"
#include "VelocityFields.h"

#include "vtkSmartPointer.h"

#include <memory>
#include <string>
#include <vector>

class vtkBoundingBox;
class vtkDataObject;
class vtkDataSet;
class vtkInformation;
class vtkInformationVector;
class vtkMultiProcessController;
class vtkPolyData;

namespace nephoscope
{
// Every rank knows the whole front of smoke and asks for its velocities together with the others
// (DistributedField), so every rank makes the whole mesh, and then writes its share of it
// (MeshSlice.h).
//
// All functions but Speaks and RequestParts are to be called by all ranks, in the same order. With
// one rank, or without a controller, they return their input at once.
class FlowVolumeExchange
{
public:
  explicit FlowVolumeExchange(vtkMultiProcessController* controller);

  // Whether errors and warnings, which are the same on all ranks, are printed by this one.
  bool ReportsMessages() const { return this->Rank == 0; }

  // The problem of the lowest rank that has one; empty if none has.
  std::string AgreeOnProblem(const std::string& problem) const;

  // Asks for the parts of the inputs that belong to this rank: of the data with a layer of ghost
  // cells, which close gaps of rounding between ranks and complete averages at their borders; of
  // the polygon without.
  void RequestParts(vtkInformationVector** inputs) const;

  bool AllTrue(bool here) const;
  bool AnyTrue(bool here) const;

  // The lowest rank where it is true; the number of ranks if there is none.
  int FirstTrue(bool here) const;

  // The numbers of all ranks, in the order of the ranks.
  std::vector<double> Gather(const std::vector<double>& mine) const;

  // Bounds of the data of all ranks, and their diagonal; 0 where there are no data.
  vtkBoundingBox BoundsOf(const std::vector<vtkDataSet*>& sets) const;
  double DiagonalOf(const std::vector<vtkDataSet*>& sets) const;

  // The size of the smallest blanked cell of all ranks (BlankedCells.h); 0 if there is none.
  double SmallestBlanked(const std::vector<vtkDataSet*>& sets) const;

  // As the functions of these names (VelocityChoice.h, VelocityFields.h, DataSets.h) for the data
  // of all ranks, of which some may be without cells. The lowest rank that can choose does. The
  // answers, also the problems, are the same on all ranks.
  bool ChooseVelocity(
    vtkDataObject* data, vtkInformation* wanted, VelocityArray& choice, std::string& problem) const;
  std::unique_ptr<DataSetField> MakeVelocityField(
    vtkDataObject* data, const VelocityArray& array, std::string& problem) const;
  std::string WhyNoVelocity(const std::vector<vtkDataSet*>& sets, const Vector3& position) const;

  // The polygons of all ranks in one, points at the same place merged, polygons that several ranks
  // have once. `polygon` may be null or empty. Its arrays are left behind.
  vtkSmartPointer<vtkPolyData> GatherPolygon(vtkPolyData* polygon) const;

  // What this rank writes: `mesh`, or the rank's part of it, which is written to `share`.
  const SmokeMesh& ShareOf(const SmokeMesh& mesh, SmokeMesh& share) const;

private:
  // The middle of the nearest cell of all ranks.
  Vector3 NearestTo(const std::vector<vtkDataSet*>& sets, const Vector3& position) const;
  void Unite(vtkBoundingBox& box) const;
  bool IsAlone() const { return this->Ranks == 1; }

  vtkMultiProcessController* Controller;
  int Rank = 0;
  int Ranks = 1;
};
}

#endif

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Blocks, and unstructured data of several ranks, in the light of all. It is computed on one mesh
// of their clouds; each gets the light at its points.
#include "vtkSunlight.h"

#include "DataSets.h"
#include "DefaultRange.h"
#include "SmokeOptics.h"
#include "vtkSunlightInternals.h"

#include "vtkCellData.h"
#include "vtkCommunicator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#include "vtkPointData.h"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace
{
// An array of several components is an error of its own block.
bool IsScalar(vtkDataSet* data, const std::string& name)
{
  vtkDataArray* onPoints = data->GetPointData()->GetArray(name.c_str());
  vtkDataArray* array = onPoints ? onPoints : data->GetCellData()->GetArray(name.c_str());
  return !array || array->GetNumberOfComponents() == 1;
}
}

// Called before the first block, on all ranks. Fewer than two datasets with clouds need not be
// joined.
void vtkSunlight::JoinClouds()
{
  this->JoinShadingClouds();
  vtkDataObject* input =
    this->GetNumberOfInputConnections(0) > 0 ? this->GetInputDataObject(0, 0) : nullptr;
  vtkMultiProcessController* ranks = nephoscope::RanksOfPieces(this);
  const bool isComposite = vtkCompositeDataSet::SafeDownCast(input) != nullptr;
  this->ColumnOfRanks = ranks && !isComposite && !nephoscope::IsStructured(input)
    ? nephoscope::SmokeColumn(vtkDataSet::SafeDownCast(input), ranks)
    : 0;
  // A grid is whole on each rank.
  if (!input || (!isComposite && (!ranks || nephoscope::IsStructured(input))))
  {
    this->Joined.reset();
    return;
  }
  std::vector<vtkSmartPointer<vtkDataSet>> clouds;
  std::vector<double> state = this->State();
  nephoscope::ForEachLeaf(input, [&](vtkDataObject* leaf) {
    auto* data = vtkDataSet::SafeDownCast(leaf);
    if (data && data->GetNumberOfPoints() > 0 && this->HasExtinction(data) &&
      IsScalar(data, this->ExtinctionArrayName))
    {
      clouds.emplace_back(data);
      state.push_back(static_cast<double>(data->GetMTime()));
    }
  });
  const int here = static_cast<int>(clouds.size());
  int everywhere = here;
  ranks ? ranks->AllReduce(&here, &everywhere, 1, vtkCommunicator::SUM_OP) : 0;
  if (everywhere < 2)
  {
    this->Joined.reset();
    return;
  }
  if (nephoscope::IsTrueOfAnyPiece(this, !this->Joined || this->Joined->State != state))
  {
    this->Joined = std::make_unique<Joint>();
    this->Joined->State = std::move(state);
    for (const auto& data : clouds)
    {
      this->Joined->Clouds.Parts.push_back(this->PartOf(data));
    }
    this->Joined->Clouds.Join(ranks);
  }
  this->Joined->Told = false;
}

// Makes one mesh of the second input, of its blocks or of the parts of all ranks.
void vtkSunlight::JoinShadingClouds()
{
  vtkDataObject* input =
    this->GetNumberOfInputConnections(1) > 0 ? this->GetInputDataObject(1, 0) : nullptr;
  vtkMultiProcessController* ranks = nephoscope::RanksOfPieces(this);
  this->JoinedShading = nullptr;
  if (!input || (vtkDataSet::SafeDownCast(input) && (!ranks || nephoscope::IsStructured(input))))
  {
    return;
  }
  const nephoscope::OpticalArrays light{ { { "SunTransmittance", 1, 1 }, { "Irradiance", 0, 1 },
    { "UpwardIrradiance", 0, 1 } } };
  nephoscope::JoinedClouds clouds;
  nephoscope::ForEachLeaf(input, [&](vtkDataObject* leaf) {
    auto* data = vtkDataSet::SafeDownCast(leaf);
    if (data && data->GetPointData()->HasArray(light[0].Name.c_str()))
    {
      clouds.Parts.emplace_back(data, light);
    }
  });
  const bool areAnyLit = nephoscope::IsTrueOfAnyPiece(this, !clouds.Parts.empty());
  clouds.Join(ranks);
  this->JoinedShading = clouds.Mesh;
  const std::vector<float>* values[] = { &clouds.Optics.Extinction, &clouds.Optics.Albedo,
    &clouds.Optics.Asymmetry };
  for (int k = 0; k < 3 && areAnyLit; ++k)
  {
    std::copy(values[k]->begin(), values[k]->end(),
      nephoscope::AddPointArray(clouds.Mesh, light[k].Name.c_str())->GetPointer(0));
  }
}

vtkDataSet* vtkSunlight::ShadingClouds()
{
  return this->JoinedShading ? this->JoinedShading.Get()
                             : vtkDataSet::SafeDownCast(this->GetInputDataObject(1, 0));
}

nephoscope::CloudPart vtkSunlight::PartOf(vtkDataSet* data)
{
  vtkSmartPointer<vtkDataSet> copy;
  copy.TakeReference(data->NewInstance());
  copy->ShallowCopy(data);
  this->ChooseExtinction(copy);
  nephoscope::CloudPart part(copy,
    { { { this->UsedExtinction, 0, this->ExtinctionScale },
      { this->AlbedoArrayName, this->Albedo, 1 },
      { this->AsymmetryArrayName, this->Asymmetry, 1 } } });
  part.Data = data;
  return part;
}

nephoscope::CloudPart* vtkSunlight::FindPart(vtkDataSet* input)
{
  if (!this->Joined)
  {
    return nullptr;
  }
  auto& parts = this->Joined->Clouds.Parts;
  const auto part = std::find_if(
    parts.begin(), parts.end(), [input](const auto& one) { return one.Data == input; });
  return part == parts.end() ? nullptr : &*part;
}

bool vtkSunlight::ComputeJoint()
{
  nephoscope::JoinedClouds& clouds = this->Joined->Clouds;
  auto work = std::make_unique<Work>();
  work->Extinction = clouds.Optics.Extinction;
  work->Albedo = clouds.Optics.Albedo;
  work->Asymmetry = clouds.Optics.Asymmetry;
  if (!this->CheckUp() || !this->FindSun(clouds.Mesh, work->Sun) ||
    !this->ComputeLight(clouds.Mesh, *work))
  {
    return false;
  }
  this->Joined->Light = std::move(work);
  return true;
}

bool vtkSunlight::AddJointLight(vtkDataSet* data, nephoscope::CloudPart& part)
{
  if (!this->Check(data))
  {
    return false;
  }
  this->WarnOfValues(part.Wrong);
  part.Wrong = 0;
  if (!this->Joined->Light && !this->ComputeJoint())
  {
    return false;
  }
  if (!this->Joined->Told)
  {
    this->WarnOfLight(this->Joined->Clouds.Mesh, *this->Joined->Light);
    this->Joined->Told = true;
  }
  Work own = this->Joined->Light->At(part.Numbers);
  own.Places = nephoscope::PlacesOf(data);
  if (part.Weights.empty()) // a block keeps its own values, even where blocks meet
  {
    own.Extinction = part.Optics.Extinction;
    own.Albedo = part.Optics.Albedo;
    own.Asymmetry = part.Optics.Asymmetry;
    this->ScaleOptics(own);
  }
  this->Write(data, own);
  return true;
}

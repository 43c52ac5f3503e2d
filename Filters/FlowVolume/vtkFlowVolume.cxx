// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkFlowVolume.h"

#include "GeneratingPolygon.h"
#include "SteadyVolume.h"
#include "VelocityFields.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkDoubleArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkUnstructuredGrid.h"

#include <string>

vtkStandardNewMacro(vtkFlowVolume);

namespace nephoscope
{
struct FlowVolumeState
{
};
}

namespace
{
template <typename Array, typename Value>
void AddArray(vtkDataSetAttributes* attributes, const char* name, const std::vector<Value>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), array->GetPointer(0));
  attributes->AddArray(array);
}

void PutMesh(const nephoscope::SmokeMesh& mesh, vtkUnstructuredGrid* output)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.Points.size()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    points->SetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
  }
  vtkNew<vtkCellArray> cells;
  cells->AllocateExact(static_cast<vtkIdType>(mesh.Tetrahedra.size()),
    static_cast<vtkIdType>(4 * mesh.Tetrahedra.size()));
  for (const auto& t : mesh.Tetrahedra)
  {
    cells->InsertNextCell({ t[0], t[1], t[2], t[3] });
  }
  output->SetPoints(points);
  output->SetCells(VTK_TETRA, cells);
  AddArray<vtkDoubleArray>(output->GetPointData(), "Age", mesh.PointAges);
  AddArray<vtkIntArray>(output->GetCellData(), "EmissionStep", mesh.EmissionSteps);
  AddArray<vtkDoubleArray>(output->GetCellData(), "Age", mesh.Ages);
  AddArray<vtkDoubleArray>(output->GetCellData(), "Density", mesh.Densities);
}
}

vtkFlowVolume::vtkFlowVolume()
{
  this->SetNumberOfInputPorts(2);
}

vtkFlowVolume::~vtkFlowVolume() = default;

void vtkFlowVolume::SetPolygonConnection(vtkAlgorithmOutput* polygon)
{
  this->SetInputConnection(1, polygon);
}

int vtkFlowVolume::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkDataObject" : "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkFlowVolume::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* input = vtkDataSet::GetData(inputs[0], 0);
  vtkUnstructuredGrid* output = vtkUnstructuredGrid::GetData(outputs, 0);
  vtkInformation* wanted = this->GetInputArrayInformation(0);
  const char* name = wanted->Get(vtkDataObject::FIELD_NAME());
  std::string problem;
  const auto field =
    nephoscope::MakeVelocityField(input, { name ? name : "DisplayVelocity", false }, problem);
  if (!field)
  {
    vtkErrorMacro(<< problem);
    return 1;
  }
  nephoscope::RegularPolygon regular;
  std::copy_n(this->Center, 3, regular.Center.begin());
  std::copy_n(this->Normal, 3, regular.Normal.begin());
  regular.Radius = this->Radius > 0.0 ? this->Radius : input->GetLength() / 50.0;
  regular.Sides = this->NumberOfSides;
  nephoscope::Vector3 velocity{};
  nephoscope::CellHint hint;
  unsigned char inside = 0;
  field->Sample({ 1, &regular.Center, 0.0, &velocity, &inside, &hint });
  const double speed = vtkMath::Norm(velocity.data());
  if (!inside || speed == 0.0)
  {
    vtkErrorMacro(
      "The centre of the generating polygon is outside the data or the flow there is zero: move it into the flow.");
    return 1;
  }
  if (this->NormalToFlow)
  {
    regular.Normal = velocity;
  }
  nephoscope::FlowVolumeSettings settings;
  settings.Duration = this->Duration > 0.0 ? this->Duration : 0.5 * input->GetLength() / speed;
  settings.TimeStep = this->TimeStep > 0.0 ? this->TimeStep : settings.Duration / 64.0;
  const auto polygon = nephoscope::TriangulateRegularPolygon(regular, this->PolygonEdgeLength);
  const auto mesh =
    nephoscope::BuildSteadyVolume(*field, polygon, settings, 0.0, [this](double done) {
      this->UpdateProgress(done);
      return !this->CheckAbort();
    });
  PutMesh(mesh, output);
  field->SampleArrays(
    mesh.Points.size(), mesh.Points.data(), mesh.Hints.data(), output->GetPointData());
  AddArray<vtkDoubleArray>(output->GetPointData(), "Age", mesh.PointAges);
  return 1;
}

void vtkFlowVolume::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Center: " << this->Center[0] << " " << this->Center[1] << " " << this->Center[2]
     << "\n";
  os << indent << "Duration: " << this->Duration << " s\n";
  os << indent << "TimeStep: " << this->TimeStep << " s\n";
}

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "DensityCells.h"

#include "CloudCellsFunction.h"
#include "CloudGridWalkFunctions.h"
#include "ShaderArrays.h"

#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{

std::string DensityCells::Take(const std::vector<DensityBlock>& blocks)
{
  const std::string error = this->Cells.Take(blocks);
  this->Warning = this->Cells.Warning;
  this->MeanDensity = this->Cells.MeanDensity;
  this->Bins.Sort(this->Cells);
  for (const auto& p : this->Cells.Points)
  {
    this->Radius =
      std::max(this->Radius, std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]) * 1.00001f);
  }
  const std::vector<float>& densities = this->Cells.CellDensities;
  if (!densities.empty()) // they follow the points, four by four
  {
    std::vector<std::array<float, 4>>& points = this->Cells.Points;
    this->FirstCellDensity = static_cast<int>(points.size());
    points.resize(points.size() + (densities.size() + 3) / 4);
    std::copy(densities.begin(), densities.end(),
      points[static_cast<std::size_t>(this->FirstCellDensity)].begin());
  }
  return error;
}

std::string DensityCells::GetShaderCode() const
{
  return ArrayDeclarations(CurrentArrayLayout()) + CloudGridWalkFunctions + CloudCellsFunction;
}

std::string DensityCells::Upload(vtkOpenGLRenderWindow* window)
{
  if (this->IsUploaded)
  {
    return std::string();
  }
  std::string error =
    this->Points.Upload(window, this->Cells.Points.data(), this->Cells.Points.size(), 4, VTK_FLOAT);
  error = !error.empty() ? error
                         : this->Tetrahedra.Upload(window, this->Cells.Tetrahedra.data(),
                             this->Cells.Tetrahedra.size(), 4, VTK_INT);
  error = !error.empty()
    ? error
    : this->Lists.Upload(window, this->Bins.Lists.data(), this->Bins.Lists.size(), 1, VTK_INT);
  this->IsUploaded = error.empty();
  return this->IsUploaded ? error
                          : "has " + std::to_string(this->Cells.Tetrahedra.size()) +
      " tetrahedra with density, too many for this OpenGL: extract a part of it, or resample it to an image";
}

void DensityCells::Activate()
{
  if (this->IsUploaded)
  {
    this->Units[0] = this->Points.Activate();
    this->Units[1] = this->Tetrahedra.Activate();
    this->Units[2] = this->Lists.Activate();
  }
}

void DensityCells::Deactivate()
{
  if (this->IsUploaded)
  {
    this->Points.Deactivate();
    this->Tetrahedra.Deactivate();
    this->Lists.Deactivate();
  }
}

void DensityCells::SetUniforms(vtkShaderProgram* program, vtkMatrix4x4* viewToData)
{
  if (!this->IsUploaded)
  {
    return;
  }
  vtkNew<vtkMatrix4x4> toCells;
  toCells->DeepCopy(viewToData);
  float perBin[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    toCells->SetElement(axis, 3, toCells->GetElement(axis, 3) - this->Cells.Center[axis]);
    perBin[axis] = 1 / this->Bins.Size[axis];
  }
  toCells->Transpose(); // as OpenGL wants it
  program->SetUniformMatrix("cloudViewToCells", toCells);
  program->SetUniformi("cloudCellPoints", this->Units[0]);
  program->SetUniformi("cloudTetrahedra", this->Units[1]);
  program->SetUniformi("cloudBinLists", this->Units[2]);
  program->SetUniform3f("cloudBinsLow", this->Bins.Low);
  program->SetUniform3f("cloudBinsPerLength", perBin);
  float counts[3];
  std::copy_n(this->Bins.Counts, 3, counts);
  program->SetUniform3f("cloudBinCounts", counts);
  program->SetUniformf("cloudCellsRadius", this->Radius);
  program->SetUniformi("cloudFirstCellDensity", this->FirstCellDensity);
}

void DensityCells::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Points.Release(window);
  this->Tetrahedra.Release(window);
  this->Lists.Release(window);
  this->IsUploaded = false;
}

} // namespace nephoscope

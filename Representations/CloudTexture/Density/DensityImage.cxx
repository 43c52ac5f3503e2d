// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "DensityImage.h"

#include "CloudGridWalkFunctions.h"
#include "CloudVolumeFunction.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

#include <algorithm>

namespace nephoscope
{
namespace
{
constexpr std::size_t mostPointsWithCorners = std::size_t(1) << 24; // 256 MB
}

DensityImage::DensityImage(vtkImageData* image, vtkDataArray* array)
{
  image->GetDimensions(this->Size);
  const int* extent = image->GetExtent();
  this->ToIndex->DeepCopy(image->GetPhysicalToIndexMatrix());
  for (int axis = 0; axis < 3; ++axis)
  {
    this->ToIndex->SetElement(axis, 3, this->ToIndex->GetElement(axis, 3) - extent[2 * axis]);
  }
  this->Read(array);
}

void DensityImage::Read(vtkDataArray* array)
{
  this->Values.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  double sum = 0;
  std::size_t count = 0, wrong = 0;
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    const double value = array->GetComponent(static_cast<vtkIdType>(i), 0);
    wrong += !IsDensity(value);
    this->Values[i] = IsDensity(value) ? static_cast<float>(value) : 0.0f;
    sum += this->Values[i];
    count += this->Values[i] > 0;
  }
  this->MeanDensity = count > 0 ? sum / static_cast<double>(count) : 1;
  this->Warning = wrong > 0 ? "has " + std::to_string(wrong) +
      " values that are not a density, >= 0 and finite: they count as 0"
                            : "";
}

std::string DensityImage::GetShaderCode() const
{
  return std::string("const bool hasCorners = ") + (this->HasCorners() ? "true" : "false") + ";\n" +
    CloudGridWalkFunctions + CloudVolumeFunction;
}

bool DensityImage::HasCorners() const
{
  return this->Values.size() <= mostPointsWithCorners;
}

// At (0, 0), (1, 0), (0, 1) and (1, 1) of x and y from each point; no voxel begins at the last
// ones.
std::vector<float> DensityImage::Corners() const
{
  std::vector<float> corners(4 * this->Values.size());
  const std::size_t steps[4] = { 0, 1, std::size_t(this->Size[0]), std::size_t(this->Size[0]) + 1 };
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    for (std::size_t c = 0; c < 4; ++c)
    {
      corners[4 * i + c] = this->Values[std::min(i + steps[c], this->Values.size() - 1)];
    }
  }
  return corners;
}

std::string DensityImage::Upload(vtkOpenGLRenderWindow* window)
{
  if (this->IsUploaded)
  {
    return std::string();
  }
  GLint largest = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &largest);
  if (std::max({ this->Size[0], this->Size[1], this->Size[2] }) > largest)
  {
    return "has more than " + std::to_string(largest) +
      " points along an axis, the limit of this OpenGL: resample it to fewer";
  }
  this->Texture->SetContext(window);
  this->Texture->SetDataType(GL_FLOAT);
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  std::vector<float> corners = this->HasCorners() ? this->Corners() : std::vector<float>();
  this->IsUploaded = this->Texture->Create3DFromRaw(static_cast<unsigned int>(this->Size[0]),
    static_cast<unsigned int>(this->Size[1]), static_cast<unsigned int>(this->Size[2]),
    this->HasCorners() ? 4 : 1, VTK_FLOAT,
    this->HasCorners() ? corners.data() : this->Values.data());
  if (!this->IsUploaded)
  {
    return "does not fit into a texture of this OpenGL";
  }
  return std::string();
}

void DensityImage::Activate()
{
  if (this->IsUploaded)
  {
    this->Texture->Activate();
  }
}

void DensityImage::Deactivate()
{
  if (this->IsUploaded)
  {
    this->Texture->Deactivate();
  }
}

void DensityImage::SetUniforms(vtkShaderProgram* program, vtkMatrix4x4* viewToData)
{
  if (!this->IsUploaded)
  {
    return;
  }
  vtkNew<vtkMatrix4x4> toIndex;
  vtkMatrix4x4::Multiply4x4(this->ToIndex, viewToData, toIndex);
  toIndex->Transpose(); // as OpenGL wants it
  program->SetUniformMatrix("cloudViewToVolume", toIndex);
  program->SetUniformi("cloudVolume", this->Texture->GetTextureUnit());
}

void DensityImage::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->IsUploaded = false;
}

} // namespace nephoscope

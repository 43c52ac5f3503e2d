// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGLFunctions.h"

#include "DensityVolume.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace nephoscope
{

DensityVolume::DensityVolume() = default;
DensityVolume::~DensityVolume() = default;

bool DensityVolume::Prepare(vtkImageData* image, const std::string& name)
{
  const decltype(this->MadeFrom) key(image, image ? image->GetMTime() : 0, name);
  if (key == this->MadeFrom)
  {
    return false;
  }
  this->MadeFrom = key;
  this->Values.clear();
  this->Error.clear();
  this->Warning.clear();
  this->IsUploaded = false;
  if (!image)
  {
    return true;
  }
  vtkDataArray* array = name.empty() ? image->GetPointData()->GetScalars() : image->GetPointData()->GetArray(name.c_str());
  const int* size = image->GetDimensions();
  if (!array)
  {
    this->Error = name.empty() ? "has no active point scalars: name an array with SetDensityArrayName"
                               : "has no point array '" + name + "' of the density";
  }
  else if (array->GetNumberOfComponents() != 1)
  {
    this->Error = "needs an array of one component: " + std::string(array->GetName() ? array->GetName() : "its scalars") + " has " +
      std::to_string(array->GetNumberOfComponents());
  }
  else if (std::min({ size[0], size[1], size[2] }) < 2)
  {
    this->Error = "needs two points or more along each axis";
  }
  else
  {
    this->Read(image, array);
  }
  return true;
}

void DensityVolume::Read(vtkImageData* image, vtkDataArray* array)
{
  image->GetDimensions(this->Size);
  const int* extent = image->GetExtent();
  this->ToIndex->DeepCopy(image->GetPhysicalToIndexMatrix());
  for (int axis = 0; axis < 3; ++axis)
  {
    this->ToIndex->SetElement(axis, 3, this->ToIndex->GetElement(axis, 3) - extent[2 * axis]);
  }
  this->Values.resize(static_cast<std::size_t>(array->GetNumberOfTuples()));
  double sum = 0;
  std::size_t count = 0, wrong = 0;
  for (std::size_t i = 0; i < this->Values.size(); ++i)
  {
    const double value = array->GetComponent(static_cast<vtkIdType>(i), 0);
    const bool isDensity = value >= 0 && value < 1e30;
    wrong += !isDensity;
    this->Values[i] = isDensity ? static_cast<float>(value) : 0.0f;
    sum += this->Values[i];
    count += this->Values[i] > 0;
  }
  this->MeanDensity = count > 0 ? sum / static_cast<double>(count) : 1;
  this->Warning = wrong > 0 ? "has " + std::to_string(wrong) + " values that are not a density, >= 0 and finite: they count as 0" : "";
}

std::string DensityVolume::Upload(vtkOpenGLRenderWindow* window)
{
  if (!this->IsUsed() || this->IsUploaded)
  {
    return std::string();
  }
  GLint largest = 0;
  glGetIntegerv(GL_MAX_3D_TEXTURE_SIZE, &largest);
  if (std::max({ this->Size[0], this->Size[1], this->Size[2] }) > largest)
  {
    this->Values.clear();
    return "has more than " + std::to_string(largest) + " points along an axis, the limit of this OpenGL: resample it to fewer";
  }
  this->Texture->SetContext(window);
  this->Texture->SetDataType(GL_FLOAT);
  this->Texture->SetMinificationFilter(vtkTextureObject::Nearest);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Nearest);
  this->IsUploaded = this->Texture->Create3DFromRaw(static_cast<unsigned int>(this->Size[0]), static_cast<unsigned int>(this->Size[1]),
    static_cast<unsigned int>(this->Size[2]), 1, VTK_FLOAT, this->Values.data());
  if (!this->IsUploaded)
  {
    this->Values.clear();
    return "does not fit into a texture of this OpenGL";
  }
  return std::string();
}

void DensityVolume::Activate()
{
  if (this->IsUploaded)
  {
    this->Texture->Activate();
  }
}

void DensityVolume::Deactivate()
{
  if (this->IsUploaded)
  {
    this->Texture->Deactivate();
  }
}

void DensityVolume::SetUniforms(vtkShaderProgram* program, vtkMatrix4x4* viewToData)
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

void DensityVolume::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Texture->ReleaseGraphicsResources(window);
  this->IsUploaded = false;
}

} // namespace nephoscope

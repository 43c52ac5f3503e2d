// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatVectorScene.h"

#include "ArraySelection.h"
#include "SplatClasses.h"
#include "SplatPass.h"
#include "SplatSamples.h"
#include "SplatTree.h"
#include "VectorTexture.h"

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkScalarsToColors.h"

#include <cmath>

namespace nephoscope
{
namespace
{
// One number of a tuple: the value, or of several components their magnitude.
double MagnitudeOf(vtkDataArray* array, vtkIdType id)
{
  const int components = array->GetNumberOfComponents();
  if (components == 1)
  {
    return array->GetComponent(id, 0);
  }
  double sum = 0;
  for (int c = 0; c < components; ++c)
  {
    sum += array->GetComponent(id, c) * array->GetComponent(id, c);
  }
  return std::sqrt(sum);
}

std::string CheckColors(vtkDataSet* data, bool onCells, const SplatVectorSettings& settings)
{
  vtkFieldData* attributes = AttributesOf(data, onCells);
  vtkDataArray* array = attributes->GetArray(settings.ColorArrayName.c_str());
  if (!array)
  {
    return std::string(onCells ? "No cell array" : "No point array") + " named '" +
      settings.ColorArrayName +
      "' for the colours of the vectors, which must be where the vectors are. Choose one with SetVectorColorArrayName; arrays there: " +
      NamesOfArrays(attributes) + ".";
  }
  if (!settings.ColorFunction)
  {
    return "VectorColorArrayName is '" + settings.ColorArrayName +
      "', but there is no function for its colours: call SetVectorColorFunction.";
  }
  return CheckLength(data, { array, onCells, 0 });
}
}

std::string CheckVectors(vtkDataSet* data, bool onCells, const SplatVectorSettings& settings)
{
  vtkFieldData* attributes = AttributesOf(data, onCells);
  vtkDataArray* array = attributes->GetArray(settings.ArrayName.c_str());
  if (!array || array->GetNumberOfComponents() != 3)
  {
    // On several ranks of ParaView arrays of points have become arrays of cells: neither word would
    // help.
    return "No array of three components named '" + settings.ArrayName +
      "' for the vectors is where the coloured array is. Choose one with SetVectorArrayName; arrays of three components there: " +
      NamesOfArrays(attributes, 3) + ".";
  }
  const std::string length = CheckLength(data, { array, onCells, 0 });
  return !length.empty() || settings.ColorArrayName.empty() ? length
                                                            : CheckColors(data, onCells, settings);
}

void SplatVectorScene::Update(
  vtkDataSet* data, bool onCells, const SplatSamples& samples, const SplatVectorSettings& settings)
{
  vtkDataArray* array = AttributesOf(data, onCells)->GetArray(settings.ArrayName.c_str());
  const ArrayKey key(array, array->GetMTime());
  if (key != this->ReadFrom)
  {
    this->Vectors.KeepMotion(this->Loop, settings.Loop);
    this->Vectors.Read(data, onCells, array, samples);
    this->ReadFrom = key;
    this->Uploaded = false;
  }
  this->ReadColors(data, onCells, samples, settings);
}

void SplatVectorScene::ReadColors(
  vtkDataSet* data, bool onCells, const SplatSamples& samples, const SplatVectorSettings& settings)
{
  if (settings.ColorArrayName.empty())
  {
    this->Uploaded = this->Uploaded && this->Colors.empty();
    this->Colors.clear();
    this->ColorsFrom = ColorKey(nullptr, 0, nullptr, 0);
    return;
  }
  vtkDataArray* array = AttributesOf(data, onCells)->GetArray(settings.ColorArrayName.c_str());
  const ColorKey key(
    array, array->GetMTime(), settings.ColorFunction, settings.ColorFunction->GetMTime());
  if (key == this->ColorsFrom)
  {
    return;
  }
  settings.ColorFunction->Build();
  this->Colors.resize(samples.Size());
  for (std::size_t i = 0; i < this->Colors.size(); ++i)
  {
    double rgb[3];
    settings.ColorFunction->GetColor(MagnitudeOf(array, samples.Ids[i]), rgb);
    this->Colors[i] = { { float(rgb[0]), float(rgb[1]), float(rgb[2]) } };
  }
  this->ColorsFrom = key;
  this->Uploaded = false;
}

void SplatVectorScene::ForgetSamples()
{
  this->ReadFrom = ArrayKey(nullptr, 0);
  this->ColorsFrom = ColorKey(nullptr, 0, nullptr, 0);
  this->Uploaded = false;
}

std::array<float, 4> SplatVectorScene::ColorOf(
  std::size_t item, const SplatClasses& classes, const SplatVectorSettings& settings) const
{
  const auto sample = static_cast<std::size_t>(classes.Samples[item]);
  const float seed = this->Vectors.SeedOf(sample);
  if (!this->Colors.empty())
  {
    const auto& c = this->Colors[sample];
    return { { c[0], c[1], c[2], seed } };
  }
  if (settings.OneColor)
  {
    const auto& c = settings.Color;
    return { { float(c[0]), float(c[1]), float(c[2]), seed } };
  }
  const auto& c = classes.Colors[item];
  return { { c[0], c[1], c[2], seed } };
}

std::string SplatVectorScene::Upload(vtkOpenGLRenderWindow* window, SplatPass& pass,
  const SplatClasses& classes, const SplatTree& tree, const SplatVectorSettings& settings)
{
  const LookKey look(settings.OneColor, settings.Color);
  std::string error;
  if (!this->Uploaded || look != this->Look)
  {
    std::vector<std::array<float, 4>> colors(classes.Samples.size());
    for (std::size_t i = 0; i < colors.size(); ++i)
    {
      colors[i] = this->ColorOf(i, classes, settings);
    }
    tree.AppendColors(colors);
    error = pass.UploadVectorColors(window, colors);
    this->Look = look;
  }
  if (error.empty() && (!this->Uploaded || !(this->Loop == settings.Loop)))
  {
    std::vector<std::array<float, 4>> vectors = this->Vectors.Pack(classes, settings.Loop);
    tree.AppendVectors(vectors, this->Vectors.PeriodsPerSpeed(settings.Loop));
    for (std::array<float, 4>& vector : vectors)
    {
      vector[3] = static_cast<float>(StoredPhase(vector[3], settings.Loop.Steps));
    }
    error = pass.UploadVectors(window, vectors);
    this->Loop = settings.Loop;
  }
  this->Uploaded = error.empty();
  return error;
}

} // namespace nephoscope

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * From arrays and settings to the vectors that are drawn: what has not changed is not read or
 * copied again.
 */
#ifndef nephoscope_SplatVectorScene_h
#define nephoscope_SplatVectorScene_h

#include "SplatVectors.h"

#include <array>
#include <string>
#include <tuple>

class vtkDataArray;
class vtkDataSet;
class vtkOpenGLRenderWindow;
class vtkScalarsToColors;

namespace nephoscope
{

class SplatPass;
class SplatTree;

struct SplatVectorSettings
{
  std::string ArrayName;                       ///< of the vectors; empty: none
  std::string ColorArrayName;                  ///< empty: no array gives the colour
  vtkScalarsToColors* ColorFunction = nullptr; ///< of that array
  bool OneColor = false;                       ///< otherwise that of the splat
  std::array<double, 3> Color{ { 1, 1, 1 } };
  SplatLoop Loop;
};

/** The problem with the arrays, or an empty string. */
std::string CheckVectors(vtkDataSet* data, bool onCells, const SplatVectorSettings& settings);

class SplatVectorScene
{
public:
  /** Reads the arrays, which CheckVectors has found good. */
  void Update(vtkDataSet* data, bool onCells, const SplatSamples& samples,
    const SplatVectorSettings& settings);

  /** To be called when there are other samples. */
  void ForgetSamples();
  /** To be called when other splats are drawn, or graphics resources are gone. */
  void ForgetUpload() { this->Uploaded = false; }

  /** The nodes of `tree` follow the splats of the classes. */
  std::string Upload(vtkOpenGLRenderWindow* window, SplatPass& pass, const SplatClasses& classes,
    const SplatTree& tree, const SplatVectorSettings& settings);

  bool HasVectors() const { return std::get<0>(this->ReadFrom) != nullptr; }
  SplatVectors& GetVectors() { return this->Vectors; }
  const SplatVectors& GetVectors() const { return this->Vectors; }

private:
  using ArrayKey = std::tuple<vtkDataArray*, vtkMTimeType>;
  using ColorKey = std::tuple<vtkDataArray*, vtkMTimeType, vtkScalarsToColors*, vtkMTimeType>;
  using LookKey = std::tuple<bool, std::array<double, 3>>;

  void ReadColors(vtkDataSet* data, bool onCells, const SplatSamples& samples,
    const SplatVectorSettings& settings);
  std::array<float, 4> ColorOf(
    std::size_t item, const SplatClasses& classes, const SplatVectorSettings& settings) const;

  SplatVectors Vectors;
  std::vector<std::array<float, 3>> Colors; // of all samples; empty: no array gives them
  ArrayKey ReadFrom{ nullptr, 0 };
  ColorKey ColorsFrom{ nullptr, 0, nullptr, 0 };
  LookKey Look{ false, { { 0, 0, 0 } } };
  SplatLoop Loop;
  bool Uploaded = false;
};

} // namespace nephoscope

#endif

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The surface as it is drawn: its cells with float texture coordinates, cover and places, cut where
 * the texture wraps around.
 */
#ifndef nephoscope_TexturedSurface_h
#define nephoscope_TexturedSurface_h

#include "MeanChord.h"

#include "vtkSmartPointer.h"

#include <string>

class vtkPolyData;

namespace nephoscope
{

struct TexturedSurface
{
  vtkSmartPointer<vtkPolyData> Surface; ///< null: nothing can be drawn
  double Center[3] = { 0, 0, 0 };       ///< what places are given from
  double Weights[2] = { 1, 0 };
  double Scale = 1;         ///< repetitions of the texture in one unit of the coordinates
  bool WrapsAround = false; ///< u is a longitude
  bool HasSecondSet = false;
  bool HasWeights = false; ///< of points
  bool HasCover = false;
  bool HasDensity = false;
  MeanChord Chord;     ///< weighted with the density; empty unless it was asked for
  std::string Normals; ///< name of the point normals; empty where there are none
  std::string Error;   ///< what forbids drawing
  std::string Warning; ///< what was put right
};

/** Names of arrays that may be missing are empty. Length and scale 0: from the surface itself. */
struct TextureChoice
{
  std::string Coordinates[2];
  std::string Cover;
  std::string Density;
  double Scale = 0;
  double Length = 0;
  bool MeasureChord = false;
  bool UseAltitude = false;
  double AltitudeRange[2] = { 0, 0 }; ///< not in order: that of the surface
};

/** Names of the arrays of the surface as drawn. */
constexpr const char* textureArrayNames[2] = { "NephoscopeTexture1", "NephoscopeTexture2" };
constexpr const char* coverArrayName = "NephoscopeCover";
constexpr const char* densityArrayName = "NephoscopeDensity";
constexpr const char* weightsArrayName = "NephoscopeWeights";
constexpr const char* placeArrayName = "NephoscopePlace";

TexturedSurface PrepareTexturedSurface(vtkPolyData* input, const TextureChoice& choice);

} // namespace nephoscope

#endif

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Nearest and farthest depth of many small things, such as splats, in squares of pixels.
 *
 * Where rays pass through cells and splats, they have to be drawn in slices only between these
 * depths (VolumeSpans.h). Each thing covers the squares that a cube around it covers: what is found
 * may be too large, never too small.
 */
#ifndef nephoscope_DepthTiles_h
#define nephoscope_DepthTiles_h

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro

#include <array>
#include <vector>

class vtkRenderer;

namespace nephoscope
{

class VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT DepthTiles
{
public:
  static constexpr int Side = 8; ///< of a square, pixels

  DepthTiles(vtkRenderer* renderer, const int viewport[4]);

  /** A cube around a place; both in view coordinates, `reach` is half of an edge. */
  void Add(const std::array<double, 3>& place, double reach);

  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  /** Near and far depth in [0, 1], row by row; 1 and 0 where there is nothing. */
  const std::vector<std::array<float, 2>>& GetRanges() const { return this->Ranges; }

  /** The part of the squares' depths between two distances from the eye's plane, in the mean. */
  double GetFilling(double nearest, double farthest) const;

private:
  struct Rectangle
  {
    std::array<double, 2> Low, High;
  };
  Rectangle RectangleOf(const std::array<double, 3>& place, double reach) const;
  std::array<double, 3> ToDevice(double x, double y, double z) const;
  float DepthAt(double z) const;

  int Width = 0, Height = 0;
  double Pixels[2] = { 0, 0 };
  double Matrix[4][4] = {}; // from view to device coordinates
  bool IsParallel = false;
  std::vector<std::array<float, 2>> Ranges;
};

} // namespace nephoscope

#endif

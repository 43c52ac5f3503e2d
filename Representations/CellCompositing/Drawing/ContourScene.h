// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Contour surfaces inside the cells, ready for the shaders: the values in ascending order with
 * colour and layers, the scalars they are contours of, and the gradients for smooth normals.
 *
 * A point lies above a value when its scalar is at least the value. All is made again only when its
 * source changed.
 */
#ifndef nephoscope_ContourScene_h
#define nephoscope_ContourScene_h

#include "CellGeometry.h"

#include "vtkType.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkDataSet;
class vtkVolumeProperty;

namespace nephoscope
{

struct ContourSettings;

///@{
/** The colour function's colour for a value, and the time of its last change. */
std::array<float, 3> FunctionColor(vtkVolumeProperty* property, double value);
vtkMTimeType ColorMTime(vtkVolumeProperty* property);
///@}

class ContourScene
{
public:
  /** Two texels of the shaders' buffer. */
  struct Contour
  {
    float Value;                  ///< normalised as the scalars
    float LayerBelow, LayerAbove; ///< numbers of tables
    float Unused;
    std::array<float, 4>
      Color; ///< and opacity; red < 0: of the colour function where the surface is
  };

  /**
   * `selection` names the array that is contoured, of points; without an array it is the coloured
   * one. `tables[k]` is the number of the transfer tables of layer k, the one with k values below.
   * To be called after the geometry was built.
   */
  void Update(const CellGeometry& geometry, std::int64_t geometryVersion, vtkDataSet* data,
    const ScalarSelection& selection, const ContourSettings& settings, vtkVolumeProperty* property,
    const std::vector<int>& tables);

  bool IsUsed() const { return !this->Contours.empty(); }
  /** Some surface is not transparent. */
  bool DrawsAny() const { return !this->Drawn.empty(); }
  /** A surface with some opacity is crossed between the least and the greatest scalar. */
  bool DrawsBetween(float low, float high) const;
  /** False where the grid closes on itself, but not the contoured array. */
  bool ClosesWith(const CellGeometry& geometry) const;
  ///@{
  /** The values that are contoured. */
  double GetLeast() const { return this->Range[0]; }
  double GetGreatest() const { return this->Greatest; }
  ///@}
  /** Number of values at or below s. */
  std::size_t FindLayer(float s) const;

  std::vector<Contour> Contours; ///< ascending
  bool OfColor = true;
  bool Smooth = false;
  std::vector<float> Scalars; ///< per point, normalised, NaN where not finite; empty if OfColor
  std::vector<std::array<float, 4>> Gradients; ///< per point if Smooth
  std::int64_t Version = 0;                    ///< grows whenever anything above changed
  std::int64_t FieldVersion = 0;               ///< of scalars and gradients alone

private:
  void UpdateField(const CellGeometry& geometry, std::int64_t geometryVersion, vtkDataSet* data,
    const ScalarSelection& selection, bool smooth);

  double Range[2] = { 0, 1 }; // never equal
  double Greatest = 1;
  std::vector<float> Drawn; // values of the surfaces that are not transparent, ascending

  /** What the surfaces were made from. */
  struct Sources
  {
    std::int64_t Field = 0;
    std::vector<double> Surfaces; ///< value, opacity, red, green, blue of each
    std::vector<int> Tables;
    vtkVolumeProperty* Property = nullptr;
    vtkMTimeType Changed = 0;
    bool operator==(const Sources& other) const;
  };
  /** What scalars and gradients were made from. */
  struct FieldSources
  {
    std::int64_t Geometry = 0;
    bool OfColor = false;
    bool Smooth = false;
    vtkDataArray* Array = nullptr;
    vtkMTimeType Changed = 0;
    bool operator==(const FieldSources& other) const;
  };
  Sources Made;
  FieldSources MadeField;
};

} // namespace nephoscope

#endif

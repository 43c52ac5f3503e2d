// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The volume of a medium and its opacity there, from which all mappers and hosts compute the
 * default unit distance.
 */
#ifndef nephoscope_MediumMeasures_h
#define nephoscope_MediumMeasures_h

#include "MediumProjections.h"

#include "vtkNephoscopeRepresentationsCommonModule.h" // for export macro
#include "vtkType.h"

#include <array>
#include <functional>

class vtkDataArray;
class vtkPiecewiseFunction;

namespace nephoscope
{

/** A box; it holds nothing where a lower bound exceeds the upper one. */
using MediumBounds = std::array<double, 6>;

constexpr MediumBounds NoMediumBounds = { { 1.0, -1.0, 1.0, -1.0, 1.0, -1.0 } };

struct VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT MediumMeasures
{
  double Volume = 0.0;
  double FiniteVolume = 0.0; ///< where the scalar is finite
  double ScalarIntegral = 0.0;
  double OpacityIntegral = 0.0; ///< of the opacity function, where there is one
  double Silhouettes = 0.0;     ///< sum of those of the samples' cells, where samples are measured
  double ScalarRange[2] = { 1.0, -1.0 };
  MediumBounds Bounds = NoMediumBounds; ///< of this process
  /**
   * How far the medium reaches towards each corner of the common bounds: 3 at the corner, sqrt(3)
   * on the inscribed ellipsoid.
   */
  std::array<double, 8> Reach{};
  MediumProjections Projections; ///< in the common bounds

  /** A part of the medium: its box, its volume, and mean values in it. */
  struct Part
  {
    MediumBounds Box;
    double Volume;
    double Scalar;
    double Opacity;
  };

  /**
   * Adds to the integrals; a part whose scalar is not finite contributes only its volume, because
   * it is not drawn.
   */
  void AddPart(const MediumBounds& frame, const Part& part);

  /** Multiplies the integrals if the parts also represent others. */
  void Scale(double factor);

  /**
   * Extends Reach, `frame` being the common bounds, by a box around `place` that extends by `half`
   * to each side.
   */
  void AddPlace(const MediumBounds& frame, const double place[3], const double half[3]);
};

/** The box with a place in it; places that are not finite do not count. */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT void ExtendBounds(
  MediumBounds& bounds, const double place[3]);

/**
 * Which of the samples are measured, where there are many: about 1e5, or `most`, evenly spread, but
 * not at the same place of every row of a grid.
 */
class SampleChoice
{
public:
  explicit SampleChoice(vtkIdType count, vtkIdType most = 100000)
    : Stride(1 + count / most)
  {
  }
  /** Whether the sample with this number is one of them. */
  bool Takes(vtkIdType number) const
  {
    const auto group = static_cast<unsigned long long>(number / this->Stride);
    const auto mixed = (group * 0x9E3779B97F4A7C15ULL) >> 33;
    return number % this->Stride ==
      static_cast<vtkIdType>(mixed % static_cast<unsigned long long>(this->Stride));
  }

  /** For how many each of them stands. */
  vtkIdType Standing() const { return this->Stride; }

private:
  vtkIdType Stride;
};

/** A value of an array of scalars; the magnitude of a vector. */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT double ScalarOf(vtkDataArray* scalars, vtkIdType tuple);

/**
 * Mean length of a ray inside the medium: its volume divided by its mean silhouette, `common` being
 * the bounds that Reach refers to. The mean silhouette of a convex body is a quarter of its surface
 * (Cauchy). It is that of the box of the bounds where the medium reaches into its corners, that of
 * the ellipsoid inside, taken as pi/6 of the box's, where it does not, and in between in
 * proportion. 0 without a volume.
 */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT double MeanChordOf(
  const MediumMeasures& measures, const MediumBounds& common);

/** How many samples a ray through the medium meets on average. */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT double MeanSamples(
  const MediumMeasures& measures, const MediumBounds& common);

/**
 * Mean over the volume of a ramp from 0 to 1 over the scalar's range; 0.5 when the scalar is
 * constant or missing.
 */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT double MeanRamp(const MediumMeasures& measures);

/** Mean optical depth that the default unit distance aims at. */
constexpr double meanOpticalDepth = 2.0;

/** How many times the mean optical depth the rays through opaque places may have. */
constexpr double localOpticalDepth = 2.0;

/**
 * The range of the finite values, or magnitudes, of an array. The array's own is not used: VTK
 * keeps it with the array, and vtkPointDataToCellData hands that of the points on to the cells.
 */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT void FindFiniteRange(
  vtkDataArray* array, double range[2]);

/**
 * The opacity function's value at a scalar divided by its greatest value; none without a function
 * or without opacity.
 */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT std::function<double(double)> FullOpacity(
  vtkPiecewiseFunction* function);

/**
 * The unit distance that gives rays through the medium a mean optical depth of 2, with the opacity
 * function of the measures, scaled to reach 1; without one (`ramp`), with a ramp over the range of
 * the scalar. Where the opacity fills a small part of the medium, the distance is greater, so that
 * rays through that part have a mean optical depth of 4 and its core shows. It depends on the size
 * of the data, not on their resolution. 0 if nothing is opaque, or without a volume.
 */
VTKNEPHOSCOPEREPRESENTATIONSCOMMON_EXPORT double DefaultUnitDistance(
  const MediumMeasures& measures, const MediumBounds& common, bool ramp);

} // namespace nephoscope

#endif

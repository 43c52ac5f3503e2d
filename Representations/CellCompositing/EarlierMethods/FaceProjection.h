// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The faces of the visible tetrahedra on the screen, from back to front by their centroids, for
 * FaceSweep.
 *
 * Faces are cut at the near plane, and the cross-sections of the tetrahedra that reach through it
 * are added, so that what the near plane leaves is a closed volume again.
 */
#ifndef nephoscope_FaceProjection_h
#define nephoscope_FaceProjection_h

#include "FaceMesh.h"

#include <array>
#include <cstdint>
#include <vector>

class vtkMatrix4x4;

namespace nephoscope
{

/** A view of the geometry in pixels. z is the distance from the eye along the view axis. */
class FaceView
{
public:
  FaceView(vtkMatrix4x4* modelToView, vtkMatrix4x4* viewToDevice, const double eyeView[4],
    int width, int height);

  struct Place
  {
    double X, Y; ///< in pixels; the centre of the first pixel is at 0.5
    double Z;
  };
  double Depth(const Vector3& p) const { return this->EyeZ - this->ViewPosition(p)[2]; }
  /** What faces are sorted by: the distance from the eye; in a parallel projection z. */
  double Distance(const Vector3& p) const;
  Place Project(const Vector3& p) const;
  /** z of a depth in [0, 1] at a pixel. */
  double DepthOfBuffer(int x, int y, double depth) const;
  /** Length of a ray per unit of z, sqrt(1 + x^2 + y^2) where it crosses z = 1. */
  double Stretch(int x, int y) const;

  bool IsPerspective() const { return this->Perspective; }
  /** A model matrix with a reflection turns all faces round. */
  bool IsMirrored() const { return this->Mirrored; }
  double GetNear() const { return this->Near; }

  int Width, Height;

private:
  Vector3 ViewPosition(const Vector3& p) const;
  Vector3 ViewPointOfPixel(int x, int y, double deviceZ) const;

  using Matrix = std::array<double, 16>;
  Matrix ModelToView, ModelToDevice, DeviceToView;
  Vector3 Eye; // in view coordinates; of a parallel projection the origin
  double EyeZ;
  double Near;
  bool Perspective;
  bool Mirrored;
};

struct ScreenPoint
{
  FaceView::Place Place;
  float Scalar;  ///< where scalars are those of points
  float Opacity; ///< where opacity scalars are those of points
};

struct ScreenFace
{
  std::array<std::int32_t, 3> Points; ///< counterclockwise on the screen
  std::int32_t Behind;                ///< the visible tetrahedron behind the face, or -1
  std::int32_t InFront;               ///< the visible tetrahedron on the eye's side, or -1
  /** The same places with the values of the other side, where these may be others. */
  std::array<std::int32_t, 3> OtherPoints;
  bool OtherIsInFront; ///< which side that is
  /**
   * What the face adds to the count of crossings: 1 where a ray leaves the volume, -1 where it
   * enters, seen from the eye.
   */
  int Mark() const { return (this->InFront >= 0) - (this->Behind >= 0); }
};

/**
 * Pixel coordinates in steps of 1/1024 are whole numbers: which pixels a face covers is decided
 * without rounding.
 */
constexpr int stepsPerPixel = 1024;
std::array<std::int64_t, 2> SnappedPlace(const FaceView::Place& place);

class FaceProjection
{
public:
  /** `visible` says for each tetrahedron whether it is drawn. */
  void Build(const CellGeometry& geometry, const FaceMesh& mesh,
    const std::vector<std::uint8_t>& visible, const FaceView& view, bool sorted);

  const std::vector<ScreenPoint>& GetPoints() const { return this->Points; }
  const std::vector<ScreenFace>& GetFaces() const { return this->Faces; }

private:
  class Builder;
  std::vector<ScreenPoint> Points;
  std::vector<ScreenFace> Faces;
};

} // namespace nephoscope

#endif

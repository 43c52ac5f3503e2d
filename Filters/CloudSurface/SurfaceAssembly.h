// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Converts the triangles that were contoured in index space to the surface of the clouds: drops
// hidden triangles, merges points at seams and poles, and sets positions, arrays and normals.
#ifndef nephoscope_SurfaceAssembly_h
#define nephoscope_SurfaceAssembly_h

#include "IndexSpaceContour.h"

#include <vector>

class vtkPoints;
class vtkPolyData;

namespace nephoscope
{
class SurfaceAssembly
{
public:
  // `missing`: points without a value.
  SurfaceAssembly(vtkDataSet* grid, const SmoothingPlan& plan, const IndexSpaceSurface& contour,
    const std::vector<unsigned char>& missing);

  void JoinSeams(bool join) { this->Join = join; }

  // Points and arrays of the output. `scalars`: the array that was contoured; `values`: sorted, as
  // they were contoured; `indices`: of each the index that the user gave it.
  void Build(vtkDataArray* scalars, const std::vector<double>& values,
    const std::vector<int>& indices, vtkPolyData* output);

  // Then: the triangles, which face outwards, and "Normals" if wanted.
  void AddTriangles(const std::vector<double>& field, bool withNormals, vtkPolyData* output);

private:
  void FindJoinedPoints();
  void KeepTriangles();
  void NumberPoints();
  bool IsVisible(const vtkIdType* triangle) const;
  bool IsCellVisible(const GridIndex& cell) const;
  void CarryArrays(vtkDataArray* scalars, vtkPolyData* output) const;
  void CarryAtPoles(vtkPolyData* output) const;
  void CarryFromNearerPoint(vtkPolyData* output) const;
  void AddContourIndex(
    const std::vector<double>& values, const std::vector<int>& indices, vtkPolyData* output) const;
  bool FacesInwards(vtkDataArray* normals, vtkPoints* points) const;
  void NearestEdge(vtkIdType point, GridIndex& a, GridIndex& b, double& share) const;

  vtkDataSet* Grid;
  const SmoothingPlan& Plan;
  const IndexSpaceSurface& Contour;
  const std::vector<unsigned char>& Missing;
  const bool AnyHidden; // a point or perhaps a cell
  bool Join = true;
  std::vector<vtkIdType>
    Representative; // of each contoured point, the one in its place; empty: itself
  std::vector<vtkIdType>
    Triangles; // three contoured points each, then, after NumberPoints, three of the output
  std::vector<vtkIdType> Sources; // of each point of the output, the contoured one
};
}

#endif

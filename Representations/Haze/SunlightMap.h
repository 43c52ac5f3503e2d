// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The fraction of the sun's beam that lit clouds let through to every place: on a lattice whose
 * third axis points towards the sun.
 */
#ifndef nephoscope_SunlightMap_h
#define nephoscope_SunlightMap_h

#include "HazeScene.h"

#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkSmartPointer.h"

#include <array>
#include <vector>

class vtkDataSet;
class vtkMatrix4x4;

namespace nephoscope
{

struct LitClouds
{
  vtkSmartPointer<vtkDataSet> Data; ///< with the point array SunTransmittance
  vtkSmartPointer<vtkMatrix4x4> ToWorld;
};

class SunlightMap
{
public:
  /**
   * `towardsSun` has length 1. Inside the meshes of clouds the map holds their array. Behind them
   * the beam keeps the strength with which it has left the last face, and behind two clouds that of
   * the darker one. All ranks call this together, with what clouds they have.
   */
  SunlightMap(const std::vector<LitClouds>& clouds, const double towardsSun[3],
    const MaximumOfRanks& maximum);

  /** Fractions on the lattice, an array of floats; null: no rank has clouds. */
  vtkImageData* GetImage() const { return this->Image; }

  /**
   * From places in the world to (0 ... 1)^3, with the nodes of the lattice at the centres of
   * texels. Below 0 on the third axis, the fraction is that at 0.
   */
  vtkMatrix4x4* GetFromWorld() const { return this->FromWorld; }

private:
  void FindFrame(const double towardsSun[3]);
  bool FindLattice(const std::vector<LitClouds>& clouds, const MaximumOfRanks& maximum);
  /** `clouds` have the fractions alone. */
  void SampleInside(vtkDataSet* clouds, vtkMatrix4x4* toSun, std::vector<double>& fractions) const;
  void SampleFaces(vtkDataSet* clouds, vtkMatrix4x4* toSun, std::vector<double>& fractions) const;

  using Corner = std::array<double, 4>; // place and fraction
  Corner InLattice(const double place[3], vtkMatrix4x4* toSun) const;
  void Shade(const std::array<Corner, 3>& triangle, std::vector<double>& fractions) const;

  vtkNew<vtkMatrix4x4> ToSun; // from the world
  vtkNew<vtkMatrix4x4> FromWorld;
  vtkSmartPointer<vtkImageData> Image;
};

} // namespace nephoscope

#endif

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkGlobeTerrain
 * @brief   terrain heights as a surface on a globe or a map, with a flat sea
 *
 *     rectilinear, image or structured grid of one level: longitude deg, latitude deg, an array of
 *     heights
 *                                |
 *     place as vtkGlobeGrid does -> sea at height 0 -> Terrain, Normals, TextureCoordinates
 *                                |
 *     vtkStructuredGrid of one level, in metres
 *
 * The terrain under clouds, figure 1 of Max, Crawfis and Becker, "New Techniques in 3D Scalar and
 * Vector Field Visualization", Pacific Graphics 1993: coloured by its altitude with its own colour
 * scale. Use the projection of the vtkGlobeGrid of the clouds; the exaggeration may differ. It is
 * opaque geometry: clouds, smoke and haze end at it.
 *
 * Point arrays written, besides those of the input: Height, float, m, 0 in the sea; Terrain (active
 * scalars), float, m: on land the height, in the sea 0 at the coast to -SeaDepth far from it, for
 * colour maps that are blue below 0; Normals (float, 3, length 1); TextureCoordinates (float, 2) of
 * a plate carree picture from 180 W to 180 E. Field data as of vtkGlobeGrid.
 */
#ifndef vtkGlobeTerrain_h
#define vtkGlobeTerrain_h

#include "vtkGlobeGrid.h"

class VTKNEPHOSCOPEFILTERSGLOBEGRID_EXPORT vtkGlobeTerrain : public vtkGlobeGrid
{
public:
  static vtkGlobeTerrain* New();
  vtkTypeMacro(vtkGlobeTerrain, vtkGlobeGrid);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the array of land fractions, on points or cells as the heights are; 0.5 and more is
   * land. Default "lsm". Without such an array, points above sea level are land.
   */
  vtkSetMacro(LandArrayName, std::string);
  vtkGetMacro(LandArrayName, std::string);
  ///@}

  ///@{
  /**
   * Depth below 0 of the array Terrain in the open sea, in m, 0 or more. It affects the colour
   * only; the sea is flat. Default 100.
   */
  vtkSetClampMacro(SeaDepth, double, 0.0, 20000.0);
  vtkGetMacro(SeaDepth, double);
  ///@}

protected:
  vtkGlobeTerrain();
  ~vtkGlobeTerrain() override = default;

  int RequestData(
    vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkGlobeTerrain(const vtkGlobeTerrain&) = delete;
  void operator=(const vtkGlobeTerrain&) = delete;

  bool IsTerrain(vtkDataSet* input);

  std::string LandArrayName = "lsm";
  double SeaDepth = 100.0;
  vtkMTimeType Failed = 0; // for ReportOnce
};

#endif

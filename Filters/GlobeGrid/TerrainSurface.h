// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What makes a level of heights, placed on a globe or a map, a terrain: a flat sea, one array to
// colour it by, normals and texture coordinates.
#ifndef nephoscope_TerrainSurface_h
#define nephoscope_TerrainSurface_h

class vtkDataArray;
class vtkStructuredGrid;

namespace nephoscope
{
struct TerrainPlace
{
  bool OnGlobe;
  double Radius; // of the planet, m
};

// Sea are the points whose land fraction is below 0.5; without `land`, those that are not above sea
// level. They are put at height 0.
void FlattenSea(vtkStructuredGrid* terrain, vtkDataArray* land, const TerrainPlace& place);

// Writes the array Terrain, float, m: on land the height, 0 or more; in the sea from 0 at a land
// fraction of 0.5 to -`depth` at 0, so that a colour map tells them apart and the coast lies
// between the points. To be called after FlattenSea.
void AddTerrainScale(vtkStructuredGrid* terrain, vtkDataArray* land, double depth);

// Writes Normals, upwards, of length 1, from differences along both axes, across the seam too; at a
// pole the mean of the next row.
void AddTerrainNormals(vtkStructuredGrid* terrain, const TerrainPlace& place);

// Writes TextureCoordinates of a plate carree picture from 180 W to 180 E and from 90 S to 90 N.
// They grow along a row without a jump, beyond 0 to 1 if need be: textures must repeat.
void AddTerrainTextureCoordinates(vtkStructuredGrid* terrain, const TerrainPlace& place);
}

#endif

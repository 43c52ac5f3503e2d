// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** What surfaces need so that the view can cut them between ranks and put the pieces together. */
#ifndef nephoscope_CuttableSurface_h
#define nephoscope_CuttableSurface_h

class vtkPolyData;

namespace nephoscope
{

/**
 * Divides each polygon of more than three corners into triangles at its first corner, as VTK's mapper does when it draws them; cell arrays follow.
 * Where the view cuts a surface between ranks, the pieces of such triangles are drawn as the whole; those of polygons are not.
 */
void fanPolygons(vtkPolyData* surface);

/**
 * Gives points global ids. Without any the view merges points in one place where it appends the pieces of several ranks (vtkAppendFilter), and a sharp
 * edge or a seam of the texture gets the normals or coordinates of one side. Ids of the data become ordinary
 * numbers, which the view keeps.
 */
void keepPointsApart(vtkPolyData* surface, int rank);

} // namespace nephoscope

#endif

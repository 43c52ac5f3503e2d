// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Which arrays of its input vtkCellCompositingMapper reads, and what it says of those that cannot
// be drawn.
#include "vtkCellCompositingMapper.h"

#include "ArraySelection.h"
#include "CellCompositingInternals.h"
#include "CellGeometry.h"
#include "ContourSettings.h"
#include "PointGradients.h"
#include "TetrahedraAmongCells.h"
#include "UniformMedium.h"

#include "vtkAbstractMapper.h"
#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeProperty.h"

#include <algorithm>
#include <set>
#include <sstream>

#if __has_include("vtkCellTypeUtilities.h") // VTK 9.6 deprecates the name lookup of vtkCellTypes
#include "vtkCellTypeUtilities.h"
using CellTypeNames = vtkCellTypeUtilities;
#else
#include "vtkCellTypes.h"
using CellTypeNames = vtkCellTypes;
#endif

using nephoscope::CellGeometry;
using nephoscope::CheckLength;
using nephoscope::NamesOfArrays;
using nephoscope::ScalarSelection;

std::string vtkCellCompositingMapper::SelectContours(
  vtkDataSet* input, const ScalarSelection& scalars, ScalarSelection& contoured)
{
  contoured = {};
  const std::string& name = this->Contours->ArrayName;
  if (this->Contours->Surfaces.empty())
  {
    return std::string();
  }
  if (name.empty())
  {
    const char* colored = scalars.Array->GetName();
    if (colored && colored == std::string(nephoscope::uniformMediumName))
    {
      return "No array is coloured: choose a point array to contour. Point arrays: " +
        NamesOfArrays(input->GetPointData()) + ".";
    }
    return scalars.OnCells && this->Contours->DrawsSurfaces() &&
        !this->Contours->ContoursMakeLayers()
      ? "The coloured array is a cell array, which has no contour surfaces inside its cells: apply Cell Data to Point "
        "Data, or choose a point array to contour. Point arrays: " +
        NamesOfArrays(input->GetPointData()) + "."
      : std::string();
  }
  contoured.Array = input->GetPointData()->GetArray(name.c_str());
  if (!contoured.Array)
  {
    const bool onCells = input->GetCellData()->GetArray(name.c_str()) != nullptr;
    return "No point array named '" + name + "' to contour" +
      (onCells ? "; a cell array has no surfaces inside its cells: apply Cell Data to Point Data. "
               : ". ") +
      "Point arrays: " + NamesOfArrays(input->GetPointData()) + ".";
  }
  return CheckLength(input, contoured);
}

std::string vtkCellCompositingMapper::SelectLayers(vtkDataSet* input, vtkDataArray*& layers)
{
  layers = nullptr;
  const std::string& name = this->Contours->LayerArrayName;
  if (name.empty() || this->Contours->LayerProperties.empty())
  {
    return std::string();
  }
  layers = input->GetCellData()->GetArray(name.c_str());
  if (!layers)
  {
    return "No cell array named '" + name +
      "' for the layers. Cell arrays: " + NamesOfArrays(input->GetCellData()) + ".";
  }
  return CheckLength(input, { layers, true, 0 });
}

namespace
{
std::string CellsAre(vtkIdType count)
{
  return std::to_string(count) + (count == 1 ? " cell is" : " cells are");
}

// Where `count` cells lack a value, and what helps.
std::string Place(bool onCells, vtkIdType count)
{
  const std::string place = onCells ? "there" : count == 1 ? "at its points" : "at their points";
  return place + ". Blank such " + (onCells ? "cells" : "points") + ", or replace the values.";
}

// The polygons that vtkContourCellSplitter adds to the pieces of cells; they are no mistake.
vtkIdType CountContourPolygons(vtkDataSet* input)
{
  vtkDataArray* contours = input->GetCellData()->GetArray("ContourIndex");
  vtkIdType count = 0;
  for (vtkIdType cell = 0; contours && cell < contours->GetNumberOfTuples(); ++cell)
  {
    count += contours->GetComponent(cell, 0) >= 0 ? 1 : 0;
  }
  return count;
}

bool HasCopies(vtkUnsignedCharArray* ghosts)
{
  bool has = false;
  for (vtkIdType cell = 0; ghosts && cell < ghosts->GetNumberOfValues(); ++cell)
  {
    has = has || (ghosts->GetValue(cell) & vtkDataSetAttributes::DUPLICATECELL) != 0;
  }
  return has;
}
}

void vtkCellCompositingMapper::WarnAboutGeometry(vtkDataSet* input, const CellGeometry& geometry,
  const ScalarSelection& scalars, const ScalarSelection& opacity)
{
  const auto quoted = [](vtkDataArray* array) {
    return std::string("'") + (array->GetName() ? array->GetName() : "(unnamed)") + "'";
  };
  const std::string names = quoted(scalars.Array) +
    (opacity.Array && opacity.Array != scalars.Array ? ", " + quoted(opacity.Array) : "");

  const bool none = geometry.NumberOfTetrahedra() == 0;
  const std::string leftOut = geometry.NumberOfInvalidCells > 0
    ? (none ? "Nothing is drawn: " : "") + CellsAre(geometry.NumberOfInvalidCells) +
      (none ? " left out" : " not drawn") + " because array " + names +
      " or a coordinate is not finite " + Place(scalars.OnCells, geometry.NumberOfInvalidCells)
    : std::string();
  if (this->Internals->LeftOut.IsNew(leftOut)) // ranks get the same data again
  {
    vtkWarningMacro(<< leftOut);
  }
  // Polygons beside 3-D cells have messages of their own.
  const vtkIdType others = geometry.NumberOfUnsupportedCells -
    std::max<vtkIdType>(CountContourPolygons(input),
      geometry.NumberOfTetrahedra() > 0
        ? this->Internals->Scene.GetPolygons().GetPolygons().NumberOfPolygons
        : 0);
  if (others > 0)
  {
    const char* type = CellTypeNames::GetClassNameFromTypeId(geometry.UnsupportedCellType);
    vtkWarningMacro(<< CellsAre(others) << " not drawn (" << type
                    << (others == 1 ? "" : ", for example")
                    << "): only 3-D cells can be composited.");
  }
  if (geometry.NumberOfNonConvexCells > 0)
  {
    vtkWarningMacro(<< geometry.NumberOfNonConvexCells
                    << (geometry.NumberOfNonConvexCells == 1 ? " polyhedron is" : " polyhedra are")
                    << " not convex and drawn wrong: run vtkPolyhedronToTetrahedra first.");
  }
  if (geometry.NumberOfWarpedCells > 0 && geometry.Hexahedra.empty())
  {
    vtkWarningMacro(
      << CellsAre(geometry.NumberOfWarpedCells)
      << " drawn wrong: so warped that the tetrahedra they are divided into overlap. Set CellInterpolation to Trilinear, and draw "
         "layers and polygons without these cells.");
  }
  this->WarnAboutFolds(input, geometry);
  this->WarnAboutInterpolation(input, geometry);
  // On several processes one may have copies of the others' cells alone.
  const bool isTold = geometry.NumberOfInvalidCells + geometry.NumberOfUnsupportedCells > 0;
  if (geometry.NumberOfTetrahedra() == 0 && input->GetNumberOfCells() > 0 && !isTold &&
    !HasCopies(input->GetCellGhostArray()))
  {
    const vtkIdType count = input->GetNumberOfCells();
    const std::string which = count == 1
      ? "the only cell is hidden or has no volume."
      : "of " + std::to_string(count) + " cells, all are hidden or have no volume.";
    vtkWarningMacro(<< "Nothing is drawn: " << which);
  }
}

// Trilinear cells were asked for, and the mesh has none.
void vtkCellCompositingMapper::WarnAboutInterpolation(
  vtkDataSet* input, const CellGeometry& geometry)
{
  if (this->CellInterpolation != TRILINEAR_INTERPOLATION || geometry.NumberOfTetrahedra() == 0)
  {
    return;
  }
  const std::set<int> types = nephoscope::CellTypesOf(input);
  std::string reason;
  bool isDivided = types.empty(); // cells that have a trilinear field
  for (const int type : types)
  {
    isDivided =
      isDivided || (type != VTK_TETRA && nephoscope::HexahedronFormOf(type).Tetrahedra > 0);
    reason = nephoscope::IsOtherSolid(type) ? std::string("there are others among them (") +
        CellTypeNames::GetClassNameFromTypeId(type) + "). Draw these as a dataset of their own."
                                            : reason;
  }
  if (this->HasPolygonsOrLayers())
  {
    reason = "polygons in faces and layers need it.";
  }
  if (isDivided && !reason.empty())
  {
    vtkWarningMacro(<< "No cell is drawn as trilinear: all are divided into tetrahedra, because "
                    << reason);
  }
}

// Cells that fold over themselves, as they are numbered or in any order of their points.
void vtkCellCompositingMapper::WarnAboutFolds(vtkDataSet* input, const CellGeometry& geometry)
{
  const std::int64_t misnumbered = geometry.NumberOfMisnumberedCells;
  const std::int64_t folded = geometry.NumberOfFoldedCells, count = misnumbered + folded;
  std::ostringstream warning;
  if (count > 0)
  {
    double bounds[6];
    input->GetCellBounds(geometry.FirstFoldedCell, bounds);
    const bool one = count == 1;
    warning << count
            << (one ? " cell folds over itself: cell "
                    : " cells fold over themselves, the first is cell ")
            << geometry.FirstFoldedCell << " near (" << 0.5 * (bounds[0] + bounds[1]) << ", "
            << 0.5 * (bounds[2] + bounds[3]) << ", " << 0.5 * (bounds[4] + bounds[5]) << ").";
    if (misnumbered > 0)
    {
      warning
        << (folded > 0 ? " The points of " + std::to_string(misnumbered) + " are"
               : one   ? " Its points are"
                       : " Their points are")
        << " numbered in a wrong order, and drawn in the right one. Correct the order where the mesh is made.";
    }
    if (folded > 0)
    {
      warning
        << (misnumbered > 0 ? " The others are"
               : one        ? " It is"
                            : " They are")
        << " drawn inexactly. Move the points where the mesh is made; vtkMeshQuality finds such cells by a scaled Jacobian below 0.";
    }
  }
  if (this->Internals->FoldWarning.IsNew(warning.str())) // ranks get the same data again
  {
    vtkWarningMacro(<< warning.str());
  }
}

void vtkCellCompositingMapper::WarnAboutContours(const std::string& reason)
{
  this->Internals->HasContours = reason.empty();
  if (this->Internals->ContourWarning.IsNew(reason))
  {
    vtkWarningMacro(<< "Contour surfaces are not drawn. " << reason);
  }
}

// Values that none of several time steps has are told once.
void vtkCellCompositingMapper::WarnAboutContourValues()
{
  const nephoscope::ContourScene& contours = this->Internals->Scene.GetContours();
  if (!contours.DrawsAny())
  {
    return;
  }
  vtkDataArray* ofAll =
    this->GetDataSetInput()->GetFieldData()->GetArray(nephoscope::storedContourRangeName);
  const double low = ofAll ? ofAll->GetComponent(0, 0) : contours.GetLeast();
  const double high = ofAll ? ofAll->GetComponent(1, 0) : contours.GetGreatest();
  const auto& surfaces = this->Contours->Surfaces;
  const bool isSeen = std::any_of(surfaces.begin(), surfaces.end(), [&](const auto& surface) {
    return surface.Opacity > 0 && surface.Value >= low && surface.Value <= high;
  });
  vtkDataArray* array = this->Internals->Contoured.Array ? this->Internals->Contoured.Array
                                                         : this->Internals->Scalars.Array;
  std::ostringstream values, warning;
  for (const auto& surface : surfaces)
  {
    values << (values.str().empty() ? "" : ", ") << surface.Value;
  }
  values << " of '" << (array->GetName() ? array->GetName() : "(unnamed)") << "'";
  if (!isSeen && this->Internals->ContourValuesWarning.IsNew(values.str()))
  {
    warning << "No contour surface is seen: there are none at " << values.str()
            << ", whose values ";
    (low < high ? warning << "go from " << low << " to " << high : warning << "are all " << low)
      << ".";
    vtkWarningMacro(<< warning.str());
  }
}

void vtkCellCompositingMapper::WarnAboutPolygons()
{
  const nephoscope::CellPolygons& polygons = this->Internals->Scene.GetPolygons().GetPolygons();
  const auto notDrawn = [](vtkIdType count) {
    return std::to_string(count) + (count == 1 ? " polygon is" : " polygons are") + " not drawn: ";
  };
  const bool asked = this->GetPolygons() == CONTOUR_POLYGONS;
  const std::string others = asked && polygons.NumberOfOthers > 0
    ? notDrawn(polygons.NumberOfOthers) +
      "call SetPolygonsToAll() to composite those that lie in faces of cells, or leave them out of the mesh."
    : "";
  const std::string apart = polygons.NumberApart > 0
    ? notDrawn(polygons.NumberApart) + (polygons.NumberApart == 1 ? "it does" : "they do") +
      " not lie in faces of cells. Show such polygons separately, as a surface: if the renderer peels volumes, it is drawn at its depth among the cells."
    : "";
  if (this->Internals->PolygonWarnings[0].IsNew(others))
  {
    vtkWarningMacro(<< others);
  }
  if (this->Internals->PolygonWarnings[1].IsNew(apart))
  {
    vtkWarningMacro(<< apart);
  }
}

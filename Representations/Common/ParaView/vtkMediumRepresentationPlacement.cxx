// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Position, Orientation, Scale and Origin of the display: of the prop on one rank, of the data on
// several.
#include "vtkMediumRepresentation.h"

#include "DataBlocks.h"
#include "MovedData.h"
#include "vtkMediumVolume.h"

#include "vtkActor.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"

namespace
{
const char* const movedName = "NephoscopeMoved";

void CopyPlacement(vtkProp3D* from, vtkProp3D* to)
{
  to->SetOrigin(from->GetOrigin());
  to->SetPosition(from->GetPosition());
  to->SetOrientation(from->GetOrientation());
  to->SetScale(from->GetScale());
}
}

void vtkMediumRepresentation::SetOrientation(double x, double y, double z)
{
  this->Placement->SetOrientation(x, y, z);
  this->FollowPlacement();
}

void vtkMediumRepresentation::SetOrigin(double x, double y, double z)
{
  this->Placement->SetOrigin(x, y, z);
  this->FollowPlacement();
}

void vtkMediumRepresentation::SetPosition(double x, double y, double z)
{
  this->Placement->SetPosition(x, y, z);
  this->FollowPlacement();
}

void vtkMediumRepresentation::SetScale(double x, double y, double z)
{
  this->Placement->SetScale(x, y, z);
  this->FollowPlacement();
}

void vtkMediumRepresentation::FollowPlacement()
{
  CopyPlacement(this->Placement, this->Actor);
  if (GetNumberOfRanks() > 1 &&
    (this->HasMovedPiece || nephoscope::TurnsOrShifts(this->Placement->GetMatrix())))
  {
    this->MarkModified();
  }
}

void vtkMediumRepresentation::PlacePiece()
{
  vtkMatrix4x4* matrix = this->Placement->GetMatrix();
  this->HasMovedPiece = GetNumberOfRanks() > 1 && nephoscope::TurnsOrShifts(matrix);
  if (this->HasMovedPiece)
  {
    this->MovePiece(matrix);
    nephoscope::StoreNumbers(this->Piece, movedName, { 1.0 });
  }
  this->PlaceActor(this->Piece);
}

void vtkMediumRepresentation::MovePiece(vtkMatrix4x4* matrix)
{
  this->Piece = nephoscope::MovedData(this->Piece, matrix);
  if (vtkMath::AreBoundsInitialized(this->DataBounds))
  {
    nephoscope::MoveBounds(this->DataBounds, matrix);
  }
}

// A client knows by the data that they have been moved on the ranks of its server.
void vtkMediumRepresentation::PlaceActor(vtkDataSet* data)
{
  const bool moved = data->GetFieldData()->HasArray(movedName);
  vtkNew<vtkActor> nowhere;
  CopyPlacement(moved ? nowhere : this->Placement, this->Actor);
}

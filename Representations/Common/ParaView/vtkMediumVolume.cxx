// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumVolume.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkDataSet.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkMediumVolume);

double* vtkMediumVolume::GetBounds()
{
  double* bounds = this->Superclass::GetBounds();
  if (!bounds || !vtkMath::AreBoundsInitialized(bounds) || !this->SeenBounds.IsValid())
  {
    return bounds;
  }
  vtkBoundingBox seen;
  for (int i = 0; i < 8; ++i)
  {
    double corner[4] = { 0, 0, 0, 1 };
    this->SeenBounds.GetCorner(i, corner);
    this->GetMatrix()->MultiplyPoint(corner, corner);
    seen.AddPoint(corner);
  }
  if (seen.IntersectBox(vtkBoundingBox(bounds)))
  {
    seen.GetBounds(bounds);
  }
  return bounds;
}

int vtkMediumVolume::RenderVolumetricGeometry(vtkViewport* viewport)
{
  vtkAbstractVolumeMapper* mapper = this->GetMapper();
  if (!mapper || mapper->GetNumberOfInputConnections(0) == 0)
  {
    return 0;
  }
  mapper->Update();
  vtkDataSet* data = mapper->GetDataSetInput();
  if (!data || data->GetNumberOfPoints() == 0)
  {
    return 0; // a rank without a piece
  }
  mapper->Render(static_cast<vtkRenderer*>(viewport), this);
  this->EstimatedRenderTime += mapper->GetTimeToDraw();
  return 1;
}

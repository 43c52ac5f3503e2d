// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCellCompositingVolume.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkDataSet.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkCellCompositingVolume);

int vtkCellCompositingVolume::RenderVolumetricGeometry(vtkViewport* viewport)
{
  vtkInformation* keys = this->GetPropertyKeys();
  if (keys && keys->Has(vtkOpenGLRenderPass::RenderPasses()))
  {
    this->Postponed = true; // the pass calls once per peel
    return 0;
  }
  return this->Draw(viewport);
}

int vtkCellCompositingVolume::RenderOverlay(vtkViewport* viewport)
{
  if (!this->Postponed)
  {
    return 0;
  }
  this->Postponed = false;
  return this->Draw(viewport);
}

int vtkCellCompositingVolume::Draw(vtkViewport* viewport)
{
  vtkAbstractVolumeMapper* mapper = this->GetMapper();
  if (!mapper || mapper->GetNumberOfInputConnections(0) == 0)
  {
    return 0;
  }
  mapper->Update();
  vtkDataSet* data = mapper->GetDataSetInput();
  if (!data || data->GetNumberOfCells() == 0)
  {
    return 0; // a rank without a piece
  }
  mapper->Render(static_cast<vtkRenderer*>(viewport), this);
  this->EstimatedRenderTime += mapper->GetTimeToDraw();
  return 1;
}

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMediumVolume.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkRenderer.h"

vtkStandardNewMacro(vtkMediumVolume);

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

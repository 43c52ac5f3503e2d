// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What ShallowCopy() of a volume mapper copies beside its own settings: vtkAbstractMapper has the
 * clipping planes alone.
 */
#ifndef nephoscope_MapperSettings_h
#define nephoscope_MapperSettings_h

#include "vtkAbstractVolumeMapper.h"
#include "vtkNew.h"
#include "vtkPlane.h"
#include "vtkPlaneCollection.h"

namespace nephoscope
{

inline void CopyInputAndScalars(vtkAbstractVolumeMapper* from, vtkAbstractVolumeMapper* to)
{
  to->SetInputConnection(
    0, from->GetNumberOfInputConnections(0) > 0 ? from->GetInputConnection(0, 0) : nullptr);
  to->SetScalarMode(from->GetScalarMode());
  if (from->GetArrayAccessMode() == VTK_GET_ARRAY_BY_NAME)
  {
    to->SelectScalarArray(from->GetArrayName());
  }
  else
  {
    to->SelectScalarArray(from->GetArrayId());
  }
}

/** The input, the choice of scalars, and a list of its own of the same clipping planes. */
inline void CopyVolumeSettings(vtkAbstractVolumeMapper* from, vtkAbstractVolumeMapper* to)
{
  CopyInputAndScalars(from, to);
  if (from->GetClippingPlanes())
  {
    vtkNew<vtkPlaneCollection> planes;
    for (int i = 0; i < from->GetNumberOfClippingPlanes(); ++i)
    {
      planes->AddItem(from->GetClippingPlanes()->GetItem(i));
    }
    to->SetClippingPlanes(planes);
  }
}

} // namespace nephoscope

#endif

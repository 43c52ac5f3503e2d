// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** The render passes that draw a prop: they leave their keys with it. */
#ifndef nephoscope_PeelingPass_h
#define nephoscope_PeelingPass_h

#include "vtkDualDepthPeelingPass.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkOpenGLRenderPass.h"
#include "vtkProp.h"

namespace nephoscope
{

/** Calls work(pass) for every render pass that has left its key with the prop. */
template <typename Work>
void ForEachPass(vtkProp* prop, Work work)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  vtkInformationObjectBaseVectorKey* key = vtkOpenGLRenderPass::RenderPasses();
  const int count = keys && keys->Has(key) ? keys->Length(key) : 0;
  for (int i = 0; i < count; ++i)
  {
    if (auto* pass = vtkOpenGLRenderPass::SafeDownCast(vtkObject::SafeDownCast(keys->Get(key, i))))
    {
      work(pass);
    }
  }
}

/** The pass that peels this prop; null where none does. */
inline vtkDualDepthPeelingPass* PeelingPass(vtkProp* prop)
{
  vtkDualDepthPeelingPass* found = nullptr;
  ForEachPass(prop, [&](vtkOpenGLRenderPass* pass) {
    if (auto* peeling = vtkDualDepthPeelingPass::SafeDownCast(pass))
    {
      found = peeling;
    }
  });
  return found;
}

} // namespace nephoscope

#endif

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HazeShaderPass.h"

#include "HazeFragmentFunctions.h"
#include "HazeView.h"

#include "vtkInformation.h"
#include "vtkInformationObjectBaseVectorKey.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkProp.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

namespace nephoscope
{

vtkStandardNewMacro(HazeShaderPass);

namespace
{
// Volumes have shaders of other kinds.
template <typename Function>
void ForEachSurface(vtkRenderer* renderer, const Function& function)
{
  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    if (!vtkVolume::SafeDownCast(prop))
    {
      function(prop);
    }
  }
}
}

void HazeShaderPass::Enter(vtkRenderer* renderer)
{
  this->Renderer = renderer;
  const std::string functions = HazeView(renderer).Definition();
  if (functions != this->Functions)
  {
    this->Functions = functions;
    this->FunctionsTime.Modified();
  }
  ForEachSurface(renderer, [this](vtkProp* prop) {
    vtkInformation* keys = prop->GetPropertyKeys();
    if (!keys)
    {
      vtkNew<vtkInformation> own;
      prop->SetPropertyKeys(own);
      keys = own;
    }
    keys->Append(vtkOpenGLRenderPass::RenderPasses(), this);
  });
}

void HazeShaderPass::Leave(vtkRenderer* renderer)
{
  ForEachSurface(renderer, [this](vtkProp* prop) {
    vtkInformation* keys = prop->GetPropertyKeys();
    if (keys && keys->Has(vtkOpenGLRenderPass::RenderPasses()))
    {
      keys->Remove(vtkOpenGLRenderPass::RenderPasses(), this);
      if (keys->Length(vtkOpenGLRenderPass::RenderPasses()) == 0)
      {
        keys->Remove(vtkOpenGLRenderPass::RenderPasses());
      }
    }
  });
  this->Renderer = nullptr;
}

// Where the colour is known and before depth peeling takes it: its tag is there in all versions of
// VTK.
bool HazeShaderPass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp*)
{
  const std::string dec = "//VTK::DepthPeeling::Dec", impl = "//VTK::DepthPeeling::Impl";
  vtkShaderProgram::Substitute(
    fragmentShader, dec, this->Functions + HazeFragmentFunctions + dec, false);
  vtkShaderProgram::Substitute(fragmentShader, impl,
    "gl_FragData[0].rgb = hazedColor(gl_FragData[0].rgb, hazeFragmentVC());\n  " + impl, false);
  return true;
}

bool HazeShaderPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper*, vtkProp*, vtkOpenGLVertexArrayObject*)
{
  if (this->Renderer)
  {
    HazeView(this->Renderer).SetUniforms(program);
  }
  return true;
}

} // namespace nephoscope

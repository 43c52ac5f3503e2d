// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "HazeShadows.h"

#include "DataSets.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"
#include "vtkTextureObject.h"
#include "vtkVolume.h"

#include <algorithm>
#include <functional>
#include <sstream>

namespace nephoscope
{
namespace
{
constexpr double sameSun = 0.9994; // cosine of 2 degrees

void ForEachLitVolume(
  vtkRenderer* renderer, const std::function<void(vtkVolume*, vtkDataSet*)>& body)
{
  vtkCollectionSimpleIterator iterator;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(iterator);
  while (vtkProp* prop = props->GetNextProp(iterator))
  {
    auto* volume = vtkVolume::SafeDownCast(prop);
    vtkAlgorithm* mapper = volume && volume->GetVisibility() ? volume->GetMapper() : nullptr;
    vtkDataObject* data = mapper && mapper->GetNumberOfInputConnections(0) > 0
      ? mapper->GetInputDataObject(0, 0)
      : nullptr;
    ForEachLeaf(data, [&](vtkDataObject* leaf) {
      auto* set = vtkDataSet::SafeDownCast(leaf);
      vtkDataArray* fraction = set ? set->GetPointData()->GetArray("SunTransmittance") : nullptr;
      if (fraction && fraction->GetNumberOfTuples() == set->GetNumberOfPoints() &&
        !set->IsA("vtkPolyData") && set->GetNumberOfCells() > 0)
      {
        body(volume, set);
      }
    });
  }
}

// The sun that data were lit by; false where they do not tell.
bool SunOf(vtkDataSet* data, double sun[3])
{
  vtkDataArray* told = data->GetFieldData()->GetArray("SunDirection");
  if (!told || told->GetNumberOfTuples() < 1 || told->GetNumberOfComponents() != 3)
  {
    return false;
  }
  told->GetTuple(0, sun);
  return vtkMath::Normalize(sun) > 0;
}

std::string OtherSun(const double towardsSun[3], const double ofClouds[3])
{
  std::ostringstream words;
  words << "Clouds cast no shadows in the haze: they are lit by a sun in the direction ("
        << ofClouds[0] << ", " << ofClouds[1] << ", " << ofClouds[2]
        << "), and the haze by one in the direction (" << towardsSun[0] << ", " << towardsSun[1]
        << ", " << towardsSun[2]
        << "). Give both the same sun, or turn the cloud shadows of the haze off.";
  return words.str();
}
}

HazeShadows::HazeShadows()
  : Window([this](vtkWindow* window) {
    this->Uploaded = false;
    this->Texture->ReleaseGraphicsResources(window);
  })
{
}

HazeShadows::~HazeShadows() = default;

std::vector<LitClouds> HazeShadows::FindClouds(vtkRenderer* renderer, const double towardsSun[3])
{
  std::vector<LitClouds> clouds;
  this->Problem.clear();
  ForEachLitVolume(renderer, [&](vtkVolume* volume, vtkDataSet* data) {
    auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    volume->GetMatrix(matrix);
    double sun[4] = { 0, 0, 0, 0 };
    if (SunOf(data, sun) && vtkMath::Dot(sun, towardsSun) < sameSun)
    {
      double turned[4]; // with the volume
      matrix->MultiplyPoint(sun, turned);
      vtkMath::Normalize(turned);
      if (vtkMath::Dot(turned, towardsSun) < sameSun)
      {
        this->Problem = OtherSun(towardsSun, sun);
        return;
      }
    }
    clouds.push_back({ data, matrix });
  });
  return clouds;
}

void HazeShadows::Find(
  vtkRenderer* renderer, const double* towardsSun, const MaximumOfRanks& maximum)
{
  if (!towardsSun)
  {
    this->Forget();
    return;
  }
  std::vector<Version> versions;
  ForEachLitVolume(renderer, [&](vtkVolume* volume, vtkDataSet* data) {
    vtkNew<vtkMatrix4x4> matrix;
    volume->GetMatrix(matrix);
    std::array<double, 16> elements;
    std::copy_n(matrix->GetData(), 16, elements.begin());
    versions.emplace_back(data, data->GetMTime(), elements);
  });
  double changed =
    !this->Map || versions != this->Versions || !std::equal(towardsSun, towardsSun + 3, this->Sun);
  maximum(&changed, 1);
  if (changed > 0)
  {
    this->Map =
      std::make_unique<SunlightMap>(this->FindClouds(renderer, towardsSun), towardsSun, maximum);
    this->Versions = std::move(versions);
    std::copy_n(towardsSun, 3, this->Sun);
    this->Uploaded = false;
  }
}

void HazeShadows::Forget()
{
  this->Map.reset();
  this->Versions.clear();
  this->Problem.clear();
}

void HazeShadows::Upload(vtkOpenGLRenderWindow* window)
{
  const int* size = this->Map->GetImage()->GetDimensions();
  this->Texture->SetContext(window);
  this->Texture->Create3DFromRaw(static_cast<unsigned int>(size[0]),
    static_cast<unsigned int>(size[1]), static_cast<unsigned int>(size[2]), 1, VTK_FLOAT,
    this->Map->GetImage()->GetPointData()->GetScalars()->GetVoidPointer(0));
  this->Texture->SetMinificationFilter(vtkTextureObject::Linear);
  this->Texture->SetMagnificationFilter(vtkTextureObject::Linear);
  this->Texture->SetWrapS(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapT(vtkTextureObject::ClampToEdge);
  this->Texture->SetWrapR(vtkTextureObject::ClampToEdge);
  this->Uploaded = true;
}

void HazeShadows::Bind(vtkOpenGLRenderWindow* window)
{
  if (!this->Exist() || !window)
  {
    return;
  }
  this->Window.Enter(window);
  if (!this->Uploaded)
  {
    this->Upload(window);
  }
  this->Texture->Activate();
  this->Unit = this->Texture->GetTextureUnit();
}

void HazeShadows::Unbind()
{
  if (this->Unit >= 0)
  {
    this->Texture->Deactivate();
    this->Unit = -1;
  }
}

} // namespace nephoscope

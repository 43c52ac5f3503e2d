// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Several volumes of one renderer: those that may cover one another are drawn at once, as one
// medium, by the first of them.
#include "vtkCellCompositingMapper.h"

#include "CellCompositingInternals.h"
#include "CellsInOrder.h"
#include "CoveredPixels.h"
#include "ViewState.h"
#include "VolumeSlices.h"
#include "vtkCellCompositingProjectedTetrahedraMapper.h"
#include "vtkCellCompositingRayCastMapper.h"

#include "vtkDataSet.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPropCollection.h"
#include "vtkRenderer.h"

#include <algorithm>

using nephoscope::PixelRegion;
using nephoscope::VolumeOrder;

namespace
{
vtkCellCompositingMapper* MapperOf(vtkVolume* volume)
{
  vtkAbstractVolumeMapper* mapper = volume->GetMapper();
  if (auto* inPlace = vtkCellCompositingProjectedTetrahedraMapper::SafeDownCast(mapper))
  {
    return inPlace->GetCellCompositingMapper();
  }
  if (auto* inPlace = vtkCellCompositingRayCastMapper::SafeDownCast(mapper))
  {
    return inPlace->GetCellCompositingMapper();
  }
  return vtkCellCompositingMapper::SafeDownCast(mapper);
}

PixelRegion PixelsOf(vtkRenderer* renderer, const double bounds[6])
{
  const double origin[3] = { 0, 0, 0 };
  const vtkNew<vtkVolume> world;
  const nephoscope::ViewState state(renderer, world, origin);
  int viewport[4] = { 0, 0, 0, 0 };
  renderer->GetTiledSizeAndOrigin(&viewport[2], &viewport[3], &viewport[0], &viewport[1]);
  nephoscope::PointBounds box;
  box.Add({ { bounds[0], bounds[2], bounds[4] } });
  box.Add({ { bounds[1], bounds[3], bounds[5] } });
  return nephoscope::CoveredPixels(state.View, box, viewport);
}

}

VolumeOrder::Part nephoscope::CellsInOrder::PartOf(
  const std::function<vtkCellCompositingMapper*()>& find)
{
  const auto draw = [find](vtkRenderer* renderer, vtkVolume* volume) {
    find()->DrawInOrder(renderer, volume);
  };
  const auto mixes = [find](vtkRenderer* renderer, vtkVolume*) -> std::size_t {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    return window && find()->ReasonToBeAlone(window).empty() ? RayMedia::Most : 1;
  };
  const auto mayBeSliced = [find]() { return !find()->DrawsTrianglesOrFaces(); };
  return { draw, mixes, mayBeSliced, {}, VolumeSlices::PerPass };
}

// Empty, or why this volume cannot be drawn together with others.
std::string vtkCellCompositingMapper::ReasonToBeAlone(vtkOpenGLRenderWindow* window)
{
  vtkDataSet* input = this->GetDataSetInput();
  if (!input || input->GetNumberOfCells() == 0)
  {
    return "it has no cells";
  }
  if (this->Method != RAY_METHOD && this->Method != AUTOMATIC_METHOD)
  {
    return "its method is neither Automatic nor Rays";
  }
  if (this->Method == AUTOMATIC_METHOD && this->VisibilityOrder != EXACT_ORDER)
  {
    return "its order is not Exact";
  }
  if (this->Integration != EXACT_INTEGRATION)
  {
    return "its integration is not Exact";
  }
  if (this->GetNumberOfContourValues() > 0)
  {
    return "it has contour values";
  }
  this->Internals->Scene.ReadPolygons(input, *this->Contours);
  if (this->Internals->Scene.GetPolygons().IsUsed())
  {
    return "it has polygons between its cells";
  }
  return this->ChooseWayOfDrawing(window).empty() && this->UsesRays()
    ? std::string()
    : "this OpenGL driver does not draw rays correctly";
}

void vtkCellCompositingMapper::WarnAboutMedia(int kind, const std::string& warning)
{
  if (this->Internals->MediaWarnings[kind].IsNew(warning))
  {
    vtkWarningMacro(<< warning);
  }
}

// This volume and those that it may cover, or they one another, in the renderer's order.
std::vector<vtkCellCompositingMapper::vtkMedium> vtkCellCompositingMapper::FindMedia(
  vtkOpenGLRenderWindow* window, vtkRenderer* renderer, vtkVolume* volume)
{
  struct Candidate
  {
    vtkMedium Medium;
    PixelRegion Pixels;
    bool Joined;
  };
  this->GetInputAlgorithm()->Update();
  const std::string reason = this->ReasonToBeAlone(window);
  const vtkMedium alone = { this, volume };
  std::vector<Candidate> candidates;
  bool covers = false;
  vtkCollectionSimpleIterator place;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(place);
  while (vtkProp* prop = props->GetNextProp(place))
  {
    auto* other = vtkVolume::SafeDownCast(prop);
    vtkCellCompositingMapper* mapper = other ? MapperOf(other) : nullptr;
    if (!mapper || !mapper->GetInputAlgorithm() || (mapper != this && !VolumeOrder::IsDrawn(other)))
    {
      continue;
    }
    const double* bounds = other->GetBounds();
    covers = covers || (mapper != this && bounds && VolumeOrder::Overlap(other, volume));
    if (mapper == this || mapper->ReasonToBeAlone(window).empty())
    {
      candidates.push_back(
        { { mapper, other }, PixelsOf(renderer, other->GetBounds()), mapper == this });
    }
  }
  this->WarnAboutMedia(0,
    covers && !reason.empty() && !nephoscope::VolumeSlices::GetCurrent()
      ? "This volume and another one overlap in space, but are not composited as one medium, because " +
        reason + ": the one that is drawn later covers the other."
      : std::string());
  const std::vector<Candidate> all = candidates;
  const auto isShared = [&all](const Candidate& candidate) { // by several volumes
    return std::count_if(all.begin(), all.end(), [&](const Candidate& other) {
      return other.Medium.Mapper == candidate.Medium.Mapper;
    }) > 1;
  };
  candidates.erase(
    std::remove_if(candidates.begin(), candidates.end(), isShared), candidates.end());
  const bool isListed = std::any_of(candidates.begin(), candidates.end(),
    [](const Candidate& candidate) { return candidate.Joined; });
  if (!reason.empty() || !isListed)
  {
    return { alone };
  }
  // Those that are apart are drawn one after another where something else may have to be drawn
  // between them.
  const bool overlapping =
    candidates.size() > nephoscope::RayMedia::Most || VolumeOrder::HasOthers(renderer);
  for (bool found = true; found;)
  {
    found = false;
    for (Candidate& candidate : candidates)
    {
      const bool joins = !candidate.Joined &&
        std::any_of(candidates.begin(), candidates.end(), [&](const Candidate& other) {
          return other.Joined && nephoscope::HaveCommonPixels(candidate.Pixels, other.Pixels) &&
            (!overlapping || VolumeOrder::Overlap(candidate.Medium.Volume, other.Medium.Volume));
        });
      candidate.Joined = candidate.Joined || joins;
      found = found || joins;
    }
  }
  std::vector<vtkMedium> media;
  for (const Candidate& candidate : candidates)
  {
    if (candidate.Joined)
    {
      media.push_back(candidate.Medium);
    }
  }
  return media;
}

void vtkCellCompositingMapper::DrawMedia(
  vtkOpenGLRenderWindow* window, const std::vector<vtkMedium>& media)
{
  std::vector<nephoscope::CellCompositingPass::Medium> together;
  for (const vtkMedium& medium : media)
  {
    vtkInternals& internals = *medium.Mapper->Internals;
    together.push_back({ &internals.Pass, &internals.View->View, &internals.Options });
  }
  vtkInternals& first = *media.front().Mapper->Internals;
  std::string reason;
  if (media.size() > 1 && first.MediaRefused)
  {
    reason =
      "this OpenGL driver does not compile the shader that would composite them as one medium";
  }
  else if (media.size() > nephoscope::RayMedia::Most ||
    !nephoscope::CellCompositingPass::CanDrawMedia(together))
  {
    reason = "these are more than can be composited as one medium here";
  }
  this->WarnAboutMedia(1,
    media.size() < 2 || reason.empty() || nephoscope::VolumeSlices::GetCurrent()
      ? std::string()
      : std::to_string(media.size()) + " volumes may cover one another, and " + reason +
        ": they are drawn one over the other. Append their data to one.");
  if (media.size() < 2 || !reason.empty())
  {
    for (const vtkMedium& medium : media)
    {
      medium.Mapper->ReportOnce(medium.Mapper->DrawScene(window, medium.Volume));
    }
    return;
  }
  for (const vtkMedium& medium : media)
  {
    medium.Mapper->Internals->Picture =
      medium.Mapper == media.front().Mapper ? nullptr : media.front().Mapper;
  }
  const std::string error = first.Peeled
    ? first.Pass.DrawMediaPeel(window, together, { media.front().Mapper, media.front().Volume })
    : first.Pass.DrawMedia(window, together);
  first.MediaRefused = error == nephoscope::RayMedia::NotCompiled;
  if (first.MediaRefused && !first.Peeled)
  {
    this->DrawMedia(window, media);
    return;
  }
  media.front().Mapper->ReportOnce(error);
}

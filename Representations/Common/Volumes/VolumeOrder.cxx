// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VolumeOrder.h"

#include "ReportedError.h"
#include "VolumePeel.h"
#include "VolumeSlices.h"

#include "vtkAbstractVolumeMapper.h"
#include "vtkBoundingBox.h"
#include "vtkCamera.h"
#include "vtkProp3D.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <memory>
#include <mutex>

namespace nephoscope
{
namespace
{
using Volumes = std::vector<vtkVolume*>;
struct Enrolled
{
  VolumeOrder::Part Part;
  std::shared_ptr<VolumeSlices> Slices; // of the first volume of a renderer
  ReportedError Surfaces;
};
using Parts = std::map<vtkAbstractVolumeMapper*, Enrolled>;

std::mutex partsMutex;

Parts& AllParts() // lives as long as the last mapper
{
  static auto* parts = new Parts;
  return *parts;
}

const VolumeOrder::Part* PartOf(vtkAbstractVolumeMapper* mapper)
{
  const std::lock_guard<std::mutex> lock(partsMutex);
  const auto found = AllParts().find(mapper);
  return found == AllParts().end() ? nullptr : &found->second.Part;
}

const VolumeOrder::Part* PartOf(vtkVolume* volume)
{
  return PartOf(volume->GetMapper());
}

VolumeSlices& SlicesOf(vtkVolume* volume)
{
  const std::lock_guard<std::mutex> lock(partsMutex);
  std::shared_ptr<VolumeSlices>& slices = AllParts()[volume->GetMapper()].Slices;
  if (!slices)
  {
    slices = std::make_shared<VolumeSlices>();
  }
  return *slices;
}

// GetBounds() of a mapper may point to what the next call changes.
std::array<double, 6> BoxOf(vtkProp3D* prop)
{
  std::array<double, 6> box;
  std::copy_n(prop->GetBounds(), 6, box.begin());
  return box;
}

/** Whether all of them are drawn as one medium. */
bool AreMedium(vtkRenderer* renderer, const Volumes& volumes)
{
  return std::all_of(volumes.begin(), volumes.end(), [&](vtkVolume* volume) {
    return PartOf(volume)->Mixes(renderer, volume) >= std::max<std::size_t>(volumes.size(), 2);
  });
}

bool MaySlice(const Volumes& volumes)
{
  return std::all_of(volumes.begin(), volumes.end(),
    [](vtkVolume* volume) { return PartOf(volume)->MayBeSliced(); });
}

/** Those of a group that are drawn as one medium, together; the others alone. */
std::vector<VolumeSlices::Medium> MediaOf(vtkRenderer* renderer, const Volumes& group)
{
  const auto mixes = [&](vtkVolume* volume) { return PartOf(volume)->Mixes(renderer, volume); };
  Volumes mixed;
  std::copy_if(group.begin(), group.end(), std::back_inserter(mixed),
    [&](vtkVolume* volume) { return mixes(volume) > 1; });
  const bool areOne = AreMedium(renderer, mixed);
  std::vector<VolumeSlices::Medium> media;
  for (vtkVolume* volume : group)
  {
    const bool isMixed = areOne && mixes(volume) > 1;
    if (!isMixed || volume == mixed.front())
    {
      media.push_back({ isMixed ? mixed : Volumes(1, volume), PartOf(volume)->AddTo,
        PartOf(volume)->SlicesAtOnce });
    }
  }
  return media;
}

Volumes DrawnVolumes(vtkRenderer* renderer)
{
  Volumes volumes;
  vtkCollectionSimpleIterator place;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(place);
  while (vtkProp* prop = props->GetNextProp(place))
  {
    auto* volume = vtkVolume::SafeDownCast(prop);
    if (volume && PartOf(volume) && VolumeOrder::IsDrawn(volume))
    {
      volumes.push_back(volume);
    }
  }
  return volumes;
}

/**
 * -1: the low side of an axis is in front, 1: the high side; 0: no ray meets both. `low` and `high`
 * bound a gap.
 */
int SideInFront(vtkCamera* camera, int axis, double low, double high)
{
  const double eye = camera->GetPosition()[axis];
  const double towardsEye = -camera->GetDirectionOfProjection()[axis];
  if (camera->GetParallelProjection())
  {
    return towardsEye > 0 ? 1 : towardsEye < 0 ? -1 : 0;
  }
  return eye >= high ? 1 : eye <= low ? -1 : 0;
}

bool IsBehind(vtkCamera* camera, vtkProp3D* a, vtkProp3D* b)
{
  const std::array<double, 6> boxA = BoxOf(a);
  const std::array<double, 6> boxB = BoxOf(b);
  bool behind = false;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double aLow = boxA[2 * axis], aHigh = boxA[2 * axis + 1];
    const double bLow = boxB[2 * axis], bHigh = boxB[2 * axis + 1];
    if (aHigh <= bLow || bHigh <= aLow)
    {
      const bool aIsLow = aHigh <= bLow;
      const int front = SideInFront(camera, axis, aIsLow ? aHigh : bHigh, aIsLow ? bLow : aLow);
      if ((front == 1) != aIsLow || front == 0)
      {
        return false;
      }
      behind = true;
    }
  }
  return behind;
}

/** Volumes that overlap in space and cannot be one medium, together; each group once. */
std::vector<Volumes> GroupsOf(vtkRenderer* renderer, Volumes volumes)
{
  std::vector<Volumes> groups;
  while (!volumes.empty())
  {
    Volumes group(1, volumes.front());
    volumes.erase(volumes.begin());
    for (std::size_t i = 0; i < group.size(); ++i)
    {
      vtkVolume* member = group[i];
      const auto isApart = [member](
                             vtkVolume* other) { return !VolumeOrder::Overlap(member, other); };
      const auto met = std::stable_partition(volumes.begin(), volumes.end(), isApart);
      group.insert(group.end(), met, volumes.end());
      volumes.erase(met, volumes.end());
    }
    if (AreMedium(renderer, group) || !MaySlice(group)) // as a medium, its first volume draws all
    {
      for (vtkVolume* member : group)
      {
        groups.push_back({ member });
      }
    }
    else
    {
      groups.push_back(group);
    }
  }
  return groups;
}

bool IsBehind(vtkCamera* camera, const Volumes& a, const Volumes& b)
{
  return std::any_of(a.begin(), a.end(), [&](vtkVolume* one) {
    return std::any_of(
      b.begin(), b.end(), [&](vtkVolume* other) { return IsBehind(camera, one, other); });
  });
}

/** From back to front; where boxes surround one another in a circle, in the order of adding. */
std::vector<Volumes> Sorted(vtkCamera* camera, std::vector<Volumes> groups)
{
  std::vector<Volumes> order;
  while (!groups.empty())
  {
    auto next = std::find_if(groups.begin(), groups.end(), [&](const Volumes& group) {
      return std::none_of(groups.begin(), groups.end(),
        [&](const Volumes& other) { return &other != &group && IsBehind(camera, other, group); });
    });
    next = next == groups.end() ? groups.begin() : next;
    order.push_back(*next);
    groups.erase(next);
  }
  return order;
}

// Surfaces, and texts in space, which later releases of VTK draw as translucent.
bool IsTranslucent(vtkProp3D* prop)
{
  const double* bounds = prop->GetVisibility() ? prop->GetBounds() : nullptr;
  return bounds && vtkBoundingBox::IsValid(bounds) && prop->HasTranslucentPolygonalGeometry();
}

/** Whether VTK has drawn a translucent surface behind the volume that is not behind it. */
bool CoversSurfaces(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkCollectionSimpleIterator place;
  vtkPropCollection* props = renderer->GetViewProps();
  props->InitTraversal(place);
  while (vtkProp* prop = props->GetNextProp(place))
  {
    auto* one = vtkProp3D::SafeDownCast(prop);
    if (one && IsTranslucent(one) && !IsBehind(renderer->GetActiveCamera(), one, volume))
    {
      return true;
    }
  }
  return false;
}

// ParaView draws the first picture of a view twice, at first without peeling.
bool IsSetToPeel(vtkRenderer* renderer)
{
  return renderer->GetUseDepthPeeling() && renderer->GetUseDepthPeelingForVolumes() &&
    renderer->GetRenderWindow()->GetMultiSamples() == 0;
}

void WarnAboutSurfaces(vtkAbstractVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  const bool covers = VolumeOrder::IsDrawn(volume) && !VolumePeel::IsRequested(volume) &&
    !IsSetToPeel(renderer) && CoversSurfaces(renderer, volume);
  bool isNew = false;
  {
    const std::lock_guard<std::mutex> lock(partsMutex);
    isNew = AllParts()[mapper].Surfaces.IsNew(covers ? "surfaces" : "");
  }
  if (isNew)
  {
    vtkWarningWithObjectMacro(mapper,
      "A translucent surface in front of or inside this volume is drawn behind it, because the renderer does not peel "
      "volumes. Call its UseDepthPeelingOn(), UseDepthPeelingForVolumesOn() and SetOcclusionRatio(0), and SetMultiSamples(0) of the "
      "window (in ParaView: Edit > Settings > Render View > Depth Peeling, and Depth Peeling for Volumes).");
  }
}

void DrawOne(vtkRenderer* renderer, vtkVolume* volume)
{
  PartOf(volume)->Draw(renderer, volume);
}
}

void VolumeOrder::Enrol(vtkAbstractVolumeMapper* mapper, const Part& part)
{
  const std::lock_guard<std::mutex> lock(partsMutex);
  AllParts()[mapper].Part = part;
}

void VolumeOrder::Leave(vtkAbstractVolumeMapper* mapper)
{
  const std::lock_guard<std::mutex> lock(partsMutex);
  AllParts().erase(mapper);
}

void VolumeOrder::ReleaseGraphicsResources(vtkAbstractVolumeMapper* mapper, vtkWindow* window)
{
  const std::lock_guard<std::mutex> lock(partsMutex);
  const auto found = AllParts().find(mapper);
  if (found != AllParts().end() && found->second.Slices)
  {
    found->second.Slices->ReleaseGraphicsResources(window);
  }
}

bool VolumeOrder::IsEnrolled(vtkVolume* volume)
{
  return PartOf(volume) != nullptr;
}

bool VolumeOrder::IsDrawn(vtkVolume* volume)
{
  const double* bounds = volume->GetVisibility() ? volume->GetBounds() : nullptr;
  return bounds && vtkBoundingBox::IsValid(bounds) && volume->GetRenderTimeMultiplier() > 0;
}

bool VolumeOrder::Overlap(vtkVolume* a, vtkVolume* b)
{
  const std::array<double, 6> boxA = BoxOf(a);
  const std::array<double, 6> boxB = BoxOf(b);
  for (int axis = 0; axis < 6; axis += 2)
  {
    if (boxA[axis + 1] <= boxB[axis] || boxB[axis + 1] <= boxA[axis])
    {
      return false;
    }
  }
  return true;
}

bool VolumeOrder::HasOthers(vtkRenderer* renderer)
{
  const Volumes volumes = DrawnVolumes(renderer);
  return std::any_of(volumes.begin(), volumes.end(),
    [&](vtkVolume* volume) { return !AreMedium(renderer, { volume }); });
}

void VolumeOrder::Draw(vtkAbstractVolumeMapper* mapper, vtkRenderer* renderer, vtkVolume* volume)
{
  WarnAboutSurfaces(mapper, renderer, volume);
  const Volumes volumes = DrawnVolumes(renderer);
  if (volumes.size() < 2 || std::find(volumes.begin(), volumes.end(), volume) == volumes.end())
  {
    PartOf(mapper)->Draw(renderer, volume);
    return;
  }
  if (volume != volumes.front())
  {
    return; // the first draws all
  }
  VolumeSlices& slices = SlicesOf(volume);
  for (const Volumes& group : Sorted(renderer->GetActiveCamera(), GroupsOf(renderer, volumes)))
  {
    if (group.size() == 1)
    {
      DrawOne(renderer, group.front());
    }
    else
    {
      slices.Draw(renderer, group, MediaOf(renderer, group), DrawOne);
    }
  }
}

} // namespace nephoscope

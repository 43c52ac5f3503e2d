// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSplatSpeedKey.h"

#include "RoundTime.h"
#include "vtkTexturedSplatMapper.h"

#include "vtkCamera.h"
#include "vtkCoordinate.h"
#include "vtkLeaderActor2D.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkObjectFactory.h"
#include "vtkPropCollection.h"
#include "vtkProperty2D.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkScalarBarActor.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTextRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <sstream>

vtkStandardNewMacro(vtkSplatSpeedKey);

namespace
{
constexpr double shortest = 75.0; // pixels that the longest vectors move in the time of the arrow
constexpr double longest = 0.22;  // of the width of the view
constexpr double gap = 6.0;       // pixels between keys
constexpr double veil = 0.6;      // opacity of the background of the words
constexpr double smallest = 0.7;  // size of the letters in a small view, of that which was set
constexpr double widest = 0.6;    // of the width of the view: the words stay in a corner
constexpr double full[2] = { 600.0,
  450.0 }; // pixels of a view with letters of the size that was set

std::string NumberText(double number)
{
  std::ostringstream text;
  text.precision(4);
  text << number;
  return text.str();
}

std::string LengthText(double metres)
{
  return metres >= 1000.0 ? NumberText(metres / 1000.0) + " km" : NumberText(metres) + " m";
}

std::string TimeText(double seconds)
{
  constexpr double minute = 60.0, hour = 3600.0, day = 86400.0;
  return seconds >= day ? NumberText(seconds / day) + (seconds == day ? " day" : " days")
    : seconds >= hour   ? NumberText(seconds / hour) + " h"
    : seconds >= minute ? NumberText(seconds / minute) + " min"
                        : NumberText(seconds) + " s";
}

using Box = std::array<double, 4>; // left, right, bottom and top

bool Overlap(const Box& a, const Box& b)
{
  return a[0] < b[1] && b[0] < a[1] && a[2] < b[3] && b[2] < a[3];
}

// With the title, which may stand above the frame of the bar.
Box BoxOf(vtkScalarBarActor* bar, vtkViewport* viewport)
{
  const double* corner = bar->GetPositionCoordinate()->GetComputedDoubleViewportValue(viewport);
  const double left = corner[0], bottom = corner[1];
  const double* other = bar->GetPosition2Coordinate()->GetComputedDoubleViewportValue(viewport);
  const double title = bar->GetTitle() && bar->GetTitle()[0] != '\0'
    ? bar->GetTitleTextProperty()->GetFontSize()
    : 0.0;
  return { { left, other[0], bottom, other[1] + title } };
}

// The first free place for the box from its bottom upwards, or where it is if there is none.
double FreeBottom(Box box, const std::vector<Box>& taken, double height)
{
  const double wanted = box[2], size = box[3] - box[2];
  for (std::size_t i = 0; i <= taken.size(); ++i)
  {
    const auto hit = std::find_if(
      taken.begin(), taken.end(), [&](const Box& other) { return Overlap(box, other); });
    if (hit == taken.end())
    {
      return box[3] <= height ? box[2] : wanted;
    }
    box[2] = (*hit)[3] + gap;
    box[3] = box[2] + size;
  }
  return wanted;
}

double WidthOf(const std::string& text, vtkTextProperty* style, int dpi)
{
  std::array<int, 4> box{ { 0, -1, 0, -1 } };
  vtkTextRenderer* renderer = vtkTextRenderer::GetInstance();
  return renderer && renderer->GetBoundingBox(style, text, box.data(), dpi) ? box[1] - box[0] + 1
                                                                            : 0;
}

bool IsNumber(const std::string& word)
{
  const std::size_t first = word.find_first_not_of('(');
  return first != std::string::npos && word.back() != ')' &&
    std::isdigit(static_cast<unsigned char>(word[first]));
}

// A number with its unit is one word.
bool NextWord(std::istringstream& words, std::string& word)
{
  std::string unit;
  const bool found = static_cast<bool>(words >> word);
  if (found && IsNumber(word) && words >> unit)
  {
    word += " " + unit;
  }
  return found;
}

// With the words that do not fit into the width on lines of their own.
std::string Broken(const std::string& text, vtkTextProperty* style, int dpi, double width)
{
  std::istringstream lines(text);
  std::string result, line;
  while (std::getline(lines, line))
  {
    std::istringstream words(line);
    std::string part, word;
    while (NextWord(words, word))
    {
      const std::string longer = part.empty() ? word : part + " " + word;
      const bool fits = part.empty() || WidthOf(longer, style, dpi) <= width;
      result += fits ? "" : part + "\n";
      part = fits ? longer : word;
    }
    result += part + "\n";
  }
  result.pop_back();
  return result;
}

// Pixels of a unit of length at the focal point.
double PixelsOfUnit(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkCamera* camera = renderer->GetActiveCamera();
  const double height = camera->GetParallelProjection() ? 2.0 * camera->GetParallelScale()
                                                        : 2.0 * camera->GetDistance() *
      std::tan(vtkMath::RadiansFromDegrees(camera->GetViewAngle() / 2));
  const double scale = std::cbrt(std::abs(volume->GetMatrix()->Determinant()));
  const int* size = renderer->GetSize();
  const int pixels = camera->GetUseHorizontalViewAngle() ? size[0] : size[1];
  return height > 0.0 ? scale * pixels / height : 0.0;
}
}

vtkSplatSpeedKey::vtkSplatSpeedKey()
{
  this->PositionCoordinate->SetCoordinateSystemToNormalizedViewport();
  this->PositionCoordinate->SetValue(0.03, 0.03);
  this->Words->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  this->Style->SetFontSize(16);
  this->Style->SetLineSpacing(1.15);
  this->Style->SetBackgroundOpacity(veil);
  this->Style->SetVerticalJustificationToBottom();
  this->Arrow->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  this->Arrow->GetPosition2Coordinate()->SetCoordinateSystemToViewport();
  this->Arrow->GetPosition2Coordinate()->SetReferenceCoordinate(nullptr);
  this->Arrow->SetArrowPlacementToPoint2();
  this->Arrow->SetArrowStyleToFilled();
  this->Arrow->GetProperty()->SetLineWidth(2);
}

vtkSplatSpeedKey::~vtkSplatSpeedKey() = default;

void vtkSplatSpeedKey::SetVolume(vtkVolume* volume)
{
  if (volume != this->Volume)
  {
    this->Volume = volume;
    this->Modified();
  }
}

vtkVolume* vtkSplatSpeedKey::GetVolume()
{
  return this->Volume;
}

vtkTextProperty* vtkSplatSpeedKey::GetTextProperty()
{
  return this->Style;
}

std::string vtkSplatSpeedKey::GetText()
{
  return this->Text;
}

vtkTexturedSplatMapper* vtkSplatSpeedKey::GetDrawnMapper(vtkViewport* viewport)
{
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  auto* mapper =
    this->Volume ? vtkTexturedSplatMapper::SafeDownCast(this->Volume->GetMapper()) : nullptr;
  if (!renderer || !mapper || mapper->GetVectorArrayName().empty() ||
    !this->Volume->GetVisibility() || !(mapper->GetDrawnMaximumSpeed() > 0.0))
  {
    return nullptr;
  }
  vtkRendererCollection* renderers = renderer->GetRenderWindow()->GetRenderers();
  vtkCollectionSimpleIterator at;
  renderers->InitTraversal(at);
  while (vtkRenderer* other = renderers->GetNextRenderer(at))
  {
    if (other->HasViewProp(this->Volume))
    {
      return mapper;
    }
  }
  return nullptr;
}

// `arrow`: its length in pixels, of which a unit of length has `pixels`; at most `most`.
std::string vtkSplatSpeedKey::Describe(
  vtkTexturedSplatMapper* mapper, double pixels, double most, double& arrow)
{
  const bool metres = this->SpeedUnit == "m/s";
  const std::string unit = this->SpeedUnit.empty() ? "" : " " + this->SpeedUnit;
  const double greatest = mapper->GetDrawnMaximumSpeed();
  const double passing = mapper->GetDrawnTimeScale() * this->FilmUnitSeconds;
  std::string text;
  arrow = 0.0;
  if (mapper->GetTrueSpeed() && passing > 0.0 && pixels > 0.0)
  {
    // A round number of seconds in which the way of the longest vectors is long enough; at least
    // one.
    const double needed = shortest / (greatest * passing * pixels);
    const double below = nephoscope::RoundDown(std::max(needed, 1.0));
    const double seconds = below < needed ? nephoscope::RoundDown(2.5 * below) : below;
    const double speed =
      nephoscope::RoundDown(std::min(greatest, most / (passing * seconds * pixels)));
    const double way = speed * passing * seconds;
    arrow = way * pixels;
    const std::string film = NumberText(seconds) + " " + this->FilmUnit;
    text = (unit.empty() ? "speed " : "") + NumberText(speed) + unit + " moves this far (" +
      (metres ? LengthText(way * this->LengthUnit) : NumberText(way)) + ") in " + film + "\n" +
      (seconds == 1.0 ? film : "1 " + this->FilmUnit) + " shows " +
      (metres ? TimeText(passing * this->LengthUnit)
              : NumberText(passing) + " of the data's time") +
      "\n";
  }
  const char* kind = mapper->GetVectorStyle() == vtkTexturedSplatMapper::SEGMENTS
    ? "longest segments: "
    : "fastest streaks: ";
  return text + kind + (unit.empty() ? "speed " : "") + NumberText(greatest) + unit;
}

// In letters, and in lines, that fit into the view.
void vtkSplatSpeedKey::Write(vtkViewport* viewport, bool hasArrow)
{
  const int dpi = viewport->GetVTKWindow()->GetDPI();
  const double left = this->PositionCoordinate->GetComputedDoubleViewportValue(viewport)[0];
  const int* size = viewport->GetSize();
  const double room = std::max(std::min(widest * size[0], size[0] - left - gap), 1.0);
  const double share = std::min({ room / std::max(WidthOf(this->Text, this->Style, dpi), 1.0),
    size[0] / full[0], size[1] / full[1] });
  vtkNew<vtkTextProperty> style;
  style->ShallowCopy(this->Style);
  style->SetFontSize(
    static_cast<int>(std::floor(this->Style->GetFontSize() * std::clamp(share, smallest, 1.0))));
  const std::string text = Broken(this->Text, style, dpi, room);
  this->Words->GetTextProperty()->ShallowCopy(style);
  this->Words->SetInput(
    (hasArrow ? " \n" + text : text).c_str()); // the first line is that of the arrow
}

void vtkSplatSpeedKey::Place(vtkViewport* viewport, double arrow)
{
  const double* corner = this->PositionCoordinate->GetComputedDoubleViewportValue(viewport);
  const double x = corner[0];
  double y = corner[1], size[2];
  this->Words->GetSize(viewport, size);
  std::vector<Box> taken;
  for (vtkSplatSpeedKey* key : this->GetEarlierKeys(viewport))
  {
    taken.push_back(key->Rectangle);
  }
  vtkPropCollection* props = viewport->GetViewProps();
  vtkCollectionSimpleIterator at;
  props->InitTraversal(at);
  while (vtkProp* prop = props->GetNextProp(at))
  {
    auto* bar = vtkScalarBarActor::SafeDownCast(prop);
    if (bar && bar->GetVisibility())
    {
      taken.push_back(BoxOf(bar, viewport));
    }
  }
  this->Rectangle = { { x, x + std::max(size[0], arrow), y, y + size[1] } };
  y = FreeBottom(this->Rectangle, taken, viewport->GetSize()[1]);
  this->Rectangle[2] = y;
  this->Rectangle[3] = y + size[1];
  this->Words->GetPositionCoordinate()->SetValue(x, y);
  const double middle = y + size[1] - 0.6 * this->Words->GetTextProperty()->GetFontSize();
  this->Arrow->SetVisibility(arrow >= 1.0);
  this->Arrow->GetPositionCoordinate()->SetValue(x, middle);
  this->Arrow->GetPosition2Coordinate()->SetValue(x + arrow, middle);
}

std::vector<vtkSplatSpeedKey*> vtkSplatSpeedKey::GetEarlierKeys(vtkViewport* viewport)
{
  std::vector<vtkSplatSpeedKey*> keys;
  vtkPropCollection* props = viewport->GetViewProps();
  vtkCollectionSimpleIterator at;
  props->InitTraversal(at);
  for (vtkProp* prop = props->GetNextProp(at); prop && prop != this; prop = props->GetNextProp(at))
  {
    auto* key = vtkSplatSpeedKey::SafeDownCast(prop);
    if (key && key->GetVisibility() && !key->Text.empty())
    {
      keys.push_back(key);
    }
  }
  return keys;
}

bool vtkSplatSpeedKey::Repeats(vtkViewport* viewport)
{
  const std::vector<vtkSplatSpeedKey*> keys = this->GetEarlierKeys(viewport);
  return std::any_of(keys.begin(), keys.end(),
    [this](const vtkSplatSpeedKey* key) { return key->Text == this->Text; });
}

int vtkSplatSpeedKey::RenderOverlay(vtkViewport* viewport)
{
  vtkTexturedSplatMapper* mapper = this->GetDrawnMapper(viewport);
  if (!mapper)
  {
    this->Text.clear();
    return 0;
  }
  auto* renderer = vtkRenderer::SafeDownCast(viewport);
  double arrow = 0.0;
  this->Text = this->Describe(
    mapper, PixelsOfUnit(renderer, this->Volume), longest * viewport->GetSize()[0], arrow);
  if (this->Repeats(viewport))
  {
    this->Text.clear();
    return 0;
  }
  if (this->AutomaticColor)
  {
    const double* color = viewport->GetBackground();
    const double ink = color[0] + color[1] + color[2] > 1.5 ? 0.0 : 1.0;
    this->GetTextProperty()->SetColor(ink, ink, ink);
    this->GetTextProperty()->SetBackgroundColor(1.0 - ink, 1.0 - ink, 1.0 - ink);
  }
  this->Write(viewport, arrow >= 1.0);
  this->Arrow->GetProperty()->SetColor(this->GetTextProperty()->GetColor());
  this->Place(viewport, arrow);
  int drawn = this->Words->RenderOpaqueGeometry(viewport) + this->Words->RenderOverlay(viewport);
  if (this->Arrow->GetVisibility())
  {
    drawn += this->Arrow->RenderOpaqueGeometry(viewport) + this->Arrow->RenderOverlay(viewport);
  }
  return drawn > 0;
}

void vtkSplatSpeedKey::ReleaseGraphicsResources(vtkWindow* window)
{
  this->Words->ReleaseGraphicsResources(window);
  this->Arrow->ReleaseGraphicsResources(window);
  this->Superclass::ReleaseGraphicsResources(window);
}

void vtkSplatSpeedKey::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Volume: " << this->Volume.Get() << "\n";
  os << indent << "SpeedUnit: " << this->SpeedUnit << "\n";
  os << indent << "LengthUnit: " << this->LengthUnit << "\n";
  os << indent << "FilmUnit: " << this->FilmUnit << "\n";
  os << indent << "FilmUnitSeconds: " << this->FilmUnitSeconds << "\n";
  os << indent << "AutomaticColor: " << this->AutomaticColor << "\n";
  os << indent << "Text: " << this->GetText() << "\n";
}

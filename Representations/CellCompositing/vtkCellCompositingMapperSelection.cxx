// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What a selector is told of the cells: it reads numbers from the colours of several pictures.
#include "vtkCellCompositingMapper.h"

#include "CellCompositingInternals.h"

#include "vtkCellData.h"
#include "vtkDataSet.h"
#include "vtkHardwareSelector.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <functional>

namespace
{
using Pixel = nephoscope::SelectedPixels::Pixel;
using NumberOfPixel = std::function<vtkIdType(const Pixel&)>;

constexpr vtkIdType low24 = 0xffffff; // bits of a colour

/** Numbers that a selector is told. */
class Numbers
{
public:
  Numbers(vtkDataSetAttributes* attributes, const std::string& name)
    : AreOwn(name.empty())
    , Array(name.empty() ? nullptr : attributes->GetArray(name.c_str()))
  {
  }

  /** Without a name that of the input; -1: the named array is not there, or has none. */
  vtkIdType At(vtkIdType index, vtkIdType own) const
  {
    if (this->AreOwn)
    {
      return own;
    }
    const double number = this->Array && index < this->Array->GetNumberOfTuples()
      ? this->Array->GetComponent(index, 0)
      : -1;
    return number >= 0 ? static_cast<vtkIdType>(number) : -1;
  }

private:
  bool AreOwn;
  vtkDataArray* Array;
};

/** The colours of a pass, or nothing where it shows none of these numbers. */
std::vector<float> Colors(const std::vector<Pixel>& pixels, const NumberOfPixel& numberOf)
{
  std::vector<float> colors;
  colors.reserve(4 * pixels.size());
  for (const Pixel& pixel : pixels)
  {
    float color[3] = { 0, 0, 0 };
    if (pixel.Cell >= 0)
    {
      vtkHardwareSelector::Convert(numberOf(pixel), color);
    }
    colors.insert(colors.end(), color, color + 3);
    colors.push_back(static_cast<float>(pixel.Depth));
  }
  return colors;
}

/** The number that a selector has chosen for all of a prop. */
vtkIdType NumberOfProp(vtkHardwareSelector* selector)
{
  const float* color = selector->GetPropColorValue();
  vtkIdType number = 0;
  for (int i = 2; i >= 0; --i)
  {
    number = 256 * number + static_cast<vtkIdType>(255 * color[i] + 0.5f);
  }
  return number;
}
}

void vtkCellCompositingMapper::DrawSelection(vtkRenderer* renderer, vtkVolume* volume)
{
  vtkHardwareSelector* selector = renderer->GetSelector();
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  const int pass = selector->GetCurrentPass();
  nephoscope::SelectedPixels& selected = this->Internals->Selected;
  if (!window || !this->GetInputAlgorithm() || this->Internals->Busy)
  {
    return;
  }
  if (pass == vtkHardwareSelector::ACTOR_PASS) // the first one, of a view that may be a new one
  {
    selected = nephoscope::SelectedPixels();
    if (this->Prepare(window, renderer, volume))
    {
      this->PickArea(renderer, volume, selector->GetArea());
    }
  }
  vtkDataSet* data = this->GetDataSetInput();
  if (selected.IsEmpty() || !data)
  {
    return;
  }
  selector->BeginRenderProp();
  const bool ofPoints = selector->GetFieldAssociation() == vtkDataObject::FIELD_ASSOCIATION_POINTS;
  const Numbers cells(data->GetCellData(), this->CellIdArrayName);
  const Numbers points(data->GetPointData(), this->PointIdArrayName);
  const Numbers blocks(data->GetCellData(), this->CompositeIdArrayName);
  const Numbers processes(data->GetCellData(), this->ProcessIdArrayName);
  const bool readsProcesses =
    selector->GetUseProcessIdFromData() && !this->ProcessIdArrayName.empty();
  const auto cellOf = [&](const Pixel& p) {
    return std::max<vtkIdType>(cells.At(p.Cell, p.Cell), 0);
  };
  const auto pointOf = [&](const Pixel& p) {
    return std::max<vtkIdType>(points.At(p.Point, p.Point), 0);
  };
  for (Pixel& pixel : selected.Pixels)
  {
    const bool isKnown = pixel.Cell >= 0 && blocks.At(pixel.Cell, 0) >= 0 &&
      (ofPoints ? points.At(pixel.Point, 0) : cells.At(pixel.Cell, 0)) >= 0 &&
      (!readsProcesses || processes.At(pixel.Cell, 0) >= 0);
    if (!isKnown)
    {
      pixel = Pixel();
      continue;
    }
    selector->UpdateMaximumCellId(cellOf(pixel));
    selector->UpdateMaximumPointId(pointOf(pixel));
  }
  NumberOfPixel numberOf;
  switch (pass)
  {
    case vtkHardwareSelector::ACTOR_PASS:
      numberOf = [number = NumberOfProp(selector)](const Pixel&) { return number; };
      break;
    case vtkHardwareSelector::COMPOSITE_INDEX_PASS:
      numberOf = [&](const Pixel& p) { return blocks.At(p.Cell, 0); };
      break;
    case vtkHardwareSelector::PROCESS_PASS:
      numberOf = [&, own = NumberOfProp(selector)](
                   const Pixel& p) { return readsProcesses ? processes.At(p.Cell, 0) + 1 : own; };
      break;
    case vtkHardwareSelector::POINT_ID_LOW24:
      numberOf = [&](const Pixel& p) { return pointOf(p) & low24; };
      break;
    case vtkHardwareSelector::POINT_ID_HIGH24:
      numberOf = [&](const Pixel& p) { return pointOf(p) >> 24; };
      break;
    case vtkHardwareSelector::CELL_ID_LOW24:
      numberOf = [&](const Pixel& p) { return cellOf(p) & low24; };
      break;
    case vtkHardwareSelector::CELL_ID_HIGH24:
      numberOf = [&](const Pixel& p) { return cellOf(p) >> 24; };
      break;
    default: // of cell grids
      break;
  }
  if (numberOf)
  {
    this->Internals->Selection.Draw(window, selected.First, selected.Width, selected.Squares(),
      Colors(selected.Pixels, numberOf));
  }
  selector->EndRenderProp();
}

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CellExtinction.h"

#include "HexahedronForm.h"
#include "SplatMatrix.h"
#include "TransferFunctionTable.h"

#include "vtkDataSet.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkSMPThreadLocalObject.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace nephoscope
{
namespace
{
/**
 * Gauss's rule with three points along each axis of the hexahedron, and how much of the cell each
 * stands for.
 */
struct Rule
{
  std::array<std::array<float, 8>, 27> Corner; ///< weights of the corners
  std::array<float, 27> Volume;                ///< sum: 1
  std::array<float, 8> Share{};                ///< of the cell, of each corner
};

/**
 * The extent of the volume at a place within a hexahedron some of whose corners coincide, by those
 * of the reference cell.
 */
float Extent(int type, const double at[3])
{
  switch (type)
  {
    case VTK_WEDGE:
      return static_cast<float>(1 - at[1]);
    case VTK_PYRAMID:
      return static_cast<float>((1 - at[2]) * (1 - at[2]));
    case VTK_TETRA:
      return static_cast<float>((1 - at[1]) * (1 - at[2]) * (1 - at[2]));
    default:
      return 1.0f;
  }
}

Rule MakeRule(int type)
{
  const double place[3] = { 0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15) };
  const double weight[3] = { 5.0 / 18, 8.0 / 18, 5.0 / 18 };
  Rule rule;
  float sum = 0;
  for (std::size_t q = 0; q < 27; ++q)
  {
    const std::size_t index[3] = { q % 3, q / 3 % 3, q / 9 };
    const double at[3] = { place[index[0]], place[index[1]], place[index[2]] };
    for (unsigned c = 0; c < 8; ++c)
    {
      rule.Corner[q][c] = static_cast<float>(
        (c & 1 ? at[0] : 1 - at[0]) * (c & 2 ? at[1] : 1 - at[1]) * (c & 4 ? at[2] : 1 - at[2]));
    }
    rule.Volume[q] =
      static_cast<float>(weight[index[0]] * weight[index[1]] * weight[index[2]]) * Extent(type, at);
    sum += rule.Volume[q];
  }
  for (std::size_t q = 0; q < 27; ++q)
  {
    rule.Volume[q] /= sum;
    for (std::size_t c = 0; c < 8; ++c)
    {
      rule.Share[c] += rule.Volume[q] * rule.Corner[q][c];
    }
  }
  return rule;
}

const Rule& RuleOf(int type)
{
  static const Rule box = MakeRule(VTK_HEXAHEDRON), wedge = MakeRule(VTK_WEDGE),
                    pyramid = MakeRule(VTK_PYRAMID), tetrahedron = MakeRule(VTK_TETRA);
  return type == VTK_WEDGE ? wedge
    : type == VTK_PYRAMID  ? pyramid
    : type == VTK_TETRA    ? tetrahedron
                           : box;
}

/** What a cell gives to its corners. */
struct Gift
{
  std::array<vtkIdType, 8> Points;
  std::array<double, 8> Weights;    ///< the first is 0: nothing is given
  std::array<float, 8> Extinctions; ///< each is a share of the mean of the cell
};

class CellsOfPoints
{
public:
  CellsOfPoints(
    vtkDataSet* data, const std::vector<float>& scalars, const TransferFunctionTable& table)
    : Data(data)
    , Hidden(data->GetCellGhostArray())
    , Scalars(scalars)
    , Table(table)
    , Own(scalars.size())
  {
    vtkSMPTools::For(
      0, static_cast<vtkIdType>(scalars.size()), [&](vtkIdType begin, vtkIdType end) {
        for (vtkIdType i = begin; i < end; ++i)
        {
          this->Own[std::size_t(i)] = this->Map(scalars[std::size_t(i)]);
        }
      });
  }

  std::vector<float> Mean()
  {
    std::vector<double> sum(this->Own.size(), 0.0), weight(this->Own.size(), 0.0);
    std::vector<Gift> gifts;
    const vtkIdType count = this->Data->GetNumberOfCells();
    if (count > 0)
    {
      this->Data->GetCellType(0); // so that calls from threads find it prepared
    }
    for (vtkIdType first = 0; first < count; first += chunk)
    {
      this->Give(first, std::min(count, first + chunk), gifts);
      for (const Gift& gift : gifts) // one after another, so that the sums do not depend on threads
      {
        for (std::size_t c = 0; c < 8 && gift.Weights[0] > 0; ++c)
        {
          sum[std::size_t(gift.Points[c])] += gift.Weights[c] * gift.Extinctions[c];
          weight[std::size_t(gift.Points[c])] += gift.Weights[c];
        }
      }
    }
    std::vector<float> mean = this->Own;
    for (std::size_t i = 0; i < mean.size(); ++i)
    {
      mean[i] = weight[i] > 0 ? static_cast<float>(sum[i] / weight[i]) : mean[i];
    }
    return mean;
  }

private:
  static constexpr vtkIdType chunk = 1 << 15;

  float Map(float scalar) const
  {
    return std::isfinite(scalar) ? this->Table.Evaluate(scalar)[3] : 0.0f;
  }

  void Give(vtkIdType first, vtkIdType last, std::vector<Gift>& gifts)
  {
    gifts.resize(std::size_t(last - first));
    vtkSMPThreadLocalObject<vtkIdList> lists;
    vtkSMPTools::For(first, last, [&](vtkIdType begin, vtkIdType end) {
      vtkIdList* list = lists.Local();
      for (vtkIdType cell = begin; cell < end; ++cell)
      {
        Gift& gift = gifts[std::size_t(cell - first)];
        gift.Weights[0] = 0;
        const int type = this->Data->GetCellType(cell);
        const HexahedronForm form = HexahedronFormOf(type);
        if (!this->IsHidden(cell) && form.Tetrahedra > 0)
        {
          this->Data->GetCellPoints(cell, list);
          this->GiveOf(RuleOf(type), form, list, gift);
        }
      }
    });
  }

  bool IsHidden(vtkIdType cell) const
  {
    return this->Hidden && (this->Hidden->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL);
  }

  void GiveOf(const Rule& rule, const HexahedronForm& form, vtkIdList* list, Gift& gift) const
  {
    std::array<float, 8> scalar;
    float mean = 0, greatest = 0;
    for (std::size_t c = 0; c < 8; ++c)
    {
      gift.Points[c] = list->GetId(form.Vertices[c]);
      scalar[c] = this->Scalars[std::size_t(gift.Points[c])];
      gift.Extinctions[c] = this->Own[std::size_t(gift.Points[c])];
      mean += rule.Share[c] * gift.Extinctions[c];
      greatest = std::max(greatest, gift.Extinctions[c]);
      if (!std::isfinite(scalar[c]))
      {
        return;
      }
    }
    const double size = this->SizeOf(gift.Points);
    for (std::size_t c = 0; c < 8; ++c)
    {
      gift.Weights[c] = size * static_cast<double>(rule.Share[c]);
    }
    this->Interpolate(rule, scalar, mean, gift);
  }

  void Interpolate(
    const Rule& rule, const std::array<float, 8>& scalar, float mean, Gift& gift) const
  {
    std::array<float, 8> given{};
    float inside = 0;
    for (std::size_t q = 0; q < 27; ++q)
    {
      float at = 0;
      for (std::size_t c = 0; c < 8; ++c)
      {
        at += rule.Corner[q][c] * scalar[c];
      }
      const float part = rule.Volume[q] * this->Map(at);
      inside += part;
      for (std::size_t c = 0; c < 8; ++c)
      {
        given[c] += rule.Corner[q][c] * part;
      }
    }
    for (std::size_t c = 0; c < 8; ++c)
    {
      gift.Extinctions[c] =
        mean > 0 ? gift.Extinctions[c] * (inside / mean) : given[c] / rule.Share[c];
    }
  }

  /** About the volume. */
  double SizeOf(const std::array<vtkIdType, 8>& points) const
  {
    SplatMatrix edges{};
    for (unsigned c = 0; c < 8; ++c)
    {
      double x[3];
      this->Data->GetPoint(points[c], x);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        for (std::size_t k = 0; k < 3; ++k)
        {
          edges[axis][k] += (c >> axis & 1 ? 0.25 : -0.25) * x[k];
        }
      }
    }
    return std::abs(Determinant(edges));
  }

  vtkDataSet* Data;
  vtkUnsignedCharArray* Hidden;
  const std::vector<float>& Scalars;
  const TransferFunctionTable& Table;
  std::vector<float> Own;
};
} // namespace

std::vector<float> InterpolateExtinction(
  vtkDataSet* data, const std::vector<float>& scalars, const TransferFunctionTable& table)
{
  return CellsOfPoints(data, scalars, table).Mean();
}

} // namespace nephoscope

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SplatNeedles.h"

#include "CellCenter.h"
#include "CellSamples.h"
#include "CellShape.h"
#include "SplatMatrix.h"

#include "vtkCellType.h"
#include "vtkDataSet.h"
#include "vtkIdList.h"
#include "vtkMath.h"
#include "vtkNew.h"

#include <algorithm>
#include <cmath>

namespace nephoscope
{
namespace
{
// Squares of widths. Around an axis, where the mean of squares is half of the greatest one, cells
// get as wide as they are long but for `wide`.
constexpr double narrow = 1.0 / 9, wide = 0.8, aroundAxis = 2;

// False, at little cost, for nearly all samples of even meshes: the ellipsoid is not three times as
// long as it is wide. The product of the squares of its three lengths is at most the least one
// times the square of half the sum of all.
bool MayBeNeedle(const std::array<float, 9>& shape)
{
  const SplatMatrix m = MatrixOfShape(shape);
  const double volume = Determinant(m);
  double sum = 0;
  for (const float x : shape)
  {
    sum += double(x) * x;
  }
  return sum > 0 && volume * volume < narrow * sum * 0.25 * sum * sum;
}

// The axes of a sample's ellipsoid and the squares of their lengths, and of the lengths that they
// need.
class Needle
{
public:
  explicit Needle(const std::array<float, 9>& shape)
  {
    double a[3][3], vectors[3][3];
    const SplatMatrix square = SquareOfShape(shape);
    double* rows[3] = { a[0], a[1], a[2] };
    double* columns[3] = { vectors[0], vectors[1], vectors[2] };
    for (std::size_t i = 0; i < 9; ++i)
    {
      a[i / 3][i % 3] = square[i / 3][i % 3];
    }
    vtkMath::Jacobi(rows, this->Squares.data(), columns);
    for (std::size_t i = 0; i < 9; ++i)
    {
      this->Axes[i / 3][i % 3] = vectors[i % 3][i / 3];
    }
    this->Needed = this->Squares;
  }

  // Another sample, at this offset: so many times its square is needed.
  void Compare(const SplatMatrix& other, const Vector3& offset, double times = 1)
  {
    const double length = Norm(offset);
    for (std::size_t k = 0; k < 3 && length > 0; ++k)
    {
      const double along = Dot(this->Axes[k], offset) / length;
      Vector3 across = this->Axes[k];
      for (std::size_t c = 0; c < 3; ++c)
      {
        across[c] -= along * offset[c] / length;
      }
      const double longest = *std::max_element(this->Squares.begin(), this->Squares.end());
      const double width = std::min(Dot(across, Times(other, across)), longest);
      if (this->Squares[k] < narrow * width)
      {
        this->Needed[k] = std::max(this->Needed[k], wide * std::min(times * width, longest));
      }
    }
  }

  bool IsWidened() const { return this->Needed != this->Squares; }

  void Widen(std::array<float, 9>& shape, float& part) const
  {
    SplatMatrix square{};
    for (std::size_t k = 0; k < 3; ++k)
    {
      SplatMatrix axis{};
      AddOuterProduct(axis, this->Axes[k]);
      AddWeighted(square, axis, this->Needed[k]);
    }
    const SplatMatrix root = TriangularRoot(square);
    const double before = std::abs(Determinant(MatrixOfShape(shape))), after = Determinant(root);
    if (!(after > before))
    {
      return;
    }
    part *= static_cast<float>(before / after);
    for (std::size_t i = 0; i < 9; ++i)
    {
      shape[i] = static_cast<float>(root[i / 3][i % 3]);
    }
  }

private:
  SplatMatrix Axes{};
  Vector3 Squares{}, Needed{};
};

// Pairs of corners: of hexahedra and quadrilaterals edges, of others all, as if they were divided
// into tetrahedra.
template <typename Visit>
void ForEachEdge(int type, vtkIdType corners, const Visit& visit)
{
  const bool voxel = type == VTK_VOXEL || type == VTK_PIXEL;
  for (vtkIdType a = 0; a < corners; ++a)
  {
    for (vtkIdType b = a + 1; b < corners; ++b)
    {
      const vtkIdType step = b - a;
      const bool ofVoxel = step == (step & -step) && (a & step) == 0;
      const bool ofRing = a / 4 == b / 4 && (step == 1 || step == 3);
      const bool ofHexahedron = ofRing || step == 4;
      const bool chosen = voxel                      ? ofVoxel
        : type == VTK_HEXAHEDRON || type == VTK_QUAD ? ofHexahedron
                                                     : true;
      if (chosen)
      {
        visit(a, b);
      }
    }
  }
}

class NeedleFinder
{
public:
  NeedleFinder(vtkDataSet* data, const std::vector<vtkIdType>& places,
    const std::vector<unsigned char>& hidden, const CellSplats& splats)
    : Data(data)
    , Places(places)
    , Hidden(hidden)
    , Splats(splats)
  {
    this->Numbers.assign(splats.Shapes.size(), none);
    for (std::size_t i = 0; i < splats.Shapes.size(); ++i)
    {
      if ((splats.Kept.empty() || !splats.Kept[i]) && MayBeNeedle(splats.Shapes[i]))
      {
        this->Numbers[i] = static_cast<int>(this->Needles.size());
        this->Needles.emplace_back(splats.Shapes[i]);
      }
    }
  }

  bool IsEmpty() const { return this->Needles.empty(); }

  void WidenPoints()
  {
    this->ForCells([&](vtkIdType cell) {
      const int type = this->Data->GetCellType(cell);
      ForEachEdge(type, this->Corners->GetNumberOfIds(), [&](vtkIdType a, vtkIdType b) {
        const std::size_t i = this->CornerOf(a), j = this->CornerOf(b);
        if (this->HasShape(i) && this->HasShape(j))
        {
          const Vector3 offset = this->PlaceOf(j) - this->PlaceOf(i);
          this->Compare(i, j, offset);
          this->Compare(j, i, offset);
        }
      });
    });
    this->Widen();
  }

  void WidenCells()
  {
    std::vector<SplatMatrix> means(static_cast<std::size_t>(this->Data->GetNumberOfPoints()));
    std::vector<int> counts(means.size(), 0);
    const auto forCorners = [&](const auto& visit) {
      this->ForCells([&](vtkIdType cell) {
        for (vtkIdType c = 0;
             c < this->Corners->GetNumberOfIds() && this->HasShape(std::size_t(cell)); ++c)
        {
          visit(static_cast<std::size_t>(cell), this->CornerOf(c));
        }
      });
    };
    forCorners([&](std::size_t cell, std::size_t corner) {
      AddWeighted(means[corner], SquareOfShape(this->Splats.Shapes[cell]), 1);
      ++counts[corner];
    });
    std::size_t last = this->Numbers.size(); // the cell whose centre that is
    Vector3 center{};
    forCorners([&](std::size_t cell, std::size_t corner) {
      if (this->Numbers[cell] != none)
      {
        center = cell == last ? center : CenterOfCell(this->Data, static_cast<vtkIdType>(cell));
        last = cell;
        SplatMatrix mean{};
        AddWeighted(mean, means[corner], 1.0 / counts[corner]);
        this->NeedleOf(cell).Compare(mean, this->PlaceOf(corner) - center, aroundAxis);
      }
    });
    this->Widen();
  }

private:
  static constexpr int none = -1;

  Needle& NeedleOf(std::size_t i)
  {
    return this->Needles[static_cast<std::size_t>(this->Numbers[i])];
  }

  void Compare(std::size_t i, std::size_t other, const Vector3& offset)
  {
    if (this->Numbers[i] != none)
    {
      this->NeedleOf(i).Compare(SquareOfShape(this->Splats.Shapes[other]), offset);
    }
  }

  // With its corners.
  template <typename Visit>
  void ForCells(const Visit& visit)
  {
    for (vtkIdType cell = 0; cell < this->Data->GetNumberOfCells(); ++cell)
    {
      if (this->Hidden.empty() || !this->Hidden[static_cast<std::size_t>(cell)])
      {
        this->Data->GetCellPoints(cell, this->Corners);
        visit(cell);
      }
    }
  }

  std::size_t CornerOf(vtkIdType corner) const
  {
    const auto point = static_cast<std::size_t>(this->Corners->GetId(corner));
    return this->Places.empty() ? point : static_cast<std::size_t>(this->Places[point]);
  }

  Vector3 PlaceOf(std::size_t point) const
  {
    Vector3 x;
    this->Data->GetPoint(static_cast<vtkIdType>(point), x.data());
    return x;
  }

  bool HasShape(std::size_t i) const { return this->Splats.Shapes[i][0] != 0; }

  void Widen()
  {
    for (std::size_t i = 0; i < this->Numbers.size(); ++i)
    {
      if (this->Numbers[i] != none && this->HasShape(i) && this->NeedleOf(i).IsWidened())
      {
        this->NeedleOf(i).Widen(this->Splats.Shapes[i], this->Splats.Parts[i]);
      }
    }
  }

  vtkDataSet* Data;
  const std::vector<vtkIdType>& Places;
  const std::vector<unsigned char>& Hidden;
  CellSplats Splats;
  std::vector<Needle> Needles; // of the samples that may be some
  std::vector<int> Numbers;    // for each sample, that of its needle
  vtkNew<vtkIdList> Corners;
};
}

void WidenNeedles(vtkDataSet* data, bool onCells, const std::vector<vtkIdType>& places,
  const std::vector<unsigned char>& hidden, const CellSplats& splats)
{
  NeedleFinder finder(data, places, hidden, splats);
  if (finder.IsEmpty())
  {
    return;
  }
  if (onCells)
  {
    finder.WidenCells();
  }
  else
  {
    finder.WidenPoints();
  }
}

} // namespace nephoscope

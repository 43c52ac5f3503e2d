// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "RankUnion.h"

#include "ChessboardDivision.h"
#include "DataSets.h"
#include "RankExchange.h"
#include "RankPieces.h"
#include "Ranks.h"
#include "Vector3.h"

#include "vtkBoundingBox.h"
#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <vector>

namespace nephoscope
{
namespace
{
using DataSets = std::vector<vtkSmartPointer<vtkDataSet>>;

// By rank. A client has been given those of all ranks of its server: each is a piece. Collective.
std::vector<DataSets> OfEachRank(const DataSets& own)
{
  constexpr int tag = 26140;
  auto* controller = OtherRanks();
  if (!controller)
  {
    std::vector<DataSets> pieces;
    std::transform(own.begin(), own.end(), std::back_inserter(pieces),
      [](const auto& piece) { return DataSets{ piece }; });
    return pieces;
  }
  std::vector<DataSets> ofRanks(static_cast<std::size_t>(controller->GetNumberOfProcesses()));
  ofRanks[static_cast<std::size_t>(controller->GetLocalProcessId())] = own;
  const auto send = [&](int rank) {
    const auto count = static_cast<int>(own.size());
    controller->Send(&count, 1, rank, tag);
    for (const auto& data : own)
    {
      controller->Send(data, rank, tag + 1);
    }
  };
  const auto receive = [&](int rank) {
    int count = 0;
    controller->Receive(&count, 1, rank, tag);
    for (int i = 0; i < count; ++i)
    {
      const auto data = vtk::TakeSmartPointer(controller->ReceiveDataObject(rank, tag + 1));
      if (auto* set = vtkDataSet::SafeDownCast(data))
      {
        ofRanks[static_cast<std::size_t>(rank)].emplace_back(set);
      }
    }
  };
  MeetOtherRanks(controller, send, receive);
  return ofRanks;
}

DataSets Together(const std::vector<DataSets>& ofRanks)
{
  DataSets all;
  for (const DataSets& some : ofRanks)
  {
    all.insert(all.end(), some.begin(), some.end());
  }
  return all;
}

// Points of several ranks that lie in one place but for rounding.
class MeetingPoints
{
public:
  explicit MeetingPoints(double step)
    : Step(step)
  {
  }

  // The point of an earlier rank that is there, or null.
  const Vector3* Find(const Vector3& p) const
  {
    for (int corner = 0; corner < 8; ++corner)
    {
      const auto found = this->Points.find(this->BoxOf(
        p, { { corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5 } }));
      if (found != this->Points.end())
      {
        return &found->second;
      }
    }
    return nullptr;
  }

  void Add(const Vector3& p) { this->Points.emplace(this->BoxOf(p, { { 0, 0, 0 } }), p); }

private:
  Vector3 BoxOf(const Vector3& p, const Vector3& offset) const
  {
    return { { std::floor(p[0] / this->Step + offset[0]), std::floor(p[1] / this->Step + offset[1]),
      std::floor(p[2] / this->Step + offset[2]) } };
  }

  double Step;
  std::map<Vector3, Vector3> Points; // by the box that they are in
};

vtkBoundingBox BoxOf(const DataSets& surfaces)
{
  vtkBoundingBox box;
  for (vtkDataSet* surface : surfaces)
  {
    box.AddBounds(surface->GetBounds());
  }
  return box;
}

// Ranks compute the points that their pieces have in common each for itself. A surface with gaps
// between pieces is not closed.
void CloseGaps(const std::vector<DataSets>& ofRanks)
{
  constexpr double rounding = 1e-6;
  std::vector<vtkBoundingBox> boxes;
  std::transform(ofRanks.begin(), ofRanks.end(), std::back_inserter(boxes), BoxOf);
  const double step = rounding * BoxOf(Together(ofRanks)).GetDiagonalLength();
  if (!(step > 0))
  {
    return;
  }
  for (vtkBoundingBox& box : boxes)
  {
    if (box.IsValid())
    {
      box.Inflate(step);
    }
  }
  MeetingPoints points(step);
  for (std::size_t rank = 0; rank < ofRanks.size(); ++rank)
  {
    std::vector<Vector3> mine;
    const auto isShared = [&](const Vector3& p) {
      for (std::size_t other = 0; other < boxes.size(); ++other)
      {
        if (other != rank && boxes[other].IsValid() && boxes[other].ContainsPoint(p.data()))
        {
          return true;
        }
      }
      return false;
    };
    for (vtkDataSet* surface : ofRanks[rank])
    {
      vtkNew<vtkPoints> moved; // the points are also those of the pipeline
      moved->DeepCopy(vtkPolyData::SafeDownCast(surface)->GetPoints());
      for (vtkIdType i = 0; i < moved->GetNumberOfPoints(); ++i)
      {
        Vector3 p;
        moved->GetPoint(i, p.data());
        if (isShared(p))
        {
          const Vector3* found = points.Find(p);
          if (found)
          {
            moved->SetPoint(i, found->data());
          }
          else
          {
            mine.push_back(p);
          }
        }
      }
      vtkPolyData::SafeDownCast(surface)->SetPoints(moved);
    }
    std::for_each(mine.begin(), mine.end(), [&](const Vector3& p) { points.Add(p); });
  }
}

vtkSmartPointer<vtkMultiBlockDataSet> AsBlocks(const DataSets& sets)
{
  auto blocks = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (std::size_t i = 0; i < sets.size(); ++i)
  {
    blocks->SetBlock(static_cast<unsigned int>(i), sets[i]);
  }
  return blocks;
}

void CopyArray(vtkDataSetAttributes* from, vtkDataSetAttributes* to, const std::string& name)
{
  vtkDataArray* array = name.empty() ? from->GetScalars() : from->GetArray(name.c_str());
  if (array && name.empty())
  {
    to->SetScalars(array);
  }
  else if (array)
  {
    to->AddArray(array);
  }
}

// With what the density is found from, and no other array.
vtkSmartPointer<vtkDataSet> OnlyWith(vtkDataSet* set, const std::string& name)
{
  auto copy = vtk::TakeSmartPointer(set->NewInstance());
  copy->CopyStructure(set);
  for (const int kind : { vtkDataObject::POINT, vtkDataObject::CELL })
  {
    vtkDataSetAttributes* arrays = set->GetAttributes(kind);
    CopyArray(arrays, copy->GetAttributes(kind), name);
    CopyArray(arrays, copy->GetAttributes(kind), vtkDataSetAttributes::GhostArrayName());
    CopyArray(arrays, copy->GetAttributes(kind), divisionName);
  }
  copy->GetFieldData()->AddArray(set->GetFieldData()->GetArray(pieceName));
  return copy;
}

bool HasHiddenParts(vtkDataSet* set)
{
  const auto hides = [](vtkUnsignedCharArray* flags, int duplicate) {
    const unsigned char* begin = flags ? flags->GetPointer(0) : nullptr;
    return flags && std::any_of(begin, begin + flags->GetNumberOfValues(), [=](unsigned char flag) {
      return (flag & ~duplicate) != 0;
    });
  };
  return hides(set->GetCellGhostArray(), vtkDataSetAttributes::DUPLICATECELL) ||
    hides(set->GetPointGhostArray(), vtkDataSetAttributes::DUPLICATEPOINT);
}

vtkDataArray* ArrayOfPoints(vtkDataSet* set, const std::string& name)
{
  return name.empty() ? set->GetPointData()->GetScalars()
                      : set->GetPointData()->GetArray(name.c_str());
}

// Whether they are of one image: the same lattice, and an array of points with the same name.
bool ArePieces(vtkImageData* a, vtkImageData* b, const std::string& name)
{
  const auto arrayOf = [&](vtkDataSet* set) { return ArrayOfPoints(set, name); };
  if (!a || !b || HasHiddenParts(a) || HasHiddenParts(b) || !arrayOf(a) || !arrayOf(b))
  {
    return false;
  }
  const double* turn = a->GetDirectionMatrix()->GetData();
  return std::equal(a->GetSpacing(), a->GetSpacing() + 3, b->GetSpacing()) &&
    std::equal(a->GetOrigin(), a->GetOrigin() + 3, b->GetOrigin()) &&
    std::equal(turn, turn + 9, b->GetDirectionMatrix()->GetData()) &&
    arrayOf(a)->GetDataType() == arrayOf(b)->GetDataType() &&
    arrayOf(a)->GetNumberOfComponents() == arrayOf(b)->GetNumberOfComponents();
}

// Row by row.
void CopyPoints(vtkImageData* from, vtkDataArray* values, vtkImageData* to, vtkDataArray* all)
{
  int e[6];
  from->GetExtent(e);
  for (int k = e[4]; k <= e[5]; ++k)
  {
    for (int j = e[2]; j <= e[3]; ++j)
    {
      int start[3] = { e[0], j, k };
      all->InsertTuples(
        to->ComputePointId(start), e[1] - e[0] + 1, from->ComputePointId(start), values);
    }
  }
}

vtkSmartPointer<vtkDataSet> JoinedImage(const DataSets& pieces, const std::string& name)
{
  auto* first = vtkImageData::SafeDownCast(pieces.front());
  const auto arrayOf = [&](vtkDataSet* set) { return ArrayOfPoints(set, name); };
  int extent[6];
  first->GetExtent(extent);
  for (vtkDataSet* piece : pieces)
  {
    const int* own = vtkImageData::SafeDownCast(piece)->GetExtent();
    for (int c = 0; c < 6; c += 2)
    {
      extent[c] = std::min(extent[c], own[c]);
      extent[c + 1] = std::max(extent[c + 1], own[c + 1]);
    }
  }
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(extent);
  image->SetSpacing(first->GetSpacing());
  image->SetOrigin(first->GetOrigin());
  image->SetDirectionMatrix(first->GetDirectionMatrix());
  auto values = vtk::TakeSmartPointer(arrayOf(first)->NewInstance());
  values->SetName(arrayOf(first)->GetName());
  values->SetNumberOfComponents(arrayOf(first)->GetNumberOfComponents());
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  values->Fill(0.0); // where no rank has a piece
  for (vtkDataSet* piece : pieces)
  {
    CopyPoints(vtkImageData::SafeDownCast(piece), arrayOf(piece), image, values);
  }
  name.empty() ? image->GetPointData()->SetScalars(values)
               : image->GetPointData()->AddArray(values);
  return image;
}
} // namespace

vtkSmartPointer<vtkMultiBlockDataSet> SurfacesOfRanks(vtkDataObject* own)
{
  DataSets mine;
  for (vtkDataSet* set : own ? DataSetsOf(own) : std::vector<vtkDataSet*>())
  {
    auto* surface = vtkPolyData::SafeDownCast(set);
    if (surface && surface->GetNumberOfPoints() > 0)
    {
      auto copy = vtkSmartPointer<vtkPolyData>::New();
      copy->ShallowCopy(surface);
      copy->RemoveGhostCells();
      mine.emplace_back(copy);
    }
  }
  const std::vector<DataSets> ofRanks = OfEachRank(mine);
  CloseGaps(ofRanks);
  return AsBlocks(Together(ofRanks));
}

vtkSmartPointer<vtkMultiBlockDataSet> DensitiesOfRanks(vtkDataObject* own, const std::string& name)
{
  DataSets mine;
  for (vtkDataSet* set : own ? DataSetsOf(own) : std::vector<vtkDataSet*>())
  {
    if (set->GetNumberOfPoints() > 0)
    {
      mine.push_back(OnlyWith(set, name));
    }
  }
  DataSets all = Together(OfEachRank(mine));
  std::for_each(all.begin(), all.end(), RestorePiece);
  auto* first = all.empty() ? nullptr : vtkImageData::SafeDownCast(all.front());
  const bool areOneImage = std::all_of(all.begin(), all.end(),
    [&](vtkDataSet* piece) { return ArePieces(first, vtkImageData::SafeDownCast(piece), name); });
  return AsBlocks(areOneImage && all.size() > 1 ? DataSets{ JoinedImage(all, name) } : all);
}

vtkMultiBlockDataSet* RankUnion::Of(
  vtkDataObject* own, const std::string& name, const Exchange& exchange)
{
  const vtkMTimeType time = NewestMTime(own);
  const bool isOther =
    !this->Whole || own != this->From || time != this->Time || name != this->Name;
  if (MaximumOverRanks(isOther ? 1 : 0) == 1)
  {
    this->Whole = exchange(own, name);
    this->From = own;
    this->Time = time;
    this->Name = name;
  }
  return this->Whole;
}

} // namespace nephoscope

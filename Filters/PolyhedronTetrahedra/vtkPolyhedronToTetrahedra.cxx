// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkPolyhedronToTetrahedra.h"

#include "DividedGrid.h"
#include "EmptyInput.h"
#include "OwnThreads.h"
#include "PolyhedronDivider.h"
#include "RequiredInput.h"

#include "vtkCellType.h"
#include "vtkDataSetAttributes.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkSMPTools.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <algorithm>
#include <string>

using nephoscope::DivisionOutcome;

vtkStandardNewMacro(vtkPolyhedronToTetrahedra);

struct vtkPolyhedronToTetrahedra::vtkWork
{
  vtkUnstructuredGrid* Grid = nullptr;
  nephoscope::DivisionOptions Options;
  nephoscope::CellDivisions Divisions;
  std::vector<DivisionOutcome> Outcomes;
  std::string Reason; ///< of the first failure of TetGen
};

namespace
{
/** Divides cells of one grid. One object per thread. */
class CellReader
{
public:
  CellReader(vtkUnstructuredGrid* grid, const nephoscope::DivisionOptions& options)
    : Grid(grid)
    , Points(grid->GetPoints())
    , CellGhosts(grid->GetCellGhostArray())
    , PointGhosts(grid->GetPointGhostArray())
    , Divider(options)
  {
  }

  DivisionOutcome Divide(vtkIdType cell)
  {
    if (this->Grid->GetCellType(cell) != VTK_POLYHEDRON || this->IsHidden(cell))
    {
      return DivisionOutcome::Whole;
    }
    this->Grid->GetFaceStream(cell, this->Stream); // number of faces, then size and points of each
    const vtkIdType size = this->Stream->GetNumberOfIds();
    const vtkIdType* ids = this->Stream->GetPointer(0);
    if (size < 2)
    {
      return DivisionOutcome::NotClosed;
    }
    return this->Divider.Divide(
      nephoscope::FaceList<vtkIdType>{ ids + 1, ids + size }, [this](vtkIdType id) {
        nephoscope::Vector3 x;
        this->Points->GetPoint(id, x.data());
        return x;
      });
  }

  nephoscope::PolyhedronDivider& GetDivider() { return this->Divider; }

  std::unique_ptr<nephoscope::CellDivision> TakeDivision()
  {
    return std::make_unique<nephoscope::CellDivision>(std::move(this->Divider.GetDivision()));
  }

private:
  bool IsHidden(vtkIdType cell)
  {
    if (this->CellGhosts && (this->CellGhosts->GetValue(cell) & vtkDataSetAttributes::HIDDENCELL))
    {
      return true;
    }
    if (!this->PointGhosts)
    {
      return false;
    }
    this->Grid->GetCellPoints(cell, this->Stream);
    const vtkIdType* ids = this->Stream->GetPointer(0);
    return std::any_of(ids, ids + this->Stream->GetNumberOfIds(), [this](vtkIdType id) {
      return (this->PointGhosts->GetValue(id) & vtkDataSetAttributes::HIDDENPOINT) != 0;
    });
  }

  vtkUnstructuredGrid* Grid;
  vtkPoints* Points;
  vtkUnsignedCharArray* CellGhosts;
  vtkUnsignedCharArray* PointGhosts;
  nephoscope::PolyhedronDivider Divider;
  vtkNew<vtkIdList> Stream;
};

bool HoldsPolyhedra(vtkUnstructuredGrid* grid)
{
  for (vtkIdType cell = 0; grid && grid->GetPoints() && cell < grid->GetNumberOfCells(); ++cell)
  {
    if (grid->GetCellType(cell) == VTK_POLYHEDRON)
    {
      return true;
    }
  }
  return false;
}

struct Complaint
{
  DivisionOutcome Outcome;
  const char* What;
  std::string Remedy;
};

std::vector<Complaint> Complaints(bool useTetGen, const std::string& reason)
{
  const std::string enable = nephoscope::IsBuiltWithTetGen() && !useTetGen
    ? "Set UseTetGen on."
    : "Build with TetGen: in Debian install libtet1.5-dev, then configure with NEPHOSCOPE_USE_TETGEN=ON.";
  return {
    { DivisionOutcome::NotStar, "not star-shaped, no single point sees the whole inside", enable },
    { DivisionOutcome::Failed, "not star-shaped, and TetGen does not divide it",
      "TetGen on the first: " + reason +
        ". Most often the faces of such a cell cross each other: repair it." },
    { DivisionOutcome::NotClosed, "not closed: an edge belongs to one face, or to more than two",
      "Repair its faces; where a neighbour has a point in the middle of an edge, both faces at the edge must have it." },
    { DivisionOutcome::NotOriented, "one-sided: its faces have no inside", "Repair its faces." },
    { DivisionOutcome::BadFace, "bounded by a face that has no area or crosses itself",
      "Repair its faces." },
    { DivisionOutcome::NotFinite, "bounded by a point whose coordinates are not finite",
      "Remove the cell, or repair the point." },
  };
}
}

bool vtkPolyhedronToTetrahedra::HasTetGen()
{
  return nephoscope::IsBuiltWithTetGen();
}

int vtkPolyhedronToTetrahedra::FillInputPortInformation(int, vtkInformation* info)
{
  nephoscope::TakeAnyData(info);
  return 1;
}

vtkTypeBool vtkPolyhedronToTetrahedra::ProcessRequest(
  vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  return nephoscope::HasOtherInput(this, this->ToldOfInput, request, inputs, outputs,
           { "vtkDataSet" }, "It must be a dataset with cells.") ||
    this->Superclass::ProcessRequest(request, inputs, outputs);
}

int vtkPolyhedronToTetrahedra::RequestData(
  vtkInformation*, vtkInformationVector** inputs, vtkInformationVector* outputs)
{
  vtkDataSet* input = vtkDataSet::GetData(inputs[0], 0);
  vtkDataSet* output = vtkDataSet::GetData(outputs, 0);
  this->NumberOfDividedCells = this->NumberOfNewPoints = this->NumberOfUndividedCells = 0;
  if (!input || !output)
  {
    vtkErrorMacro("There is no input: connect a dataset.");
    return 0;
  }
  output->ShallowCopy(input);
  vtkWork work;
  work.Grid = vtkUnstructuredGrid::SafeDownCast(input);
  if (nephoscope::IsEmptyInput(this, this->ToldOfEmptiness, inputs, outputs) ||
    !HoldsPolyhedra(work.Grid))
  {
    return 1;
  }
  work.Options.DivideConvex = this->DivideConvexPolyhedra;
  work.Options.WarpTolerance = this->FaceWarpTolerance;
  work.Options.IsFloat = work.Grid->GetPoints()->GetDataType() == VTK_FLOAT;
  work.Outcomes.resize(
    static_cast<std::size_t>(work.Grid->GetNumberOfCells()), DivisionOutcome::Whole);
  work.Divisions.resize(work.Outcomes.size());
  this->DivideInParallel(work);
  this->DivideByTetGen(work);
  if (this->CheckAbort())
  {
    output->Initialize(); // nothing rather than a part
    return 1;
  }
  this->NumberOfDividedCells =
    std::count(work.Outcomes.begin(), work.Outcomes.end(), DivisionOutcome::Divided);
  if (this->NumberOfDividedCells > 0)
  {
    this->NumberOfNewPoints = nephoscope::BuildDividedGrid(
      work.Grid, work.Divisions, vtkUnstructuredGrid::SafeDownCast(output));
  }
  this->Report(work);
  return 1;
}

// In chunks: observers of the progress are called by the thread that asked for the update.
void vtkPolyhedronToTetrahedra::DivideInParallel(vtkWork& work)
{
  const vtkIdType n = work.Grid->GetNumberOfCells();
  const vtkIdType chunk = std::max<vtkIdType>(10000, n / 50);
  auto divide = [&](vtkIdType begin, vtkIdType end) {
    CellReader reader(work.Grid, work.Options);
    for (vtkIdType cell = begin; cell < end; ++cell)
    {
      const auto i = static_cast<std::size_t>(cell);
      work.Outcomes[i] = reader.Divide(cell);
      if (work.Outcomes[i] == DivisionOutcome::Divided)
      {
        work.Divisions[i] = reader.TakeDivision();
      }
    }
  };
  for (vtkIdType first = 0; first < n && !this->CheckAbort(); first += chunk)
  {
    this->UpdateProgress(0.8 * static_cast<double>(first) / static_cast<double>(n));
    nephoscope::WithThreads([&]() { vtkSMPTools::For(first, std::min(first + chunk, n), divide); });
  }
}

// Some hundred cells at a time, so that progress is told and memory does not grow.
void vtkPolyhedronToTetrahedra::DivideByTetGen(vtkWork& work)
{
  if (!this->UseTetGen || !nephoscope::IsBuiltWithTetGen())
  {
    return;
  }
  std::vector<std::size_t> cells;
  for (std::size_t i = 0; i < work.Outcomes.size(); ++i)
  {
    if (work.Outcomes[i] == DivisionOutcome::NotStar)
    {
      cells.push_back(i);
    }
  }
  constexpr std::size_t batch = 200;
  for (std::size_t first = 0; first < cells.size() && !this->CheckAbort(); first += batch)
  {
    const std::size_t last = std::min(first + batch, cells.size());
    this->DivideBatchByTetGen(work,
      { cells.begin() + static_cast<std::ptrdiff_t>(first),
        cells.begin() + static_cast<std::ptrdiff_t>(last) });
    this->UpdateProgress(0.8 + 0.1 * static_cast<double>(last) / static_cast<double>(cells.size()));
  }
}

void vtkPolyhedronToTetrahedra::DivideBatchByTetGen(
  vtkWork& work, const std::vector<std::size_t>& cells)
{
  std::vector<std::unique_ptr<CellReader>> readers;
  std::vector<nephoscope::TetGenTask> tasks;
  for (const std::size_t i : cells)
  {
    readers.push_back(std::make_unique<CellReader>(work.Grid, work.Options));
    readers.back()->Divide(static_cast<vtkIdType>(i)); // makes its surface again
    tasks.push_back(readers.back()->GetDivider().MakeTask());
  }
  nephoscope::DivideTasksByTetGen(tasks, [this]() { return !this->CheckAbort(); });
  for (std::size_t k = 0; k < cells.size(); ++k)
  {
    const std::size_t i = cells[k];
    std::string reason;
    work.Outcomes[i] = readers[k]->GetDivider().Judge(tasks[k], reason);
    if (work.Outcomes[i] == DivisionOutcome::Divided)
    {
      work.Divisions[i] = readers[k]->TakeDivision();
    }
    work.Reason = work.Reason.empty() ? reason : work.Reason;
  }
}

void vtkPolyhedronToTetrahedra::Report(const vtkWork& work)
{
  for (const Complaint& complaint : Complaints(this->UseTetGen, work.Reason))
  {
    const auto count = std::count(work.Outcomes.begin(), work.Outcomes.end(), complaint.Outcome);
    if (count == 0)
    {
      continue;
    }
    this->NumberOfUndividedCells += count;
    const auto first = std::find(work.Outcomes.begin(), work.Outcomes.end(), complaint.Outcome);
    vtkWarningMacro(<< count << (count == 1 ? " polyhedron is" : " polyhedra are")
                    << " left undivided (cell " << first - work.Outcomes.begin()
                    << (count == 1 ? "" : " is the first") << "): " << complaint.What << ". "
                    << complaint.Remedy);
  }
}

void vtkPolyhedronToTetrahedra::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "DivideConvexPolyhedra: " << this->DivideConvexPolyhedra << "\n"
     << indent << "FaceWarpTolerance: " << this->FaceWarpTolerance << "\n"
     << indent << "UseTetGen: " << this->UseTetGen << "\n"
     << indent << "HasTetGen: " << vtkPolyhedronToTetrahedra::HasTetGen() << "\n"
     << indent << "NumberOfDividedCells: " << this->NumberOfDividedCells << "\n"
     << indent << "NumberOfNewPoints: " << this->NumberOfNewPoints << "\n"
     << indent << "NumberOfUndividedCells: " << this->NumberOfUndividedCells << "\n";
}

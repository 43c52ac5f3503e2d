// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Several blocks are as one; refined levels come first; what has no field says why.
#include "AdvanceParticles.h"
#include "FieldGrids.h"
#include "VelocityFields.h"

#include "vtkAMRBox.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkOverlappingAMR.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"
#include "vtkStructuredData.h"
#include "vtkTable.h"
#include "vtkUniformGrid.h"

#include <gtest/gtest.h>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
Vector3 Swirl(const Vector3& x)
{
  return { 2.5 - x[1], x[0] - 3.0, 0.2 };
}

std::unique_ptr<DataSetField> FieldOf(vtkDataObject* data, bool onCells = false)
{
  std::string problem;
  auto field = MakeVelocityField(data, { "velocity", onCells }, problem);
  EXPECT_TRUE(field) << problem;
  return field;
}

std::string ProblemOf(vtkDataObject* data, const VelocityArray& array = { "velocity", false })
{
  std::string problem;
  EXPECT_FALSE(MakeVelocityField(data, array, problem));
  return problem;
}

// The part of the image in columns `first` to `last`.
vtkSmartPointer<vtkImageData> Columns(vtkImageData* image, int first, int last)
{
  int extent[6];
  image->GetExtent(extent);
  auto part = vtkSmartPointer<vtkImageData>::New();
  part->DeepCopy(image);
  extent[1] = extent[0] + last;
  extent[0] += first;
  part->Crop(extent);
  return part;
}

struct Path
{
  std::vector<Vector3> Positions;
  std::vector<unsigned char> Inside;
};

Path Follow(const DataSetField& field, std::vector<Vector3> positions, int threads = 1)
{
  const std::size_t count = positions.size();
  std::vector<CellHint> hints(count);
  std::vector<unsigned char> inside(count, 1);
  IntegrationSettings settings;
  settings.Threads = threads;
  for (int k = 0; k < 30; ++k)
  {
    AdvanceParticles(
      field, { positions.data(), hints.data(), inside.data(), count, nullptr }, 0.0, 0.1, settings);
  }
  return { positions, inside };
}

bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

// A coarse level [0, 8]^3 of cells of 1 and a fine level [2, 6]^3 of cells of 0.5.
vtkSmartPointer<vtkOverlappingAMR> Refined(bool blank)
{
  auto amr = vtkSmartPointer<vtkOverlappingAMR>::New();
  int blocks[2] = { 1, 1 };
  amr->Initialize(2, blocks);
  const double origin[3] = { 0, 0, 0 };
  amr->SetOrigin(origin);
  int points[3] = { 9, 9, 9 };
  const int solid =
    vtkStructuredData::GetDataDescription(points); // its name is another from VTK 9.5 on
  amr->SetGridDescription(solid);
  for (unsigned int level = 0; level < 2; ++level)
  {
    const double h = level == 0 ? 1.0 : 0.5;
    const double low[3] = { level * 2.0, level * 2.0, level * 2.0 };
    const double spacing[3] = { h, h, h };
    amr->SetSpacing(level, spacing);
    vtkNew<vtkUniformGrid> grid;
    grid->SetOrigin(low);
    grid->SetSpacing(h, h, h);
    grid->SetDimensions(points);
    AddPointVectors(grid.Get(), [level](const Vector3&) { return Vector3{ level + 1.0, 0, 0 }; });
    if (level == 0 && blank)
    {
      auto* ghosts = grid->AllocateCellGhostArray();
      for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
      {
        double b[6];
        grid->GetCellBounds(i, b);
        const bool covered =
          b[0] >= 2 && b[1] <= 6 && b[2] >= 2 && b[3] <= 6 && b[4] >= 2 && b[5] <= 6;
        ghosts->SetValue(i, covered ? vtkDataSetAttributes::REFINEDCELL : 0);
      }
    }
    amr->SetAMRBox(level, 0, vtkAMRBox(low, points, spacing, origin, solid));
    amr->SetDataSet(level, 0, grid);
  }
  return amr;
}
}

TEST(CompositeFields, BlocksAreAsOne)
{
  auto whole = Image();
  AddPointVectors(whole, Swirl);
  vtkNew<vtkMultiBlockDataSet> inner;
  inner->SetBlock(0, Columns(whole, 2, 3));
  vtkNew<vtkPolyData> surface; // a boundary patch, as OpenFOAM readers give
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, Columns(whole, 3, 6));
  blocks->SetBlock(1, surface);
  blocks->SetBlock(2, inner);
  blocks->SetBlock(3, Columns(whole, 0, 2));
  vtkNew<vtkPartitionedDataSet> partitions;
  partitions->SetPartition(0, Columns(whole, 0, 1));
  partitions->SetPartition(1, Columns(whole, 1, 6));
  vtkNew<vtkPartitionedDataSetCollection> collection;
  collection->SetPartitionedDataSet(0, partitions);
  const auto seeds = PositionsInside(whole, 1500);
  const Path expected = Follow(*FieldOf(whole), seeds);
  const auto left = std::count(expected.Inside.begin(), expected.Inside.end(), 0);
  EXPECT_GT(left, 100);
  EXPECT_LT(left, 1400);
  for (vtkDataObject* data :
    std::initializer_list<vtkDataObject*>{ blocks, partitions, collection })
  {
    const auto field = FieldOf(data);
    for (const int threads : { 1, 2, 4 })
    {
      const Path path = Follow(*field, seeds, threads);
      EXPECT_TRUE(path.Inside == expected.Inside);
      double worst = 0.0;
      for (std::size_t i = 0; i < seeds.size(); ++i)
      {
        for (std::size_t c = 0; c < 3; ++c)
        {
          worst = std::max(worst, std::abs(path.Positions[i][c] - expected.Positions[i][c]));
        }
      }
      EXPECT_LT(worst, 1e-12);
    }
  }
}

TEST(CompositeFields, ArraysOfAllBlocks)
{
  auto whole = Image();
  AddPointVectors(whole, Swirl);
  auto left = Columns(whole, 0, 3);
  auto right = Columns(whole, 3, 6);
  AddPointVectors(right, LinearVelocity, "only right");
  vtkNew<vtkMultiBlockDataSet> blocks;
  blocks->SetBlock(0, left);
  blocks->SetBlock(1, right);
  const auto field = FieldOf(blocks);
  const std::vector<Vector3> positions = { { 1.5, 2, 2 }, { 4.5, 2, 2 }, { 50, 0, 0 } };
  const std::vector<CellHint> hints(3);
  vtkNew<vtkPointData> output;
  field->SampleArrays(3, positions.data(), hints.data(), output);
  auto* velocity = output->GetArray("velocity");
  auto* partial = output->GetArray("only right");
  ASSERT_TRUE(velocity && partial);
  EXPECT_NEAR(velocity->GetComponent(0, 1), -1.5, 1e-14);
  EXPECT_NEAR(velocity->GetComponent(1, 1), 1.5, 1e-14);
  EXPECT_TRUE(std::isnan(velocity->GetComponent(2, 1)));
  EXPECT_TRUE(std::isnan(partial->GetComponent(0, 0)));
  EXPECT_NEAR(partial->GetComponent(1, 0), LinearVelocity(positions[1])[0], 1e-14);
}

TEST(CompositeFields, TheFinestVisibleLevel)
{
  for (const bool blank : { false, true })
  {
    const auto amr = Refined(blank);
    const auto field = FieldOf(amr);
    const std::vector<Vector3> positions = { { 4, 4, 4 }, { 1, 1, 1 }, { 5.9, 2.1, 3 },
      { 6.1, 3, 3 } };
    const double expected[4] = { 2, 1, 2, 1 };
    std::vector<CellHint> hints(4);
    std::vector<Vector3> velocities(4);
    std::vector<unsigned char> inside(4);
    for (int block = 0; block < 2; ++block) // whatever the hint
    {
      for (auto& hint : hints)
      {
        hint.Block = block;
        hint.Cell = 100;
      }
      field->Sample({ 4, positions.data(), 0.0, velocities.data(), inside.data(), hints.data() });
      for (std::size_t i = 0; i < 4; ++i)
      {
        EXPECT_TRUE(inside[i]);
        EXPECT_DOUBLE_EQ(velocities[i][0], expected[i]);
      }
    }
  }
}

TEST(Problems, NameTheArrayWhatThereIsAndTheRemedy)
{
  auto image = Image();
  AddPointVectors(image, Swirl, "wind");
  AddCellVectors(image, Swirl, "flux");
  vtkNew<vtkDoubleArray> speed;
  speed->SetName("speed");
  speed->SetNumberOfTuples(image->GetNumberOfPoints());
  image->GetPointData()->AddArray(speed);
  std::string problem = ProblemOf(image);
  EXPECT_TRUE(Contains(problem, "no point array 'velocity'")) << problem;
  EXPECT_TRUE(Contains(problem, "'wind'") && Contains(problem, "'flux'")) << problem;
  EXPECT_FALSE(Contains(problem, "'speed'")) << problem;
  EXPECT_TRUE(Contains(problem, "Calculator")) << problem;
  problem = ProblemOf(image, { "flux", false });
  EXPECT_TRUE(Contains(problem, "'flux'") && Contains(problem, "cell array of that name"))
    << problem;
  problem = ProblemOf(image, { "wind", true });
  EXPECT_TRUE(Contains(problem, "'wind'") && Contains(problem, "point array of that name"))
    << problem;
  problem = ProblemOf(image, { "speed", false });
  EXPECT_TRUE(Contains(problem, "'speed' has 1 component;")) << problem;
  image->GetPointData()->RemoveArray("wind");
  image->GetCellData()->RemoveArray("flux");
  EXPECT_TRUE(Contains(ProblemOf(image), "three components: none"));
}

TEST(Problems, ShapesWithoutVolume)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    vtkNew<vtkImageData> flat;
    int dimensions[3] = { 4, 5, 6 };
    dimensions[axis] = 1;
    flat->SetDimensions(dimensions);
    AddPointVectors(flat.Get(), Swirl);
    EXPECT_TRUE(Contains(ProblemOf(flat), "flat")) << axis;
  }
  vtkNew<vtkImageData> none;
  EXPECT_TRUE(Contains(ProblemOf(none), "empty"));
  vtkNew<vtkUnstructuredGrid> noCells;
  EXPECT_TRUE(Contains(ProblemOf(noCells), "empty"));
  vtkNew<vtkUnstructuredGrid> triangle;
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  triangle->SetPoints(points);
  const vtkIdType ids[3] = { 0, 1, 2 };
  triangle->InsertNextCell(VTK_TRIANGLE, 3, ids);
  AddPointVectors(triangle.Get(), Swirl);
  EXPECT_TRUE(Contains(ProblemOf(triangle), "no cells with a volume"));
  vtkNew<vtkMultiBlockDataSet> blocks;
  EXPECT_TRUE(Contains(ProblemOf(blocks), "empty"));
  blocks->SetBlock(0, triangle);
  EXPECT_TRUE(Contains(ProblemOf(blocks), "No block"));
  vtkNew<vtkTable> table;
  EXPECT_TRUE(Contains(ProblemOf(table), "vtkTable"));
  EXPECT_TRUE(Contains(ProblemOf(nullptr), "no dataset"));
}

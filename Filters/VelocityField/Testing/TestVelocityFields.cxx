// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Fields of datasets: exact for linear velocities on every kind of grid, whatever the hint, the
// number type and the threads; blanked cells and missing values are outside.
#include "AdvanceParticles.h"
#include "FieldGrids.h"
#include "VelocityFields.h"

#include "vtkIntArray.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkShortArray.h"
#include "vtkStringArray.h"
#include "vtkUnsignedCharArray.h"

#include <gtest/gtest.h>

#include <limits>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
std::unique_ptr<DataSetField> FieldOf(vtkDataObject* data, bool onCells = false)
{
  std::string problem;
  auto field = MakeVelocityField(data, { "velocity", onCells }, problem);
  EXPECT_TRUE(field) << problem;
  EXPECT_EQ(problem, "");
  return field;
}

struct Samples
{
  Samples(const DataSetField& field, const std::vector<Vector3>& positions, std::int64_t hint = -1)
    : Hints(positions.size())
    , Velocities(positions.size())
    , Inside(positions.size())
  {
    for (std::size_t i = 0; hint >= 0 && i < positions.size(); ++i)
    {
      this->Hints[i].Cell = hint + static_cast<std::int64_t>(i);
      this->Hints[i].Block = static_cast<std::int32_t>(i % 5);
    }
    field.Sample({ positions.size(), positions.data(), 0.0, this->Velocities.data(),
      this->Inside.data(), this->Hints.data() });
  }

  std::vector<CellHint> Hints;
  std::vector<Vector3> Velocities;
  std::vector<unsigned char> Inside;
};

bool IsInside(const DataSetField& field, const Vector3& position)
{
  return Samples(field, { position }).Inside[0] != 0;
}
}

TEST(VelocityFields, LinearVelocityIsExactOnEveryGridFromEveryHint)
{
  for (const auto& grid : AllGrids())
  {
    SCOPED_TRACE(grid.first);
    AddPointVectors(grid.second, LinearVelocity);
    const auto field = FieldOf(grid.second);
    const auto positions = PositionsInside(grid.second, 2000);
    for (const std::int64_t hint : { -1, 0, 50, 100000 }) // the last is of no cell
    {
      const Samples samples(*field, positions, hint);
      double worst = 0.0;
      int lost = 0;
      for (std::size_t i = 0; i < positions.size(); ++i)
      {
        lost += !samples.Inside[i];
        worst = std::max(worst, Distance(samples.Velocities[i], LinearVelocity(positions[i])));
      }
      EXPECT_EQ(lost, 0);
      EXPECT_LT(worst, 2e-13);
    }
    EXPECT_FALSE(IsInside(*field, { 100, 0, 0 }));
    EXPECT_FALSE(IsInside(*field, { std::nan(""), 0, 0 }));
  }
}

TEST(VelocityFields, EveryNumberType)
{
  // Whole numbers: exact in every type.
  const auto velocity = [](const Vector3& x) -> Vector3 { return { 2 * x[0], -x[1], 3 + x[2] }; };
  const std::vector<Vector3> positions = PositionsInside(Image(), 200);
  const auto check = [&](auto* tag) {
    using Array = std::remove_pointer_t<decltype(tag)>;
    auto image = Image();
    AddPointVectors<Array>(image, velocity);
    const Samples samples(*FieldOf(image), positions);
    for (std::size_t i = 0; i < positions.size(); ++i)
    {
      EXPECT_LT(Distance(samples.Velocities[i], velocity(positions[i])), 1e-13);
    }
  };
  check(static_cast<vtkDoubleArray*>(nullptr));
  check(static_cast<vtkFloatArray*>(nullptr));
  check(static_cast<vtkShortArray*>(nullptr));
  check(static_cast<vtkSOADataArrayTemplate<float>*>(nullptr));
  check(static_cast<vtkSOADataArrayTemplate<double>*>(nullptr));
}

TEST(VelocityFields, HiddenCellsAreOutsideAndTheirFacesAreNot)
{
  auto image = Image();
  AddPointVectors(image, LinearVelocity);
  image->AllocateCellGhostArray()->SetValue(0, vtkDataSetAttributes::HIDDENCELL); // [0, 1]^3
  const auto field = FieldOf(image);
  EXPECT_FALSE(IsInside(*field, { 0.5, 0.5, 0.5 }));
  EXPECT_TRUE(IsInside(*field, { 1.5, 0.5, 0.5 }));
  for (const std::int64_t hint : { -1, 0, 1 })
  {
    EXPECT_TRUE(Samples(*field, { { 1.0, 0.5, 0.5 } }, hint).Inside[0]);
    EXPECT_FALSE(Samples(*field, { { 0.0, 0.5, 0.5 } }, hint).Inside[0]);
  }
  auto hexahedra = Hexahedra();
  AddPointVectors(hexahedra, LinearVelocity);
  hexahedra->AllocateCellGhostArray()->SetValue(0, vtkDataSetAttributes::HIDDENCELL);
  const auto cells = FieldOf(hexahedra);
  EXPECT_FALSE(IsInside(*cells, { 0.6, 0.7, 0.5 }));
  EXPECT_TRUE(IsInside(*cells, { 1.7, 0.7, 0.5 }));
}

TEST(VelocityFields, AHiddenPointHidesItsCellsAndDuplicatesStay)
{
  auto image = Image();
  AddPointVectors(image, LinearVelocity);
  auto* ghosts = image->AllocatePointGhostArray();
  ghosts->FillValue(vtkDataSetAttributes::DUPLICATEPOINT);
  ghosts->SetValue(0, vtkDataSetAttributes::HIDDENPOINT);
  image->AllocateCellGhostArray()->FillValue(vtkDataSetAttributes::DUPLICATECELL);
  const auto field = FieldOf(image);
  EXPECT_FALSE(IsInside(*field, { 0.5, 0.5, 0.5 }));
  EXPECT_TRUE(IsInside(*field, { 1.5, 0.5, 0.5 }));
}

TEST(VelocityFields, ValuesThatAreNoNumbersAreOutside)
{
  for (const auto& grid : AllGrids())
  {
    SCOPED_TRACE(grid.first);
    AddPointVectors(grid.second, LinearVelocity);
    auto* velocity = grid.second->GetPointData()->GetArray("velocity");
    const vtkIdType middle = 3 + 7 * (2 + 6 * 2);
    velocity->SetComponent(middle, 1, std::nan(""));
    velocity->SetComponent(middle + 1, 2, std::numeric_limits<double>::infinity());
    const auto field = FieldOf(grid.second);
    Vector3 x;
    grid.second->GetPoint(middle, x.data());
    EXPECT_FALSE(IsInside(*field, x));
    grid.second->GetPoint(0, x.data());
    EXPECT_TRUE(IsInside(*field, x));
  }
}

TEST(VelocityFields, CellVelocities)
{
  auto image = Image();
  AddCellVectors(image, LinearVelocity);
  const auto field = FieldOf(image, true);
  // Away from the boundary the mean of the cells around a point is the linear field itself.
  for (const Vector3& x :
    { Vector3{ 2.3, 2.2, 1.7 }, Vector3{ 5.0, 3.5, 3.0 }, Vector3{ 1.0, 1.0, 1.0 } })
  {
    const Samples samples(*field, { x });
    EXPECT_TRUE(samples.Inside[0]);
    EXPECT_LT(Distance(samples.Velocities[0], LinearVelocity(x)), 1e-13);
  }
  auto tetrahedra = Tetrahedra();
  AddCellVectors(tetrahedra, [](const Vector3&) { return Vector3{ 1, 2, 3 }; });
  const Samples samples(*FieldOf(tetrahedra, true), PositionsInside(tetrahedra, 100));
  for (const Vector3& v : samples.Velocities)
  {
    EXPECT_LT(Distance(v, { 1, 2, 3 }), 1e-14);
  }
}

TEST(VelocityFields, HiddenCellsDoNotCountInTheMean)
{
  auto image = Image();
  AddCellVectors(image, [](const Vector3& x) {
    return x[0] < 3.0 ? Vector3{ 1, 2, 3 } : Vector3{ 1e20, 1e20, 1e20 };
  });
  auto* ghosts = image->AllocateCellGhostArray();
  for (vtkIdType i = 0; i < image->GetNumberOfCells(); ++i)
  {
    ghosts->SetValue(i, i % 6 >= 3 ? vtkDataSetAttributes::HIDDENCELL : 0);
  }
  const auto field = FieldOf(image, true);
  const Samples samples(*field, { { 2.9, 2, 2 }, { 3.1, 2, 2 } });
  ASSERT_TRUE(samples.Inside[0]);
  EXPECT_LT(Distance(samples.Velocities[0], { 1, 2, 3 }), 1e-14);
  EXPECT_FALSE(samples.Inside[1]);
}

TEST(VelocityFields, TheNumberOfThreadsDoesNotMatter)
{
  for (const auto& grid : AllGrids())
  {
    SCOPED_TRACE(grid.first);
    AddPointVectors(grid.second, [](const Vector3& x) -> Vector3 {
      return { 2.0 - x[1], x[0] - 3.0, 0.1 };
    });
    const auto seeds = PositionsInside(grid.second, 1000);
    for (const auto method : { IntegrationMethod::RungeKutta4, IntegrationMethod::DormandPrince })
    {
      std::vector<Vector3> expected;
      std::vector<unsigned char> expectedInside;
      for (const int threads : { 1, 2, 4 })
      {
        const auto field = FieldOf(grid.second);
        auto positions = seeds;
        std::vector<CellHint> hints(seeds.size());
        std::vector<unsigned char> inside(seeds.size(), 1);
        IntegrationSettings settings;
        settings.Method = method;
        settings.Threads = threads;
        for (int k = 0; k < 4; ++k)
        {
          AdvanceParticles(*field,
            { positions.data(), hints.data(), inside.data(), seeds.size(), nullptr }, 0.0, 0.2,
            settings);
        }
        if (expected.empty())
        {
          expected = positions;
          expectedInside = inside;
          EXPECT_GT(std::count(inside.begin(), inside.end(), 1), 100);
          EXPECT_GT(std::count(inside.begin(), inside.end(), 0), 10);
        }
        EXPECT_TRUE(positions == expected);
        EXPECT_TRUE(inside == expectedInside);
      }
    }
  }
}

TEST(SampleArrays, EveryArrayOnEveryGrid)
{
  for (const auto& grid : AllGrids())
  {
    SCOPED_TRACE(grid.first);
    AddPointVectors(grid.second, LinearVelocity);
    AddPointVectors<vtkIntArray>(
      grid.second,
      [](const Vector3&) {
        return Vector3{ 7, -8, 9 };
      },
      "whole");
    vtkNew<vtkStringArray> names;
    names->SetName("names");
    names->SetNumberOfValues(grid.second->GetNumberOfPoints());
    grid.second->GetPointData()->AddArray(names);
    grid.second->AllocatePointGhostArray();
    const auto field = FieldOf(grid.second);
    auto positions = PositionsInside(grid.second, 3000);
    positions.push_back({ 1000, 0, 0 });
    const Samples samples(*field, positions);
    vtkNew<vtkPointData> output;
    field->SampleArrays(positions.size(), positions.data(), samples.Hints.data(), output);
    EXPECT_EQ(output->GetNumberOfArrays(), 2);
    auto* velocity = vtkDoubleArray::SafeDownCast(output->GetArray("velocity"));
    auto* whole = vtkIntArray::SafeDownCast(output->GetArray("whole"));
    ASSERT_TRUE(velocity && whole);
    for (std::size_t i = 0; i + 1 < positions.size(); ++i)
    {
      Vector3 value;
      velocity->GetTuple(static_cast<vtkIdType>(i), value.data());
      EXPECT_LT(Distance(value, LinearVelocity(positions[i])), 2e-13);
      whole->GetTuple(static_cast<vtkIdType>(i), value.data());
      EXPECT_EQ(value, (Vector3{ 7, -8, 9 }));
    }
    EXPECT_TRUE(std::isnan(velocity->GetComponent(3000, 2)));
    EXPECT_EQ(whole->GetComponent(3000, 1), 0);
  }
}

TEST(SampleArrays, CellArraysTooIfTheVelocityIsOnCells)
{
  auto image = Image();
  AddCellVectors(image, LinearVelocity);
  AddCellVectors(
    image,
    [](const Vector3& x) {
      return Vector3{ x[0], 0, 0 };
    },
    "place");
  AddPointVectors(image, LinearVelocity, "points");
  const auto field = FieldOf(image, true);
  const Vector3 x{ 2.25, 2.5, 2.75 };
  const Samples samples(*field, { x });
  vtkNew<vtkPointData> output;
  field->SampleArrays(1, &x, samples.Hints.data(), output);
  EXPECT_EQ(output->GetNumberOfArrays(), 3);
  EXPECT_NEAR(output->GetArray("place")->GetComponent(0, 0), 2.25, 1e-14);
  EXPECT_NEAR(output->GetArray("points")->GetComponent(0, 0), LinearVelocity(x)[0], 1e-14);
}

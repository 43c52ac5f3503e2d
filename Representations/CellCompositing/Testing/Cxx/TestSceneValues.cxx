// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Where only values of arrays change, nothing else is made again, and what there is is the same as
// if all had been.
#include "CellScene.h"

#include "OrderMeshes.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkDoubleArray.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
vtkDataArray* AddCellValues(vtkDataSet* data, double step)
{
  vtkDataArray* array =
    AddScalars(data, true, [=](vtkIdType i) { return std::fmod(0.3 + step * double(i), 1.0); });
  return array;
}

class SceneOfPuffs : public ::testing::Test
{
protected:
  SceneOfPuffs()
  {
    this->Opacity->AddPoint(0, 0);
    this->Opacity->AddPoint(0.25, 0);
    this->Opacity->AddPoint(1, 1);
    this->Property->SetScalarOpacity(this->Opacity);
    this->Property->SetColor(this->Color);
    this->Color->AddRGBPoint(0, 1, 1, 1);
    this->Color->AddRGBPoint(1, 0, 1, 1);
  }

  CellScene::Versions Update(CellScene& scene, const ScalarSelection& colors,
    const ScalarSelection& opacities, CellScene::Method method = CellScene::Method::Projection,
    ProjectionOrder::Kind order = ProjectionOrder::Kind::Topological)
  {
    std::string error;
    this->Built =
      scene.UpdateGeometry(this->Data, colors, opacities, CellGeometry::Form::Grid, error);
    EXPECT_EQ(error, "");
    scene.UpdateTransferFunction(this->Property);
    EXPECT_TRUE(scene.UpdateMethod(method));
    if (method == CellScene::Method::Projection)
    {
      EXPECT_TRUE(scene.UpdateOrder(order, this->Eye));
    }
    else
    {
      scene.UpdateEye(this->Eye);
    }
    scene.UpdateDrawn();
    return scene.GetVersions();
  }

  /** What the scene has is what one made afresh has. */
  void ExpectAsNew(const ScalarSelection& colors, const ScalarSelection& opacities,
    CellScene::Method method = CellScene::Method::Projection)
  {
    CellScene fresh;
    this->Update(fresh, colors, opacities, method);
    const CellGeometry &a = this->Scene.GetGeometry(), &b = fresh.GetGeometry();
    EXPECT_EQ(a.Tetrahedra.Copy(), b.Tetrahedra.Copy());
    EXPECT_EQ(a.CellScalars, b.CellScalars);
    EXPECT_EQ(a.OpacityScalars, b.OpacityScalars);
    EXPECT_EQ(a.HasOpacityScalars, b.HasOpacityScalars);
    EXPECT_EQ(a.OpacityOnCells, b.OpacityOnCells);
    EXPECT_EQ(a.SingleScalar, b.SingleScalar);
    EXPECT_EQ(a.ScalarRange[1], b.ScalarRange[1]);
    EXPECT_EQ(a.OpacityRange[1], b.OpacityRange[1]);
    ASSERT_EQ(a.Points.size(), b.Points.size());
    for (std::size_t i = 0; i < a.Points.size(); ++i)
    {
      EXPECT_EQ(a.Points[i].Scalar, b.Points[i].Scalar);
    }
    EXPECT_EQ(this->Scene.GetDrawn(), fresh.GetDrawn());
    EXPECT_EQ(this->Scene.GetNumberOfVisible(), fresh.GetNumberOfVisible());
    EXPECT_EQ(this->Scene.GetTransferFunction().Nodes, fresh.GetTransferFunction().Nodes);
    EXPECT_EQ(this->Scene.GetOpacityFunction().Nodes, fresh.GetOpacityFunction().Nodes);
    if (method == CellScene::Method::Rays)
    {
      EXPECT_EQ(this->Scene.GetNeighbors()->Neighbors, fresh.GetNeighbors()->Neighbors);
      EXPECT_EQ(this->Scene.GetEyeTetrahedron().Opacity, fresh.GetEyeTetrahedron().Opacity);
    }
  }

  vtkSmartPointer<vtkUnstructuredGrid> Data =
    MakeCubeWithout(4, [](int i, int j, int k) { return i == 1 && j == 2 && k == 0; });
  vtkNew<vtkPiecewiseFunction> Opacity;
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkVolumeProperty> Property;
  Vector4 Eye = { { 9, 8, 7, 1 } };
  CellScene Scene;
  bool Built = false;
};
}

TEST_F(SceneOfPuffs, OpacityOfCellsMovesNothingElse)
{
  const ScalarSelection colors = { AddPointNumbers(this->Data), false, -1 };
  for (const auto method : { CellScene::Method::Projection, CellScene::Method::Rays })
  {
    vtkDataArray* density = AddCellValues(this->Data, 0.17);
    const CellScene::Versions first =
      this->Update(this->Scene, colors, { density, true, -1 }, method);
    density->SetComponent(5, 0, 0.9);
    density->Modified();
    const CellScene::Versions second =
      this->Update(this->Scene, colors, { density, true, -1 }, method);
    EXPECT_FALSE(this->Built);
    EXPECT_EQ(first.Geometry, second.Geometry);
    EXPECT_EQ(first.Colors, second.Colors);
    EXPECT_NE(first.Opacities, second.Opacities);
    EXPECT_EQ(first.Topology, second.Topology);
    EXPECT_EQ(first.Order, second.Order);
    EXPECT_EQ(first.Transfer, second.Transfer) << "the range is the same";
    this->ExpectAsNew(colors, { density, true, -1 }, method);

    // Another array, with another range, in another dataset, as a filter gives it.
    vtkDataArray* moved = AddCellValues(this->Data, 0.31);
    moved->SetComponent(0, 0, 1.7);
    this->Data->Modified();
    const CellScene::Versions third =
      this->Update(this->Scene, colors, { moved, true, -1 }, method);
    EXPECT_EQ(first.Geometry, third.Geometry);
    EXPECT_EQ(first.Topology, third.Topology);
    EXPECT_EQ(first.Order, third.Order);
    EXPECT_NE(second.Opacities, third.Opacities);
    EXPECT_NE(second.Transfer, third.Transfer);
    this->ExpectAsNew(colors, { moved, true, -1 }, method);
    const auto copy = vtkSmartPointer<vtkUnstructuredGrid>::New();
    copy->ShallowCopy(this->Data);
    this->Data = copy;
    const CellScene::Versions fourth =
      this->Update(this->Scene, colors, { moved, true, -1 }, method);
    EXPECT_EQ(fourth.Latest(), third.Latest()) << "nothing to upload";
  }
}

TEST_F(SceneOfPuffs, SelectionsThatChangeSides)
{
  vtkDataArray* ofPoints = AddPointNumbers(this->Data);
  vtkDataArray* ofCells = AddCellValues(this->Data, 0.17);
  const ScalarSelection choices[] = { { ofPoints, false, -1 }, { ofCells, true, -1 }, {} };
  this->Update(this->Scene, choices[0], choices[1]);
  const std::int64_t geometry = this->Scene.GetVersions().Geometry;
  for (int colors = 0; colors < 2; ++colors)
  {
    for (int opacities = 0; opacities < 3; ++opacities)
    {
      this->Update(this->Scene, choices[colors], choices[opacities]);
      EXPECT_EQ(this->Scene.GetVersions().Geometry, geometry);
      this->ExpectAsNew(choices[colors], choices[opacities]);
    }
  }
}

TEST_F(SceneOfPuffs, MissingValuesMakeTheGeometryAgain)
{
  vtkDataArray* density = AddCellValues(this->Data, 0.17);
  const ScalarSelection colors = { AddPointNumbers(this->Data), false, -1 };
  this->Update(this->Scene, colors, { density, true, -1 });
  const std::size_t whole = this->Scene.GetGeometry().Tetrahedra.size();
  density->SetComponent(3, 0, std::numeric_limits<double>::quiet_NaN());
  density->Modified();
  this->Update(this->Scene, colors, { density, true, -1 });
  EXPECT_TRUE(this->Built);
  EXPECT_LT(this->Scene.GetGeometry().Tetrahedra.size(), whole);
  EXPECT_EQ(this->Scene.GetGeometry().NumberOfInvalidCells, 1);
  density->SetComponent(3, 0, 0.5);
  density->Modified();
  this->Update(this->Scene, colors, { density, true, -1 });
  EXPECT_EQ(this->Scene.GetGeometry().Tetrahedra.size(), whole);
  this->ExpectAsNew(colors, { density, true, -1 });
}

// Points at the same place are one for rays where their values are equal.
TEST_F(SceneOfPuffs, ValuesOfCoincidentPoints)
{
  BlockMesh blocks;
  blocks.AddBox(2, 2, 2, { { 0, 0, 0 } }, { { 1, 1, 1 } });
  blocks.AddBox(2, 2, 2, { { 1, 0, 0 } }, { { 2, 1, 1 } });
  this->Data = blocks.Get();
  vtkDataArray* height =
    AddScalars(this->Data, false, [&](vtkIdType i) { return this->Data->GetPoint(i)[2]; });
  const ScalarSelection colors = { height, false, -1 };
  const CellScene::Versions first = this->Update(this->Scene, colors, {}, CellScene::Method::Rays);
  height->SetComponent(2, 0, 5); // now two places have two values each
  height->SetComponent(11, 0, 6);
  height->Modified();
  const CellScene::Versions second = this->Update(this->Scene, colors, {}, CellScene::Method::Rays);
  EXPECT_EQ(first.Geometry, second.Geometry);
  EXPECT_NE(first.Topology, second.Topology);
  this->ExpectAsNew(colors, {}, CellScene::Method::Rays);
  // Values of cells do not matter to them.
  const ScalarSelection density = { AddCellValues(this->Data, 0.2), true, -1 };
  const CellScene::Versions third =
    this->Update(this->Scene, colors, density, CellScene::Method::Rays);
  EXPECT_EQ(second.Topology, third.Topology);
  this->ExpectAsNew(colors, density, CellScene::Method::Rays);
}

TEST_F(SceneOfPuffs, WithoutAnOrderTheEyeMovesNothing)
{
  const ScalarSelection colors = { AddCellValues(this->Data, 0.17), true, -1 };
  const CellScene::Versions first = this->Update(
    this->Scene, colors, {}, CellScene::Method::Projection, ProjectionOrder::Kind::None);
  EXPECT_TRUE(this->Scene.UpdateOrder(ProjectionOrder::Kind::None, { { -3, 2, 1, 1 } }));
  this->Scene.UpdateDrawn();
  EXPECT_EQ(this->Scene.GetVersions().Order, first.Order);
  EXPECT_EQ(this->Scene.GetVersions().Latest(), first.Latest());
}

TEST_F(SceneOfPuffs, OneColourFollowsFunctionAndRange)
{
  vtkDataArray* values = AddCellValues(this->Data, 0.17);
  this->Update(this->Scene, { values, true, -1 }, {});
  EXPECT_FALSE(this->Scene.HasOneColor());
  values->Fill(0.6);
  values->Modified();
  this->Update(this->Scene, { values, true, -1 }, {});
  EXPECT_TRUE(this->Scene.HasOneColor()) << "a single value, whatever the function";
  values->SetComponent(0, 0, 0.7);
  values->Modified();
  this->Update(this->Scene, { values, true, -1 }, {});
  EXPECT_FALSE(this->Scene.HasOneColor());
  this->Color->AddRGBPoint(1, 1, 1, 1);
  this->Update(this->Scene, { values, true, -1 }, {});
  EXPECT_TRUE(this->Scene.HasOneColor());
}

TEST_F(SceneOfPuffs, TheMethodMayChange)
{
  const ScalarSelection colors = { AddCellValues(this->Data, 0.17), true, -1 };
  const CellScene::Versions first = this->Update(this->Scene, colors, {});
  const std::vector<std::int32_t> drawn = this->Scene.GetDrawn();
  const CellScene::Versions second = this->Update(this->Scene, colors, {}, CellScene::Method::Rays);
  EXPECT_EQ(first.Geometry, second.Geometry);
  EXPECT_NE(first.Topology, second.Topology);
  this->ExpectAsNew(colors, {}, CellScene::Method::Rays);
  const CellScene::Versions third = this->Update(this->Scene, colors, {});
  EXPECT_NE(second.Topology, third.Topology);
  EXPECT_NE(second.Drawn, third.Drawn);
  EXPECT_EQ(this->Scene.GetDrawn(), drawn);
}

TEST_F(SceneOfPuffs, WhatWasUploadedIsMadeAgainOnRequest)
{
  const ScalarSelection colors = { AddCellValues(this->Data, 0.17), true, -1 };
  const auto rays = CellScene::Method::Rays;
  const CellScene::Versions first = this->Update(this->Scene, colors, {}, rays);
  this->Scene.ReleaseUploaded();
  EXPECT_EQ(this->Scene.GetNeighbors()->Neighbors.capacity(), 0u);
  EXPECT_EQ(this->Scene.GetNeighbors()->VertexSums.capacity(), 0u);
  EXPECT_EQ(this->Update(this->Scene, colors, {}, rays).Latest(), first.Latest());
  EXPECT_TRUE(this->Scene.GetNeighbors()->Neighbors.empty()) << "nobody needs them";
  this->Scene.RenewUploaded();
  EXPECT_NE(this->Update(this->Scene, colors, {}, rays).Topology, first.Topology);
  this->ExpectAsNew(colors, {}, rays);
  this->Scene.ReleaseUploaded();
  this->Update(this->Scene, colors, {});
  this->ExpectAsNew(colors, {});
}

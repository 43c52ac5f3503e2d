// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What the mapper keeps between renders is made again when, and only when, its source changed.
#include "CellScene.h"

#include "OrderMeshes.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolumeProperty.h"

#include <gtest/gtest.h>

using namespace nephoscope;
using namespace nephoscope_test;

namespace
{
class SceneOfALattice : public ::testing::Test
{
protected:
  SceneOfALattice()
  {
    this->Opacity->AddPoint(0, 1);
    this->Opacity->AddPoint(124, 1);
    this->Property->SetScalarOpacity(this->Opacity);
    this->Property->SetColor(this->Color);
  }

  CellScene::Versions Update(const Vector4& eye = { { 9, 8, 7, 1 } },
    ProjectionOrder::Kind order = ProjectionOrder::Kind::Topological)
  {
    std::string error;
    this->Scene.UpdateGeometry(
      this->Data, { this->Scalars, false, -1 }, {}, CellGeometry::Form::Tetrahedra, error);
    EXPECT_EQ(error, "");
    this->Scene.UpdateTransferFunction(this->Property);
    EXPECT_TRUE(this->Scene.UpdateOrder(order, eye));
    this->Scene.UpdateDrawn();
    return this->Scene.GetVersions();
  }

  vtkSmartPointer<vtkStructuredGrid> Data = MakeLattice(4);
  vtkDataArray* Scalars = AddPointNumbers(Data);
  vtkNew<vtkPiecewiseFunction> Opacity;
  vtkNew<vtkColorTransferFunction> Color;
  vtkNew<vtkVolumeProperty> Property;
  CellScene Scene;
};
}

TEST_F(SceneOfALattice, NothingChangesNothingIsMadeAgain)
{
  const CellScene::Versions first = this->Update();
  const CellScene::Versions second = this->Update();
  EXPECT_EQ(first.Geometry, second.Geometry);
  EXPECT_EQ(first.Transfer, second.Transfer);
  EXPECT_EQ(first.Order, second.Order);
  EXPECT_EQ(first.Drawn, second.Drawn);
  EXPECT_EQ(this->Scene.GetDrawn().size(), 64u * 5);
  EXPECT_EQ(this->Scene.GetOrder().NumberOfCycles, 0);
}

TEST_F(SceneOfALattice, TheEyeMovesTheOrder)
{
  const CellScene::Versions first = this->Update();
  const std::vector<std::int32_t> order = this->Scene.GetDrawn();
  const CellScene::Versions second = this->Update({ { -9, -8, -7, 1 } });
  EXPECT_EQ(first.Geometry, second.Geometry);
  EXPECT_EQ(first.Transfer, second.Transfer);
  EXPECT_NE(first.Order, second.Order);
  EXPECT_NE(first.Drawn, second.Drawn);
  EXPECT_NE(this->Scene.GetDrawn(), order);
  this->Update();
  EXPECT_EQ(this->Scene.GetDrawn(), order);
}

TEST_F(SceneOfALattice, TheMethodMakesTheOrderAgain)
{
  this->Update();
  const CellScene::Versions second = this->Update({ { 9, 8, 7, 1 } }, ProjectionOrder::Kind::None);
  EXPECT_TRUE(std::is_sorted(this->Scene.GetDrawn().begin(), this->Scene.GetDrawn().end()));
  EXPECT_NE(this->Update({ { 9, 8, 7, 1 } }, ProjectionOrder::Kind::Centroid).Order, second.Order);
}

TEST_F(SceneOfALattice, TheOpacityFunctionChoosesWhatIsDrawn)
{
  const CellScene::Versions first = this->Update();
  this->Opacity->RemoveAllPoints();
  this->Opacity->AddPoint(0, 0);
  this->Opacity->AddPoint(99.5, 0);
  this->Opacity->AddPoint(124, 1);
  const CellScene::Versions second = this->Update();
  EXPECT_EQ(first.Geometry, second.Geometry);
  EXPECT_EQ(first.Order, second.Order);
  EXPECT_NE(first.Transfer, second.Transfer);
  EXPECT_NE(first.Drawn, second.Drawn);
  EXPECT_EQ(this->Scene.GetDrawn().size(), 16u * 5) << "only the last layer reaches beyond 100";
  this->Color->AddRGBPoint(0, 1, 0, 0);
  EXPECT_NE(this->Update().Transfer, second.Transfer);
}

TEST_F(SceneOfALattice, DataAndScalarsMakeEverythingAgain)
{
  const CellScene::Versions first = this->Update();
  this->Data->GetPoints()->SetPoint(0, -1, -1, -1);
  this->Data->GetPoints()->Modified();
  this->Data->Modified();
  const CellScene::Versions second = this->Update();
  EXPECT_NE(first.Geometry, second.Geometry);
  EXPECT_NE(first.Transfer, second.Transfer);
  EXPECT_NE(first.Order, second.Order);
  EXPECT_NE(first.Drawn, second.Drawn);
  this->Scalars->SetComponent(0, 0, 500);
  this->Scalars->Modified();
  EXPECT_NE(this->Update().Geometry, second.Geometry);
  EXPECT_EQ(this->Scene.GetGeometry().ScalarRange[1], 500);
}

TEST_F(SceneOfALattice, AnotherMeshIsConnectedAgain)
{
  this->Update();
  this->Data = MakeShell(8, 4, 2, 80, 1, 1.3); // as many cells
  this->Scalars = AddPointNumbers(this->Data);
  this->Update();
  ASSERT_EQ(this->Scene.GetDrawn().size(), 64u * 5);
  const std::vector<std::int32_t> drawn = this->Scene.GetDrawn();
  this->Scene = CellScene();
  this->Update();
  EXPECT_EQ(drawn, this->Scene.GetDrawn());
}

TEST_F(SceneOfALattice, CyclesAreCounted)
{
  this->Data = MakeTwistedTube(24, 2, 1);
  this->Scalars = AddPointNumbers(this->Data);
  const Vector4 above = { { 0.1, 0.05, 9, 1 } }, aside = { { 9, 1, 0.5, 1 } };
  this->Update(aside);
  EXPECT_EQ(this->Scene.GetOrder().NumberOfCycles, 0);
  const std::size_t whole = this->Scene.GetGeometry().Tetrahedra.size();
  this->Update(above);
  EXPECT_GT(this->Scene.GetOrder().NumberOfCycles, 0);
  EXPECT_GE(this->Scene.GetOrder().NumberOfCyclicTetrahedra, 24);
  EXPECT_EQ(this->Scene.GetDrawn().size(), whole);
  this->Update(above, ProjectionOrder::Kind::Centroid);
  EXPECT_EQ(this->Scene.GetOrder().NumberOfCycles, 0);
}

TEST_F(SceneOfALattice, StoppedAndResumed)
{
  this->Update();
  const std::vector<std::int32_t> drawn = this->Scene.GetDrawn();
  const Progress stop([](double) { return false; });
  std::string error;
  this->Data->Modified();
  EXPECT_FALSE(this->Scene.UpdateGeometry(this->Data, { this->Scalars, false, -1 }, {},
    CellGeometry::Form::Tetrahedra, error, nullptr, stop));
  EXPECT_EQ(error, "");
  EXPECT_TRUE(this->Scene.GetGeometry().Tetrahedra.empty());
  EXPECT_TRUE(this->Scene.UpdateGeometry(
    this->Data, { this->Scalars, false, -1 }, {}, CellGeometry::Form::Tetrahedra, error))
    << "made again";
  EXPECT_FALSE(
    this->Scene.UpdateOrder(ProjectionOrder::Kind::Topological, { { 9, 8, 7, 1 } }, stop));
  this->Update();
  EXPECT_EQ(this->Scene.GetDrawn(), drawn);
  this->Update({ { -9, 8, 7, 1 } });
  EXPECT_FALSE(
    this->Scene.UpdateOrder(ProjectionOrder::Kind::Topological, { { 9, 8, 7, 1 } }, stop))
    << "connected, but not sorted";
  this->Update();
  EXPECT_EQ(this->Scene.GetDrawn(), drawn);
}

TEST_F(SceneOfALattice, ClearDrawsNothing)
{
  const CellScene::Versions first = this->Update();
  this->Scene.Clear();
  EXPECT_TRUE(this->Scene.GetDrawn().empty());
  EXPECT_TRUE(this->Scene.GetGeometry().Tetrahedra.empty());
  EXPECT_NE(this->Update().Geometry, first.Geometry);
  EXPECT_EQ(this->Scene.GetDrawn().size(), 64u * 5);
}

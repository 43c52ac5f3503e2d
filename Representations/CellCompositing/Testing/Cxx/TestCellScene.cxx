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
    CellScene::OrderMethod method = CellScene::OrderMethod::Exact)
  {
    std::string error;
    this->Scene.UpdateGeometry(
      this->Data, { this->Scalars, false, -1 }, {}, CellGeometry::Form::Tetrahedra, error);
    EXPECT_EQ(error, "");
    this->Scene.UpdateTransferFunction(this->Property);
    OrderView view;
    view.Eye = eye;
    this->Scene.UpdateView(view);
    EXPECT_TRUE(this->Scene.UpdateOrder(method));
    this->Scene.UpdateDrawn();
    return this->Scene.GetVersions();
  }

  vtkSmartPointer<vtkStructuredGrid> Data = makeLattice(4);
  vtkDataArray* Scalars = addPointNumbers(Data);
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
  EXPECT_EQ(this->Scene.CountCycles({}).Number, 0);
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
  const CellScene::Versions second = this->Update({ { 9, 8, 7, 1 } }, CellScene::OrderMethod::None);
  EXPECT_TRUE(std::is_sorted(this->Scene.GetDrawn().begin(), this->Scene.GetDrawn().end()));
  EXPECT_NE(this->Update({ { 9, 8, 7, 1 } }, CellScene::OrderMethod::Centroid).Order, second.Order);
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
  this->Data = makeShell(8, 4, 2, 80, 1, 1.3); // as many cells
  this->Scalars = addPointNumbers(this->Data);
  this->Update();
  ASSERT_EQ(this->Scene.GetDrawn().size(), 64u * 5);
  const std::vector<std::int32_t> drawn = this->Scene.GetDrawn();
  this->Scene = CellScene();
  this->Update();
  EXPECT_EQ(drawn, this->Scene.GetDrawn());
}

// Pixels matter only where rays can enter the mesh twice.
TEST_F(SceneOfALattice, TheOrderFollowsThePixelsOfAMeshThatIsNotConvex)
{
  const auto resize = [this](int width) {
    OrderView view;
    view.Eye = { { 9, 8, 7, 1 } };
    view.ModelToDevice[15] = 1;
    view.Width = view.Height = width;
    this->Scene.UpdateView(view);
    EXPECT_TRUE(this->Scene.UpdateOrder(CellScene::OrderMethod::Exact));
    return this->Scene.GetVersions().Order;
  };
  this->Update();
  EXPECT_EQ(resize(50), resize(100));
  this->Data = makeShell(8, 4, 2, 80, 1, 1.3);
  this->Scalars = addPointNumbers(this->Data);
  this->Update();
  EXPECT_NE(resize(50), resize(100));
}

TEST_F(SceneOfALattice, CyclesAreCutAndCounted)
{
  const auto tube = makeTwistedTube(24, 2, 1);
  this->Data = tube;
  this->Scalars = addPointNumbers(tube);
  const Vector4 above = { { 0.1, 0.05, 9, 1 } }, aside = { { 9, 1, 0.5, 1 } };
  EXPECT_EQ(this->Update(aside).Pieces, this->Update({ { 9, 1, 0.6, 1 } }).Pieces)
    << "nothing to upload";
  const std::size_t whole = this->Scene.GetGeometry().Tetrahedra.size();
  ASSERT_EQ(this->Scene.GetDrawn().size(), whole);
  EXPECT_EQ(this->Scene.CountCycles({}).Number, 0);

  // By another order: counted when asked for, and nothing that is drawn changes.
  const CellScene::Versions centroid = this->Update(above, CellScene::OrderMethod::Centroid);
  const CellScene::Cycles cycles = this->Scene.CountCycles({});
  EXPECT_GT(cycles.Number, 0);
  EXPECT_GE(cycles.Tetrahedra, 24);
  EXPECT_EQ(this->Scene.GetVersions().Drawn, centroid.Drawn);
  EXPECT_EQ(this->Scene.GetDrawn().size(), whole);
  EXPECT_TRUE(this->Scene.GetPieces().Tetrahedra.empty());

  const CellScene::Versions exact = this->Update(above);
  EXPECT_NE(exact.Pieces, centroid.Pieces);
  EXPECT_EQ(this->Scene.CountCycles({}).Number, cycles.Number);
  EXPECT_EQ(this->Scene.CountCycles({}).Tetrahedra, cycles.Tetrahedra);
  EXPECT_GT(this->Scene.GetDrawn().size(), whole);
  EXPECT_NE(this->Update(aside).Pieces, exact.Pieces) << "the pieces must go";
  EXPECT_TRUE(this->Scene.GetPieces().Tetrahedra.empty());

  // Pieces of a transparent tetrahedron are not drawn.
  this->Opacity->RemoveAllPoints();
  this->Opacity->AddPoint(0, 0);
  this->Opacity->AddPoint(1e6, 0);
  this->Update(above);
  EXPECT_TRUE(this->Scene.GetDrawn().empty());
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
  EXPECT_FALSE(this->Scene.UpdateOrder(CellScene::OrderMethod::Exact, stop));
  this->Update();
  EXPECT_EQ(this->Scene.GetDrawn(), drawn);
  this->Update({ { -9, 8, 7, 1 } });
  OrderView view;
  view.Eye = { { 9, 8, 7, 1 } };
  this->Scene.UpdateView(view);
  EXPECT_FALSE(this->Scene.UpdateOrder(CellScene::OrderMethod::Exact, stop))
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

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What counts as another mesh, and as other values.
#include "DataIdentity.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCellType.h"
#include "vtkDoubleArray.h"
#include "vtkIdList.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkSOADataArrayTemplate.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include "ThreadScope.h"

#include <gtest/gtest.h>

using namespace nephoscope;

namespace
{
class Identity : public ::testing::Test
{
protected:
  Identity()
  {
    vtkNew<vtkPoints> points;
    for (int i = 0; i < 5; ++i)
    {
      points->InsertNextPoint(i % 2, i / 2, i * i);
    }
    this->Grid->SetPoints(points);
    const vtkIdType cells[2][4] = { { 0, 1, 2, 3 }, { 1, 2, 3, 4 } };
    this->Grid->InsertNextCell(VTK_TETRA, 4, cells[0]);
    this->Grid->InsertNextCell(VTK_TETRA, 4, cells[1]);
    this->Values->SetNumberOfTuples(2);
    this->Values->SetName("Density");
    this->Values->Fill(3);
    this->Grid->GetCellData()->AddArray(this->Values);
    EXPECT_TRUE(this->Mesh.Changes(this->Grid));
    EXPECT_TRUE(this->Array.Changes(this->Grid, this->Selection()));
  }
  ScalarSelection Selection() { return { this->Values, true, -1 }; }

  vtkNew<vtkUnstructuredGrid> Grid;
  vtkNew<vtkDoubleArray> Values;
  MeshIdentity Mesh;
  ValueIdentity Array;
};
}

TEST_F(Identity, StaysWhatItIs)
{
  EXPECT_FALSE(this->Mesh.Changes(this->Grid));
  EXPECT_FALSE(this->Array.Changes(this->Grid, this->Selection()));
  this->Grid->Modified(); // a filter that ran again
  EXPECT_FALSE(this->Mesh.Changes(this->Grid));
  EXPECT_FALSE(this->Array.Changes(this->Grid, this->Selection()));
}

TEST_F(Identity, AnArrayIsNotTheMesh)
{
  this->Values->SetValue(1, 4);
  this->Values->Modified();
  EXPECT_FALSE(this->Mesh.Changes(this->Grid));
  EXPECT_TRUE(this->Array.Changes(this->Grid, this->Selection()));
  EXPECT_FALSE(this->Array.Changes(this->Grid, this->Selection()));
  vtkNew<vtkDoubleArray> other;
  other->SetNumberOfTuples(2);
  this->Grid->GetCellData()->AddArray(other);
  EXPECT_FALSE(this->Mesh.Changes(this->Grid));
}

// Who writes into a mesh or array without telling it may tell the dataset.
TEST_F(Identity, ValuesWrittenInPlace)
{
  this->Values->SetValue(1, 4);
  EXPECT_FALSE(this->Array.Changes(this->Grid, this->Selection())) << "nobody told";
  this->Grid->Modified();
  EXPECT_TRUE(this->Array.Changes(this->Grid, this->Selection()));
  this->Grid->GetPoints()->SetPoint(2, 7, 7, 7);
  this->Grid->Modified();
  EXPECT_TRUE(this->Mesh.Changes(this->Grid));
  this->Grid->GetPoints()->SetPoint(2, 8, 7, 7);
  this->Grid->GetPoints()->Modified();
  EXPECT_TRUE(this->Mesh.Changes(this->Grid));
  this->Grid->GetCells()->GetConnectivityArray()->SetComponent(0, 0, 4);
  this->Grid->GetCells()->GetConnectivityArray()->Modified();
  EXPECT_TRUE(this->Mesh.Changes(this->Grid));
  this->Grid->GetCells()->GetConnectivityArray()->SetComponent(0, 0, 0);
  this->Grid->GetCells()->Modified(); // VTK's datasets do not tell the time of their cells
  EXPECT_TRUE(this->Mesh.Changes(this->Grid));
}

TEST_F(Identity, AnotherDatasetWithTheSameContents)
{
  vtkNew<vtkUnstructuredGrid> shallow, deep;
  shallow->ShallowCopy(this->Grid);
  EXPECT_FALSE(this->Mesh.Changes(shallow));
  EXPECT_FALSE(this->Array.Changes(shallow, this->Selection()));
  deep->DeepCopy(this->Grid);
  EXPECT_FALSE(this->Mesh.Changes(deep));
  EXPECT_FALSE(this->Array.Changes(deep, { deep->GetCellData()->GetArray("Density"), true, -1 }));
  deep->GetPoints()->SetPoint(0, 0, 0, 1e-9);
  deep->GetPoints()->Modified();
  EXPECT_TRUE(this->Mesh.Changes(deep));
}

TEST_F(Identity, GhostsAndTypesBelongToTheMesh)
{
  vtkNew<vtkUnsignedCharArray> ghosts;
  ghosts->SetName(vtkDataSetAttributes::GhostArrayName());
  ghosts->SetNumberOfTuples(2);
  ghosts->Fill(0);
  this->Grid->GetCellData()->AddArray(ghosts);
  EXPECT_TRUE(this->Mesh.Changes(this->Grid));
  ghosts->SetValue(1, vtkDataSetAttributes::HIDDENCELL);
  ghosts->Modified();
  EXPECT_TRUE(this->Mesh.Changes(this->Grid));
  const vtkNew<vtkUnstructuredGrid> same;
  same->ShallowCopy(this->Grid);
  same->SetCells(VTK_QUAD, this->Grid->GetCells());
  EXPECT_TRUE(this->Mesh.Changes(same));
}

TEST_F(Identity, AnotherSelection)
{
  EXPECT_TRUE(this->Array.Changes(this->Grid, { this->Values, true, 0 })) << "component";
  EXPECT_TRUE(this->Array.Changes(this->Grid, { this->Values, false, 0 })) << "association";
  EXPECT_TRUE(this->Array.Changes(this->Grid, {})) << "none";
  EXPECT_FALSE(this->Array.Changes(this->Grid, {}));
  EXPECT_TRUE(this->Array.Changes(this->Grid, this->Selection()));
}

TEST_F(Identity, ForgottenIsAnother)
{
  this->Mesh.Forget();
  this->Array.Forget();
  EXPECT_TRUE(this->Mesh.Changes(this->Grid));
  EXPECT_TRUE(this->Array.Changes(this->Grid, this->Selection()));
}

TEST(MeshIdentity, OfOtherDataEveryChangeCounts)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(3, 3, 3);
  MeshIdentity mesh;
  EXPECT_TRUE(mesh.Changes(image));
  EXPECT_FALSE(mesh.Changes(image));
  image->GetPointData()->Modified();
  EXPECT_TRUE(mesh.Changes(image));
  vtkNew<vtkUnstructuredGrid> polyhedron;
  vtkNew<vtkPoints> points;
  for (int i = 0; i < 4; ++i)
  {
    points->InsertNextPoint(i == 1, i == 2, i == 3);
  }
  polyhedron->SetPoints(points);
  vtkNew<vtkIdList> faces;
  for (const vtkIdType id : { 4, 3, 0, 1, 2, 3, 0, 1, 3, 3, 0, 2, 3, 3, 1, 2, 3 })
  {
    faces->InsertNextId(id);
  }
  polyhedron->InsertNextCell(VTK_POLYHEDRON, faces);
  EXPECT_TRUE(mesh.Changes(polyhedron));
  EXPECT_FALSE(mesh.Changes(polyhedron));
  polyhedron->Modified();
  EXPECT_TRUE(mesh.Changes(polyhedron)) << "faces are not looked at";
}

TEST(Fingerprint, TellsEveryValueApart)
{
  vtkNew<vtkDoubleArray> values;
  values->SetNumberOfComponents(3);
  values->SetNumberOfTuples(20000);
  for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
  {
    values->SetValue(i, 0.1 * static_cast<double>(i % 1000));
  }
  const std::uint64_t before = FingerprintOf(values);
  for (const vtkIdType i : { 0, 8191, 8192, 30000, 59999 })
  {
    const double value = values->GetValue(i);
    values->SetValue(i, value + 1);
    EXPECT_NE(FingerprintOf(values), before) << i;
    values->SetValue(i, value);
  }
  EXPECT_EQ(FingerprintOf(values), before);
  EXPECT_EQ(FingerprintOf(nullptr), 0u);
  for (const int threads : { 1, 2, 4 })
  {
    nephoscope_test::WithThreads(
      threads, [&]() { EXPECT_EQ(FingerprintOf(values), before) << threads; });
  }
}

TEST(Fingerprint, OfArraysInAnotherLayout)
{
  vtkNew<vtkSOADataArrayTemplate<double>> values;
  values->SetNumberOfComponents(3);
  values->SetNumberOfTuples(7);
  values->Fill(2);
  const std::uint64_t before = FingerprintOf(values);
  values->SetComponent(6, 1, 3);
  EXPECT_NE(FingerprintOf(values), before);
}

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TexturedSurface.h"

#include "SurfaceLength.h"

#include "vtkCellArray.h"
#include "vtkCellArrayIterator.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFloatArray.h"
#include "vtkIdList.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace nephoscope
{
namespace
{
bool isFinite(vtkDataArray* array)
{
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      if (!std::isfinite(array->GetComponent(i, c)))
      {
        return false;
      }
    }
  }
  return true;
}

double fieldValue(vtkPolyData* data, const char* name, int component, double missing)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 && component < array->GetNumberOfComponents() *
        array->GetNumberOfTuples()
    ? array->GetComponent(component / array->GetNumberOfComponents(), component % array->GetNumberOfComponents())
    : missing;
}

/** "Origin" is what they are given from, in the unit of the result. */
vtkSmartPointer<vtkFloatArray> positions(vtkPolyData* data, double factor, const double origin[3], const char* name)
{
  auto result = vtkSmartPointer<vtkFloatArray>::New();
  result->SetName(name);
  result->SetNumberOfComponents(3);
  result->SetNumberOfTuples(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    result->SetTuple3(i, factor * p[0] - origin[0], factor * p[1] - origin[1], factor * p[2] - origin[2]);
  }
  return result;
}

vtkSmartPointer<vtkFloatArray> coordinatesFromPositions(vtkPolyData* data, const TextureChoice& choice, const char* name)
{
  // The texture repeats itself after 10 units in all three: leaving them out keeps far places exact in float.
  constexpr double period = 10;
  SurfaceLength length;
  length.Add(data);
  const double factor = choice.Scale / (choice.Length > 0 ? choice.Length : length.Get());
  double origin[3];
  data->GetCenter(origin);
  for (double& x : origin)
  {
    x = period * std::round(factor * x / period);
  }
  return positions(data, factor, origin, name);
}

vtkSmartPointer<vtkFloatArray> scaled(vtkDataArray* array, double scale, const char* name)
{
  auto result = vtkSmartPointer<vtkFloatArray>::New();
  result->SetName(name);
  result->SetNumberOfComponents(array->GetNumberOfComponents());
  result->SetNumberOfTuples(array->GetNumberOfTuples());
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
  {
    for (int c = 0; c < array->GetNumberOfComponents(); ++c)
    {
      result->SetComponent(i, c, scale * array->GetComponent(i, c));
    }
  }
  return result;
}

/** Gives corners whose u is more than half a turn away from the first corner's a point of their own, a turn on. */
class SeamCutter
{
public:
  SeamCutter(vtkPolyData* surface, double turn)
    : Surface(surface)
    , Turn(turn)
  {
  }

  void Cut(const char* name)
  {
    this->Texture = vtkFloatArray::SafeDownCast(this->Surface->GetPointData()->GetArray(name));
    this->Copies.clear();
    vtkNew<vtkCellArray> polygons;
    auto iterator = vtk::TakeSmartPointer(this->Surface->GetPolys()->NewIterator());
    vtkNew<vtkIdList> corners;
    for (iterator->GoToFirstCell(); !iterator->IsDoneWithTraversal(); iterator->GoToNextCell())
    {
      iterator->GetCurrentCell(corners);
      const vtkIdType count = corners->GetNumberOfIds();
      const float first = count > 0 ? this->Texture->GetComponent(corners->GetId(0), 0) : 0.0f;
      for (vtkIdType i = 1; i < count; ++i)
      {
        const double u = this->Texture->GetComponent(corners->GetId(i), 0);
        const int turns = static_cast<int>(std::lround((first - u) / this->Turn));
        if (turns != 0)
        {
          corners->SetId(i, this->Copy(corners->GetId(i), turns));
        }
      }
      polygons->InsertNextCell(corners);
    }
    this->Surface->SetPolys(polygons);
  }

private:
  vtkIdType Copy(vtkIdType point, int turns)
  {
    const auto found = this->Copies.find({ point, turns });
    if (found != this->Copies.end())
    {
      return found->second;
    }
    double position[3];
    this->Surface->GetPoint(point, position);
    const vtkIdType copy = this->Surface->GetPoints()->InsertNextPoint(position);
    vtkPointData* arrays = this->Surface->GetPointData();
    for (int a = 0; a < arrays->GetNumberOfArrays(); ++a)
    {
      arrays->GetAbstractArray(a)->InsertTuple(copy, point, arrays->GetAbstractArray(a));
    }
    this->Texture->SetComponent(copy, 0, this->Texture->GetComponent(copy, 0) + turns * this->Turn);
    this->Copies[{ point, turns }] = copy;
    return copy;
  }

  vtkPolyData* Surface;
  double Turn;
  vtkFloatArray* Texture = nullptr;
  std::map<std::pair<vtkIdType, int>, vtkIdType> Copies;
};

/** Empty, or what is wrong with a point array of this name. */
std::string checkArray(vtkPolyData* input, const std::string& name, int components, const char* use)
{
  vtkDataArray* array = input->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    return "There is no point array \"" + name + "\" for the " + use +
      ". Choose one that there is, or turn cell data into point data.";
  }
  return array->GetNumberOfComponents() == components
    ? std::string()
    : "The array \"" + name + "\" for the " + use + " has another number of components than " + std::to_string(components) + ".";
}

void addCover(TexturedSurface& result, vtkPolyData* input, const std::string& name)
{
  if (name.empty())
  {
    return;
  }
  result.Error = checkArray(input, name, 1, "cover");
  if (!result.Error.empty())
  {
    return;
  }
  auto values = scaled(input->GetPointData()->GetArray(name.c_str()), 1, coverArrayName);
  bool isShare = true;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const float v = values->GetValue(i);
    isShare = isShare && v >= 0 && v <= 1;
    values->SetValue(i, v > 0 ? std::min(v, 1.0f) : 0.0f);
  }
  if (!isShare)
  {
    result.Warning += "The array \"" + name +
      "\" has values that are not a cover, 0 ... 1: they count as the nearest that is, NaN as 0. Divide percent by 100. ";
  }
  result.Surface->GetPointData()->AddArray(values);
  result.HasCover = true;
}

void addCoordinates(TexturedSurface& result, vtkPolyData* input, const TextureChoice& choice)
{
  // On longitudes the texture goes round: whole numbers of repetitions only.
  const bool isCartesian = fieldValue(input, "TextureFrame", 0, 0) != 0;
  const double scale = isCartesian ? choice.Scale : std::max(1.0, std::round(choice.Scale));
  int sets = 0;
  for (const std::string& name : choice.Coordinates)
  {
    vtkDataArray* array = name.empty() ? nullptr : input->GetPointData()->GetArray(name.c_str());
    if (!array)
    {
      continue;
    }
    if (array->GetNumberOfComponents() != 3 || !isFinite(array))
    {
      result.Warning += "The texture coordinates \"" + name + "\" are not used: they need 3 components, all of them finite. ";
      continue;
    }
    result.Surface->GetPointData()->AddArray(scaled(array, scale, textureArrayNames[sets]));
    result.Weights[sets] = fieldValue(input, "TextureWeights", name == choice.Coordinates[0] ? 0 : 1, 0.5);
    ++sets;
  }
  if (sets == 2 && input->GetPointData()->HasArray("TextureWeights"))
  {
    result.Warning += "Weights of points are not read: the weights of the field data TextureWeights hold everywhere. ";
  }
  result.HasSecondSet = sets == 2;
  const bool areWeights = result.Weights[0] >= 0 && result.Weights[1] >= 0 && result.Weights[0] + result.Weights[1] > 0;
  if (sets < 2 || !areWeights)
  {
    result.Weights[0] = sets < 2 ? 1 : 0.5;
    result.Weights[1] = sets < 2 ? 0 : 0.5;
    result.Warning += areWeights ? "" : "TextureWeights must be >= 0, and not all 0: both sets count the same. ";
  }
  if (sets == 0)
  {
    result.Surface->GetPointData()->AddArray(coordinatesFromPositions(input, choice, textureArrayNames[0]));
  }
  else if (!isCartesian)
  {
    if (input->GetNumberOfStrips() > 0)
    {
      result.Warning += "Triangle strips are not cut where longitudes go round: use vtkTriangleFilter. ";
    }
    SeamCutter cutter(result.Surface, scale);
    for (int i = 0; i < sets; ++i)
    {
      cutter.Cut(textureArrayNames[i]);
    }
  }
}
}

TexturedSurface prepareTexturedSurface(vtkPolyData* input, const TextureChoice& choice)
{
  TexturedSurface result;
  result.Surface = vtkSmartPointer<vtkPolyData>::New();
  result.Surface->DeepCopy(input); // points may be added
  input->GetCenter(result.Center);
  result.Surface->GetPointData()->AddArray(positions(input, 1, result.Center, placeArrayName));
  addCover(result, input, choice.Cover);
  if (!result.Error.empty())
  {
    result.Surface = nullptr;
    return result;
  }
  vtkDataArray* normals = result.Surface->GetPointData()->GetNormals();
  if (normals && !normals->GetName())
  {
    normals->SetName("NephoscopeNormals");
  }
  result.Normals = normals ? normals->GetName() : "";
  addCoordinates(result, input, choice);
  return result;
}

} // namespace nephoscope

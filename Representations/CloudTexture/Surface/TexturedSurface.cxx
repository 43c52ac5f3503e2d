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
#include "vtkMath.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace nephoscope
{
namespace
{
bool IsFinite(vtkDataArray* array)
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

double FieldValue(vtkPolyData* data, const char* name, int component, double missing)
{
  vtkDataArray* array = data->GetFieldData()->GetArray(name);
  return array && array->GetNumberOfTuples() > 0 &&
      component < array->GetNumberOfComponents() * array->GetNumberOfTuples()
    ? array->GetComponent(
        component / array->GetNumberOfComponents(), component % array->GetNumberOfComponents())
    : missing;
}

/** "Origin" is what they are given from, in the unit of the result. */
vtkSmartPointer<vtkFloatArray> Positions(
  vtkPolyData* data, double factor, const double origin[3], const char* name)
{
  auto result = vtkSmartPointer<vtkFloatArray>::New();
  result->SetName(name);
  result->SetNumberOfComponents(3);
  result->SetNumberOfTuples(data->GetNumberOfPoints());
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    double p[3];
    data->GetPoint(i, p);
    result->SetTuple3(
      i, factor * p[0] - origin[0], factor * p[1] - origin[1], factor * p[2] - origin[2]);
  }
  return result;
}

vtkSmartPointer<vtkFloatArray> CoordinatesFromPositions(
  vtkPolyData* data, const TextureChoice& choice, double scale, const char* name)
{
  // The texture repeats itself after 10 units in all three: leaving them out keeps far places exact
  // in float.
  constexpr double period = 10;
  const double factor = scale / (choice.Length > 0 ? choice.Length : SurfaceLength::Of(data).Get());
  double origin[3];
  data->GetCenter(origin);
  for (double& x : origin)
  {
    x = period * std::round(factor * x / period);
  }
  return Positions(data, factor, origin, name);
}

vtkSmartPointer<vtkFloatArray> Scaled(vtkDataArray* array, double scale, const char* name)
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

/**
 * Gives corners whose u is more than half a turn away from the first corner's a point of their own,
 * a turn on.
 */
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
std::string CheckArray(vtkPolyData* input, const std::string& name, int components, const char* use)
{
  vtkDataArray* array = input->GetPointData()->GetArray(name.c_str());
  if (!array)
  {
    return "There is no point array \"" + name + "\" for the " + use +
      ". Choose an existing one, or convert cell data to point data.";
  }
  return array->GetNumberOfComponents() == components ? std::string()
                                                      : "The array \"" + name + "\" for the " +
      use + " has another number of components than " + std::to_string(components) + ".";
}

/**
 * A copy of a point array of one component as float, with values between 0 and "highest"; null, and
 * an error, where there is none.
 */
vtkSmartPointer<vtkFloatArray> AddShares(TexturedSurface& result, vtkPolyData* input,
  const std::string& name, const char* use, const char* newName, float highest,
  const std::string& warning)
{
  result.Error = CheckArray(input, name, 1, use);
  if (!result.Error.empty())
  {
    return nullptr;
  }
  auto values = Scaled(input->GetPointData()->GetArray(name.c_str()), 1, newName);
  bool areRight = true;
  bool anyCloud = false;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    const float v = values->GetValue(i);
    areRight = areRight && v >= 0 && v <= highest;
    anyCloud = anyCloud || v > 0;
    values->SetValue(i, v > 0 ? std::min(v, highest) : 0.0f);
  }
  result.Warning += anyCloud || values->GetNumberOfTuples() == 0
    ? ""
    : "Nothing is drawn: all values of the array \"" + name + "\" for the " + use +
      " are 0, negative or missing. " + (areRight ? "Choose another array. " : "");
  result.Warning += areRight ? "" : "The array \"" + name + "\" " + warning;
  result.Surface->GetPointData()->AddArray(values);
  return values;
}

void AddCover(TexturedSurface& result, vtkPolyData* input, const std::string& name)
{
  if (!name.empty())
  {
    result.HasCover =
      AddShares(result, input, name, "cover", coverArrayName, 1.0f,
        "has values outside the range of a cover, 0 ... 1: they count as the nearest valid value, NaN as 0. Divide percent by 100. ") !=
      nullptr;
  }
}

void AddDensity(TexturedSurface& result, vtkPolyData* input, const std::string& name)
{
  if (!name.empty() && result.Error.empty())
  {
    result.HasDensity =
      AddShares(result, input, name, "density", densityArrayName, 1e30f,
        "has values that are not a density, >= 0 and finite: they count as 0 or as 1e30. Change them, or choose another array. ") !=
      nullptr;
    result.Error += result.Error.empty()
      ? ""
      : " If it is the array of a density volume, choose this volume too.";
  }
}

/** Adds the weights of points, where they are there: true, and they are used. */
bool AddWeights(TexturedSurface& result, vtkPolyData* input)
{
  vtkDataArray* array = input->GetPointData()->GetArray("TextureWeights");
  if (!array)
  {
    return false;
  }
  if (array->GetNumberOfComponents() != 2)
  {
    result.Warning += "The point array TextureWeights is not used: it needs 2 components. ";
    return false;
  }
  auto weights = Scaled(array, 1, weightsArrayName);
  bool areRight = true;
  for (vtkIdType i = 0; i < weights->GetNumberOfTuples(); ++i)
  {
    const double first = weights->GetComponent(i, 0), second = weights->GetComponent(i, 1);
    if (!(first >= 0 && second >= 0 && first + second > 0 && first + second < 1e30))
    {
      areRight = false;
      weights->SetTuple2(i, 0.5, 0.5);
    }
  }
  result.Warning += areRight
    ? ""
    : "TextureWeights of points must be >= 0, finite, and not all 0: where they are not, both sets count the same. ";
  result.Surface->GetPointData()->AddArray(weights);
  return true;
}

/** Relative to the center: the volume is small against those that it is a difference of. */
void FindMeanChord(TexturedSurface& result, vtkPolyData* input)
{
  vtkDataArray* density =
    result.HasDensity ? result.Surface->GetPointData()->GetArray(densityArrayName) : nullptr;
  const auto place = [&](vtkIdType id) {
    MeanChord::Point p;
    input->GetPoint(id, p.data());
    return MeanChord::Point{ { p[0] - result.Center[0], p[1] - result.Center[1],
      p[2] - result.Center[2] } };
  };
  const auto weight = [&](vtkIdType id) {
    return density ? density->GetComponent(id, 0) / 3 : 1.0 / 3;
  };
  const auto add = [&](vtkIdType a, vtkIdType b, vtkIdType c) {
    result.Chord.AddTriangle(place(a), place(b), place(c), weight(a) + weight(b) + weight(c));
  };
  vtkNew<vtkIdList> corners;
  auto polygons = vtk::TakeSmartPointer(input->GetPolys()->NewIterator());
  for (polygons->GoToFirstCell(); !polygons->IsDoneWithTraversal(); polygons->GoToNextCell())
  {
    polygons->GetCurrentCell(corners);
    for (vtkIdType i = 2; i < corners->GetNumberOfIds(); ++i)
    {
      add(corners->GetId(0), corners->GetId(i - 1), corners->GetId(i));
    }
  }
  auto strips = vtk::TakeSmartPointer(input->GetStrips()->NewIterator());
  for (strips->GoToFirstCell(); !strips->IsDoneWithTraversal(); strips->GoToNextCell())
  {
    strips->GetCurrentCell(corners);
    for (vtkIdType i = 2; i < corners->GetNumberOfIds(); ++i)
    {
      add(corners->GetId(i - 2), corners->GetId(i - 1 + i % 2),
        corners->GetId(i - i % 2)); // every second one is turned over
    }
  }
}

/**
 * The third coordinate: 0 at the low end of the range that is given, or else that of the data, 1 at
 * the high end.
 */
void SetAltitudes(vtkFloatArray* coordinates, const std::function<double(vtkIdType)>& altitude,
  const double given[2], const double ofData[2])
{
  const double* range = given[0] < given[1] ? given : ofData;
  const double height = range[1] > range[0] ? range[1] - range[0] : 1;
  for (vtkIdType i = 0; i < coordinates->GetNumberOfTuples(); ++i)
  {
    coordinates->SetComponent(i, 2, (altitude(i) - range[0]) / height);
  }
}

/** Longitude and latitude in turns, or positions, and altitudes. */
void AddPlacesWithAltitude(TexturedSurface& result, vtkPolyData* input, const TextureChoice& choice)
{
  const SurfaceLength length = SurfaceLength::Of(input);
  vtkSmartPointer<vtkFloatArray> places =
    CoordinatesFromPositions(input, choice, result.Scale, textureArrayNames[0]);
  const auto point = [input](vtkIdType i) {
    std::array<double, 3> p;
    input->GetPoint(i, p.data());
    return p;
  };
  result.WrapsAround = length.IsGlobe();
  for (vtkIdType i = 0; result.WrapsAround && i < places->GetNumberOfTuples(); ++i)
  {
    const auto p = point(i);
    const double turn = 2 * vtkMath::Pi();
    places->SetComponent(i, 0, result.Scale * std::atan2(p[1], p[0]) / turn);
    places->SetComponent(i, 1, result.Scale * std::atan2(p[2], std::hypot(p[0], p[1])) / turn);
  }
  const double ofData[2] = { result.WrapsAround ? length.SmallestRadius : length.Low[2],
    result.WrapsAround ? length.LargestRadius : length.High[2] };
  SetAltitudes(
    places,
    [&](vtkIdType i) { return result.WrapsAround ? vtkMath::Norm(point(i).data()) : point(i)[2]; },
    choice.AltitudeRange, ofData);
  result.Surface->GetPointData()->AddArray(places);
}

void AddPlaces(TexturedSurface& result, vtkPolyData* input, const TextureChoice& choice)
{
  if (choice.UseAltitude)
  {
    AddPlacesWithAltitude(result, input, choice);
    return;
  }
  result.Surface->GetPointData()->AddArray(
    CoordinatesFromPositions(input, choice, result.Scale, textureArrayNames[0]));
}

void CutWhereTextureWraps(TexturedSurface& result, vtkPolyData* input, int sets)
{
  if (input->GetNumberOfStrips() > 0)
  {
    result.Warning +=
      "Triangle strips are not cut where longitudes wrap around: use vtkTriangleFilter. ";
  }
  SeamCutter cutter(result.Surface, result.Scale);
  for (int i = 0; i < sets; ++i)
  {
    cutter.Cut(textureArrayNames[i]);
  }
}

void AddCoordinates(TexturedSurface& result, vtkPolyData* input, const TextureChoice& choice)
{
  const bool isCartesian = FieldValue(input, "TextureFrame", 0, 0) != 0;
  int sets = 0;
  for (const std::string& name : choice.Coordinates)
  {
    vtkDataArray* array = name.empty() ? nullptr : input->GetPointData()->GetArray(name.c_str());
    if (!array)
    {
      continue;
    }
    if (array->GetNumberOfComponents() != 3 || !IsFinite(array))
    {
      result.Warning += "The texture coordinates \"" + name +
        "\" are not used: they need 3 components, all of them finite. ";
      continue;
    }
    auto coordinates = Scaled(array, result.Scale, textureArrayNames[sets]);
    if (choice.UseAltitude)
    {
      SetAltitudes(
        coordinates, [array](vtkIdType i) { return array->GetComponent(i, 2); },
        choice.AltitudeRange, array->GetRange(2));
    }
    result.Surface->GetPointData()->AddArray(coordinates);
    result.Weights[sets] =
      FieldValue(input, "TextureWeights", name == choice.Coordinates[0] ? 0 : 1, 0.5);
    ++sets;
  }
  result.HasSecondSet = sets == 2;
  result.HasWeights = sets == 2 && AddWeights(result, input);
  const bool areWeights =
    result.Weights[0] >= 0 && result.Weights[1] >= 0 && result.Weights[0] + result.Weights[1] > 0;
  if (sets < 2 || !areWeights)
  {
    result.Weights[0] = sets < 2 ? 1 : 0.5;
    result.Weights[1] = sets < 2 ? 0 : 0.5;
    result.Warning +=
      areWeights ? "" : "TextureWeights must be >= 0, and not all 0: both sets count the same. ";
  }
  result.WrapsAround = sets > 0 && !isCartesian;
  if (sets == 0)
  {
    AddPlaces(result, input, choice);
  }
  if (result.WrapsAround)
  {
    CutWhereTextureWraps(result, input, std::max(sets, 1));
  }
}

/** On longitudes the texture goes round: whole numbers of repetitions only. */
double ScaleOf(vtkPolyData* input, const TextureChoice& choice)
{
  const SurfaceLength length = SurfaceLength::Of(input);
  const auto isThere = [&](const std::string& name) {
    return input->GetPointData()->GetArray(name.c_str()) != nullptr;
  };
  const bool hasCoordinates = isThere(choice.Coordinates[0]) || isThere(choice.Coordinates[1]);
  const bool hasLongitudes = hasCoordinates ? FieldValue(input, "TextureFrame", 0, 0) == 0
                                            : choice.UseAltitude && length.IsGlobe();
  const double scale = choice.Scale > 0 ? choice.Scale : length.Repetitions();
  return hasLongitudes ? std::max(1.0, std::round(scale)) : scale;
}

/** Empty where there are polygons, and of an empty piece, which is no mistake. */
std::string DescribeMissingSurface(vtkPolyData* input)
{
  if (input->GetNumberOfPolys() > 0 || input->GetNumberOfStrips() > 0 ||
    input->GetNumberOfPoints() == 0)
  {
    return std::string();
  }
  return "Nothing is drawn: the input has " + std::to_string(input->GetNumberOfPoints()) +
    " points but no polygons for the texture. Make a surface of them (Cloud Surface, Contour, Delaunay 2D), or draw them as "
    "Textured Splats.";
}
}

TexturedSurface PrepareTexturedSurface(vtkPolyData* input, const TextureChoice& choice)
{
  TexturedSurface result;
  result.Error = DescribeMissingSurface(input);
  if (!result.Error.empty())
  {
    return result;
  }
  result.Surface = vtkSmartPointer<vtkPolyData>::New();
  result.Surface->DeepCopy(input); // points may be added
  input->GetCenter(result.Center);
  result.Surface->GetPointData()->AddArray(Positions(input, 1, result.Center, placeArrayName));
  AddCover(result, input, choice.Cover);
  AddDensity(result, input, choice.Density);
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
  // By thickness only open surfaces have a cosine, and that of the triangles will do.
  result.Normals = normals && !choice.MeasureChord ? normals->GetName() : "";
  result.Scale = ScaleOf(input, choice);
  AddCoordinates(result, input, choice);
  if (choice.MeasureChord)
  {
    FindMeanChord(result, input);
  }
  return result;
}

} // namespace nephoscope

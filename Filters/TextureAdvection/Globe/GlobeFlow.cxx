// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "GlobeFlow.h"

#include "OwnThreads.h"

#include "vtkDataSet.h"
#include "vtkPointData.h"
#include "vtkStructuredGrid.h"

#include <cmath>

// Compiled twice, all that is called inlined: for any processor, and for those with wide registers
// and fused multiplication, which is chosen when the library is loaded. Sanitizers are not ready
// then.
#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__clang__) && \
  !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define NEPHOSCOPE_FOR_EACH_PROCESSOR \
  __attribute__((target_clones("arch=x86-64-v3", "default"), flatten))
#else
#define NEPHOSCOPE_FOR_EACH_PROCESSOR
#endif

namespace nephoscope
{
namespace
{
constexpr double ON_AXIS =
  1e-12; // distance from the axis of the unit sphere where a longitude means nothing
constexpr vtkIdType JOB_SIZE = 2048;

template <typename Function>
void InParallelJobs(std::size_t count, const Function& function)
{
  InParallel(static_cast<vtkIdType>(count), function, JOB_SIZE);
}

void BlendFloats(
  const std::vector<float>& a, const std::vector<float>& b, float w, std::vector<float>& mixed)
{
  mixed.resize(a.size());
  InParallelJobs(a.size(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const auto at = static_cast<std::size_t>(i);
      mixed[at] = a[at] + w * (b[at] - a[at]);
    }
  });
}

// The lowest levels are the ground of air that has none of its own.
std::vector<float> GroundOf(const GlobeWinds& winds, std::size_t layer)
{
  return winds.Ground.empty() ? std::vector<float>(winds.Levels.begin(),
                                  winds.Levels.begin() + static_cast<std::ptrdiff_t>(layer))
                              : winds.Ground;
}

// (1 - fraction) a + fraction b
void BlendWinds(
  const GlobeWinds& a, const GlobeWinds& b, double fraction, std::size_t layer, GlobeWinds& mixed)
{
  const auto w = static_cast<float>(fraction);
  mixed.Vectors.resize(a.Vectors.size());
  InParallelJobs(a.Vectors.size(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      const WindVector& p = a.Vectors[static_cast<std::size_t>(i)];
      const WindVector& q = b.Vectors[static_cast<std::size_t>(i)];
      mixed.Vectors[static_cast<std::size_t>(i)] = { p.X + w * (q.X - p.X), p.Y + w * (q.Y - p.Y),
        p.Z + w * (q.Z - p.Z), p.Rise + w * (q.Rise - p.Rise) };
    }
  });
  BlendFloats(a.Levels, b.Levels, w, mixed.Levels);
  BlendFloats(a.Heights, b.Heights, w, mixed.Heights);
  mixed.Ground.clear();
  if (!a.Ground.empty() || !b.Ground.empty())
  {
    BlendFloats(GroundOf(a, layer), GroundOf(b, layer), w, mixed.Ground);
  }
}

NEPHOSCOPE_FOR_EACH_PROCESSOR void AdvanceParcels(
  const GlobeStepper& stepper, GlobeParcel* parcels, std::size_t count, const StepWinds& winds)
{
  stepper.Advance(parcels, count, winds);
}

vtkDataArray* PointArray(
  vtkDataSet* data, const std::string& name, int components, std::string& problem)
{
  vtkDataArray* array = data->GetPointData()->GetArray(name.c_str());
  if (!array || array->GetNumberOfComponents() != components)
  {
    problem = "There is no point array '" + name + "' with " + std::to_string(components) +
      (components == 1 ? " component" : " components") + " at one of the time steps.";
    return nullptr;
  }
  return array;
}
}

struct GlobeFlow::Field : public WindField
{
  GlobeWinds Winds;
};

struct GlobeFlow::Between
{
  const WindField* Earlier;
  const WindField* Later;
  double Fraction;
  std::unique_ptr<GlobeWinds> Winds;
};

GlobeFlow::GlobeFlow(
  GlobeShape shape, int firstColumn, const PathSettings& settings, bool cartesian)
  : Shape(std::move(shape))
  , FirstColumn(firstColumn)
  , Settings(settings)
  , Cartesian(cartesian)
{
  this->Settings.LevelScale = 1.0 / this->Shape.Radius();
}

GlobeFlow::~GlobeFlow() = default;

std::unique_ptr<WindField> GlobeFlow::MakeField(
  vtkDataSet* data, const WindArrays& arrays, std::string& problem)
{
  if (!this->Shape.Fits(data))
  {
    problem =
      "The columns or rows of the grid change from one time step to another. Only heights may.";
    return nullptr;
  }
  GlobeInput input;
  input.Data = data;
  input.Velocity = PointArray(data, arrays.Velocity.Name, 3, problem);
  if (!arrays.Pressure.empty())
  {
    input.Vertical = PointArray(data, arrays.Pressure, 1, problem);
    input.VerticalRate = PointArray(data, arrays.Omega, 1, problem);
    input.Sign = -1.0;
    this->Settings.LevelScale = 1e-5; // a tolerance of 1e-6 of a radius is one of 0.1 Pa
  }
  if (!problem.empty())
  {
    return nullptr;
  }
  auto field = std::make_unique<Field>();
  field->Winds = this->Shape.MakeWinds(input, field->Missing);
  return field;
}

template <typename Function>
void GlobeFlow::ForEachParcel(const Function& function)
{
  InParallelJobs(this->Parcels.size(), [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType i = begin; i < end; ++i)
    {
      function(static_cast<std::size_t>(i), this->Parcels[static_cast<std::size_t>(i)]);
    }
  });
}

// Winds of a time of the series as they are, others from the last step or made anew.
const GlobeWinds* GlobeFlow::WindsAt(const FlowStep& step, double fraction)
{
  const auto windsOf = [](const WindField* field) {
    return &static_cast<const Field*>(field)->Winds;
  };
  if (fraction == 0.0 || step.Earlier == step.Later)
  {
    return windsOf(step.Earlier);
  }
  if (fraction == 1.0)
  {
    return windsOf(step.Later);
  }
  for (const Between& made : this->Mixed)
  {
    if (made.Earlier == step.Earlier && made.Later == step.Later && made.Fraction == fraction)
    {
      return made.Winds.get();
    }
  }
  // The end of the step before is the beginning of this one: the oldest of three can go.
  std::unique_ptr<GlobeWinds> winds = std::make_unique<GlobeWinds>();
  if (this->Mixed.size() == 3)
  {
    winds = std::move(this->Mixed.front().Winds);
    this->Mixed.erase(this->Mixed.begin());
  }
  const auto layer = static_cast<std::size_t>(this->Shape.Columns().ColumnCount()) *
    static_cast<std::size_t>(this->Shape.Columns().RowCount());
  BlendWinds(*windsOf(step.Earlier), *windsOf(step.Later), fraction, layer, *winds);
  this->Mixed.push_back({ step.Earlier, step.Later, fraction, std::move(winds) });
  return this->Mixed.back().Winds.get();
}

void GlobeFlow::Begin(vtkDataSet* points, const FlowStep& present)
{
  const auto count = static_cast<std::size_t>(points->GetNumberOfPoints());
  this->Mixed.clear(); // of fields that may be gone by now
  this->Parcels.assign(count, GlobeParcel{});
  this->Starts.resize(count);
  const std::vector<double> longitudes = this->Longitudes(points);
  const GlobeStepper stepper(this->Shape.Columns(), this->Shape.Levels(), this->Settings);
  const GlobeWinds& winds = *this->WindsAt(present, present.FromFraction);
  this->ForEachParcel([&](std::size_t i, GlobeParcel& parcel) {
    double position[3];
    double height;
    points->GetPoint(static_cast<vtkIdType>(i), position);
    double* d = parcel.Direction;
    this->Shape.PlaceOf(position, d, height);
    d[1] += 0.0; // a zero has no sign
    stepper.SetHeight(parcel, winds, height);
    stepper.ClampLevel(parcel, winds);
    Start& start = this->Starts[i];
    start.Longitude = longitudes[i];
    start.Angle = std::hypot(d[0], d[1]) > ON_AXIS ? std::atan2(d[1], d[0]) : std::nan("");
    this->Place(d, stepper.HeightOf(parcel, winds), start.Longitude, start.Place);
  });
}

void GlobeFlow::Advance(const FlowStep& step)
{
  const double middle = 0.5 * (step.FromFraction + step.ToFraction);
  const bool runge = this->Settings.Method == PathMethod::RungeKutta4;
  StepWinds winds{};
  winds.Seconds = step.Seconds;
  winds.Begin = this->WindsAt(step, step.FromFraction);
  winds.Middle = runge ? this->WindsAt(step, middle) : winds.Begin;
  winds.End =
    this->Settings.Method == PathMethod::Euler ? winds.Begin : this->WindsAt(step, step.ToFraction);
  const GlobeStepper stepper(this->Shape.Columns(), this->Shape.Levels(), this->Settings);
  InParallelJobs(this->Parcels.size(), [&](vtkIdType begin, vtkIdType end) {
    AdvanceParcels(
      stepper, this->Parcels.data() + begin, static_cast<std::size_t>(end - begin), winds);
  });
}

void GlobeFlow::Displacements(const FlowStep& present, std::vector<float>& displacements)
{
  displacements.resize(3 * this->Parcels.size());
  if (this->Parcels.empty())
  {
    return;
  }
  const GlobeStepper stepper(this->Shape.Columns(), this->Shape.Levels(), this->Settings);
  const GlobeWinds& winds = *this->WindsAt(present, present.FromFraction);
  this->ForEachParcel([&](std::size_t i, GlobeParcel& parcel) {
    GlobeParcel held = parcel; // a path does not depend on where it has been looked at
    stepper.ClampLevel(held, winds);
    const Start& start = this->Starts[i];
    double place[3];
    this->Place(held.Direction, stepper.HeightOf(held, winds),
      start.Longitude + LongitudeTravelled(start, held), place);
    for (std::size_t c = 0; c < 3; ++c)
    {
      displacements[3 * i + c] = static_cast<float>(place[c] - start.Place[c]);
    }
  });
}

// Radians eastwards along the path. From a pole, where a path has no longitude to begin with, the
// short way from the point's own meridian; to a pole, none.
double GlobeFlow::LongitudeTravelled(const Start& start, const GlobeParcel& parcel)
{
  const double* d = parcel.Direction;
  if (!(std::hypot(d[0], d[1]) > ON_AXIS))
  {
    return 0.0;
  }
  const double angle = std::atan2(d[1] + 0.0, d[0]);
  return std::isnan(start.Angle) ? std::remainder(angle - start.Longitude, TURN)
                                 : angle - start.Angle + TURN * parcel.Turns;
}

// Points of the grid have the longitude of their column: the one that closes it is a turn beyond
// the first. Other points have it in the turn that begins with the grid's first column.
std::vector<double> GlobeFlow::Longitudes(vtkDataSet* points) const
{
  std::vector<double> longitudes(static_cast<std::size_t>(points->GetNumberOfPoints()));
  int extent[6] = { 0, -1, 0, -1, 0, -1 };
  auto* grid = vtkStructuredGrid::SafeDownCast(points);
  if (grid)
  {
    grid->GetExtent(extent);
  }
  const std::size_t row = static_cast<std::size_t>(std::max(1, extent[1] - extent[0] + 1));
  const double first = this->Shape.LongitudeOf(0);
  for (std::size_t i = 0; i < longitudes.size(); ++i)
  {
    if (grid)
    {
      longitudes[i] =
        this->Shape.LongitudeOf(extent[0] - this->FirstColumn + static_cast<int>(i % row));
      continue;
    }
    double position[3];
    double direction[3];
    double height;
    points->GetPoint(static_cast<vtkIdType>(i), position);
    this->Shape.PlaceOf(position, direction, height);
    const double beyond = std::fmod(std::atan2(direction[1], direction[0]) - first, TURN);
    longitudes[i] = this->Shape.IsMap() ? position[0] / this->Shape.Radius()
                                        : first + (beyond < -1e-9 ? beyond + TURN : beyond);
  }
  return longitudes;
}

std::vector<double> GlobeFlow::GridCoordinates(vtkDataSet* points) const
{
  const std::vector<double> longitudes = this->Longitudes(points);
  std::vector<double> places(3 * longitudes.size());
  for (std::size_t i = 0; i < longitudes.size(); ++i)
  {
    double position[3];
    double direction[3];
    double height;
    points->GetPoint(static_cast<vtkIdType>(i), position);
    this->Shape.PlaceOf(position, direction, height);
    this->Place(direction, height, longitudes[i], &places[3 * i]);
  }
  return places;
}

TextureUnits GlobeFlow::Units() const
{
  TextureUnits units;
  units.OnGlobe = !this->Cartesian;
  units.Length = TURN * this->Shape.Radius();
  return units;
}

void GlobeFlow::Place(
  const double direction[3], double height, double longitude, double place[3]) const
{
  const double circumference = TURN * this->Shape.Radius();
  if (this->Cartesian)
  {
    for (int c = 0; c < 3; ++c)
    {
      place[c] = (this->Shape.Radius() + height) * direction[c] / circumference;
    }
    return;
  }
  place[0] = longitude / TURN;
  place[1] = std::atan2(direction[2], std::hypot(direction[0], direction[1])) / TURN;
  place[2] = height / circumference;
}
}

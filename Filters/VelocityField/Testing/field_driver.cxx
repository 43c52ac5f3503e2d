// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// A C interface to velocity fields, for tests and benchmarks in Python (nephoscope_testing.fields):
// the C++ classes are not wrapped. VTK objects come as addresses; arrays as pointers, three doubles
// a position.
#include "AdvanceParticles.h"
#include "VelocityFields.h"

#include "vtkDataObject.h"
#include "vtkPointData.h"

#include <cstring>

#if defined(_WIN32)
#define DRIVER_EXPORT extern "C" __declspec(dllexport)
#else
#define DRIVER_EXPORT extern "C" __attribute__((visibility("default")))
#endif

using namespace nephoscope;

// Null, and the problem in `text`, if there is no field.
DRIVER_EXPORT DataSetField* field_make(
  vtkDataObject* data, const char* array, int onCells, char* text, int textSize)
{
  std::string problem;
  DataSetField* field = MakeVelocityField(data, { array, onCells != 0 }, problem).release();
  std::strncpy(text, problem.c_str(), static_cast<std::size_t>(textSize) - 1);
  return field;
}

DRIVER_EXPORT void field_delete(DataSetField* field)
{
  delete field;
}

DRIVER_EXPORT CellHint* hints_make(long long count)
{
  return new CellHint[static_cast<std::size_t>(count)];
}

DRIVER_EXPORT void hints_delete(CellHint* hints)
{
  delete[] hints;
}

DRIVER_EXPORT void hints_set(CellHint* hints, long long count, const long long* cells)
{
  for (long long i = 0; i < count; ++i)
  {
    hints[i].Cell = cells[i];
  }
}

DRIVER_EXPORT void field_sample(const DataSetField* field, long long count,
  const Vector3* positions, CellHint* hints, Vector3* velocities, unsigned char* inside)
{
  field->Sample({ static_cast<std::size_t>(count), positions, 0.0, velocities, inside, hints });
}

DRIVER_EXPORT void field_sample_arrays(const DataSetField* field, long long count,
  const Vector3* positions, const CellHint* hints, vtkPointData* output)
{
  field->SampleArrays(static_cast<std::size_t>(count), positions, hints, output);
}

// `tolerance`: 0 for RK4, else that of the adaptive method.
DRIVER_EXPORT void field_advance(const DataSetField* field, long long count, Vector3* positions,
  CellHint* hints, unsigned char* inside, double step, int steps, double tolerance, int threads)
{
  IntegrationSettings settings;
  settings.Method =
    tolerance > 0.0 ? IntegrationMethod::DormandPrince : IntegrationMethod::RungeKutta4;
  settings.Tolerance = tolerance;
  settings.Threads = threads;
  const Particles particles{ positions, hints, inside, static_cast<std::size_t>(count), nullptr };
  for (int k = 0; k < steps; ++k)
  {
    AdvanceParticles(*field, particles, k * step, step, settings);
  }
}

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "ArrayInterpolation.h"

#include "OwnThreads.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"
#include "vtkSmartPointer.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>

namespace nephoscope
{
namespace
{
constexpr vtkIdType TUPLES_PER_JOB =
  1024; // a multiple of 8: no two threads write to one byte of a bit array

template <typename Value>
Value FromSum(double sum)
{
  if (!std::numeric_limits<Value>::is_integer)
  {
    return static_cast<Value>(sum);
  }
  if (!(std::abs(sum) < std::numeric_limits<double>::infinity()))
  {
    return Value{};
  }
  const double low = static_cast<double>(std::numeric_limits<Value>::lowest());
  const double high = static_cast<double>(std::numeric_limits<Value>::max());
  return sum <= low ? std::numeric_limits<Value>::lowest()
    : sum >= high   ? std::numeric_limits<Value>::max()
                    : static_cast<Value>(sum);
}

bool IsInteger(vtkDataArray* array)
{
  return array->GetDataType() != VTK_FLOAT && array->GetDataType() != VTK_DOUBLE;
}

struct InterpolateWorker
{
  const Stencils& From;
  vtkIdType First; // tuple of the output

  template <typename Array>
  void operator()(Array* input, vtkDataArray* output) const
  {
    Array* same = vtkArrayDownCast<Array>(output);
    if (same)
    {
      this->Run(input, same);
    }
    else
    {
      this->Run(static_cast<vtkDataArray*>(input), output);
    }
  }

  template <typename Array>
  void Run(Array* input, Array* output) const
  {
    using Value = vtk::GetAPIType<Array>;
    const bool round = IsInteger(output); // an array of unknown layout is seen as of doubles
    const auto source = vtk::DataArrayTupleRange(input);
    auto target = vtk::DataArrayTupleRange(output);
    const int components = input->GetNumberOfComponents();
    for (std::size_t i = 0; i < this->From.Count(); ++i)
    {
      const vtkIdType tuple = this->First + static_cast<vtkIdType>(i);
      const std::size_t begin = this->From.BeginOf(i);
      const std::size_t end = this->From.EndOf(i);
      if (begin == end)
      {
        SetOutside(output, tuple);
        continue;
      }
      for (int c = 0; c < components; ++c)
      {
        double sum = 0.0;
        for (std::size_t e = begin; e < end; ++e)
        {
          sum += this->From.Weights[e] * static_cast<double>(source[this->From.Ids[e]][c]);
        }
        target[tuple][c] = FromSum<Value>(round ? std::round(sum) : sum);
      }
    }
  }
};

using ArrayPair = std::pair<vtkDataArray*, vtkDataArray*>;

std::vector<ArrayPair> MakeOutput(vtkPointData* input, vtkIdType count, vtkPointData* output)
{
  std::vector<ArrayPair> pairs;
  for (int a = 0; a < input->GetNumberOfArrays(); ++a)
  {
    if (!IsInterpolated(input, a))
    {
      continue;
    }
    vtkDataArray* source = input->GetArray(a);
    auto target = vtk::TakeSmartPointer(source->NewInstance());
    target->SetName(source->GetName());
    target->SetNumberOfComponents(source->GetNumberOfComponents());
    target->CopyComponentNames(source);
    target->SetNumberOfTuples(count);
    output->AddArray(target);
    pairs.emplace_back(source, target);
    const int role = input->IsArrayAnAttribute(a);
    if (role >= 0 && source->GetName())
    {
      output->SetActiveAttribute(source->GetName(), role);
    }
  }
  return pairs;
}
}

bool IsInterpolated(vtkPointData* data, int array)
{
  vtkDataArray* numbers = data->GetArray(array);
  const int role = data->IsArrayAnAttribute(array);
  const char* name = numbers ? numbers->GetName() : nullptr;
  return numbers && role != vtkDataSetAttributes::GLOBALIDS &&
    role != vtkDataSetAttributes::PEDIGREEIDS &&
    !(name && std::strcmp(name, vtkDataSetAttributes::GhostArrayName()) == 0);
}

void SetOutside(vtkDataArray* array, vtkIdType tuple)
{
  const bool hasNaN = !IsInteger(array);
  for (int c = 0; c < array->GetNumberOfComponents(); ++c)
  {
    array->SetComponent(tuple, c, hasNaN ? std::numeric_limits<double>::quiet_NaN() : 0.0);
  }
}

void InterpolateArrays(vtkPointData* input, std::size_t count, vtkPointData* output,
  const std::function<void(std::size_t, std::size_t, Stencils&)>& fill)
{
  const auto pairs = MakeOutput(input, static_cast<vtkIdType>(count), output);
  const auto work = [&](vtkIdType firstBatch, vtkIdType endBatch) {
    Stencils stencils;
    for (vtkIdType batch = firstBatch; batch < endBatch; ++batch)
    {
      const vtkIdType begin = batch * TUPLES_PER_JOB;
      const vtkIdType end = std::min(begin + TUPLES_PER_JOB, static_cast<vtkIdType>(count));
      stencils.Clear();
      fill(static_cast<std::size_t>(begin), static_cast<std::size_t>(end), stencils);
      const InterpolateWorker worker{ stencils, begin };
      for (const ArrayPair& pair : pairs)
      {
        if (!vtkArrayDispatch::Dispatch::Execute(pair.first, worker, pair.second))
        {
          worker.Run(pair.first, pair.second);
        }
      }
    }
  };
  const vtkIdType batches = (static_cast<vtkIdType>(count) + TUPLES_PER_JOB - 1) / TUPLES_PER_JOB;
  if (batches <= 1 || pairs.empty())
  {
    work(0, pairs.empty() ? 0 : batches);
    return;
  }
  InParallel(batches, work, 1);
}
}

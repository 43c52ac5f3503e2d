// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "SeriesReading.h"

#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"

#include <cmath>

using SDDP = vtkStreamingDemandDrivenPipeline;

namespace nephoscope
{
namespace
{
// What CONTINUE_EXECUTING has set, and only a successful REQUEST_DATA would clear.
struct StopExecuting : SDDP
{
  static void Of(vtkExecutive* executive)
  {
    if (auto* pipeline = SDDP::SafeDownCast(executive))
    {
      pipeline->*(&StopExecuting::ContinueExecuting) = 0;
    }
  }
};
}

bool SeriesReading::TakeTimes(vtkInformation* input)
{
  std::vector<double> times;
  this->HasSeries = input && input->Has(SDDP::TIME_STEPS());
  if (this->HasSeries)
  {
    const double* first = input->Get(SDDP::TIME_STEPS());
    times.assign(first, first + input->Length(SDDP::TIME_STEPS()));
  }
  const bool changed = times != this->Times;
  this->Times = times;
  return changed;
}

std::size_t SeriesReading::FirstOutOfOrder() const
{
  std::size_t i = 0;
  while (i < this->Times.size() && std::isfinite(this->Times[i]) &&
    (i == 0 || this->Times[i] > this->Times[i - 1]))
  {
    ++i;
  }
  return i;
}

bool SeriesReading::RestartsUpdate(vtkInformation* request)
{
  const bool anew = this->AwaitsData && request->Has(SDDP::REQUEST_UPDATE_TIME());
  this->AwaitsData = this->AwaitsData && !anew;
  return anew;
}

void SeriesReading::GoOn(vtkInformation* request)
{
  this->Continuing = true;
  request->Set(SDDP::CONTINUE_EXECUTING(), 1);
}

void SeriesReading::End(vtkInformation* request)
{
  this->Continuing = false;
  request->Remove(SDDP::CONTINUE_EXECUTING());
}

void SeriesReading::Stop(vtkExecutive* executive)
{
  this->Continuing = false;
  StopExecuting::Of(executive);
}

void AskForWholeExtent(vtkInformation* input)
{
  if (input->Has(SDDP::WHOLE_EXTENT())) // a group of grids has none
  {
    int whole[6];
    input->Get(SDDP::WHOLE_EXTENT(), whole);
    input->Set(SDDP::UPDATE_EXTENT(), whole, 6);
  }
  input->Set(SDDP::UPDATE_PIECE_NUMBER(), 0);
  input->Set(SDDP::UPDATE_NUMBER_OF_PIECES(), 1);
  input->Set(SDDP::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
}

} // namespace nephoscope

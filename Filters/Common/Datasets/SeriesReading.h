// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Reading of a time series by one filter: its update requests one time step after another, in
 * separate passes (CONTINUE_EXECUTING).
 */
#ifndef nephoscope_SeriesReading_h
#define nephoscope_SeriesReading_h

#include "vtkNephoscopeFiltersCommonModule.h" // for export macro

#include <cstddef>
#include <vector>

class vtkExecutive;
class vtkInformation;

namespace nephoscope
{

struct VTKNEPHOSCOPEFILTERSCOMMON_EXPORT SeriesReading
{
  std::vector<double> Times; ///< of the time steps, in the pipeline's unit
  bool HasSeries = false;    ///< the input tells its time steps, be they none
  double Requested = 0.0;    ///< time of the update that is being made
  int Next = 0;              ///< time step to be read
  bool Continuing = false;   ///< in the middle of an update
  bool AwaitsData = false;   ///< between RequestUpdateExtent and RequestData

  /**
   * For RequestInformation: reads the times of the input, which may be null. True if they have
   * changed.
   */
  bool TakeTimes(vtkInformation* input);

  /**
   * The first time step that is not finite or not after its predecessor; the number of time steps
   * if there is none.
   */
  std::size_t FirstOutOfOrder() const;

  /** For ProcessRequest: an update begins, although the last one has not come to RequestData. */
  bool RestartsUpdate(vtkInformation* request);

  double NextTime() const { return this->Times[static_cast<std::size_t>(this->Next)]; }

  /** For RequestData: requests one more pass, or none. */
  void GoOn(vtkInformation* request);
  void End(vtkInformation* request);

  /**
   * The same outside RequestData: if the input fails, an executive that was told to continue would
   * repeat its requests for ever.
   */
  void Stop(vtkExecutive* executive);
};

/** Requests the whole input, whatever piece of the output is requested. */
VTKNEPHOSCOPEFILTERSCOMMON_EXPORT void AskForWholeExtent(vtkInformation* input);

} // namespace nephoscope

#endif

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCloudsOverGlobe
 * @brief the forecast that comes with Nephoscope, on a globe, in sunlight: an example to start from
 *
 *     vtkNetCDFCFReader -> vtkGlobeGrid -> vtkCloudOptics -> vtkSunlight
 *                                                                 |-> port 0: vtkStructuredGrid
 *                                                                 |
 *                              Blue Marble -> times the light at the ground -> port 1: vtkPolyData
 *
 * Port 1 is the Earth, with colours as the point array Earth (unsigned char, RGB), not active. The
 * files are searched in Folder, otherwise in share/nephoscope next to the library and above it,
 * otherwise in the folder that the environment variable NEPHOSCOPE_DATA names. On several processes
 * each has its piece of the forecast; the Earth is in the first one.
 */
#ifndef vtkCloudsOverGlobe_h
#define vtkCloudsOverGlobe_h

#include "vtkAlgorithm.h"
#include "vtkNephoscopeParaViewFiltersModule.h" // for export macro
#include "vtkNew.h"                             // for members

#include <string> // for the folder

class vtkCloudOptics;
class vtkGlobeGrid;
class vtkNetCDFCFReader;
class vtkPolyData;
class vtkStructuredGrid;
class vtkSunlight;

class VTKNEPHOSCOPEPARAVIEWFILTERS_EXPORT vtkCloudsOverGlobe : public vtkAlgorithm
{
public:
  static vtkCloudsOverGlobe* New();
  vtkTypeMacro(vtkCloudsOverGlobe, vtkAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Factor on the height. Default: 30. */
  vtkSetMacro(VerticalExaggeration, double);
  vtkGetMacro(VerticalExaggeration, double);
  ///@}

  ///@{
  /**
   * Date and time in UTC, which determine the position of the sun as in vtkSunlight. Default
   * "2011-10-10 20:00": afternoon over the Americas. A vtkSunSource as the second input replaces
   * it. The first input is not used: ParaView's scripts connect the active source to it.
   */
  vtkSetMacro(DateTime, std::string);
  vtkGetMacro(DateTime, std::string);
  ///@}

  /** Disconnects the second input. */
  void RemoveSun() { this->SetInputConnection(1, nullptr); }

  ///@{
  /** Where the files are. Empty (default): found automatically. */
  vtkSetMacro(Folder, std::string);
  vtkGetMacro(Folder, std::string);
  ///@}

  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

protected:
  vtkCloudsOverGlobe();
  ~vtkCloudsOverGlobe() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;

private:
  vtkCloudsOverGlobe(const vtkCloudsOverGlobe&) = delete;
  void operator=(const vtkCloudsOverGlobe&) = delete;

  std::string FindFile(const char* name);
  int MakeOutputs(vtkInformationVector* outputs);
  int Inform(vtkInformationVector* outputs);
  bool MakeEarth(vtkStructuredGrid* lit, vtkPolyData* earth);

  vtkNew<vtkNetCDFCFReader> Reader;
  vtkNew<vtkGlobeGrid> Globe;
  vtkNew<vtkCloudOptics> Optics;
  vtkNew<vtkSunlight> Light;
  double VerticalExaggeration = 30.0;
  std::string DateTime = "2011-10-10 20:00";
  std::string Folder;
};

#endif

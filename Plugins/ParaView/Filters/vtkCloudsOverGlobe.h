// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCloudsOverGlobe
 * @brief the forecast that comes with Nephoscope, on a globe: an example to start from
 *
 * Port 0: the forecast as vtkGlobeGrid places it, vtkStructuredGrid. Port 1: the Earth, vtkPolyData with the colours of Blue Marble as
 * the point array Earth (unsigned char, RGB), not active. The files are searched in Folder, otherwise in share/nephoscope beside the library and above
 * it, otherwise in the folder that the environment variable NEPHOSCOPE_DATA names. On several processes each has its piece of the forecast; the Earth is in the
 * first one.
 */
#ifndef vtkCloudsOverGlobe_h
#define vtkCloudsOverGlobe_h

#include "vtkAlgorithm.h"
#include "vtkNephoscopeParaViewFiltersModule.h" // for export macro
#include "vtkNew.h"                             // for members

#include <string> // for the folder

class vtkGlobeGrid;
class vtkNetCDFCFReader;
class vtkPolyData;
class vtkStructuredGrid;

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
  /** Where the files are. Empty (default): found automatically. */
  vtkSetMacro(Folder, std::string);
  vtkGetMacro(Folder, std::string);
  ///@}

  vtkTypeBool ProcessRequest(
    vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

protected:
  vtkCloudsOverGlobe();
  ~vtkCloudsOverGlobe() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;

private:
  vtkCloudsOverGlobe(const vtkCloudsOverGlobe&) = delete;
  void operator=(const vtkCloudsOverGlobe&) = delete;

  std::string FindFile(const char* name);
  int MakeOutputs(vtkInformationVector* outputs);
  int Inform(vtkInformationVector* outputs);
  void MakeClouds(vtkInformation* outInfo, vtkStructuredGrid* clouds);
  void MakeEarth(vtkPolyData* earth);

  vtkNew<vtkNetCDFCFReader> Reader;
  vtkNew<vtkGlobeGrid> Globe;
  double VerticalExaggeration = 30.0;
  std::string Folder;
};

#endif

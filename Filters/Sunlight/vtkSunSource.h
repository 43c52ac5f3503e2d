// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSunSource
 * @brief   one sun for everything in a scene
 *
 * Its output is the third input of every vtkSunlight, so that one change moves the sun of all. In
 * ParaView its representation lights the view.
 *
 * Output: vtkPolyData without points. Field data, unit vectors of three components:
 * - SunDirection: towards the sun, for data that are not on a globe
 * - SunDirectionOnGlobe: for data on the globe of vtkGlobeGrid. It differs if DateTime is set.
 */
#ifndef vtkSunSource_h
#define vtkSunSource_h

#include "vtkNephoscopeFiltersSunlightModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for DateTime

class VTKNEPHOSCOPEFILTERSSUNLIGHT_EXPORT vtkSunSource : public vtkPolyDataAlgorithm
{
public:
  static vtkSunSource* New();
  vtkTypeMacro(vtkSunSource, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Direction towards the sun, in the coordinates of the data, with any length > 0. Default (1, -1,
   * 1). Used if DateTime is empty.
   */
  vtkSetVector3Macro(SunDirection, double);
  vtkGetVector3Macro(SunDirection, double);
  ///@}

  ///@{
  /**
   * Date and time in UTC, such as "2011-10-11 18:30"; empty (default): SunDirection. For data that
   * are not on a globe, the sun is as seen from Longitude and Latitude, with x to the east and y to
   * the north.
   */
  vtkSetMacro(DateTime, std::string);
  vtkGetMacro(DateTime, std::string);
  ///@}

  ///@{
  /** Hours added to DateTime, for animations. Default: 0. */
  vtkSetMacro(HoursLater, double);
  vtkGetMacro(HoursLater, double);
  ///@}

  ///@{
  /**
   * Longitude and latitude (degrees east and north) of the observer for whom the sun is computed at
   * DateTime, if the data are not on a globe. Default 0, 0.
   */
  vtkSetClampMacro(Longitude, double, -360.0, 360.0);
  vtkGetMacro(Longitude, double);
  vtkSetClampMacro(Latitude, double, -90.0, 90.0);
  vtkGetMacro(Latitude, double);
  ///@}

protected:
  vtkSunSource();
  ~vtkSunSource() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkSunSource(const vtkSunSource&) = delete;
  void operator=(const vtkSunSource&) = delete;

  double SunDirection[3] = { 1, -1, 1 };
  std::string DateTime;
  double HoursLater = 0;
  double Longitude = 0;
  double Latitude = 0;
};

#endif

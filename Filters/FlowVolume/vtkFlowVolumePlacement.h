// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFlowVolumePlacement
 * @brief   finds a position for a generating polygon: where the flow is fast, goes far, and the polygon fits
 *
 * The centre of the bounds, which other filters start from, is no place for smoke in a shell of air around a globe or in a
 * bent pipe: there is no flow. The fastest place in which the largest polygon fits is taken if smoke from there goes far: on average at least 0.35 of
 * half the diagonal of the bounds. Where it leaves the data sooner, this follows the flow from up to 400 cells, evenly chosen, and from
 * the rims of polygons around the 24 best, and takes the place with the greatest product of
 * 1. the speed;
 * 2. the length of the path inside the data, up to half of the diagonal of the bounds, in the time that the flow takes for that at its first
 *    speed; less where the path stays in one place, within an eighth of the diagonal;
 * 3. the radius: 1/50 of the diagonal, or half, a quarter, ... 1/128 of that, such that all points of the polygon across the flow are inside the data;
 * and among places that differ by 5 % the one that is nearest to the middle of the bounds.
 * The same data give the same place, on one process or spread over several. Hosts use it for their defaults; vtkFlowVolume itself stays where it is put.
 */
#ifndef vtkFlowVolumePlacement_h
#define vtkFlowVolumePlacement_h

#include "vtkNephoscopeFiltersFlowVolumeModule.h" // for export macro
#include "vtkObject.h"

#include <string> // for names

class vtkDataObject;
class vtkMultiProcessController;

class VTKNEPHOSCOPEFILTERSFLOWVOLUME_EXPORT vtkFlowVolumePlacement : public vtkObject
{
public:
  static vtkFlowVolumePlacement* New();
  vtkTypeMacro(vtkFlowVolumePlacement, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Looks for a place in `data`, a dataset or a composite one. `velocity` names an array of three components, of the cells with
   * `onCells`, else of the points; empty (default): the one that vtkFlowVolume would take. False, with no error, if nothing flows
   * there; Problem says why if there is no array to be used.
   */
  bool Find(vtkDataObject* data, const std::string& velocity = std::string(), bool onCells = false);

  ///@{
  /** The processes that the data are spread over; Find is then to be called on all of them, and all find the same. Null (default): one. */
  virtual void SetController(vtkMultiProcessController*);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  /** Diagonal that the radius is a fraction of, where `data` is a part of the whole and there is no Controller; 0 (default): that of `data`. */
  vtkSetMacro(Diagonal, double);
  vtkGetMacro(Diagonal, double);

  /** Number of sides of the polygon that must fit, 3 or more. Default: 12. */
  vtkSetClampMacro(NumberOfSides, int, 3, VTK_INT_MAX);
  vtkGetMacro(NumberOfSides, int);

  ///@{
  /**
   * What was found: centre, unit vector along the flow, radius, speed, and how good it is (the product; the greater the better, for choosing between
   * parts).
   */
  vtkGetVector3Macro(Center, double);
  vtkGetVector3Macro(Normal, double);
  vtkGetMacro(Radius, double);
  vtkGetMacro(Speed, double);
  vtkGetMacro(Quality, double);
  ///@}

  /** Why there is no usable array; empty if there is one. */
  std::string GetProblem() const { return this->Problem; }

protected:
  vtkFlowVolumePlacement() = default;
  ~vtkFlowVolumePlacement() override;

private:
  vtkFlowVolumePlacement(const vtkFlowVolumePlacement&) = delete;
  void operator=(const vtkFlowVolumePlacement&) = delete;

  vtkMultiProcessController* Controller = nullptr;
  double Diagonal = 0.0;
  int NumberOfSides = 12;
  double Center[3] = { 0.0, 0.0, 0.0 };
  double Normal[3] = { 0.0, 0.0, 1.0 };
  double Radius = 0.0;
  double Speed = 0.0;
  double Quality = 0.0;
  std::string Problem;
};

#endif

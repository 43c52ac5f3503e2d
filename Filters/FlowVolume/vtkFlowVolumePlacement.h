// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkFlowVolumePlacement
 * @brief   finds a position for a generating polygon: where the flow enters or is fast, goes far,
 *          and the polygon fits
 *
 * Other filters start from the centre of the bounds, but in a shell of air around a globe or in a
 * bent pipe there is no flow at the centre. This class takes the fastest position in which the
 * largest polygon fits, if smoke from there travels far: on average at least 0.35 of half the
 * diagonal of the bounds. If smoke leaves the data sooner, it follows the flow from up to 400
 * evenly chosen cells, and from the rims of polygons around the 24 best, and takes the position
 * with the largest product of
 * 1. the speed;
 * 2. the length of the path inside the data, up to half of the diagonal of the bounds, in the time
 *    that the flow needs for this length at its initial speed; less if the path stays within an
 *    eighth of the diagonal;
 * 3. the radius: 1/50 of the diagonal, or half, a quarter, ... 1/128 of that, such that all points
 *    of the polygon across the flow are inside the data;
 * Among positions within 5 % of the best, it takes the one nearest to the centre of the bounds.
 * From there it goes upstream. If the flow enters the data there, with at least a quarter of the
 * speed and room for the polygon, the position is just inside, 1 to 4 radii from the border. The
 * polygon is then up to four times as wide, with a margin of one radius around it, as long as the
 * flow at its rim has 60 % of the speed in its middle. Elsewhere it goes up to 0.8 of half the
 * diagonal, as long as smoke goes farther, the flow has at least 70 % of the speed and the polygon
 * has room. The same cells give the same position as an image, a grid or unstructured data, on one
 * process or on several. Hosts use it for their defaults; vtkFlowVolume itself does not move its
 * polygon.
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
   * Looks for a position in `data`, a dataset or a composite dataset. `velocity` names an array of
   * three components, on cells with `onCells`, otherwise on points; empty (default): the array that
   * vtkFlowVolume would use. Returns false, without an error, if nothing flows; Problem gives the
   * reason if there is no usable array.
   */
  bool Find(vtkDataObject* data, const std::string& velocity = std::string(), bool onCells = false);

  ///@{
  /**
   * The processes over which the data are distributed. Call Find on all of them; all find the same
   * position. Null (default): one process.
   */
  virtual void SetController(vtkMultiProcessController*);
  vtkGetObjectMacro(Controller, vtkMultiProcessController);
  ///@}

  /**
   * The diagonal of which the radius is a fraction, for `data` that are a part of the whole without
   * a Controller; 0 (default): that of `data`.
   */
  vtkSetMacro(Diagonal, double);
  vtkGetMacro(Diagonal, double);

  /** Number of sides of the polygon that must fit, 3 or more. Default: 12. */
  vtkSetClampMacro(NumberOfSides, int, 3, VTK_INT_MAX);
  vtkGetMacro(NumberOfSides, int);

  ///@{
  /**
   * The result: centre, unit vector along the flow, radius, speed, and a score (the product; larger
   * is better, for choosing between parts).
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

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCellCompositingRepresentation
 * @brief Cell Compositing in ParaView's list of representations
 *
 * A thin layer over vtkCellCompositingMapper. It chooses what to draw (the blocks with 3-D cells, the coloured array, a
 * uniform medium under Solid Color), finds a unit distance that suits the size of the data, and tells the view
 * how the picture may be put together from several ranks:
 * - image and rectilinear pieces are boxes already, and stay where they are;
 * - all other pieces become tetrahedra and are redistributed by the view, cut at the borders of its regions.
 */
#ifndef vtkCellCompositingRepresentation_h
#define vtkCellCompositingRepresentation_h

#include "vtkNephoscopeParaViewRepresentationsModule.h" // for export macro
#include "vtkNew.h"
#include "vtkVolumeRepresentation.h"

#include <array>  // for ContourColors
#include <string> // for OpacityArray
#include <vector> // for ContourColors

class vtkCellCompositingMapper;
class vtkDataArray;
class vtkDataSet;
class vtkPiecewiseFunction;

class VTKNEPHOSCOPEPARAVIEWREPRESENTATIONS_EXPORT vtkCellCompositingRepresentation
  : public vtkVolumeRepresentation
{
public:
  static vtkCellCompositingRepresentation* New();
  vtkTypeMacro(vtkCellCompositingRepresentation, vtkVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Take the length over which extinction is counted from the data: the mean length of a ray inside the cells,
   * times the mean over the volume of a ramp from 0 to 1 over the range of the scalar, divided by 2. With
   * ParaView's default opacity function, which is that ramp, the mean optical depth is then 2, whatever the unit
   * of length and however rare high values are. It does not follow the opacity function. Default: on. On: UnitDistance is
   * ignored.
   */
  void SetAutomaticUnitDistance(bool automatic) { this->AutomaticUnitDistance = automatic; }
  bool GetAutomaticUnitDistance() const { return this->AutomaticUnitDistance; }
  ///@}

  ///@{
  /** Length over which an opacity of 1 gives an optical depth of 1, in units of the data, > 0. Default: 1. */
  void SetUnitDistance(double distance) { this->UnitDistance = distance; }
  double GetUnitDistance() const { return this->UnitDistance; }
  ///@}

  ///@{
  /** Forwarded to the mapper; see there. OpacityScale is multiplied by Opacity. */
  void SetMethod(int method);
  void SetIntegration(int integration);
  void SetVisibilityOrder(int order);
  void SetOpacityScale(double scale);
  void SetSplitAtControlPoints(bool split);
  ///@}

  ///@{
  /**
   * Array that the opacity function reads, of points or cells; empty or "None" (default): the coloured array. The automatic unit
   * distance depends on it. With "None" smoke, as vtkFlowVolume makes it, has its Density (with puffs SmokeDensity) as extinction, whatever it is coloured by
   * and without an opacity function; the automatic unit distance then gives the generating polygon's diameter an optical depth of 1 at
   * the mean density.
   */
  void SetOpacityArray(const char* name);
  const char* GetOpacityArray() const { return this->OpacityArray.c_str(); }
  ///@}

  ///@{
  /**
   * Contour surfaces inside the volume, of the coloured array or of the named point array ("None": the coloured one); see the mapper.
   * Opacity multiplies their opacities, and colours left out are those of the colour map. Of each list, entry i is that of contour
   * value i.
   */
  void SetContourValue(int i, double value);
  void SetNumberOfContourValues(int number);
  void SetContourOpacity(double opacity) { this->ContourOpacity = opacity; }
  double GetContourOpacity() const { return this->ContourOpacity; }
  void SetContourOpacities(int i, double opacity);
  void SetNumberOfContourOpacities(int number);
  void SetContourColors(int i, double red, double green, double blue);
  void SetNumberOfContourColors(int number);
  void SetContourArray(const char* name);
  void SetContourLighting(bool lighting);
  void SetSmoothContourNormals(bool smooth);
  ///@}

  ///@{
  /**
   * Factors on the extinction of layers 0, 1, ...; layers beyond the list have 1. Layers are those of a cell array, or with "None" those
   * between the contour values.
   */
  void SetLayerArray(const char* name);
  void SetLayerOpacityScale(int layer, double scale);
  void SetNumberOfLayerOpacityScales(int number);
  ///@}

  ///@{
  /** ParaView's own properties: a factor on the extinction, and the colour under Solid Color. */
  void SetOpacity(double opacity) { this->Opacity = opacity; }
  void SetDiffuseColor(double red, double green, double blue);
  ///@}

  /** The coloured array; the automatic unit distance depends on it. */
  void SetInputArrayToProcess(
    int index, int port, int connection, int association, const char* name) override;
  using Superclass::SetInputArrayToProcess;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkCellCompositingRepresentation();
  ~vtkCellCompositingRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

private:
  vtkCellCompositingRepresentation(const vtkCellCompositingRepresentation&) = delete;
  void operator=(const vtkCellCompositingRepresentation&) = delete;

  void PrepareCells(vtkDataObject* input);
  void DescribePiece(vtkInformation* inInfo);
  void PrepareMapper(vtkDataSet* cells);
  void ColorUniformly(vtkDataSet* cells);
  void PrepareContours();
  void PrepareLayers();
  void PrepareOpacity(vtkDataSet* cells, double unitDistance);
  bool DrawsSmoke(vtkDataSet* cells) const;
  vtkDataArray* FindColorArray(vtkDataSet* cells, int& association, const char*& name);
  vtkDataArray* FindOpacityArray(vtkDataSet* cells, int& association);

  vtkNew<vtkCellCompositingMapper> Mapper;
  vtkNew<vtkVolumeProperty> UniformProperty;
  vtkNew<vtkVolumeProperty> SmokeProperty; // the colours of one of the others, and an opacity of its own
  vtkNew<vtkPiecewiseFunction> SmokeOpacity;
  vtkSmartPointer<vtkDataSet> Cells;        // this rank's piece, as handed to the view
  vtkSmartPointer<vtkDataSet> UniformCells; // a delivered piece with a uniform array
  vtkMTimeType UniformCellsTime = 0;
  vtkDataSet* UniformCellsSource = nullptr; // only compared

  bool AxisAligned = false;
  bool AutomaticUnitDistance = true;
  double UnitDistance = 1.0;
  double Opacity = 1.0;
  double OpacityScale = 1.0;
  int VisibilityOrder = 0;
  std::string OpacityArray = "None";
  double ContourOpacity = 0.3;
  std::vector<double> ContourOpacities;
  std::vector<std::array<double, 3>> ContourColors;
  std::vector<double> LayerOpacityScales;
  std::vector<vtkSmartPointer<vtkVolumeProperty>> LayerProperties; // kept, so that they only change when they must
};

#endif

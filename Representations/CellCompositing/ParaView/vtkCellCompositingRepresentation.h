// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCellCompositingRepresentation
 * @brief Cell Compositing in ParaView's list of representations
 *
 * A thin layer over vtkCellCompositingMapper. It chooses what to draw (the blocks with 3-D cells,
 * the coloured array, a uniform medium under Solid Color), and tells the view how the picture may
 * be put together from several ranks:
 * - image and rectilinear pieces are boxes already, and stay where they are;
 * - all other cells are redistributed by the view, whole: a rank gets those that reach into its
 *   region, and draws the part of each ray that is in its region.
 *
 * On one rank ParaView's selection of cells and points, and hovering, find what is visible (Pick of
 * the mapper): in datasets, and cells of multiblock data. Elsewhere nothing is found: on several
 * ranks, in adaptive meshes, hyper tree grids and cells that are divided before drawing; and no
 * points where blocks share them.
 *
 * If no array is chosen for the opacity, smoke from vtkFlowVolume has its Density (with puffs
 * SmokeDensity) as extinction, whatever it is coloured by and without an opacity function. The
 * automatic unit distance then gives the generating polygon's diameter an optical depth of 1 at the
 * mean density.
 */
#ifndef vtkCellCompositingRepresentation_h
#define vtkCellCompositingRepresentation_h

#include "vtkMediumRepresentation.h"
#include "vtkNephoscopeParaViewCellCompositingModule.h" // for export macro

#include <array>  // for ContourColors and regions
#include <string> // for array names
#include <vector> // for ContourColors

class vtkCellCompositingMapper;
class vtkColorTransferFunction;
class vtkDataArray;
class vtkDataSet;
class vtkScalarsToColors;

class VTKNEPHOSCOPEPARAVIEWCELLCOMPOSITING_EXPORT vtkCellCompositingRepresentation
  : public vtkMediumRepresentation
{
public:
  static vtkCellCompositingRepresentation* New();
  vtkTypeMacro(vtkCellCompositingRepresentation, vtkMediumRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Forwarded to the mapper; see there. */
  void SetMethod(int method);
  void SetIntegration(int integration);
  void SetCellInterpolation(int interpolation);
  void SetVisibilityOrder(int order);
  void SetSplitAtControlPoints(bool split);
  void SetAutoAdjustSampleDistances(bool adjust);
  void SetMaximumImageSampleDistance(double distance);
  ///@}

  ///@{
  /**
   * Contour surfaces inside the volume, of the coloured array or of the named point array ("None":
   * the coloured one); see the mapper.
   * Opacity multiplies their opacities, and colours left out are those of the colour map. Entry i
   * of each list is that of contour value i.
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
   * ParaView's own properties: how contour surfaces and polygons reflect light, as other surfaces
   * of the display do.
   */
  void SetAmbient(double ambient) { this->Ambient = ambient; }
  void SetDiffuse(double diffuse) { this->Diffuse = diffuse; }
  void SetSpecular(double specular) { this->Specular = specular; }
  void SetSpecularPower(double power) { this->SpecularPower = power; }
  ///@}

  /**
   * Polygons between the cells; see the mapper. Those of contour i have the opacity and the colour
   * of entry i of the lists above.
   */
  void SetPolygons(int polygons);

  ///@{
  /**
   * Layers are those of a cell array, or with "None" those between the contour values. Each has a
   * factor on the extinction and its own colours: one colour or, if that is not given, a colour map
   * for the coloured array. Entry i of each list is that of layer i; layers beyond the list, with a
   * negative red or with a null colour map are coloured like the rest.
   */
  void SetLayerArray(const char* name);
  void SetLayerOpacityScale(int layer, double scale);
  void SetNumberOfLayerOpacityScales(int number);
  void SetLayerColor(int layer, double red, double green, double blue);
  void SetNumberOfLayerColors(int number);
  void AddLayerColorFunction(vtkScalarsToColors* function);
  void RemoveAllLayerColorFunctions() { this->LayerColorFunctions.clear(); }
  ///@}

protected:
  vtkCellCompositingRepresentation();
  ~vtkCellCompositingRepresentation() override;

  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;
  vtkSmartPointer<vtkDataObject> NumberInput(vtkDataObject* input) override;
  void PreparePiece(vtkDataObject* input) override;
  void MovePiece(vtkMatrix4x4* matrix) override;
  void FinishPiece() override;
  void DescribePiece(vtkInformation* inInfo) override;
  vtkDataSet* CompletePiece(vtkDataSet* data, vtkInformation* inInfo) override;
  void PrepareMapper(vtkDataSet* cells) override;
  bool DrawsBlock(vtkDataObject* block) const override;
  bool HoldsMedium(vtkDataSet* data) const override;
  int GetUniformAssociation() const override;
  vtkDataArray* FindOpacityArray(vtkDataSet* cells, int& association) override;
  std::string PrepareOpacity(vtkDataSet* cells) override;

private:
  vtkCellCompositingRepresentation(const vtkCellCompositingRepresentation&) = delete;
  void operator=(const vtkCellCompositingRepresentation&) = delete;

  void WarnOfNoVolume(bool hasNoVolume);
  void MakeListOfCells();
  bool HasSeveralGrids() const;
  void EndRaysAt(const std::array<double, 6>& region);
  int ChooseInterpolation(vtkDataSet* cells) const;
  bool NeedsGradients() const;
  void FollowContours();
  void PrepareContours();
  void PrepareMaterial();
  void PreparePolygons();
  double FindContourOpacity(std::size_t i) const;
  void PrepareLayers();
  std::size_t CountLayers() const;
  vtkColorTransferFunction* FindLayerColors(std::size_t layer);
  bool DrawsSmoke(vtkDataSet* cells) const;

  vtkNew<vtkCellCompositingMapper> Mapper;

  bool HadNoVolume = false;   // the input, and a warning has said so
  bool HasOwnNumbers = false; // the piece, of cells and points: those of the input
  bool AxisAligned = false;
  bool KeepsPiece = false;              // on its rank, in the view's last update
  std::array<double, 6> Region;         // of space, in which this rank draws
  vtkSmartPointer<vtkDataSet> Complete; // what is drawn of a delivered piece
  vtkDataSet* Delivered = nullptr;      // only compared
  vtkMTimeType DeliveredTime = 0;
  bool HasGradients = false; // the piece, of the normals of contour surfaces
  int VisibilityOrder = 0;
  int CellInterpolation; // the mapper's default at first
  double ContourOpacity = 0.3;
  double Ambient = 0.0, Diffuse = 1.0, Specular = 0.0, SpecularPower = 100.0; // ParaView's defaults
  std::size_t NumberOfPolygonLooks = 0;
  std::vector<double> ContourOpacities;
  std::vector<std::array<double, 3>> ContourColors;
  std::vector<double> LayerOpacityScales;
  std::vector<std::array<double, 3>> LayerColors;
  std::vector<vtkSmartPointer<vtkColorTransferFunction>> LayerColorFunctions; // some are null
  std::vector<vtkSmartPointer<vtkColorTransferFunction>> LayerConstants;      // made of LayerColors
  std::vector<vtkSmartPointer<vtkVolumeProperty>>
    LayerProperties; // kept, so that they only change when they must
};

#endif

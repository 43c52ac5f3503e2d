// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCloudTextureRepresentation
 * @brief ParaView representation "Cloud Texture": surfaces of clouds, drawn by
 *        vtkCloudTextureMapper
 *
 * As ParaView's surface representation, with another mapper: colours, lights, opacity and
 * transformations are its own. Blocks are drawn as one surface. On several ranks unstructured data
 * get the cells of other ranks that they lack, so that no wall is drawn between ranks. Each rank
 * gets the surface of all, and with Use Thickness their density volume, and draws the fragments
 * that lie in its region: the picture is that of one process. So is that of a client that draws the
 * data of several ranks itself. The length of a unit of texture,
 * where coordinates are positions, is that of the whole surface on all ranks.
 * Levels of detail are not used: they have no texture coordinates.
 */
#ifndef vtkCloudTextureRepresentation_h
#define vtkCloudTextureRepresentation_h

#include "vtkGeometryRepresentation.h"
#include "vtkNephoscopeParaViewCloudTextureModule.h" // for export macro

#include "JoinedSurfaces.h"
#include "RankUnion.h"
#include "vtkCloudTextureMapper.h"
#include "vtkNew.h"          // for members
#include "vtkSmartPointer.h" // for members

#include <string> // for members

class vtkCompositeDataSet;
class vtkMultiBlockDataSet;
class vtkPolyData;
class vtkTrivialProducer;

class VTKNEPHOSCOPEPARAVIEWCLOUDTEXTURE_EXPORT vtkCloudTextureRepresentation
  : public vtkGeometryRepresentation
{
public:
  static vtkCloudTextureRepresentation* New();
  vtkTypeMacro(vtkCloudTextureRepresentation, vtkGeometryRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

  /**
   * Has no effect: the simplified surface has no texture coordinates, so there is none. ParaView
   * sets it to off by default.
   */
  void SetSuppressLOD(bool) override {}

  /** What the superclass makes a surface of: on several ranks with cells of the others. */
  vtkAlgorithmOutput* GetInternalOutputPort(int port, int connection) override;
  using Superclass::GetInternalOutputPort;

  ///@{
  /** As in vtkCloudTextureMapper. */
  void SetCoverage(double value) { this->CloudMapper->SetCoverage(value); }
  void SetCoverageArrayName(const char* name);
  void SetUseThreshold(bool value) { this->CloudMapper->SetUseThreshold(value); }
  void SetThreshold(double value) { this->CloudMapper->SetThreshold(value); }
  void SetSoftness(double value) { this->CloudMapper->SetSoftness(value); }
  void SetTextureScale(double value) { this->CloudMapper->SetTextureScale(value); }
  void SetTextureLength(double value) { this->CloudMapper->SetTextureLength(value); }
  void SetOpticalDepth(double value) { this->CloudMapper->SetOpticalDepth(value); }
  void SetRelief(double value) { this->CloudMapper->SetRelief(value); }
  void SetThinColor(double red, double green, double blue)
  {
    this->CloudMapper->SetThinColor(red, green, blue);
  }
  void SetThickColor(double red, double green, double blue)
  {
    this->CloudMapper->SetThickColor(red, green, blue);
  }
  void SetColorRange(double value) { this->CloudMapper->SetColorRange(value); }
  void SetUseAltitude(bool value) { this->CloudMapper->SetUseAltitude(value); }
  void SetAltitudeRange(double low, double high) { this->CloudMapper->SetAltitudeRange(low, high); }
  void SetWaves(int value) { this->CloudMapper->SetWaves(value); }
  void SetNumberOfCustomWaves(int value) { this->CloudMapper->SetNumberOfCustomWaves(value); }
  void SetCustomWave(int i, double amplitude, double b, double c, double d, double shift, double e,
    double g, double h, double phase);
  void SetUseThickness(bool value) { this->CloudMapper->SetUseThickness(value); }
  void SetThicknessEffect(int value) { this->CloudMapper->SetThicknessEffect(value); }
  void SetThicknessWeight(double value) { this->CloudMapper->SetThicknessWeight(value); }
  void SetExtinction(double value) { this->CloudMapper->SetExtinction(value); }
  void SetDensityArrayName(const char* name);
  void SetMaximumNumberOfLayers(int value) { this->CloudMapper->SetMaximumNumberOfLayers(value); }
  void SetFirstCoordinatesName(const char* name)
  {
    this->CloudMapper->SetFirstCoordinatesName(name);
  }
  void SetSecondCoordinatesName(const char* name)
  {
    this->CloudMapper->SetSecondCoordinatesName(name);
  }
  ///@}

  ///@{
  /**
   * Input 1, optional: the grid that vtkCloudTextureMapper integrates the density of. On several
   * ranks each gets the parts of all, with this array alone.
   */
  void SetDensityVolumeConnection(vtkAlgorithmOutput* volume);
  void RemoveDensityVolume();
  ///@}

protected:
  vtkCloudTextureRepresentation();
  ~vtkCloudTextureRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  bool NeedsOrderedCompositing() override { return this->Nothing.empty(); }
  void UpdateColoringParameters() override;

private:
  vtkCloudTextureRepresentation(const vtkCloudTextureRepresentation&) = delete;
  void operator=(const vtkCloudTextureRepresentation&) = delete;

  void RequestNeighborCells(vtkInformationVector* inputs);
  void CompleteInput(vtkInformationVector* inputs);
  void TakeDelivered(vtkDataObject* surface, vtkCompositeDataSet* volume);
  void TakeSurface(vtkDataObject* delivered);
  void ReadVolume(vtkInformationVector* inputs);
  void WarnOfNothing(vtkDataObject* input, vtkDataObject* surfaces);
  void WarnOfVolume(vtkDataObject* input);

  vtkNew<vtkCloudTextureMapper> CloudMapper;
  vtkSmartPointer<vtkTrivialProducer>
    CompletedInput; // with cells of other ranks; null where the input does
  nephoscope::JoinedSurfaces Blocks;
  nephoscope::RankUnion Surfaces, Densities;    // of all ranks
  vtkSmartPointer<vtkMultiBlockDataSet> Volume; // one block, pieces of ranks, or none
  vtkDataObject* ReadFrom = nullptr;            // only compared
  vtkMTimeType ReadTime = 0;
  bool HasToldOfVolume = false; // and the input has not changed to surfaces since
  std::string Nothing;          // why nothing is drawn, as it has been told
};

#endif

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkMediumRepresentation
 * @brief what representations that draw a glowing, absorbing medium have in common
 *
 * A representation of this kind prepares a piece of data on each rank, hands it to the view and
 * draws what the view delivers with its own volume mapper. This class chooses the coloured array
 * and the array for the opacity function, colours uniformly under Solid Color, and gives extinction
 * a length that suits the size of the data. It requests ordered compositing over ranks.
 *
 * A subclass sets the mapper of `Actor` when it is made, makes `Piece` and `DataBounds` in
 * PreparePiece, says in DescribePiece how the view may spread it over ranks, and forwards what else
 * its mapper needs in PrepareMapper.
 */
#ifndef vtkMediumRepresentation_h
#define vtkMediumRepresentation_h

#include "vtkNephoscopeParaViewCommonModule.h" // for export macro
#include "vtkNew.h"
#include "vtkVolumeRepresentation.h"

#include <string> // for OpacityArray

class vtkAbstractVolumeMapper;
class vtkActor;
class vtkDataArray;
class vtkDataSet;
class vtkMatrix4x4;
class vtkPiecewiseFunction;

class VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT vtkMediumRepresentation : public vtkVolumeRepresentation
{
public:
  vtkTypeMacro(vtkMediumRepresentation, vtkVolumeRepresentation);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Take the unit distance of the opacity from the data: the mean length of a ray inside the
   * medium, times the mean over the volume of a ramp from 0 to 1 over the range of the scalar,
   * divided by 2. With ParaView's default opacity function, which is that ramp, the mean optical
   * depth is then 2, whatever the unit of length and however rare high values are. It does not
   * follow the opacity function. Default: on. On: UnitDistance is ignored.
   */
  void SetAutomaticUnitDistance(bool automatic) { this->AutomaticUnitDistance = automatic; }
  bool GetAutomaticUnitDistance() const { return this->AutomaticUnitDistance; }
  ///@}

  ///@{
  /**
   * Length over which an opacity of 1 gives an optical depth of 1, in units of the data. 0 or less,
   * by default: a tenth of the largest side of the bounds of the data.
   */
  void SetUnitDistance(double distance) { this->UnitDistance = distance; }
  double GetUnitDistance() const { return this->UnitDistance; }
  ///@}

  ///@{
  /** Factor on the extinction, >= 0, without unit. Default: 1. Opacity multiplies it. */
  void SetOpacityScale(double scale) { this->OpacityScale = scale; }
  double GetOpacityScale() const { return this->OpacityScale; }
  ///@}

  ///@{
  /**
   * Array that the opacity function reads, of points or cells; empty or "None" (default): the
   * coloured array. The automatic unit distance depends on it.
   */
  void SetOpacityArray(const char* name);
  const char* GetOpacityArray() const { return this->OpacityArray.c_str(); }
  ///@}

  ///@{
  /** ParaView's own properties: a factor on the extinction, and the colour under Solid Color. */
  void SetOpacity(double opacity) { this->Opacity = opacity; }
  void SetDiffuseColor(double red, double green, double blue);
  ///@}

  ///@{
  /**
   * Position of the data in the display; on several ranks the data are moved, because ParaView
   * divides them and orders ranks by the positions of the data themselves.
   */
  void SetOrientation(double x, double y, double z);
  void SetOrigin(double x, double y, double z);
  void SetPosition(double x, double y, double z);
  void SetScale(double x, double y, double z);
  ///@}

  /** The coloured array; the automatic unit distance depends on it. */
  void SetInputArrayToProcess(
    int index, int port, int connection, int association, const char* name) override;
  using Superclass::SetInputArrayToProcess;

  int ProcessViewRequest(
    vtkInformationRequestKey* request, vtkInformation* inInfo, vtkInformation* outInfo) override;

protected:
  vtkMediumRepresentation();
  ~vtkMediumRepresentation() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  bool AddToView(vtkView* view) override;
  bool RemoveFromView(vtkView* view) override;

  /** Whether a block of a composite input is drawn if it has the coloured array. */
  virtual bool DrawsBlock(vtkDataObject* block) const = 0;
  /** The input with what tells its cells and points apart once blocks have been put together. */
  virtual vtkSmartPointer<vtkDataObject> NumberInput(vtkDataObject* input);
  /**
   * Makes `Piece` and `DataBounds` of this rank's input, which may be null. Called by all ranks.
   */
  virtual void PreparePiece(vtkDataObject* input) = 0;
  /**
   * Moves `Piece`, which is not null, and `DataBounds`. Called by all ranks, if there are several.
   */
  virtual void MovePiece(vtkMatrix4x4* matrix);
  /** The last change of `Piece`, where it has been moved to. Called by all ranks. */
  virtual void FinishPiece() {}
  /** Describes the piece to the view; subclasses add how it may be distributed over ranks. */
  virtual void DescribePiece(vtkInformation* inInfo);
  /**
   * Called by all ranks, with what the view delivered, which may be null; returns what is drawn.
   */
  virtual vtkDataSet* CompletePiece(vtkDataSet* data, vtkInformation*) { return data; }
  /** Makes the mapper ready to draw a delivered piece, which holds something. */
  virtual void PrepareMapper(vtkDataSet* data);
  /** Whether there is something to draw in a delivered piece. */
  virtual bool HoldsMedium(vtkDataSet* data) const = 0;
  /** vtkDataObject::CELL or POINT: where a uniform medium's values stand. */
  virtual int GetUniformAssociation() const = 0;
  /** Where arrays of the input, on points or cells, stand in the piece. */
  virtual int GetAssociationInPiece(int association) const { return association; }

  static int GetNumberOfRanks();
  static bool IsFirstRank();
  /** The minimum over the ranks. Called by all ranks. */
  static int MinimumOverRanks(int mine);
  /** The sum over the ranks. Called by all ranks. */
  static double SumOverRanks(double mine);
  /**
   * Whether the input of any rank, which may be null, has points or cells; what has not is reported
   * by whoever made it. Called by all ranks.
   */
  static bool HoldsAnything(vtkDataObject* input);
  /**
   * Stores the automatic unit distance, and the range of what decides how opaque the medium is,
   * with the data, so that every time step in ParaView's cache keeps its own.
   */
  static void StoreMeasures(vtkDataSet* data, double distance, const double range[2]);
  void StoreBounds();
  vtkAbstractVolumeMapper* GetMapper() const;
  std::string GetOpacityArrayName() const; // empty for "None"
  vtkDataArray* FindColorArray(vtkDataSet* data, int& association, const char*& name);
  /**
   * Chooses the opacity function and returns the array that it reads; empty: the coloured one.
   * Where no array is chosen for the opacity, clouds that are coloured by the light of vtkSunlight
   * have the extinction that it was computed for.
   */
  virtual std::string PrepareOpacity(vtkDataSet* data);
  /**
   * Draws with an opacity proportional to the array; with `isExtinction` the optical depth of a
   * length is that of the array.
   */
  void FollowDensity(vtkDataArray* density, bool isExtinction);
  /**
   * The array that determines the opacity of the medium: the chosen one, otherwise the coloured
   * one.
   */
  virtual vtkDataArray* FindOpacityArray(vtkDataSet* data, int& association);

  vtkNew<vtkVolumeProperty> UniformProperty;
  vtkSmartPointer<vtkDataSet> Piece; // this rank's, as handed to the view
  double ActualUnitDistance = 1.0;   // of the last render
  double Opacity = 1.0;
  double OpacityScale = 1.0;

private:
  void WarnOfDisplays();
  void WarnOfEmptiness(vtkDataObject* input);
  void WarnOfMissingArray();
  vtkSmartPointer<vtkDataObject> KeepDrawnBlocks(vtkDataObject* input);
  vtkMediumRepresentation(const vtkMediumRepresentation&) = delete;
  void operator=(const vtkMediumRepresentation&) = delete;

  void FollowPlacement();
  void PlacePiece();
  void PlaceActor(vtkDataSet* data);

  void ColorUniformly(vtkDataSet* data);
  vtkVolumeProperty* ChooseProperty(vtkDataSet* data, const char* name);
  std::string WhyTransparent(vtkDataSet* data, vtkPiecewiseFunction* opacity) const;

  vtkDataArray* FindExtinctionOfLight(vtkDataSet* data);

  vtkNew<vtkVolumeProperty>
    DensityProperty; // the colours of one of the others, and an opacity of its own
  vtkNew<vtkPiecewiseFunction> DensityOpacity;
  vtkNew<vtkVolumeProperty> ConstantProperty; // where all values are the same
  std::string LastWarning;
  std::string LeftOut;      // the message about blocks
  std::string MissingArray; // a warning has named it
  bool WasEmpty = false;    // the input, and a warning has said so
  bool HasPiece = false;    // on any rank
  bool HasMovedPiece = false;
  vtkNew<vtkActor> Placement;              // of the display
  vtkSmartPointer<vtkDataSet> UniformData; // a delivered piece with a uniform array
  vtkMTimeType UniformDataTime = 0;
  vtkDataSet* UniformDataSource = nullptr; // only compared

  bool AutomaticUnitDistance = true;
  double UnitDistance = 0.0;
  std::string OpacityArray = "None";
};

#endif

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The scene of a mapper: samples and their appearance, vectors, the hierarchy, the order and the
 * layers. Each part is rebuilt only when its sources change, and uploaded again only when it is
 * rebuilt.
 */
#ifndef nephoscope_SplatScene_h
#define nephoscope_SplatScene_h

#include "ScalarSelection.h"
#include "SplatClasses.h"
#include "SplatHierarchy.h"
#include "SplatLight.h"
#include "SplatOrder.h"
#include "SplatRanges.h"
#include "SplatReach.h"
#include "SplatSamples.h"
#include "SplatVectorScene.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkVolumeProperty;

namespace nephoscope
{

struct ViewState;

/** The sources of the samples' colour and extinction. */
struct SplatFields
{
  ScalarSelection Scalars, Opacity;
  vtkVolumeProperty* Property;
  bool Interpolate; ///< between samples, before the opacity function
};

class SplatScene
{
public:
  /** Bounds of all that is drawn. The unit of `look` may be 0: it is found as for drawing. */
  const double* UpdateBounds(vtkDataSet* input, const SplatSampling& sampling, int kernel,
    const std::string& vectorArrayName, const VectorLook& look);

  /** Samples, classes and vectors. Returns the problem, or an empty string. */
  std::string Update(vtkDataSet* input, const SplatSampling& sampling, const SplatFields& fields,
    const SplatVectorSettings& vectors);

  /** Every sample is drawn. */
  void DrawSamples() { this->SetDrawsHierarchy(false); }
  /** Nodes of the hierarchy are drawn. */
  void DrawNodes(const SplatErrorRule& errors, const SplatCutRule& rule, const SplatCutView& view,
    const std::string& vectorArrayName);

  /** What is drawn, from back to front. */
  void UpdateOrder(const ViewState& state);
  /**
   * Scalars and vectors apart, layer by layer; or without `apart` both together, with `ordered`
   * layer by layer too if cells are flat. `near`: of the order's end.
   */
  void UpdateLayers(bool apart, bool ordered, vtkDataSet* input, int axis, std::size_t near);

  /** What has changed since the last upload. Returns an empty string, or what went wrong. */
  std::string Upload(
    vtkOpenGLRenderWindow* window, SplatPass& pass, const SplatVectorSettings& vectors);
  /** To be called when graphics resources are gone. */
  void ForgetUpload();

  std::size_t GetNumberOfSamples() const { return this->Classes.Samples.size(); }
  std::size_t GetNumberOfDrawn() const { return this->Drawn().size(); }
  const SplatSamples& GetSamples() const { return this->Samples; }
  /**
   * Which samples are left out because of a value, a coordinate or a size; empty if there are none.
   * `kind`: the word for a sample.
   */
  std::string DescribeLeftOut(const SplatFields& fields, const std::string& kind,
    const std::string& sizeArrayName, const std::string& vectorArrayName) const;
  /**
   * Thickness of the layers at right angles to the line of sight; 0 where they are those of a grid.
   */
  double GetLayerThickness() const;
  /** Whether the colours depend on the direction of view. */
  bool FollowsCamera() const { return this->Light.Light.IsUsed(); }
  /** Whether layers are drawn one after another, not in the order of the distances. */
  bool IsInLayers() const { return !this->Items.empty(); }
  SortedSplats GetSorted() const
  {
    return { this->Places(), this->Drawn(), this->Order, this->LongestDrawn() };
  }
  SplatVectorScene& GetVectorScene() { return this->VectorScene; }
  /** With which the hierarchy was drawn; 0 where every sample was. */
  double GetDrawnTolerance() const
  {
    return this->DrawsHierarchy ? this->Hierarchy.DrawnTolerance() : 0.0;
  }

private:
  using SampleKey = std::tuple<vtkDataSet*, vtkMTimeType, bool, double, std::string, double,
    SplatFrame, std::string, bool, bool, bool>;
  using ClassKey =
    std::tuple<vtkDataArray*, vtkDataArray*, int, vtkMTimeType, vtkMTimeType, bool, bool>;
  using BoundsKey = std::tuple<SampleKey, int, std::string, bool, double, double, double>;
  using LayerKey = std::tuple<bool, bool, int, std::size_t>;

  // Places, and the numbers of those among them that are drawn.
  const std::vector<std::array<float, 3>>& Places() const
  {
    return this->DrawsHierarchy ? this->Hierarchy.Positions() : this->Samples.Positions;
  }
  const std::vector<std::int32_t>& Drawn() const
  {
    return this->DrawsHierarchy ? this->Hierarchy.Cut() : this->Classes.Samples;
  }
  double LongestDrawn() const
  {
    return this->DrawsHierarchy ? this->Hierarchy.LongestDrawn(this->Samples)
                                : this->Samples.LongestEdge;
  }
  void SetDrawsHierarchy(bool hierarchy);
  std::string FindSamples(bool changed, bool reclassified);
  void Classify();
  void FindLight();
  ///@{
  /** What was freed is found again. */
  void RestoreJacobians();
  void RestoreColors();
  ///@}
  void FreeUploaded(const SplatVectorSettings& vectors);
  void ForgetOrder();
  void UploadOrder(SplatPass& pass) const;

  // The last update, for what is found again in the same render.
  struct Sources
  {
    vtkDataSet* Input = nullptr;
    SplatSampling Sampling;
    SplatFields Fields = {};
    bool KeepTransparent = false; // for vectors
  };
  Sources From;
  SampleKey SampledFrom;
  ClassKey ClassifiedBy{ nullptr, nullptr, 0, 0, 0, false, false };
  BoundsKey BoundsOf;
  std::optional<LayerKey> LayeredBy;
  double Bounds[6] = { 1, -1, 1, -1, 1, -1 };
  SplatSamples Samples;
  SplatClasses Classes;
  SplatLightSource Light;
  SplatVectorScene VectorScene;
  SplatHierarchy Hierarchy;
  bool DrawsHierarchy = false;     // in the last render
  SplatEye Eye{ { 0, 0, 0, -1 } }; // of the order: none
  SplatMetric Metric = UnitMetric;
  std::vector<std::int32_t> Order;
  std::vector<std::int32_t> Items; // of the order, where vectors are in layers
  bool CellsUploaded = false, ColorsUploaded = false, OrderUploaded = false;
  bool CameraMoved = false; // since shapes were used last
};

} // namespace nephoscope

#endif

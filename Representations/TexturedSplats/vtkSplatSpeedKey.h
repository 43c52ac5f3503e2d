// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSplatSpeedKey
 * @brief   legend of the vectors of textured splats: how fast they move in the film, and what their
 *          length means
 *
 * An arrow as long as the distance that a stated speed covers in a second of the film (or in 2, 5,
 * 10, ... if that is short), and text: the speed and the distance, the time in the data per second
 * of the film, and the speed of the fastest streaks or the longest segments. It follows the camera;
 * in perspective the arrow is correct at the distance of the focal point. Without TrueSpeed there
 * are only the words about the longest ones. Nothing is drawn before the vectors are, or where the
 * volume is not in the window. The position, which may be set, is that of the lower left corner.
 * Where a scalar bar or an earlier key of the renderer is there already, the key moves up; a key
 * that would repeat an earlier one is not drawn.
 */
#ifndef vtkSplatSpeedKey_h
#define vtkSplatSpeedKey_h

#include "vtkActor2D.h"
#include "vtkNephoscopeRepresentationsTexturedSplatsModule.h" // for export macro
#include "vtkNew.h"                                           // for the parts
#include "vtkSmartPointer.h"                                  // for the volume

#include <array>  // for the place
#include <string> // for the unit
#include <vector> // for other keys

class vtkLeaderActor2D;
class vtkTextActor;
class vtkTextProperty;
class vtkTexturedSplatMapper;
class vtkVolume;

class VTKNEPHOSCOPEREPRESENTATIONSTEXTUREDSPLATS_EXPORT vtkSplatSpeedKey : public vtkActor2D
{
public:
  static vtkSplatSpeedKey* New();
  vtkTypeMacro(vtkSplatSpeedKey, vtkActor2D);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The volume whose mapper, a vtkTexturedSplatMapper, draws the vectors. */
  void SetVolume(vtkVolume* volume);
  vtkVolume* GetVolume();

  ///@{
  /**
   * Unit of the vectors. With "m/s" distances and times have units too, such as km and h, which
   * LengthUnit determines. Default: empty, numbers only.
   */
  vtkSetMacro(SpeedUnit, std::string);
  vtkGetMacro(SpeedUnit, std::string);
  ///@}

  ///@{
  /**
   * With the SpeedUnit "m/s": length of the data's unit of length in metres, 1000 for data in
   * kilometres. Default: 1.
   */
  vtkSetClampMacro(LengthUnit, double, 1e-30, 1e30);
  vtkGetMacro(LengthUnit, double);
  ///@}

  ///@{
  /**
   * Name of the unit in which the film is measured here, and its length in seconds of the mapper's
   * FilmTime. Default: "s of film", 1.
   */
  vtkSetMacro(FilmUnit, std::string);
  vtkGetMacro(FilmUnit, std::string);
  vtkSetClampMacro(FilmUnitSeconds, double, 1e-30, 1e30);
  vtkGetMacro(FilmUnitSeconds, double);
  ///@}

  ///@{
  /**
   * On (default): black on a bright background, otherwise white, on a veil of the opposite colour.
   * Off: the colours of the text property.
   */
  vtkSetMacro(AutomaticColor, bool);
  vtkGetMacro(AutomaticColor, bool);
  vtkBooleanMacro(AutomaticColor, bool);
  ///@}

  /**
   * Font, size and colour. In views of fewer than 600 x 450 pixels the letters are smaller, and
   * where a line takes more than 0.6 of the width: down to 0.7 of the size, and then the line is
   * broken.
   */
  vtkTextProperty* GetTextProperty();

  /** What the last render wrote; empty if nothing. */
  std::string GetText();

  int RenderOverlay(vtkViewport* viewport) override;
  int RenderOpaqueGeometry(vtkViewport*) override { return 0; }
  int RenderTranslucentPolygonalGeometry(vtkViewport*) override { return 0; }
  vtkTypeBool HasTranslucentPolygonalGeometry() override { return 0; }
  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  vtkSplatSpeedKey();
  ~vtkSplatSpeedKey() override;

  std::string SpeedUnit;
  double LengthUnit = 1.0;
  std::string FilmUnit = "s of film";
  double FilmUnitSeconds = 1.0;
  bool AutomaticColor = true;

private:
  vtkTexturedSplatMapper* GetDrawnMapper(vtkViewport* viewport);
  std::string Describe(vtkTexturedSplatMapper* mapper, double pixels, double most, double& arrow);
  void Write(vtkViewport* viewport, bool hasArrow);
  void Place(vtkViewport* viewport, double arrow);
  bool Repeats(vtkViewport* viewport);
  std::vector<vtkSplatSpeedKey*> GetEarlierKeys(vtkViewport* viewport);

  std::array<double, 4> Rectangle{ { 0, 0, 0,
    0 } }; // left, right, bottom and top in the last render, in pixels of the view

  vtkSmartPointer<vtkVolume> Volume;
  std::string Text;
  vtkNew<vtkTextProperty> Style; // as set, for a view that is wide enough
  vtkNew<vtkTextActor> Words;
  vtkNew<vtkLeaderActor2D> Arrow;

  vtkSplatSpeedKey(const vtkSplatSpeedKey&) = delete;
  void operator=(const vtkSplatSpeedKey&) = delete;
};

#endif

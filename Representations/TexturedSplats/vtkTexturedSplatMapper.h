// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTexturedSplatMapper
 * @brief   samples of a scalar field drawn as splats in the shape of their grid cells
 *
 * Every sample is a kernel of unit integral, stretched to its grid cell. What a ray meets of it is integrated exactly, for
 * every cell shape and for parallel and perspective views: alpha = 1 - exp(-extinction * footprint). The product of what splats
 * let through is the exact transparency of the reconstructed field in any order; colours are composited from back to front, in an
 * order that is found once per view and does not depend on the order of the input.
 *
 * Vectors are drawn on the splats as streaks along their projection, foreshortened, that move with them, or as line segments: in
 * the middle of a splat's medium, so that the two partly hide each other, or layer by layer.
 *
 *     vtkDataSet ──► samples: place, Jacobian, value ──► colour, extinction ──► order ──► splats, blended in float
 *
 * Samples are points, or the centres of cells where the data are on cells, of any dataset. Structured grids give each its cell by
 * central differences; other points are balls. To be used with vtkVolume and vtkVolumeProperty; extinction is the
 * opacity function's value over ScalarOpacityUnitDistance, a rate per length, as in vtkCellCompositingMapper.
 *
 * References: R. Crawfis, N. Max, Texture Splats for 3D Scalar and Vector Field Visualization, IEEE Visualization 1993
 * (CrawfisMax1993); N. Max, R. Crawfis, B. Becker, New Techniques in 3D Scalar and Vector Field Visualization, Pacific
 * Graphics 1993, section 3 (MaxCrawfisBecker1993).
 */
#ifndef vtkTexturedSplatMapper_h
#define vtkTexturedSplatMapper_h

#include "vtkAbstractVolumeMapper.h"
#include "vtkNephoscopeRepresentationsTexturedSplatsModule.h" // for export macro
#include "vtkSmartPointer.h"                                  // for the colour function

#include <memory> // for std::unique_ptr
#include <string> // for array names

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkScalarsToColors;
namespace nephoscope
{
struct SplatDrawingOptions;
struct SplatVectorSettings;
struct ViewState;

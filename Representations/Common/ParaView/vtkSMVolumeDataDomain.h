// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkSMVolumeDataDomain
 * @brief offers a representation only for data that it can draw: with 3-D cells, or surfaces
 *
 * ParaView's list of representations depends on the kind of dataset at most, and one kind serves
 * surfaces as well as composite data. This domain belongs to a property of a representation that
 * draws 3-D cells only, and requires its input. Whenever the input changes it takes the name of the
 * representation, its attribute `representation`, out of the list, or puts it back. A name that is
 * chosen stays. It allows every value. With the attribute `sheets` it offers a representation of
 * surfaces: of structured data only for those one point thick.
 */
#ifndef vtkSMVolumeDataDomain_h
#define vtkSMVolumeDataDomain_h

#include "vtkNephoscopeParaViewCommonModule.h" // for export macro
#include "vtkSMStringListDomain.h"

#include <string> // for RepresentationName

class vtkPVDataInformation;

class VTKNEPHOSCOPEPARAVIEWCOMMON_EXPORT vtkSMVolumeDataDomain : public vtkSMStringListDomain
{
public:
  static vtkSMVolumeDataDomain* New();
  vtkTypeMacro(vtkSMVolumeDataDomain, vtkSMStringListDomain);

  int IsInDomain(vtkSMProperty*) override { return 1; }
  void Update(vtkSMProperty* property) override;
  int SetDefaultValues(vtkSMProperty*, bool) override { return 0; }

  /**
   * Whether there may be 3-D cells: no polygonal data alone, no grid one point thick, no flat
   * blocks or hyper tree grids. True where this can not be known.
   */
  static bool MayHoldVolumes(vtkPVDataInformation* data);

  /**
   * Whether it makes sense to draw the surface: not of a structured grid of 3-D cells, whose
   * surface is that of a box.
   */
  static bool IsSurface(vtkPVDataInformation* data);

protected:
  vtkSMVolumeDataDomain() = default;
  ~vtkSMVolumeDataDomain() override = default;

  int ReadXMLAttributes(vtkSMProperty* property, vtkPVXMLElement* element) override;

private:
  vtkSMVolumeDataDomain(const vtkSMVolumeDataDomain&) = delete;
  void operator=(const vtkSMVolumeDataDomain&) = delete;

  std::string RepresentationName;
  bool Sheets = false;
};

#endif

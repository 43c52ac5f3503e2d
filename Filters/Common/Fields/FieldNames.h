// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Which array a viewer should look at first, by its name. Plain C++17.
#ifndef nephoscope_FieldNames_h
#define nephoscope_FieldNames_h

#include "LowerCase.h"

#include <algorithm>
#include <initializer_list>
#include <string>

namespace nephoscope
{
enum class FieldKind
{
  CloudFraction,
  CloudWater,
  Other,
  Helper // coordinates, masks, numbers and the like: no field of the weather
};

inline bool IsOneOf(const std::string& name, std::initializer_list<const char*> names)
{
  return std::find(names.begin(), names.end(), name) != names.end();
}

inline FieldKind KindOfField(const std::string& fieldName)
{
  const std::string name = LowerCase(fieldName);
  const auto has = [&](const char* part) { return name.find(part) != std::string::npos; };
  const auto ends = [&](const std::string& end) {
    return name.size() > end.size() && name.compare(name.size() - end.size(), end.size(), end) == 0;
  };
  if (name.empty() || name.compare(0, 3, "vtk") == 0 || ends("_units") || ends("_bnds") ||
    ends("_bounds") || ends("ids") ||
    IsOneOf(name,
      { "belowground", "globegridprojection", "planetradius", "verticalexaggeration", "time", "crs",
        "lat", "latitude", "lon", "longitude", "lev", "level", "plev", "normals", "tcoords",
        "texturecoordinates", "texture coordinates" }))
  {
    return FieldKind::Helper;
  }
  if (IsOneOf(name, { "cc", "cl", "clc", "cldfra", "cfrac", "cld_frac", "tcdc", "fcloud" }) ||
    (has("cloud") && (has("frac") || has("cover") || has("area"))))
  {
    return FieldKind::CloudFraction;
  }
  if (IsOneOf(name,
        { "clwmr", "clwc", "ciwc", "clw", "cli", "cldwat", "cldice", "clmr", "cimixr", "icmr", "qc",
          "qi", "ql", "lwc", "iwc", "qcloud", "qice" }) ||
    has("cloud"))
  {
    return FieldKind::CloudWater;
  }
  return FieldKind::Other;
}
}

#endif

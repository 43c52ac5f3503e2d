// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VdbReading.h"

#include "vtkDataArray.h"
#include "vtkDataSetAttributes.h"

#include <sstream>

namespace nephoscope
{

VdbRead ReadGrids(const VdbRequest& request)
{
  VdbRead read;
  std::string name;
  try
  {
    VdbArchive archive(request.File);
    for (const VdbGridInfo& info : request.Grids)
    {
      if (request.Aborted && request.Aborted())
      {
        read.Error = "Reading was stopped.";
        return read;
      }
      name = info.Name;
      read.Grids.push_back(archive.Read(name));
      if (!read.Grids.back())
      {
        read.Error = "The grid '" + name + "' is not in '" + request.File + "'.";
        return read;
      }
    }
  }
  catch (const std::exception& exception)
  {
    read.Error = "The grid '" + name + "' of '" + request.File +
      "' cannot be read, the file may be truncated: " + Reason(exception);
  }
  return read;
}

std::string CheckMemory(
  double bytes, double limit, const std::string& what, const std::string& remedy)
{
  if (bytes <= limit)
  {
    return {};
  }
  std::ostringstream text;
  text.precision(4);
  const double gibibyte = 1024.0 * 1024.0 * 1024.0;
  text << what << " would need " << std::fixed;
  text.precision(0);
  text << bytes << " bytes (";
  text.unsetf(std::ios::fixed);
  text.precision(4);
  text << bytes / gibibyte << " GiB), more than the MemoryLimit of " << limit / gibibyte
       << " GiB: " << remedy;
  return text.str();
}

double BytesOfValues(const VdbRequest& request)
{
  double bytes = 0;
  for (const VdbGridInfo& info : request.Grids)
  {
    const bool isVector = info.Type.compare(0, 4, "vec3") == 0;
    const std::string element = isVector ? info.Type.substr(4) : info.Type;
    const bool wide = element == "d" || element == "double" || element == "int64";
    const bool narrow = element == "bool" || element == "mask";
    bytes += (isVector ? 3 : 1) * (wide ? 8 : narrow ? 1 : 4);
  }
  return bytes;
}

void ChooseActiveArrays(vtkDataSetAttributes* arrays)
{
  const char* scalars = nullptr;
  const char* vectors = nullptr;
  for (int i = 0; i < arrays->GetNumberOfArrays(); ++i)
  {
    vtkDataArray* array = arrays->GetArray(i);
    const char*& choice = array->GetNumberOfComponents() == 3 ? vectors : scalars;
    if (!choice || std::string("density") == array->GetName())
    {
      choice = array->GetName();
    }
  }
  if (scalars)
  {
    arrays->SetActiveScalars(scalars);
  }
  if (vectors)
  {
    arrays->SetActiveVectors(vectors);
  }
}

} // namespace nephoscope

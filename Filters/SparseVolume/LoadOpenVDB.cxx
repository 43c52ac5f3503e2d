// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What VdbFile.h and VdbWriting.h promise, by the library that lies beside this one and is loaded
// by the first call.
#include "VdbLibrary.h"

#include <dlfcn.h>

namespace nephoscope
{
namespace
{
struct VdbLibrary
{
  VdbFunctions Functions;
  std::string Error;
};

std::string FolderOfThisLibrary()
{
  Dl_info own;
  const std::string path =
    dladdr(reinterpret_cast<void*>(&HasOpenVDB), &own) ? own.dli_fname : std::string();
  return path.substr(0, path.rfind('/') + 1); // empty where there is none
}

VdbLibrary Load()
{
  VdbLibrary library;
  const std::string path = FolderOfThisLibrary() + NEPHOSCOPE_VDB_LIBRARY;
  void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  void* function = handle ? dlsym(handle, "nephoscope_vdb_functions") : nullptr;
  if (!function)
  {
    library.Error = std::string("OpenVDB cannot be loaded, so .vdb files can be neither read nor "
                                "written: install its library again. The system says: ") +
      dlerror();
    return library;
  }
  reinterpret_cast<decltype(&nephoscope_vdb_functions)>(function)(&library.Functions);
  return library;
}

const VdbLibrary& LoadedVdbLibrary()
{
  static const VdbLibrary library = Load();
  return library;
}

template <typename Function, typename... Arguments>
std::string Call(Function VdbFunctions::*member, Arguments&&... arguments)
{
  const VdbLibrary& library = LoadedVdbLibrary();
  return library.Error.empty() ? (library.Functions.*member)(arguments...) : library.Error;
}
}

bool HasOpenVDB()
{
  return true;
}

std::vector<VdbGridInfo> ListVdbGrids(const std::string& file, std::string& error)
{
  error = LoadedVdbLibrary().Error;
  return error.empty() ? LoadedVdbLibrary().Functions.List(file, error)
                       : std::vector<VdbGridInfo>();
}

std::string ReadVdbPoints(
  const VdbRequest& request, vtkPolyData* points, std::vector<std::string>& warnings)
{
  return Call(&VdbFunctions::ReadPoints, request, points, warnings);
}

std::string ReadVdbImage(
  const VdbRequest& request, vtkImageData* image, std::vector<std::string>& warnings)
{
  return Call(&VdbFunctions::ReadImage, request, image, warnings);
}

std::string WriteVdb(
  const VdbWriteSettings& settings, vtkDataSet* data, std::vector<std::string>& warnings)
{
  return Call(&VdbFunctions::Write, settings, data, warnings);
}

} // namespace nephoscope

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The functions of VdbFile.h and VdbWriting.h in a library of their own, which is loaded when a
 * .vdb file is first read or written. The symbols of libopenvdb take 1.5 s to look up among the
 * libraries of ParaView: every start of it would take as much longer.
 */
#ifndef nephoscope_VdbLibrary_h
#define nephoscope_VdbLibrary_h

#include "VdbFile.h"
#include "VdbWriting.h"

namespace nephoscope
{

struct VdbFunctions
{
  decltype(&ListVdbGrids) List = nullptr;
  decltype(&ReadVdbPoints) ReadPoints = nullptr;
  decltype(&ReadVdbImage) ReadImage = nullptr;
  decltype(&WriteVdb) Write = nullptr;
};

} // namespace nephoscope

/** What the library exports. */
extern "C" __attribute__((visibility("default"))) void nephoscope_vdb_functions(
  nephoscope::VdbFunctions* functions);

#endif

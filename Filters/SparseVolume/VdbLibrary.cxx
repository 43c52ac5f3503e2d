// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "VdbLibrary.h"

void nephoscope_vdb_functions(nephoscope::VdbFunctions* functions)
{
  *functions = { &nephoscope::ListVdbGrids, &nephoscope::ReadVdbPoints, &nephoscope::ReadVdbImage,
    &nephoscope::WriteVdb };
}

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Errors and warnings of what ParaView makes, in the words of its panels.
#ifndef nephoscope_LabelsInMessages_h
#define nephoscope_LabelsInMessages_h

#include "vtkNephoscopeParaViewFiltersModule.h" // for export macro

namespace nephoscope
{
// From now on every filter, reader, writer and representation of the suite that a proxy makes says
// the labels of its properties in place of their names in C++. Objects that are made in Python keep
// these. Called where the plugin is loaded: client, server and ranks.
VTKNEPHOSCOPEPARAVIEWFILTERS_EXPORT void SayLabelsInMessages();
}

#endif

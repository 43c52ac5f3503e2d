// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// One source Sun for all Sunlight filters, and for the example Clouds over the Globe.
#ifndef nephoscope_SunConnection_h
#define nephoscope_SunConnection_h

class vtkSMProxy;

namespace nephoscope
{
/**
 * Call it for a new proxy. A new Sun becomes the input Sun of all that have none, and a new
 * Sunlight filter or example without one gets the Sun that was made last.
 * The connection is an ordinary input: it is in state files, and can be undone.
 */
void ConnectToSun(vtkSMProxy* proxy);
}

#endif

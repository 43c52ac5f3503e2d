// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// Numbers that a property can not have.
#ifndef nephoscope_ValuesInDomains_h
#define nephoscope_ValuesInDomains_h

class vtkSMProxy;

namespace nephoscope
{
// From now on a number outside the range that a property of this proxy tells, or of a display
// inside it, becomes the nearest one that is in it, and what is not finite the default, with a
// warning that has the label and the range. Proxies of other plugins are left alone.
void KeepValuesInDomains(vtkSMProxy* proxy);
}

#endif

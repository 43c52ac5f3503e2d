// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Arrays that a filter has taken from the active source, where a script gives it another input. */
#ifndef nephoscope_ActiveSourceArrays_h
#define nephoscope_ActiveSourceArrays_h

class vtkSMProxy;

namespace nephoscope
{
/**
 * Functions of paraview.simple connect a new filter to the active source, and then to the input
 * that they are given: arrays chosen for the first stay.
 * Sets those that only the active source has to their defaults in the input; a name that neither
 * has is somebody's, and stays.
 */
void ForgetArraysOfActiveSource(vtkSMProxy* filter);
}

#endif

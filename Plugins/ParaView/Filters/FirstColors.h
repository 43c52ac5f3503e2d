// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// The colours and opacities of a display that is new: by which array, and with which preset of the
// suite.
#ifndef nephoscope_FirstColors_h
#define nephoscope_FirstColors_h

#include <string>

class vtkPVDataInformation;
class vtkSMProxy;
class vtkSMPVRepresentationProxy;
class vtkSMSourceProxy;

namespace nephoscope
{
/**
 * Colours by the array named `how`, or else, unless the display has colours already, by the array
 * of clouds ("clouds") or the active scalars. Without colours: "solid", and "surface" at one value
 * of the array that would colour it.
 */
void ColorFirst(
  vtkSMPVRepresentationProxy* display, vtkSMSourceProxy* source, int port, const std::string& how);

/**
 * Takes the colours from a surface that is coloured by the array of which it is a contour, or by
 * one with a single value: a map has one colour for it.
 */
void WhitenContour(vtkSMPVRepresentationProxy* display, vtkSMSourceProxy* source, int port);

/**
 * Gives the array that colours the display a preset that is in its unit: its range stays, except
 * that smoke alone in its view reaches white.
 */
void ColorByPreset(
  vtkSMPVRepresentationProxy* display, vtkSMSourceProxy* source, int port, const char* preset);

/**
 * Gives the array that colours the display the colours and opacities of its preset, unless somebody
 * has chosen others.
 */
void UsePresetOfArray(vtkSMPVRepresentationProxy* display, vtkSMSourceProxy* source, int port);

/** Whether vtkSunlight, or a filter after it, has made data. */
bool HasLight(vtkPVDataInformation* data);
}

#endif

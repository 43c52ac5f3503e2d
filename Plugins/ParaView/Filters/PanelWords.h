// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
// What the properties of a class are called in ParaView's panel.
#ifndef nephoscope_PanelWords_h
#define nephoscope_PanelWords_h

#include <string>

namespace nephoscope
{
// The text with the names of properties, which the definitions of proxies of this class tell,
// replaced by their labels.
std::string InWordsOfPanel(const std::string& text, const std::string& className);
}

#endif

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
/** Errors of a mapper: each is reported once, not once per frame. */
#ifndef nephoscope_ReportedError_h
#define nephoscope_ReportedError_h

#include <string>

namespace nephoscope
{

class ReportedError
{
public:
  /** Whether this is to be reported: it is no empty string, and not the one before. */
  bool IsNew(const std::string& error)
  {
    const bool changed = error != this->Last;
    this->Last = error;
    return changed && !error.empty();
  }

private:
  std::string Last;
};

} // namespace nephoscope

#endif

// SPDX-FileCopyrightText: The Nephoscope authors
// SPDX-License-Identifier: BSD-3-Clause
#include "TimeUnit.h"

#include "DataSets.h"
#include "LowerCase.h"

#include "vtkDataSet.h"
#include "vtkFieldData.h"
#include "vtkStringArray.h"

#include <map>
#include <sstream>
#include <string>

namespace nephoscope
{
namespace
{
// The first word of a text such as "hours since 2011-10-11".
double SecondsInUnit(const std::string& text)
{
  static const std::map<std::string, double> units = { { "millisecond", 1e-3 }, { "msec", 1e-3 },
    { "ms", 1e-3 }, { "second", 1 }, { "sec", 1 }, { "s", 1 }, { "minute", 60 }, { "min", 60 },
    { "hour", 3600 }, { "hr", 3600 }, { "h", 3600 }, { "day", 86400 }, { "d", 86400 } };
  std::string word;
  std::istringstream(LowerCase(text)) >> word;
  const bool isPlural = units.count(word) == 0 && !word.empty() && word.back() == 's';
  const auto found = units.find(isPlural ? word.substr(0, word.size() - 1) : word);
  return found == units.end() ? 0.0 : found->second;
}

double SecondsIn(vtkFieldData* fields)
{
  auto* unit =
    fields ? vtkStringArray::SafeDownCast(fields->GetAbstractArray("time_units")) : nullptr;
  return unit && unit->GetNumberOfValues() > 0 ? SecondsInUnit(unit->GetValue(0)) : 0.0;
}
}

double SecondsInUnitOfTime(vtkDataObject* data)
{
  double seconds = data ? SecondsIn(data->GetFieldData()) : 0.0;
  for (vtkDataSet* set : DataSetsOf(data))
  {
    seconds = seconds > 0.0 ? seconds : SecondsIn(set->GetFieldData());
  }
  return seconds;
}
}

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# NephoscopePresets.h in the build folder: the presets as ParaView's list takes them, and which array begins with which in what Nephoscope draws or
# makes: those of "nephoscope_weather_presets" in data of Globe Grid alone, as their names are usual elsewhere too.
set(nephoscope_presets_file "${PROJECT_SOURCE_DIR}/Plugins/Presets/nephoscope_presets.json")
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${nephoscope_presets_file}")
file(READ "${nephoscope_presets_file}" presets)
string(JSON count LENGTH "${presets}")
math(EXPR last "${count} - 1")
set(entries "")
set(NephoscopeArrays_entries "")
set(NephoscopeWeatherArrays_entries "")
foreach (index RANGE ${last})
  string(JSON preset GET "${presets}" ${index})
  string(JSON name GET "${preset}" Name)
  foreach (key IN ITEMS NephoscopeArrays NephoscopeWeatherArrays)
    string(JSON arrays ERROR_VARIABLE missing GET "${preset}" ${key})
    set(arrays_count 0)
    if (NOT missing)
      string(JSON arrays_count LENGTH "${arrays}")
    endif ()
    set(array_index 0)
    while (array_index LESS arrays_count)
      string(JSON array GET "${arrays}" ${array_index})
      string(APPEND ${key}_entries "\"${array}\": \"${name}\",\n")
      math(EXPR array_index "${array_index} + 1")
    endwhile ()
  endforeach ()
  string(APPEND entries "  { \"${name}\", R\"preset(${preset})preset\" },\n")
endforeach ()
string(REGEX REPLACE ",\n$" "\n" standard "${NephoscopeArrays_entries}")
string(REGEX REPLACE ",\n$" "\n" weather "${NephoscopeWeatherArrays_entries}")
file(CONFIGURE OUTPUT "${CMAKE_CURRENT_BINARY_DIR}/NephoscopePresets.h" @ONLY CONTENT
"// Made from Plugins/Presets/nephoscope_presets.json.
struct Preset
{
  const char* name;
  const char* json;
};
static const Preset PRESETS[] = {
@entries@};
static const char* const PRESETS_OF_ARRAYS = R\"settings({ \"nephoscope_presets\": {
@standard@}, \"nephoscope_weather_presets\": {
@weather@} })settings\";
")

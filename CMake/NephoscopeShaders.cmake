# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# Shaders become C++ strings: nephoscope_encode_shaders(VARIABLE "File.glsl=NameOfString"...) reads shaders/File.glsl and
# puts the sources and headers (NameOfString.h) to compile into VARIABLE.
function (nephoscope_encode_shaders variable)
  set(files)
  foreach (pair IN LISTS ARGN)
    string(REGEX MATCH "^(.*)=(.*)$" _ "${pair}")
    vtk_encode_string(
      INPUT         "shaders/${CMAKE_MATCH_1}"
      NAME          "${CMAKE_MATCH_2}"
      HEADER_OUTPUT header
      SOURCE_OUTPUT source)
    list(APPEND files "${source}" "${header}")
  endforeach ()
  set(${variable} "${files}" PARENT_SCOPE)
endfunction ()

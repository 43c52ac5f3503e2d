# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# ParaView's and VTK's CMake packages import the Python modules that they installed as NAME.so. Debian 13 and later rename these to
# NAME.cpython-<version>-<platform>.so, so that find_package would stop: "references the file NAME.so, but this file does not exist".
# Here such modules are imported first, from copies of the export files that have the right names. CMake passes over an export file
# all of whose targets are there. Nothing outside the build folder is touched.

# Sets `prefix` to the first folder above `folder` that has `relative`: the prefix that an export file in `folder` speaks of.
function (nephoscope_import_prefix folder relative prefix)
  get_filename_component(candidate "${folder}" DIRECTORY)
  set(below "")
  while (NOT EXISTS "${candidate}/${relative}" AND NOT candidate STREQUAL below)
    set(below "${candidate}")
    get_filename_component(candidate "${candidate}" DIRECTORY)
  endwhile ()
  set(${prefix} "${candidate}" PARENT_SCOPE)
endfunction ()

# Puts the names that modules have into the text of an export file in `folder`; adds to a number how many have been renamed.
function (nephoscope_correct_names folder text_variable number_variable)
  set(corrected "${${text_variable}}")
  set(count ${${number_variable}})
  string(REGEX MATCHALL "\"[^\"]*_IMPORT_PREFIX}/[^\"]*[.]so\"" quoted_names "${corrected}")
  list(REMOVE_DUPLICATES quoted_names)
  foreach (quoted IN LISTS quoted_names)
    string(REGEX REPLACE "^.*_IMPORT_PREFIX}/(.*)[.]so\"$" "\\1" module "${quoted}")
    get_filename_component(module_folder "${module}" DIRECTORY)
    nephoscope_import_prefix("${folder}" "${module_folder}" prefix)
    file(GLOB present "${prefix}/${module}.cpython-*.so")
    if (present AND NOT EXISTS "${prefix}/${module}.so")
      list(GET present 0 present)
      string(REPLACE "${quoted}" "\"${present}\"" corrected "${corrected}")
      math(EXPR count "${count} + 1")
    endif ()
  endforeach ()
  set(${text_variable} "${corrected}" PARENT_SCOPE)
  set(${number_variable} ${count} PARENT_SCOPE)
endfunction ()

# Copies the export files of Python modules in `folder`, corrected. Sets `copies` to them; empty where no module has been renamed.
function (nephoscope_copy_python_exports folder copies)
  set(copied "")
  set(renamed 0)
  get_filename_component(name "${folder}" NAME)
  set(copy_folder "${PROJECT_BINARY_DIR}/CMakeFiles/python-targets/${name}")
  file(GLOB exports "${folder}/*Python-targets*.cmake" "${folder}/*PythonIncubator-targets*.cmake")
  foreach (export IN LISTS exports)
    file(READ "${export}" text)
    nephoscope_correct_names("${folder}" text renamed)
    string(REPLACE "get_filename_component(_IMPORT_PREFIX \"\${CMAKE_CURRENT_LIST_FILE}\" PATH)"
      "set(_IMPORT_PREFIX \"${folder}\")" text "${text}")
    get_filename_component(name "${export}" NAME)
    file(WRITE "${copy_folder}/${name}" "${text}")
    if (name MATCHES "-targets[.]cmake$") # the others are included by these
      list(APPEND copied "${copy_folder}/${name}")
    endif ()
  endforeach ()
  if (NOT renamed)
    set(copied "")
  endif ()
  set(${copies} "${copied}" PARENT_SCOPE)
endfunction ()

# Imports the Python modules of the CMake package in `folder` where some have been renamed.
# A function, so that a find_package that calls it keeps its own variables.
function (nephoscope_import_python_targets folder)
  nephoscope_copy_python_exports("${folder}" copies)
  set(quiet "${${CMAKE_FIND_PACKAGE_NAME}_FIND_QUIETLY}")
  set(CMAKE_FIND_PACKAGE_NAME NephoscopePythonTargets) # the export files tell it what they miss
  foreach (copy IN LISTS copies)
    if (NOT quiet)
      message(STATUS "Nephoscope: Python modules by the names they have: ${copy}")
    endif ()
    include("${copy}")
  endforeach ()
endfunction ()

# Sets `folder` to that of the package which find_package would take, without loading it: asked for a version that there is not,
# find_package tells what it considered.
macro (nephoscope_locate_package package version folder)
  set(${folder} "")
  set(nephoscope_saved_dir "${${package}_DIR}")
  find_package(${package} 9999 EXACT QUIET CONFIG)
  set(${package}_DIR "${nephoscope_saved_dir}" CACHE PATH "Folder of the CMake package ${package}" FORCE)
  set(nephoscope_index 0)
  foreach (nephoscope_config IN LISTS ${package}_CONSIDERED_CONFIGS)
    list(GET ${package}_CONSIDERED_VERSIONS ${nephoscope_index} nephoscope_version)
    if (NOT ${folder} AND NOT nephoscope_version VERSION_LESS ${version})
      get_filename_component(${folder} "${nephoscope_config}" DIRECTORY)
    endif ()
    math(EXPR nephoscope_index "${nephoscope_index} + 1")
  endforeach ()
endmacro ()

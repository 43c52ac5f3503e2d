# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# Finds, builds and wraps every VTK module of the project. A new technique needs no line here: a folder
# with a vtk.module below Filters/ or Representations/ is enough; what a technique adds for ParaView is its folder ParaView/.
file(GLOB nephoscope_module_files CONFIGURE_DEPENDS
  "${PROJECT_SOURCE_DIR}/Filters/*/vtk.module"
  "${PROJECT_SOURCE_DIR}/Representations/*/vtk.module")
if (NEPHOSCOPE_USE_PARAVIEW)
  file(GLOB nephoscope_paraview_module_files CONFIGURE_DEPENDS
    "${PROJECT_SOURCE_DIR}/Plugins/ParaView/*/vtk.module"
    "${PROJECT_SOURCE_DIR}/Representations/*/ParaView/vtk.module")
  list(APPEND nephoscope_module_files ${nephoscope_paraview_module_files})
endif ()

vtk_module_scan(
  MODULE_FILES            ${nephoscope_module_files}
  PROVIDES_MODULES        nephoscope_modules
  REQUIRES_MODULES        nephoscope_required_modules
  WANT_BY_DEFAULT         ON
  HIDE_MODULES_FROM_CACHE ON
  ENABLE_TESTS            OFF)
foreach (required IN LISTS nephoscope_required_modules)
  if (NOT TARGET "${required}")
    message(FATAL_ERROR "The VTK module ${required} is missing from ${VTK_DIR}.")
  endif ()
endforeach ()

# The folders of a module whose headers are included by their names alone: PUBLIC by modules that depend on it, too.
function (nephoscope_module_folders module)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "PUBLIC;PRIVATE")
  foreach (kind IN ITEMS PUBLIC PRIVATE)
    foreach (folder IN LISTS arg_${kind})
      vtk_module_include("${module}" ${kind} "$<BUILD_INTERFACE:${CMAKE_CURRENT_SOURCE_DIR}/${folder}>")
    endforeach ()
  endforeach ()
endfunction ()

set(nephoscope_wrapping OFF)
if (NEPHOSCOPE_WRAP_PYTHON OR NEPHOSCOPE_USE_PARAVIEW) # for the plugin too
  set(nephoscope_wrapping ON)
endif ()
vtk_module_build(
  MODULES              ${nephoscope_modules}
  PACKAGE              Nephoscope
  INSTALL_EXPORT       Nephoscope
  HEADERS_DESTINATION  "${CMAKE_INSTALL_INCLUDEDIR}/nephoscope"
  CMAKE_DESTINATION    "${CMAKE_INSTALL_LIBDIR}/cmake/Nephoscope"
  ENABLE_WRAPPING      "${nephoscope_wrapping}")

if (NEPHOSCOPE_WRAP_PYTHON)
  include(NephoscopePython)
endif ()

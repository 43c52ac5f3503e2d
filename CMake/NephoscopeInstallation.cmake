# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# What an installation has for other projects: find_package(Nephoscope). Documentation/cpp.md shows how to use it.
include(CMakePackageConfigHelpers)
set(nephoscope_cmake_destination "${CMAKE_INSTALL_LIBDIR}/cmake/Nephoscope")
set(nephoscope_config "${PROJECT_BINARY_DIR}/CMakeFiles/NephoscopeConfig.cmake")
set(nephoscope_config_version "${PROJECT_BINARY_DIR}/CMakeFiles/NephoscopeConfigVersion.cmake")

# The modules of VTK that ours need. RenderingFreeType and InteractionStyle bring what a window needs besides.
set(nephoscope_vtk_modules VTK::RenderingFreeType VTK::InteractionStyle ${nephoscope_required_modules})
list(FILTER nephoscope_vtk_modules INCLUDE REGEX "^VTK::")
list(REMOVE_DUPLICATES nephoscope_vtk_modules)
list(TRANSFORM nephoscope_vtk_modules REPLACE "^VTK::" "")
list(JOIN nephoscope_vtk_modules " " nephoscope_vtk_modules)

# The components of find_package that a message lists: our modules but those for ParaView, which need its targets besides VTK's.
set(nephoscope_component_names ${nephoscope_modules})
list(FILTER nephoscope_component_names EXCLUDE REGEX "^Nephoscope::ParaView")
list(TRANSFORM nephoscope_component_names REPLACE "^Nephoscope::" "")
list(SORT nephoscope_component_names)
list(JOIN nephoscope_component_names ", " nephoscope_component_names)

configure_package_config_file("${CMAKE_CURRENT_LIST_DIR}/NephoscopeConfig.cmake.in" "${nephoscope_config}"
  INSTALL_DESTINATION "${nephoscope_cmake_destination}")
write_basic_package_version_file("${nephoscope_config_version}" COMPATIBILITY SameMinorVersion)
install(FILES "${nephoscope_config}" "${nephoscope_config_version}" "${CMAKE_CURRENT_LIST_DIR}/NephoscopePythonTargets.cmake"
  DESTINATION "${nephoscope_cmake_destination}")

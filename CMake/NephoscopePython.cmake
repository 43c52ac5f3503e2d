# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# The Python package `nephoscope`: wrapped classes next to the pure-Python part of Plugins/PyVista.
set(nephoscope_wrapped_modules ${nephoscope_modules})
list(REMOVE_ITEM nephoscope_wrapped_modules
  Nephoscope::RepresentationsCommon     # C++ only
  Nephoscope::ParaViewRepresentations)  # reached through ParaView's server manager

set(NEPHOSCOPE_PYTHON_DESTINATION "${CMAKE_INSTALL_LIBDIR}/python3/dist-packages")
set(NEPHOSCOPE_PYTHONPATH "${PROJECT_BINARY_DIR}/${NEPHOSCOPE_PYTHON_DESTINATION}")
vtk_module_wrap_python(
  MODULES             ${nephoscope_wrapped_modules}
  TARGET              Nephoscope::PythonWrapped
  PYTHON_PACKAGE      "nephoscope"
  MODULE_DESTINATION  "${NEPHOSCOPE_PYTHON_DESTINATION}"
  CMAKE_DESTINATION   "${CMAKE_INSTALL_LIBDIR}/cmake/Nephoscope"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  BUILD_STATIC        OFF
  INSTALL_EXPORT      "")

# `nephoscope/_modules.py` lists the wrapped modules for __init__.py to import.
set(nephoscope_python_module_names)
foreach (module IN LISTS nephoscope_wrapped_modules)
  _vtk_module_get_module_property("${module}" PROPERTY "library_name" VARIABLE library)
  list(APPEND nephoscope_python_module_names "\"${library}\"")
endforeach ()
list(JOIN nephoscope_python_module_names ", " nephoscope_python_module_names)
file(WRITE "${NEPHOSCOPE_PYTHONPATH}/nephoscope/_modules.py"
  "# Written by CMake: the wrapped VTK modules of this build.\nMODULES = (${nephoscope_python_module_names},)\n")
install(FILES "${NEPHOSCOPE_PYTHONPATH}/nephoscope/_modules.py"
  DESTINATION "${NEPHOSCOPE_PYTHON_DESTINATION}/nephoscope")

# The pure-Python part is copied whenever it changes.
file(GLOB nephoscope_python_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/Plugins/PyVista/nephoscope/*.py")
set(nephoscope_python_outputs)
foreach (source IN LISTS nephoscope_python_sources)
  get_filename_component(name "${source}" NAME)
  set(copied "${NEPHOSCOPE_PYTHONPATH}/nephoscope/${name}")
  add_custom_command(OUTPUT "${copied}" DEPENDS "${source}"
    COMMAND ${CMAKE_COMMAND} -E copy "${source}" "${copied}" VERBATIM)
  list(APPEND nephoscope_python_outputs "${copied}")
endforeach ()
add_custom_target(NephoscopePythonSources ALL DEPENDS ${nephoscope_python_outputs})
install(FILES ${nephoscope_python_sources} DESTINATION "${NEPHOSCOPE_PYTHON_DESTINATION}/nephoscope")

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# The Python package `nephoscope`: wrapped classes next to the pure-Python part of Plugins/PyVista, in three places:
#   the build tree    ${NEPHOSCOPE_PYTHONPATH}
#   the install tree  ${CMAKE_INSTALL_PREFIX}/${NEPHOSCOPE_PYTHON_DESTINATION}
#   a wheel           zipped by Plugins/PyVista/packaging from the install component `nephoscope_wheel`
# Modules without classes say EXCLUDE_WRAP; those of the plugin are reached through ParaView's server manager.
set(nephoscope_wrapped_modules)
foreach (module IN LISTS nephoscope_modules)
  _vtk_module_get_module_property("${module}" PROPERTY "exclude_wrap" VARIABLE excluded)
  if (NOT excluded AND NOT module MATCHES "^Nephoscope::ParaView")
    list(APPEND nephoscope_wrapped_modules "${module}")
  endif ()
endforeach ()

set(NEPHOSCOPE_WHEEL_TAG "" CACHE STRING "Tag of the wheel, such as cp311-cp311-linux_x86_64; empty: that of Python3_EXECUTABLE")

set(NEPHOSCOPE_PYTHON_DESTINATION "${CMAKE_INSTALL_LIBDIR}/python3/dist-packages" CACHE STRING
  "Folder of the Python package below the prefix")
mark_as_advanced(NEPHOSCOPE_PYTHON_DESTINATION)
set(NEPHOSCOPE_PYTHONPATH "${PROJECT_BINARY_DIR}/${NEPHOSCOPE_PYTHON_DESTINATION}")
vtk_module_wrap_python(
  MODULES             ${nephoscope_wrapped_modules}
  TARGET              Nephoscope::PythonWrapped
  PYTHON_PACKAGE      "nephoscope"
  MODULE_DESTINATION  "${NEPHOSCOPE_PYTHON_DESTINATION}"
  CMAKE_DESTINATION   "${CMAKE_INSTALL_LIBDIR}/cmake/Nephoscope"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  BUILD_STATIC        OFF
  INSTALL_HEADERS     OFF)

# The libraries of the wheel: all but those that need ParaView's client and server.
set(nephoscope_wheel_targets)
foreach (module IN LISTS nephoscope_modules)
  if (NOT module MATCHES "^Nephoscope::ParaView")
    get_target_property(target "${module}" ALIASED_TARGET)
    list(APPEND nephoscope_wheel_targets "${target}")
  endif ()
endforeach ()
# The compiled Python modules, and `nephoscope/_modules.py`, which lists them for __init__.py.
set(nephoscope_module_names)
foreach (module IN LISTS nephoscope_wrapped_modules)
  _vtk_module_get_module_property("${module}" PROPERTY "library_name" VARIABLE library)
  list(APPEND nephoscope_module_names "\"${library}\"")
  list(APPEND nephoscope_wheel_targets "${library}Python")
endforeach ()
list(JOIN nephoscope_module_names ", " nephoscope_module_names)
set(nephoscope_used_modules ${nephoscope_required_modules})
foreach (module IN LISTS nephoscope_modules)
  _vtk_module_get_module_property("${module}" PROPERTY "optional_depends" VARIABLE optional)
  foreach (other IN LISTS optional)
    if (TARGET "${other}")
      list(APPEND nephoscope_used_modules "${other}")
    endif ()
  endforeach ()
endforeach ()
list(REMOVE_DUPLICATES nephoscope_used_modules)
set(nephoscope_vtk_module_names)
foreach (module IN LISTS nephoscope_used_modules)
  _vtk_module_get_module_property("${module}" PROPERTY "exclude_wrap" VARIABLE excluded)
  if (NOT excluded AND NOT module MATCHES "^ParaView::")
    _vtk_module_get_module_property("${module}" PROPERTY "library_name" VARIABLE library)
    list(APPEND nephoscope_vtk_module_names "\"${library}\"")
  endif ()
endforeach ()
list(JOIN nephoscope_vtk_module_names ", " nephoscope_vtk_module_names)
set(nephoscope_from_pypi False)
if (NEPHOSCOPE_FOR_PYPI)
  set(nephoscope_from_pypi True)
endif ()
configure_file("${PROJECT_SOURCE_DIR}/Plugins/PyVista/packaging/_modules.py.in"
  "${NEPHOSCOPE_PYTHONPATH}/nephoscope/_modules.py" @ONLY)

# In a wheel the libraries lie beside the modules, and those of VTK's wheel in the folder of its modules. Another VTK, outside the
# system's library folders, is found again after installation.
if (APPLE)
  set(nephoscope_rpath "@loader_path")
else ()
  set(nephoscope_rpath "$ORIGIN")
endif ()
set(nephoscope_link_path ON)
if (NEPHOSCOPE_FOR_PYPI)
  list(APPEND nephoscope_rpath "${nephoscope_rpath}/../vtkmodules")
  set(nephoscope_link_path OFF)
  add_library(nephoscope_older_symbols STATIC "${PROJECT_SOURCE_DIR}/CMake/wheel/older_symbols.c" "${PROJECT_SOURCE_DIR}/CMake/wheel/older_wait.c")
  set_target_properties(nephoscope_older_symbols PROPERTIES POSITION_INDEPENDENT_CODE ON C_VISIBILITY_PRESET hidden)
endif ()
foreach (target IN LISTS nephoscope_wheel_targets)
  if (NEPHOSCOPE_FOR_PYPI)
    target_link_libraries(${target} PRIVATE $<BUILD_INTERFACE:nephoscope_older_symbols>)
    set_property(TARGET ${target} PROPERTY INSTALL_RPATH "") # VTK sets one for the layout of an installation
  endif ()
  set_property(TARGET ${target} APPEND PROPERTY INSTALL_RPATH ${nephoscope_rpath})
  set_property(TARGET ${target} PROPERTY INSTALL_RPATH_USE_LINK_PATH ${nephoscope_link_path})
endforeach ()

# The pure-Python part, and the presets that it shares with the plugin, are copied whenever they change.
file(GLOB nephoscope_python_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/Plugins/PyVista/nephoscope/*.py")
list(APPEND nephoscope_python_sources "${PROJECT_SOURCE_DIR}/Plugins/Presets/nephoscope_presets.json")
set(nephoscope_python_outputs)
file(GLOB nephoscope_weather_sources CONFIGURE_DEPENDS "${PROJECT_SOURCE_DIR}/Plugins/PyVista/nephoscope/weather/*.py"
  "${PROJECT_SOURCE_DIR}/Plugins/PyVista/nephoscope/weather/*.xml")
foreach (source IN LISTS nephoscope_python_sources nephoscope_weather_sources)
  get_filename_component(name "${source}" NAME)
  if (source IN_LIST nephoscope_weather_sources)
    string(PREPEND name "weather/")
  endif ()
  set(copied "${NEPHOSCOPE_PYTHONPATH}/nephoscope/${name}")
  add_custom_command(OUTPUT "${copied}" DEPENDS "${source}"
    COMMAND ${CMAKE_COMMAND} -E copy "${source}" "${copied}" VERBATIM)
  list(APPEND nephoscope_python_outputs "${copied}")
endforeach ()
add_custom_target(NephoscopePythonSources ALL DEPENDS ${nephoscope_python_outputs})

# Package metadata: by its entry point PyVista finds the accessor although nephoscope was imported first, or not at all.
set(nephoscope_dist_info "nephoscope-${PROJECT_VERSION}.dist-info")
file(READ "${PROJECT_SOURCE_DIR}/Plugins/PyVista/packaging/description.md" nephoscope_description)
set(nephoscope_requirements "Requires-Python: >=3.9")
set(nephoscope_licence "License-Expression: BSD-3-Clause\nLicense-File: LICENSE")
if (NEPHOSCOPE_FOR_PYPI)
  if (NEPHOSCOPE_USE_OPENVDB) # that of CMake/wheel/openvdb
    set(nephoscope_licence "License-Expression: BSD-3-Clause AND MPL-2.0 AND Apache-2.0 AND BSD-2-Clause AND MIT\nLicense-File: LICENSE")
    foreach (name IN ITEMS third-party OpenVDB oneTBB Blosc Bitshuffle FastLZ LZ4)
      string(APPEND nephoscope_licence "\nLicense-File: ${name}.txt")
    endforeach ()
  endif ()
  string(CONCAT nephoscope_requirements "Requires-Python: >=3.11\nRequires-Dist: vtk==${VTK_VERSION}\n"
    "Provides-Extra: pyvista\nRequires-Dist: pyvista>=0.48; extra == 'pyvista'\n"
    "Provides-Extra: web\nRequires-Dist: pyvista[jupyter]>=0.48; extra == 'web'\nRequires-Dist: trame>=3; extra == 'web'\n"
    "Requires-Dist: trame-vtk>=2.8; extra == 'web'\nRequires-Dist: trame-vuetify>=2.8; extra == 'web'\n"
    "Provides-Extra: data\nRequires-Dist: pyvista>=0.48; extra == 'data'\nRequires-Dist: xarray>=2023.1; extra == 'data'\nRequires-Dist: eccodes>=2.39; extra == 'data'\n"
    "Requires-Dist: eccodeslib; extra == 'data'\nRequires-Dist: netCDF4; extra == 'data'\nRequires-Dist: zarr; extra == 'data'\n"
    "Requires-Dist: dask; extra == 'data'\nRequires-Dist: cfgrib>=0.9.15; extra == 'data'\nRequires-Dist: pyproj; extra == 'data'\nRequires-Dist: scipy; extra == 'data'")
endif ()
foreach (name IN ITEMS METADATA entry_points.txt)
  configure_file("${PROJECT_SOURCE_DIR}/Plugins/PyVista/packaging/${name}.in"
    "${NEPHOSCOPE_PYTHONPATH}/${nephoscope_dist_info}/${name}" @ONLY)
endforeach ()
set(nephoscope_wheel_tag "${NEPHOSCOPE_WHEEL_TAG}")
if (NOT nephoscope_wheel_tag)
  execute_process(COMMAND "${Python3_EXECUTABLE}" -c
    "import re, sys, sysconfig; v = 'cp%d%d' % sys.version_info[:2]; print(v, v, re.sub('[-.]', '_', sysconfig.get_platform()), sep='-')"
    OUTPUT_VARIABLE nephoscope_wheel_tag OUTPUT_STRIP_TRAILING_WHITESPACE)
endif ()
if (NOT nephoscope_wheel_tag)
  message(FATAL_ERROR "The Python interpreter '${Python3_EXECUTABLE}' does not run. Set Python3_EXECUTABLE.")
endif ()
configure_file("${PROJECT_SOURCE_DIR}/Plugins/PyVista/packaging/WHEEL.in"
  "${PROJECT_BINARY_DIR}/${nephoscope_dist_info}/WHEEL" @ONLY)

# nephoscope_install_python(<folder> [<arguments of install()>...])   folder: empty, or ending in a slash
function (nephoscope_install_python folder)
  install(FILES ${nephoscope_python_sources} "${NEPHOSCOPE_PYTHONPATH}/nephoscope/_modules.py"
    DESTINATION "${folder}nephoscope" ${ARGN})
  install(FILES ${nephoscope_weather_sources} DESTINATION "${folder}nephoscope/weather" ${ARGN})
  install(FILES
    "${NEPHOSCOPE_PYTHONPATH}/${nephoscope_dist_info}/METADATA"
    "${NEPHOSCOPE_PYTHONPATH}/${nephoscope_dist_info}/entry_points.txt"
    DESTINATION "${folder}${nephoscope_dist_info}" ${ARGN})
  install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${folder}${nephoscope_dist_info}/licenses" ${ARGN})
endfunction ()
nephoscope_install_python("${NEPHOSCOPE_PYTHON_DESTINATION}/")
nephoscope_install_python("" COMPONENT nephoscope_wheel EXCLUDE_FROM_ALL)
install(FILES "${PROJECT_BINARY_DIR}/${nephoscope_dist_info}/WHEEL"
  DESTINATION "${nephoscope_dist_info}" COMPONENT nephoscope_wheel EXCLUDE_FROM_ALL)
install(TARGETS ${nephoscope_wheel_targets}
  LIBRARY DESTINATION nephoscope COMPONENT nephoscope_wheel NAMELINK_SKIP EXCLUDE_FROM_ALL)

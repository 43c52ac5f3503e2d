# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# The Debian package of `./nephoscope package`, made by CPack: ParaView plugin, Python package, VTK modules with headers.
# ParaView loads at its start what lies in the folder `plugins` beside its program, on the server's side too.
set(nephoscope_maintainer "The Nephoscope authors <nephoscope@nephoscope.invalid>")
set(nephoscope_debian "${PROJECT_BINARY_DIR}/debian")
set(nephoscope_debian_documents "${CMAKE_INSTALL_DATAROOTDIR}/doc/nephoscope-paraview")
file(MAKE_DIRECTORY "${nephoscope_debian}")
file(CREATE_LINK "../${CMAKE_INSTALL_LIBDIR}/${NEPHOSCOPE_PLUGIN_SUBDIRECTORY}/Nephoscope" "${nephoscope_debian}/plugins" SYMBOLIC)
install(FILES "${nephoscope_debian}/plugins" DESTINATION "${CMAKE_INSTALL_BINDIR}")

file(READ "${PROJECT_SOURCE_DIR}/LICENSE" nephoscope_licence)
string(REGEX REPLACE "\n\n" "\n.\n" nephoscope_licence "${nephoscope_licence}")
string(REGEX REPLACE "\n" "\n " nephoscope_licence "${nephoscope_licence}")
configure_file("${CMAKE_CURRENT_LIST_DIR}/debian/copyright.in" "${nephoscope_debian}/copyright" @ONLY)
file(CREATE_LINK copyright "${nephoscope_debian}/LICENSE" SYMBOLIC) # the name by which README.md links to it
install(FILES "${nephoscope_debian}/copyright" "${nephoscope_debian}/LICENSE" DESTINATION "${nephoscope_debian_documents}")

# The pages, with the pictures and the pages that they link to.
install(FILES "${PROJECT_SOURCE_DIR}/README.md" "${PROJECT_SOURCE_DIR}/CONTRIBUTING.md" "${PROJECT_SOURCE_DIR}/CHANGELOG.md" "${PROJECT_SOURCE_DIR}/CITATION.cff"
  DESTINATION "${nephoscope_debian_documents}")
install(DIRECTORY "${PROJECT_SOURCE_DIR}/Documentation/" DESTINATION "${nephoscope_debian_documents}/Documentation" PATTERN site EXCLUDE)
set(nephoscope_pages Plugins/PyVista/examples/clouds.ipynb)
file(GLOB nephoscope_example RELATIVE "${PROJECT_SOURCE_DIR}" "${PROJECT_SOURCE_DIR}/Testing/Package/example/*")
foreach (folder IN ITEMS Filters Representations Plugins Testing Data CMake)
  file(GLOB_RECURSE nephoscope_of_folder RELATIVE "${PROJECT_SOURCE_DIR}" "${PROJECT_SOURCE_DIR}/${folder}/*.md")
  list(APPEND nephoscope_pages ${nephoscope_of_folder})
endforeach ()
list(FILTER nephoscope_pages EXCLUDE REGEX "/build/")
foreach (page IN LISTS nephoscope_pages nephoscope_example)
  get_filename_component(folder "${page}" DIRECTORY)
  install(FILES "${PROJECT_SOURCE_DIR}/${page}" DESTINATION "${nephoscope_debian_documents}/${folder}")
endforeach ()
# What the Python package and the reader of weather data name in their messages about missing packages.
foreach (packages IN ITEMS requirements requirements-data requirements-grib requirements-netcdf requirements-zarr)
  install(FILES "${PROJECT_SOURCE_DIR}/Plugins/PyVista/${packages}.txt" DESTINATION share/nephoscope)
endforeach ()

# With it ParaView 5.11 keeps unstructured data between ranks in spite of a recent libexpat (Documentation/debian.md).
if (TARGET expat_whole_tokens)
  install(TARGETS expat_whole_tokens LIBRARY DESTINATION "${CMAKE_INSTALL_LIBDIR}/nephoscope")
endif ()

# A change log in the form that Debian asks for, and the step after which the linker finds the libraries.
string(TIMESTAMP nephoscope_debian_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
configure_file("${CMAKE_CURRENT_LIST_DIR}/debian/changelog.in" "${nephoscope_debian}/changelog.Debian" @ONLY)
execute_process(COMMAND gzip -9nf "${nephoscope_debian}/changelog.Debian" COMMAND_ERROR_IS_FATAL ANY)
install(FILES "${nephoscope_debian}/changelog.Debian.gz" DESTINATION "${nephoscope_debian_documents}")
file(WRITE "${nephoscope_debian}/triggers" "activate-noawait ldconfig\n")
file(WRITE "${nephoscope_debian}/prerm" "#!/bin/sh
set -e
# What Python has compiled beside the modules.
rm -rf /usr/${NEPHOSCOPE_PYTHON_DESTINATION}/nephoscope/__pycache__ /usr/${NEPHOSCOPE_PYTHON_DESTINATION}/nephoscope/*/__pycache__
")
file(CHMOD "${nephoscope_debian}/prerm" PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_PACKAGE_CONTROL_EXTRA "${nephoscope_debian}/triggers;${nephoscope_debian}/prerm")

# ParaView loads only plugins made with its own version.
string(REGEX REPLACE "^([0-9]+)[.]([0-9]+).*" "\\1.\\2" nephoscope_paraview_version "${ParaView_VERSION}")
math(EXPR nephoscope_next_minor "${ParaView_VERSION_MINOR} + 1")
set(nephoscope_qt 6) # that of Debian's ParaView
if (ParaView_VERSION VERSION_LESS 5.13)
  set(nephoscope_qt 5)
endif ()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME nephoscope-paraview)
set(CPACK_PACKAGE_CONTACT "${nephoscope_maintainer}")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "clouds, smoke and wind for VTK and ParaView")
set(CPACK_PACKAGE_DESCRIPTION "Filters, OpenGL mappers and ParaView representations for clouds, smoke and
wind: volumes of polyhedral cells with the exact ray integral, textured
splats, cloud surfaces with a moving texture, haze, terrain, flow volumes.
ParaView loads the plugin when it starts; Python has the package nephoscope.")
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE "1~${NEPHOSCOPE_FOR_DEBIAN}")
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
string(CONCAT CPACK_DEBIAN_PACKAGE_DEPENDS
  "paraview (>= ${nephoscope_paraview_version}~), paraview (<< ${ParaView_VERSION_MAJOR}.${nephoscope_next_minor}~), "
  "libqt${nephoscope_qt}sql${nephoscope_qt}-sqlite, " # with which Qt opens help pages
  "python3-paraview, python3")
set(CPACK_DEBIAN_PACKAGE_RECOMMENDS "python3-venv") # for what the messages about missing Python packages say
set(CPACK_DEBIAN_PACKAGE_SUGGESTS "paraview-dev") # VTK's headers, for find_package(Nephoscope)
set(CPACK_STRIP_FILES ON)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
include(CPack)

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# Not tested. See README.md.
superbuild_add_project(nephoscope
  DEPENDS cxx11 paraview
  DEPENDS_OPTIONAL openvdb python3 qt5 qt6
  LICENSE_FILES LICENSE
  SPDX_LICENSE_IDENTIFIER BSD-3-Clause
  SPDX_COPYRIGHT_TEXT "The Nephoscope authors"
  CMAKE_ARGS
    -DBUILD_TESTING:BOOL=OFF
    -DCMAKE_INSTALL_LIBDIR:PATH=lib
    -DNEPHOSCOPE_USE_TETGEN:STRING=OFF
    -DNEPHOSCOPE_WRAP_PYTHON:BOOL=${python3_enabled})

# ParaView loads the plugin where its own are: the packaging step looks for them by name.
list(APPEND paraview_plugins Nephoscope)

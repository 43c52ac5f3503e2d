# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# The ParaView plugin `Nephoscope`.
include(NephoscopeHelp) # sets NEPHOSCOPE_HELP
set(nephoscope_no_help ON)
if (NEPHOSCOPE_HELP)
  set(nephoscope_no_help OFF)
  set(PARAVIEW_QT_MAJOR_VERSION 5) # ParaView 5.13 makes no help pages with a later one. Nothing else here depends on Qt
endif ()
set(NEPHOSCOPE_PLUGIN_SUBDIRECTORY "nephoscope-plugins")
set(NEPHOSCOPE_PLUGIN_PATH
  "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}/${NEPHOSCOPE_PLUGIN_SUBDIRECTORY}/Nephoscope")
paraview_plugin_scan(
  PLUGIN_FILES      "${PROJECT_SOURCE_DIR}/Plugins/ParaView/paraview.plugin"
  PROVIDES_PLUGINS  nephoscope_plugins
  ENABLE_BY_DEFAULT ON
  HIDE_PLUGINS_FROM_CACHE ON)
paraview_plugin_build(
  PLUGINS              ${nephoscope_plugins}
  PLUGINS_FILE_NAME    "nephoscope.xml"
  LIBRARY_SUBDIRECTORY "${NEPHOSCOPE_PLUGIN_SUBDIRECTORY}"
  DISABLE_XML_DOCUMENTATION ${nephoscope_no_help}
  INSTALL_HEADERS      OFF)

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# Help pages in ParaView, which "?" in the properties panel opens: made of the XML of the plugin by Plugins/ParaView/Help/make_help.py, packed
# by Qt's qhelpgenerator (Debian: qhelpgenerator-qt5; its format is the same for Qt 5 and 6). paraview_add_plugin puts them into the plugin.
# ParaView's own functions for that, which are replaced here, ask for Qt's development files and for xmlpatterns, which Qt 6 has not.
# Sets NEPHOSCOPE_HELP to whether there are help pages.
find_program(NEPHOSCOPE_QHELPGENERATOR NAMES qhelpgenerator qhelpgenerator-qt5 qhelpgenerator6
  HINTS /usr/lib/qt5/bin /usr/lib/qt6/bin /usr/lib/qt6/libexec /usr/libexec/qt6)
mark_as_advanced(NEPHOSCOPE_QHELPGENERATOR)
find_program(NEPHOSCOPE_PYTHON NAMES "${Python3_EXECUTABLE}" python3)
mark_as_advanced(NEPHOSCOPE_PYTHON)
set(NEPHOSCOPE_HELP FALSE)
if (NEPHOSCOPE_QHELPGENERATOR AND NEPHOSCOPE_PYTHON)
  set(NEPHOSCOPE_HELP TRUE)
else ()
  message(STATUS "Nephoscope: without qhelpgenerator (Debian: qhelpgenerator-qt5) the plugin has no help pages.")
  return ()
endif ()

# The XML files are kept for the function below; a target of that name is expected.
function (paraview_client_documentation)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "TARGET;OUTPUT_DIR" "XMLS")
  set(xmls "")
  foreach (xml IN LISTS arg_XMLS)
    get_filename_component(xml "${xml}" ABSOLUTE)
    list(APPEND xmls "${xml}")
  endforeach ()
  add_custom_target("${arg_TARGET}")
  set_property(TARGET "${arg_TARGET}" PROPERTY nephoscope_xmls "${xmls}")
endfunction ()

function (paraview_client_generate_help)
  cmake_parse_arguments(PARSE_ARGV 0 arg "" "NAME;TARGET;OUTPUT_DIR;OUTPUT_PATH;TABLE_OF_CONTENTS;SOURCE_DIR" "PATTERNS;DEPENDS")
  get_property(xmls TARGET "${arg_NAME}_doc" PROPERTY nephoscope_xmls)
  set(script "${PROJECT_SOURCE_DIR}/Plugins/ParaView/Help/make_help.py")
  set(packed "${arg_OUTPUT_DIR}/${arg_NAME}.qch")
  add_custom_command(OUTPUT "${packed}"
    COMMAND "${NEPHOSCOPE_PYTHON}" "${script}" "${arg_OUTPUT_DIR}" "${arg_NAME}" ${xmls}
    COMMAND "${CMAKE_COMMAND}" -E env QT_QPA_PLATFORM=offscreen
      "${NEPHOSCOPE_QHELPGENERATOR}" "${arg_OUTPUT_DIR}/${arg_NAME}.qhp" -o "${packed}"
    DEPENDS "${script}" ${xmls}
    COMMENT "Help pages of ${arg_NAME}"
    VERBATIM)
  add_custom_target("${arg_TARGET}" DEPENDS "${packed}")
  set(${arg_OUTPUT_PATH} "${packed}" PARENT_SCOPE)
endfunction ()

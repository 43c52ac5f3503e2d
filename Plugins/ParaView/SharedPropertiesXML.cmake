# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# Writes FlowVolume.xml, Globe.xml and Smoothing.xml: each has two filters with most properties in common, which ParaView's XML can not say.
set(nephoscope_shared_properties_xml)
foreach (name IN ITEMS FlowVolume Globe Smoothing)
  file(READ "${CMAKE_CURRENT_SOURCE_DIR}/${name}Properties.xml.in" shared_properties)
  configure_file(${name}.xml.in "${CMAKE_CURRENT_BINARY_DIR}/${name}.xml" @ONLY)
  list(APPEND nephoscope_shared_properties_xml "${CMAKE_CURRENT_BINARY_DIR}/${name}.xml")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${name}Properties.xml.in)
endforeach ()

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# Writes FlowVolume.xml: two filters that have most properties in common, which ParaView's XML can not say.
file(READ "${CMAKE_CURRENT_SOURCE_DIR}/FlowVolumeProperties.xml.in" flow_volume_properties)
set(nephoscope_flow_volume_xml "${CMAKE_CURRENT_BINARY_DIR}/FlowVolume.xml")
configure_file(FlowVolume.xml.in "${nephoscope_flow_volume_xml}" @ONLY)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS FlowVolumeProperties.xml.in)

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# Writes Representations.xml: ParaView's XML can not say "the same for these four", so CMake says it.

# nephoscope_extend_representation(NAME variable [EXPOSE_OPACITY_FUNCTION] SHARE subproxies...)
# Appends to `variable` the XML that puts Cell Compositing into ParaView's representation NAME, sharing properties with
# the given subproxies of it.
function (nephoscope_extend_representation representation variable)
  cmake_parse_arguments(PARSE_ARGV 2 arg "EXPOSE_OPACITY_FUNCTION" "" "SHARE")
  set(share_properties "")
  foreach (subproxy IN LISTS arg_SHARE)
    string(APPEND share_properties "
        <ShareProperties subproxy=\"${subproxy}\">
          <Exception name=\"Input\"/>
          <Exception name=\"Visibility\"/>
        </ShareProperties>")
  endforeach ()
  set(expose_opacity_function "")
  if (arg_EXPOSE_OPACITY_FUNCTION)
    set(expose_opacity_function "
            <Property name=\"ScalarOpacityFunction\"/>")
  endif ()
  file(READ "${CMAKE_CURRENT_SOURCE_DIR}/CellCompositingExtension.xml.in" template)
  string(CONFIGURE "${template}" extension @ONLY)
  set(${variable} "${${variable}}${extension}" PARENT_SCOPE)
endfunction ()

set(NEPHOSCOPE_CELL_COMPOSITING_EXTENSIONS "")
# Newer releases give rectilinear grids a representation of their own. Its definition is text inside ParaView's library.
get_target_property(remoting_views ParaView::RemotingViews LOCATION)
file(STRINGS "${remoting_views}" rectilinear_grids REGEX "RectilinearGridRepresentation" LIMIT_COUNT 1)
# Images and rectilinear grids, structured grids, unstructured grids, and composite datasets of these.
set(grids UniformGrid StructuredGrid UnstructuredGrid)
if (rectilinear_grids)
  list(APPEND grids RectilinearGrid)
endif ()
foreach (representation IN LISTS grids)
  nephoscope_extend_representation(${representation}Representation NEPHOSCOPE_CELL_COMPOSITING_EXTENSIONS
    SHARE SurfaceRepresentation VolumeRepresentation)
endforeach ()
# Composites of mixed kinds. This one has no volume rendering of its own, hence no opacity function either.
nephoscope_extend_representation(GeometryRepresentation NEPHOSCOPE_CELL_COMPOSITING_EXTENSIONS
  EXPOSE_OPACITY_FUNCTION SHARE SurfaceRepresentation)

set(nephoscope_representations_xml "${CMAKE_CURRENT_BINARY_DIR}/Representations.xml")
configure_file(Representations.xml.in "${nephoscope_representations_xml}" @ONLY)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS CellCompositingExtension.xml.in)

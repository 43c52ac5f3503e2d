# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# Writes Representations.xml: ParaView's XML can not say "the same for these four", so CMake says it.

# nephoscope_configure_text(FILE variable)
# The text of a file with the variables of the caller put in.
macro (nephoscope_configure_text file variable)
  file(READ "${CMAKE_CURRENT_SOURCE_DIR}/${file}" nephoscope_template)
  string(CONFIGURE "${nephoscope_template}" ${variable} @ONLY)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${file}")
endmacro ()

# nephoscope_extend_representation(HOST NAME LABEL variable [EXPOSE_OPACITY_FUNCTION] SHARE subproxies... [OWN properties...])
# Appends to `variable` the XML that puts the representation NAME into ParaView's representation HOST, sharing properties with
# the given subproxies of it, but for the OWN ones.
function (nephoscope_extend_representation host name label variable)
  cmake_parse_arguments(PARSE_ARGV 4 arg "EXPOSE_OPACITY_FUNCTION" "" "SHARE;OWN")
  set(share_properties "")
  foreach (subproxy IN LISTS arg_SHARE)
    string(APPEND share_properties "
        <ShareProperties subproxy=\"${subproxy}\">")
    foreach (property IN ITEMS Input Visibility LISTS arg_OWN)
      string(APPEND share_properties "
          <Exception name=\"${property}\"/>")
    endforeach ()
    string(APPEND share_properties "
        </ShareProperties>")
  endforeach ()
  set(expose_opacity_function "")
  if (arg_EXPOSE_OPACITY_FUNCTION)
    set(expose_opacity_function "
            <Property name=\"ScalarOpacityFunction\"/>")
  endif ()
  set(when_chosen "
            <Hints>
              <PropertyWidgetDecorator type=\"GenericDecorator\" mode=\"visibility\" property=\"Representation\"
                value=\"${label}\"/>
            </Hints>")
  nephoscope_configure_text(${name}Panel.xml.in panel)
  nephoscope_configure_text(RepresentationExtension.xml.in extension)
  set(${variable} "${${variable}}${extension}" PARENT_SCOPE)
endfunction ()

# The properties that every representation of a medium has, with what is said of this one only.
set(name CellCompositing)
set(opacity_array_none "None: the coloured array. The opacity of smoke from Flow Volume is then proportional to its density,
          whatever it is coloured by; clouds coloured by Sunlight have the extinction for which their light was computed.")
set(unit_distance_else "; for smoke, an optical depth of 1 over a path as long as the generating polygon is wide")
nephoscope_configure_text(MediumProperties.xml.in cell_compositing_medium_properties)
set(name TexturedSplats)
set(opacity_array_none "None: the coloured array; clouds coloured by Sunlight have the extinction for which their light was computed.")
set(unit_distance_else "")
nephoscope_configure_text(MediumProperties.xml.in textured_splats_medium_properties)
set(with_vectors "<PropertyWidgetDecorator type=\"GenericDecorator\" mode=\"visibility\" property=\"TexturedSplatsVectorArray\"
            value=\"None\" inverse=\"1\"/>")
nephoscope_configure_text(TexturedSplats.xml.in textured_splats_representation)

set(nephoscope_extensions "")
# Newer releases give rectilinear grids a representation of their own. Its definition is text inside ParaView's library.
get_target_property(remoting_views ParaView::RemotingViews LOCATION)
file(STRINGS "${remoting_views}" rectilinear_grids REGEX "RectilinearGridRepresentation" LIMIT_COUNT 1)
# Images and rectilinear grids, structured grids, unstructured grids, and composite datasets of these; adaptive meshes of images.
set(grids UniformGrid StructuredGrid UnstructuredGrid AMR)
if (rectilinear_grids)
  list(APPEND grids RectilinearGrid)
endif ()
foreach (grid IN LISTS grids)
  nephoscope_extend_representation(${grid}Representation CellCompositing "Cell Compositing" nephoscope_extensions
    SHARE SurfaceRepresentation VolumeRepresentation)
  nephoscope_extend_representation(${grid}Representation TexturedSplats "Textured Splats" nephoscope_extensions
    SHARE SurfaceRepresentation VolumeRepresentation)
endforeach ()
# Particles, surfaces, explicit structured grids, and composites of mixed kinds; hyper tree grids. These have no volume rendering of their
# own, hence no opacity function either: ours have one in common.
foreach (host IN ITEMS Geometry HyperTreeGrid)
  nephoscope_extend_representation(${host}Representation CellCompositing "Cell Compositing" nephoscope_extensions
    EXPOSE_OPACITY_FUNCTION SHARE SurfaceRepresentation)
  nephoscope_extend_representation(${host}Representation TexturedSplats "Textured Splats" nephoscope_extensions
    SHARE SurfaceRepresentation CellCompositingRepresentation
    OWN OpacityScale OpacityArray AutomaticUnitDistance UnitDistance)
endforeach ()
# Surfaces, also in unstructured grids, and grids one point thick. Hyper tree grids, for the sentence that says what makes a surface of them.
nephoscope_configure_text(CloudTexture.xml.in cloud_texture_representation)
set(sheets ${grids})
list(REMOVE_ITEM sheets AMR)
foreach (host IN LISTS sheets ITEMS Geometry HyperTreeGrid)
  nephoscope_extend_representation(${host}Representation CloudTexture "Cloud Texture" nephoscope_extensions
    SHARE SurfaceRepresentation)
endforeach ()

set(nephoscope_representations_xml "${CMAKE_CURRENT_BINARY_DIR}/Representations.xml")
configure_file(Representations.xml.in "${nephoscope_representations_xml}" @ONLY)

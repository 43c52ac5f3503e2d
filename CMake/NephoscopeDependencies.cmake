# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# ParaView (with its own VTK) or a VTK alone.
set(nephoscope_vtk_components
  CommonCore CommonDataModel CommonExecutionModel CommonMath CommonMisc CommonTransforms
  FiltersCore FiltersGeneral FiltersSources ImagingCore IOImage
  InteractionStyle RenderingCore RenderingFreeType RenderingOpenGL2 RenderingVolume RenderingVolumeOpenGL2)
# glew (up to VTK 9.3) or glad (from 9.4) give the OpenGL entry points.
set(nephoscope_vtk_optional_components FiltersParallelDIY2 TestingCore TestingRendering glew glad opengl)
if (NEPHOSCOPE_WRAP_PYTHON)
  list(APPEND nephoscope_vtk_components WrappingPythonCore Python)
  # Programs, not modules: VTK 9.6 gives their targets, yet calls them missing when they are required.
  set(nephoscope_vtk_programs WrapHierarchy WrapPython WrapPythonInit)
endif ()

include(NephoscopePythonTargets) # modules that Debian renamed
set(nephoscope_own_vtk "")
if (NEPHOSCOPE_USE_PARAVIEW)
  list(APPEND nephoscope_vtk_components FiltersHyperTree)
  nephoscope_locate_package(ParaView 5.11 nephoscope_paraview)
  if (EXISTS "${nephoscope_paraview}/vtk")
    set(nephoscope_own_vtk "${nephoscope_paraview}/vtk")
  endif ()
endif ()
if (nephoscope_own_vtk)
  nephoscope_import_python_targets("${nephoscope_own_vtk}")
else ()
  nephoscope_locate_package(VTK 9.2 nephoscope_vtk)
  nephoscope_import_python_targets("${nephoscope_vtk}")
endif ()
if (NEPHOSCOPE_USE_PARAVIEW)
  nephoscope_import_python_targets("${nephoscope_paraview}")
  find_package(ParaView 5.11 REQUIRED COMPONENTS RemotingCore RemotingServerManager RemotingViews)
endif ()
# find_package(ParaView) loads only the components ParaView itself names, from its own VTK_DIR; ours
# come from the very same VTK by a second call.
find_package(VTK 9.2 REQUIRED COMPONENTS ${nephoscope_vtk_components}
  OPTIONAL_COMPONENTS ${nephoscope_vtk_optional_components} ${nephoscope_vtk_programs})
foreach (program IN LISTS nephoscope_vtk_programs)
  if (NOT TARGET "VTK::${program}")
    message(FATAL_ERROR "The VTK in ${VTK_DIR} has no VTK::${program}; set NEPHOSCOPE_WRAP_PYTHON=OFF to do without.")
  endif ()
endforeach ()
message(STATUS "Nephoscope: VTK ${VTK_VERSION} from ${VTK_DIR}")
if (NEPHOSCOPE_FOR_PYPI)
  get_target_property(nephoscope_vtk_library VTK::CommonCore LOCATION)
  if (nephoscope_vtk_library MATCHES "/libvtkCommonCore-[^/]*[.]so") # those of the wheel have no version in their names
    message(FATAL_ERROR "The VTK ${VTK_VERSION} in ${VTK_DIR} is not the SDK of the `vtk` wheel, which pip installs beside Nephoscope: a wheel built with it would "
      "not start. Name such an SDK, that of the package vtk-sdk or the one that `./nephoscope wheel` makes. For the VTK of Debian or ParaView build without pip: "
      "cmake -S . -B build")
  endif ()
endif ()
if (NEPHOSCOPE_TESTING AND BUILD_TESTING AND NOT TARGET VTK::TestingRendering)
  message(WARNING "This VTK has no VTK::TestingRendering: tests that compare images are not built.")
endif ()

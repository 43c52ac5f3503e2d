# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# The sample data, where the plugin (vtkCloudsOverGlobe) and the Python package (sample_data) look for them: at the same place below the
# build and the installed tree, and inside the package in a wheel.
foreach (file IN ITEMS gfs_2p5deg_2011101100.nc forecast_10deg_6h.nc blue_marble_2048.jpg)
  file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/share/nephoscope")
  file(CREATE_LINK "${PROJECT_SOURCE_DIR}/Data/${file}" "${PROJECT_BINARY_DIR}/share/nephoscope/${file}" COPY_ON_ERROR SYMBOLIC)
  install(FILES "${PROJECT_SOURCE_DIR}/Data/${file}" DESTINATION share/nephoscope)
  install(FILES "${PROJECT_SOURCE_DIR}/Data/${file}" DESTINATION nephoscope/data COMPONENT nephoscope_wheel EXCLUDE_FROM_ALL)
endforeach ()

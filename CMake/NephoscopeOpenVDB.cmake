# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# OpenVDB (MPL 2.0), which reads and writes sparse volumes in .vdb files. Nothing else needs it.
set(NEPHOSCOPE_USE_OPENVDB AUTO CACHE STRING "Link OpenVDB to read and write .vdb files: AUTO (where it is found), ON, OFF")
set_property(CACHE NEPHOSCOPE_USE_OPENVDB PROPERTY STRINGS AUTO ON OFF)
set(NEPHOSCOPE_HAS_OPENVDB OFF)
set(OpenVDB_FOUND OFF)
if (NEPHOSCOPE_USE_OPENVDB STREQUAL "AUTO")
  find_package(OpenVDB 8 QUIET)
elseif (NEPHOSCOPE_USE_OPENVDB)
  find_package(OpenVDB 8 REQUIRED)
endif ()
if (OpenVDB_FOUND)
  set(NEPHOSCOPE_HAS_OPENVDB ON)
  message(STATUS "Nephoscope: OpenVDB ${OpenVDB_VERSION} reads and writes .vdb files.")
else ()
  message(STATUS "Nephoscope: built without OpenVDB. .vdb files can be neither read nor written; in Debian install "
    "libopenvdb-dev, or set NEPHOSCOPE_USE_OPENVDB.")
endif ()

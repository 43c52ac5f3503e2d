# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# OpenVDB (in Debian libopenvdb-dev): the target OpenVDB::openvdb, OpenVDB_FOUND, OpenVDB_VERSION. The module that OpenVDB brings
# itself ends the configuration where one of its own dependencies is missing; here that means "not found", for an optional package.
find_path(OpenVDB_INCLUDE_DIR openvdb/openvdb.h)
find_library(OpenVDB_LIBRARY NAMES openvdb)
mark_as_advanced(OpenVDB_INCLUDE_DIR OpenVDB_LIBRARY)
set(OpenVDB_VERSION "")
set(openvdb_uses_imath OFF)
if (OpenVDB_INCLUDE_DIR)
  file(STRINGS "${OpenVDB_INCLUDE_DIR}/openvdb/version.h" version_lines
    REGEX "define OPENVDB_(LIBRARY_(MAJOR|MINOR|PATCH)_VERSION_NUMBER|USE_IMATH_HALF)")
  foreach (part IN ITEMS MAJOR MINOR PATCH)
    if ("${version_lines}" MATCHES "OPENVDB_LIBRARY_${part}_VERSION_NUMBER +([0-9]+)")
      list(APPEND OpenVDB_VERSION "${CMAKE_MATCH_1}")
    endif ()
  endforeach ()
  list(JOIN OpenVDB_VERSION "." OpenVDB_VERSION)
  if ("${version_lines}" MATCHES "OPENVDB_USE_IMATH_HALF")
    set(openvdb_uses_imath ON)
  endif ()
endif ()
# Both are in OpenVDB's headers.
set(openvdb_needs TBB::tbb)
find_package(TBB CONFIG QUIET)
if (openvdb_uses_imath)
  list(APPEND openvdb_needs Imath::Imath)
  find_package(Imath CONFIG QUIET)
endif ()
set(OpenVDB_DEPENDENCIES_FOUND TRUE)
foreach (need IN LISTS openvdb_needs)
  if (NOT TARGET "${need}")
    set(OpenVDB_DEPENDENCIES_FOUND FALSE)
  endif ()
endforeach ()
include(FindPackageHandleStandardArgs)
find_package_handle_standard_args(OpenVDB
  REQUIRED_VARS OpenVDB_LIBRARY OpenVDB_INCLUDE_DIR OpenVDB_DEPENDENCIES_FOUND
  VERSION_VAR OpenVDB_VERSION
  REASON_FAILURE_MESSAGE "OpenVDB needs its library, its headers, and TBB and Imath with theirs.")
if (OpenVDB_FOUND AND NOT TARGET OpenVDB::openvdb)
  add_library(OpenVDB::openvdb UNKNOWN IMPORTED)
  set_target_properties(OpenVDB::openvdb PROPERTIES
    IMPORTED_LOCATION "${OpenVDB_LIBRARY}"
    INTERFACE_INCLUDE_DIRECTORIES "${OpenVDB_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${openvdb_needs}")
endif ()

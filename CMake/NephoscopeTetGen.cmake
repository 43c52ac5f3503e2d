# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# TetGen, which divides the polyhedra that no single point sees the whole of. It is under the GNU AGPL 3: what is built with it
# may only be passed on under that licence, while the sources here stay under BSD-3-Clause. Nothing else needs it.
set(NEPHOSCOPE_USE_TETGEN AUTO CACHE STRING
  "Link TetGen (GNU AGPL 3) to divide polyhedra that are not star-shaped: AUTO (where it is found), ON, OFF")
set_property(CACHE NEPHOSCOPE_USE_TETGEN PROPERTY STRINGS AUTO ON OFF)
set(NEPHOSCOPE_HAS_TETGEN OFF)
if (NEPHOSCOPE_USE_TETGEN STREQUAL "AUTO")
  find_package(TetGen QUIET)
elseif (NEPHOSCOPE_USE_TETGEN)
  find_package(TetGen REQUIRED)
else ()
  set(TetGen_FOUND OFF)
endif ()
if (TetGen_FOUND)
  set(NEPHOSCOPE_HAS_TETGEN ON)
  message(STATUS "Nephoscope: TetGen ${TetGen_VERSION} is linked. Its licence is the GNU AGPL 3, which then holds for the built "
    "plugin and package as a whole when you pass them on; NEPHOSCOPE_USE_TETGEN=OFF builds without it.")
else ()
  message(STATUS "Nephoscope: built without TetGen. Polyhedra that are not star-shaped are reported, not divided; "
    "in Debian install libtet1.5-dev (GNU AGPL 3), or set NEPHOSCOPE_USE_TETGEN.")
endif ()

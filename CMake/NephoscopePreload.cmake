# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# NEPHOSCOPE_PRELOAD: the libraries, separated by colons, that programs not built here must load first (LD_PRELOAD). Ours are
# named without their folder, which may have spaces, and found by LD_LIBRARY_PATH in NEPHOSCOPE_PRELOAD_FOLDER.
# The script `nephoscope` sets both for the hosts, from the cache. The tests set NEPHOSCOPE_TEST_PRELOAD, which has one library more.
set(NEPHOSCOPE_PRELOAD_FOLDER "${CMAKE_LIBRARY_OUTPUT_DIRECTORY}/preload" CACHE INTERNAL "Where our libraries to preload are")
set(nephoscope_preload)
# The runtime of the sanitizer, because Python was built without it. It must be the first; and libstdc++, whose exceptions it would not know
# in a program that starts without it.
if (NEPHOSCOPE_SANITIZE MATCHES "address|thread" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  string(SUBSTRING "${CMAKE_MATCH_0}" 0 1 letter)
  execute_process(COMMAND "${CMAKE_CXX_COMPILER}" "-print-file-name=lib${letter}san.so"
    OUTPUT_VARIABLE runtime OUTPUT_STRIP_TRAILING_WHITESPACE)
  list(APPEND nephoscope_preload "${runtime}" libstdc++.so.6)
endif ()
# VTK before 9.3.1 misreads its XML files with a recent libexpat; preload/whole_tokens.c tells why.
if (CMAKE_SYSTEM_NAME STREQUAL "Linux" AND VTK_VERSION VERSION_LESS 9.3.1)
  add_library(expat_whole_tokens MODULE "${CMAKE_CURRENT_LIST_DIR}/preload/whole_tokens.c")
  target_link_libraries(expat_whole_tokens PRIVATE ${CMAKE_DL_LIBS})
  set_target_properties(expat_whole_tokens PROPERTIES
    LIBRARY_OUTPUT_DIRECTORY "${NEPHOSCOPE_PRELOAD_FOLDER}"
    C_VISIBILITY_PRESET default COMPILE_OPTIONS "-fno-sanitize=all" LINK_OPTIONS "-fno-sanitize=all")
  list(APPEND nephoscope_preload libexpat_whole_tokens.so)
endif ()
list(JOIN nephoscope_preload ":" NEPHOSCOPE_TEST_PRELOAD)
set(NEPHOSCOPE_PRELOAD "${NEPHOSCOPE_TEST_PRELOAD}" CACHE INTERNAL "Libraries to preload into the hosts")
# The tests of the plugin take up to a third less time with this one; preload/weak_pointers.cxx tells why. Users' hosts do not have it.
if (BUILD_TESTING AND CMAKE_SYSTEM_NAME STREQUAL "Linux" AND VTK_VERSION VERSION_LESS 9.3 AND NOT NEPHOSCOPE_SANITIZE)
  add_library(weak_pointers MODULE "${CMAKE_CURRENT_LIST_DIR}/preload/weak_pointers.cxx")
  target_include_directories(weak_pointers PRIVATE $<TARGET_PROPERTY:VTK::CommonCore,INTERFACE_INCLUDE_DIRECTORIES>)
  nephoscope_target_options(weak_pointers)
  set_target_properties(weak_pointers PROPERTIES LIBRARY_OUTPUT_DIRECTORY "${NEPHOSCOPE_PRELOAD_FOLDER}")
  string(APPEND NEPHOSCOPE_TEST_PRELOAD ":libweak_pointers.so")
endif ()

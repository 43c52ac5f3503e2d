# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# Language level, warnings, sanitizers and where the build puts things.
set(CMAKE_CXX_STANDARD 17)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_UNITY_BUILD_BATCH_SIZE 16) # of a build with CMAKE_UNITY_BUILD: names in unnamed namespaces must differ within a module

get_property(multi_config GLOBAL PROPERTY GENERATOR_IS_MULTI_CONFIG)
if (nephoscope_is_top_level AND NOT CMAKE_BUILD_TYPE AND NOT multi_config)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release, RelWithDebInfo or MinSizeRel" FORCE)
endif ()

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_BINDIR}")
set(CMAKE_LIBRARY_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")
set(CMAKE_ARCHIVE_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/${CMAKE_INSTALL_LIBDIR}")

option(NEPHOSCOPE_WARNINGS_AS_ERRORS "Treat compiler warnings as errors" OFF)
set(NEPHOSCOPE_SANITIZE "" CACHE STRING
  "Sanitizers, as -fsanitize= takes them: address, undefined, thread")

# Applied to this project's own sources by nephoscope_target_options(), not to generated wrappers.
function (nephoscope_target_options target)
  if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${target} PRIVATE
      $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wshadow>
      $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<BOOL:${NEPHOSCOPE_WARNINGS_AS_ERRORS}>>:-Werror>)
  endif ()
endfunction ()

if (NEPHOSCOPE_SANITIZE)
  add_compile_options(-fsanitize=${NEPHOSCOPE_SANITIZE} -fno-sanitize-recover=all -fno-omit-frame-pointer -g1) # lines are all that a finding names
  add_link_options(-fsanitize=${NEPHOSCOPE_SANITIZE})
endif ()

# VTK's messages name the source file: in what is distributed without the folder of this machine.
if (NEPHOSCOPE_FOR_PYPI OR NEPHOSCOPE_FOR_DEBIAN)
  add_compile_options("-fmacro-prefix-map=${PROJECT_SOURCE_DIR}/=")
endif ()

# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# Six ways to declare a test. Every test gets one or more labels: math, filter, image, plugin, parallel.
# Tests that draw need a display: `./nephoscope test` gives them a virtual one.
#
#   nephoscope_add_math_test(NAME SOURCE.cxx)            GoogleTest on headers alone
#   nephoscope_add_cxx_test(NAME SOURCES... MODULES... PARTS... LABELS...)   GoogleTest with VTK modules and test libraries
#   nephoscope_add_test_library(NAME SOURCES... MODULES...)         sources that no library exports, compiled once, for the PARTS of several tests
#   nephoscope_add_shader_test(NAME FOLDER SOURCES... MODULES...)   GoogleTest with Testing/Cxx/ShaderRunner.h; FOLDER has the shaders
#   nephoscope_add_python_test(SCRIPT.py LABELS... [ARGS...])       plain Python, package on its path; exit 0 passes
#   nephoscope_add_softpipe_test(SCRIPT.py [CASES...])              those cases once more, on Mesa's software OpenGL 3.3 (slow: small pictures)
#   nephoscope_add_egl_test(SCRIPT.py [CASES...])        those cases once more, without a display, where VTK has such windows: its wheel
#
# Tests with the property COST start first, the dearest before others: what takes long, or needs both processors or a lock, would keep a
# processor idle at the end.
#
# A build for VTK's wheel has the same Python tests, run by an environment in which the wheel is installed
# (NEPHOSCOPE_PYVISTA_PYTHON; the tests run that, and not Python3_EXECUTABLE). It has no tests in C++.
if (NEPHOSCOPE_FOR_PYPI)
  set(Python3_EXECUTABLE "${NEPHOSCOPE_PYVISTA_PYTHON}")
else ()
  find_package(GTest REQUIRED)
  include(GoogleTest)
  set(nephoscope_package_path "${NEPHOSCOPE_PYTHONPATH}:")
endif ()

set(NEPHOSCOPE_TEST_OUTPUT "${PROJECT_BINARY_DIR}/Testing/Output")
file(MAKE_DIRECTORY "${NEPHOSCOPE_TEST_OUTPUT}")
# Each saves a test a sixth of its time or more: Mesa keeps compiled shaders even where there is no home; its software OpenGL compiles
# them without optimization, which would take longer than drawing small pictures, and draws in one thread, as several tests run at once; memory that is
# used again and again is not given back.
set(nephoscope_savings "MESA_SHADER_CACHE_DIR=${PROJECT_BINARY_DIR}/Testing/ShaderCache" "GALLIVM_PERF=nopt" "LP_NUM_THREADS=0"
  "MALLOC_MMAP_THRESHOLD_=1000000000" "MALLOC_TRIM_THRESHOLD_=2000000000")
set(NEPHOSCOPE_TEST_ENVIRONMENT
  "PYTHONPATH=${nephoscope_package_path}${PROJECT_SOURCE_DIR}/Testing/Python"
  "NEPHOSCOPE_DATA=${PROJECT_SOURCE_DIR}/Data"
  "NEPHOSCOPE_TEST_LIBRARIES=${CMAKE_LIBRARY_OUTPUT_DIRECTORY}"
  "NEPHOSCOPE_TEST_OUTPUT=${NEPHOSCOPE_TEST_OUTPUT}"
  "PV_PLUGIN_PATH=${NEPHOSCOPE_PLUGIN_PATH}"
  ${nephoscope_savings}
  "ASAN_OPTIONS=detect_leaks=0" # neither Python nor the OpenGL driver frees everything; other C++ tests look for leaks
  "LSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/Testing/Sanitizers/leaks.supp"
  "TSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/Testing/Sanitizers/threads.supp")
if (NEPHOSCOPE_TEST_PRELOAD)
  list(APPEND NEPHOSCOPE_TEST_ENVIRONMENT "LD_PRELOAD=${NEPHOSCOPE_TEST_PRELOAD}" "LD_LIBRARY_PATH=${NEPHOSCOPE_PRELOAD_FOLDER}")
endif ()

# The tests in C++ run for a minute in all, and compile for longer than that without this.
function (nephoscope_test_options target)
  nephoscope_target_options(${target})
  if (CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${target} PRIVATE $<$<AND:$<COMPILE_LANGUAGE:CXX>,$<CONFIG:Release>>:-O1>)
  endif ()
endfunction ()

# GoogleTest's headers take half of the time in which most tests in C++ compile: they are read once for all. With ccache, which handles
# such headers badly, it is as quick without.
set(nephoscope_precompile_gtest OFF)
if (NOT NEPHOSCOPE_FOR_PYPI AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(nephoscope_precompile_gtest ON)
  file(GENERATE OUTPUT "${PROJECT_BINARY_DIR}/Testing/GoogleTestHeaders.cxx" CONTENT "// no code: the target holds headers\n")
  add_library(GoogleTestHeaders OBJECT "${PROJECT_BINARY_DIR}/Testing/GoogleTestHeaders.cxx")
  set_source_files_properties("${PROJECT_BINARY_DIR}/Testing/GoogleTestHeaders.cxx" PROPERTIES GENERATED ON)
  target_link_libraries(GoogleTestHeaders PRIVATE GTest::gtest)
  target_precompile_headers(GoogleTestHeaders PRIVATE <gtest/gtest.h>)
  nephoscope_test_options(GoogleTestHeaders)
endif ()

function (nephoscope_add_math_test name source)
  nephoscope_add_cxx_test(${name} SOURCES ${source} LABELS math)
endfunction ()

function (nephoscope_test_folders target)
  file(GLOB folders CONFIGURE_DEPENDS # those of the technique, and those that all share
    "${CMAKE_CURRENT_SOURCE_DIR}/../[A-Z]*/*.h" "${PROJECT_SOURCE_DIR}/Filters/Common/[A-Z]*/*.h")
  list(TRANSFORM folders REPLACE "/[^/]*$" "")
  list(REMOVE_DUPLICATES folders)
  target_include_directories(${target} PRIVATE "${CMAKE_CURRENT_SOURCE_DIR}/.." ${folders} "${PROJECT_SOURCE_DIR}/Testing/Cxx")
endfunction ()

function (nephoscope_add_test_library name)
  if (NEPHOSCOPE_FOR_PYPI)
    return ()
  endif ()
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;MODULES")
  add_library(${name} STATIC ${arg_SOURCES})
  nephoscope_test_folders(${name})
  target_link_libraries(${name} PUBLIC ${arg_MODULES})
  nephoscope_test_options(${name})
endfunction ()

function (nephoscope_add_cxx_test name)
  if (NEPHOSCOPE_FOR_PYPI)
    return ()
  endif ()
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "SOURCES;MODULES;PARTS;LABELS")
  add_executable(${name} ${arg_SOURCES})
  nephoscope_test_folders(${name})
  target_link_libraries(${name} PRIVATE GTest::gtest GTest::gtest_main ${arg_PARTS} ${arg_MODULES})
  if (arg_MODULES)
    vtk_module_autoinit(TARGETS ${name} MODULES ${arg_MODULES})
  endif ()
  nephoscope_test_options(${name})
  if (nephoscope_precompile_gtest)
    target_precompile_headers(${name} REUSE_FROM GoogleTestHeaders)
  endif ()
  add_test(NAME ${name} COMMAND ${name})
  set(leaks "ASAN_OPTIONS=detect_leaks=1")
  if ("image" IN_LIST arg_LABELS)
    set(leaks "ASAN_OPTIONS=detect_leaks=0")
  endif ()
  set_tests_properties(${name} PROPERTIES
    LABELS "${arg_LABELS}" TIMEOUT 300 ENVIRONMENT "${NEPHOSCOPE_TEST_ENVIRONMENT};${leaks}")
endfunction ()

function (nephoscope_add_shader_test name folder)
  if (NEPHOSCOPE_FOR_PYPI)
    return ()
  endif ()
  cmake_parse_arguments(PARSE_ARGV 2 arg "" "" "SOURCES;MODULES")
  set(modules ${arg_MODULES} VTK::RenderingOpenGL2)
  foreach (module IN ITEMS glad glew opengl) # the OpenGL functions, as this VTK has them
    if (TARGET VTK::${module})
      list(APPEND modules VTK::${module})
    endif ()
  endforeach ()
  nephoscope_add_cxx_test(${name} SOURCES ${arg_SOURCES} MODULES ${modules} LABELS image)
  target_include_directories(${name} PRIVATE "${PROJECT_SOURCE_DIR}/Representations/Common/OpenGL")
  target_compile_definitions(${name} PRIVATE NEPHOSCOPE_SHADER_FOLDER="${folder}")
  set_tests_properties(${name} PROPERTIES SKIP_RETURN_CODE 125)
endfunction ()

function (nephoscope_add_python_test script)
  cmake_parse_arguments(PARSE_ARGV 1 arg "" "" "LABELS;ARGS")
  get_filename_component(name "${script}" NAME_WE)
  add_test(NAME ${name} COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/${script}" ${arg_ARGS})
  set_tests_properties(${name} PROPERTIES
    LABELS "${arg_LABELS}" TIMEOUT 300 ENVIRONMENT "${NEPHOSCOPE_TEST_ENVIRONMENT}")
endfunction ()

function (nephoscope_add_softpipe_test script)
  get_filename_component(name "${script}" NAME_WE)
  add_test(NAME ${name}OnSoftpipe COMMAND "${Python3_EXECUTABLE}" "${script}" ${ARGN})
  set_tests_properties(${name}OnSoftpipe PROPERTIES LABELS "image" TIMEOUT 300
    ENVIRONMENT "${NEPHOSCOPE_TEST_ENVIRONMENT};LIBGL_ALWAYS_SOFTWARE=1;GALLIUM_DRIVER=softpipe")
endfunction ()

function (nephoscope_add_egl_test script)
  if (NOT NEPHOSCOPE_FOR_PYPI)
    return ()
  endif ()
  get_filename_component(name "${script}" NAME_WE)
  add_test(NAME ${name}OnEGL COMMAND "${Python3_EXECUTABLE}" "${CMAKE_CURRENT_SOURCE_DIR}/${script}" ${ARGN})
  set_tests_properties(${name}OnEGL PROPERTIES LABELS "image" TIMEOUT 300
    ENVIRONMENT "${NEPHOSCOPE_TEST_ENVIRONMENT};VTK_DEFAULT_OPENGL_WINDOW=vtkEGLRenderWindow;DISPLAY=")
endfunction ()

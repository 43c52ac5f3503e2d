# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# cmake -DBUILD=... -DFOLDER=... -DCOMPILER=... -DGENERATOR=... -DVTK_DIR=... -P TestPackage.cmake
# Installs BUILD below FOLDER, moves that, configures `components` with it, tries a project without the language C, and builds and runs the example: its picture must show something.
# Before, it configures `within`, which adds the sources to another project.
function (run)
  execute_process(COMMAND ${ARGN} WORKING_DIRECTORY "${FOLDER}" RESULT_VARIABLE status OUTPUT_VARIABLE said ERROR_VARIABLE said)
  if (status)
    message(FATAL_ERROR "exit status ${status} of ${ARGN}\n${said}")
  endif ()
endfunction ()

file(READ "${CMAKE_CURRENT_LIST_DIR}/../../Documentation/cpp.md" page)
foreach (name IN ITEMS CMakeLists.txt clouds.cxx)
  file(READ "${CMAKE_CURRENT_LIST_DIR}/example/${name}" text)
  string(FIND "${page}" "${text}" place)
  if (place EQUAL -1)
    message(FATAL_ERROR "Documentation/cpp.md shows another ${name} than Testing/Package/example has")
  endif ()
endforeach ()

file(REMOVE_RECURSE "${FOLDER}")
file(MAKE_DIRECTORY "${FOLDER}")
run("${CMAKE_COMMAND}" --install "${BUILD}" --prefix "${FOLDER}/first place" --strip)
file(RENAME "${FOLDER}/first place" "${FOLDER}/prefix")
function (configure project)
  run("${CMAKE_COMMAND}" -G "${GENERATOR}" -S "${CMAKE_CURRENT_LIST_DIR}/${project}" -B "${project}" "-DCMAKE_CXX_COMPILER=${COMPILER}" ${ARGN})
endfunction ()
configure(within "-DVTK_DIR=${VTK_DIR}")
configure(components "-DCMAKE_PREFIX_PATH=${FOLDER}/prefix")
file(WRITE "${FOLDER}/without-c/CMakeLists.txt" "cmake_minimum_required(VERSION 3.16)\nproject(WithoutC LANGUAGES CXX)\nfind_package(Nephoscope REQUIRED)\n")
execute_process(COMMAND "${CMAKE_COMMAND}" -G "${GENERATOR}" -S without-c -B without-c/build "-DCMAKE_PREFIX_PATH=${FOLDER}/prefix" "-DCMAKE_CXX_COMPILER=${COMPILER}"
  WORKING_DIRECTORY "${FOLDER}" OUTPUT_QUIET ERROR_VARIABLE said)
if (NOT said MATCHES "project\\(WithoutC LANGUAGES C CXX\\)")
  message(FATAL_ERROR "a project without C is not told what to do:\n${said}")
endif ()
configure(example "-DCMAKE_PREFIX_PATH=${FOLDER}/prefix" -DCMAKE_BUILD_TYPE=Release)
run("${CMAKE_COMMAND}" --build example)
run(example/clouds)
file(SIZE "${FOLDER}/clouds.png" size)
if (size LESS 5000) # a plain background has some 600 bytes
  message(FATAL_ERROR "${FOLDER}/clouds.png is blank")
endif ()

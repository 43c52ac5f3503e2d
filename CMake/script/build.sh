# shellcheck shell=bash
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# Configures and builds one preset of CMakePresets.json.

cache_value() { sed -n "s/^$1:[^=]*=//p" "$BUILD/CMakeCache.txt"; }

# Whether a package of this verb was perhaps not there when the build folder was configured, and so not found.
made_without_packages()
{
  [ ! -f "$BUILD/packages" ] || printf '%s\n' "${PACKAGES[@]}" | grep -qvxFf "$BUILD/packages"
}

# Whether the build folder must be configured (again); later changes of CMake files are seen by the build itself.
configure_needed()
{
  [ -f "$BUILD/build.ninja" ] || return 0
  ! made_without_packages || return 0
  [ ! "$TOP/CMakePresets.json" -nt "$BUILD/build.ninja" ] || return 0 # the cache keeps its time where nothing in it changes
  [ "$1" = ON ] && [ "$(cache_value BUILD_TESTING)" != ON ]
}

# Several sources compiled at a time need a third of the processor time; but of them, one that changes makes ccache forget all.
compiler_options()
{
  if command -v ccache >/dev/null; then
    printf '%s\n' -DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DCMAKE_UNITY_BUILD=OFF
  elif [ "$PRESET" = default ]; then # the others look for warnings and errors, source by source
    printf '%s\n' -DCMAKE_UNITY_BUILD=ON
  fi
}

# configure [with-tests]. Without the word tests stay as they are: off in a new build folder.
configure()
{
  BUILD="$TOP/build"
  [ "$PRESET" = default ] || BUILD="$TOP/build/$PRESET"
  step "Configure (preset $PRESET)"
  if [ -f "$BUILD/CMakeCache.txt" ] && [ ! "$(cache_value CMAKE_HOME_DIRECTORY)" -ef "$TOP" ]; then
    rm -rf "$BUILD/CMakeCache.txt" "$BUILD/CMakeFiles" "$BUILD/build.ninja" # the project was moved or copied
  fi
  local testing=OFF options=()
  [ $# -eq 0 ] || testing=ON
  if ! configure_needed $testing; then
    say_unless_quiet "      is configured"
    return
  fi
  if [ $testing = ON ] || [ ! -f "$BUILD/CMakeCache.txt" ]; then
    options+=("-DBUILD_TESTING=$testing")
  fi
  local compiler
  mapfile -t compiler < <(compiler_options)
  # CMake reads the presets of the current folder.
  (cd "$TOP" && run_logged "configure-$PRESET" cmake --preset "$PRESET" -B "$BUILD" "${options[@]}" "${compiler[@]}") ||
    fail 1 "could not configure the preset $PRESET"
  printf '%s\n' "${PACKAGES[@]}" >"$BUILD/packages"
}

# build_targets [TARGET...]: all without any.
# shellcheck disable=SC2120 # the gallery passes some
build_targets()
{
  # One at a time: two hosts started together must not both build.
  exec 9>"$BUILD/.lock"
  flock 9
  run_logged "build-$PRESET" cmake --build "$BUILD" -j "$(nproc)" ${1:+--target "$@"} ||
    fail 1 "could not build the preset $PRESET"
  exec 9>&-
}

build()
{
  step "Build"
  # shellcheck disable=SC2119
  build_targets
}

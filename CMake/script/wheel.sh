# shellcheck shell=bash
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# The wheel for `pip install`: built for VTK's wheel of the Python package index, with an SDK made from Debian's packages
# (CMake/wheel), and tested in a fresh environment.
# shellcheck disable=SC2034 # read by the verb
WHEEL_PACKAGES=(g++ cmake ninja-build python3-venv)
# shellcheck disable=SC2034
WHEEL_TEST_PACKAGES=(xvfb xauth libgl1 libegl1 libxrender1)
WHEEL_WORK="$TOP/build/wheel"
WHEEL_TREE="$WHEEL_WORK/tree" # one for all versions of Python: what is not wrapping is compiled once
WHEEL_OPTIONS=()
if command -v ccache >/dev/null; then
  WHEEL_OPTIONS=(-DCMAKE_C_COMPILER_LAUNCHER=ccache -DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi

# parse_wheel_arguments ARGUMENT...: sets WHEEL_PYTHONS, WHEEL_TEST and WHEEL_SOURCE; leaves the arguments of ctest in ARGUMENTS.
# shellcheck disable=SC2034
parse_wheel_arguments()
{
  WHEEL_PYTHONS=() WHEEL_TEST=no WHEEL_SOURCE=no
  while [ $# -gt 0 ]; do
    case $1 in
      --python)
        [[ "${2:-}" =~ ^3\.1[1-4]$ ]] || usage_error "wheel --python wants 3.11, 3.12, 3.13 or 3.14"
        WHEEL_PYTHONS+=("$2")
        shift 2 ;;
      --sdist) WHEEL_SOURCE=yes; shift ;;
      --test) WHEEL_TEST=yes; shift; break ;;
      *) usage_error "wheel takes --python, --sdist and --test, not $1" ;;
    esac
  done
  ARGUMENTS=("$@")
  [ ${#WHEEL_PYTHONS[@]} -gt 0 ] || [ "$WHEEL_SOURCE" = yes ] || WHEEL_PYTHONS=("$(wheel_own_python)")
}

# Whether the wheel that makes the type stubs of all must be made first: there are none, or some source is newer.
needs_wheel_of_stubs()
{
  local stubs="$WHEEL_WORK/stubs/__init__.pyi"
  [ ${#WHEEL_PYTHONS[@]} -gt 0 ] && [ "${WHEEL_PYTHONS[0]}" != "$(wheel_own_python)" ] &&
    { [ ! -s "$stubs" ] ||
      [ -n "$(find "$TOP/Filters" "$TOP/Representations" "$TOP/Plugins/PyVista" \( -name '*.h' -o -name '*.py' \) -newer "$stubs" -print -quit 2>/dev/null)" ]; }
}

# The version of the system's Python, whose wheel also makes the stubs of all the others.
wheel_own_python() { "$SYSTEM_PYTHON" -c 'import sys; print("%d.%d" % sys.version_info[:2])'; }

# wheel_tools: an environment that has pip, to fetch VTK's wheel.
wheel_tools()
{
  WHEEL_TOOLS="$WHEEL_WORK/tools/bin/python"
  [ -x "$WHEEL_TOOLS" ] || "$SYSTEM_PYTHON" -m venv "$WHEEL_WORK/tools"
}

# What all versions of Python share.
make_wheel_openvdb()
{
  wheel_tools
  step "OpenVDB for the wheel"
  run_logged wheel-openvdb "$WHEEL_TOOLS" "$TOP/CMake/wheel/make_openvdb.py" --work "$WHEEL_WORK" -- "${WHEEL_OPTIONS[@]}" ||
    fail 1 "could not build OpenVDB"
}

# make_wheel VERSION: sets WHEEL to the file.
make_wheel()
{
  local python=$1 tag=cp${1/./} openvdb="$WHEEL_WORK/openvdb/prefix" compiler
  mapfile -t compiler < <(compiler_options)
  step "SDK of VTK's wheel for Python $python"
  run_logged "wheel-sdk-$tag" "$WHEEL_TOOLS" "$TOP/CMake/wheel/make_sdk.py" --python "$python" --work "$WHEEL_WORK" ||
    fail 1 "could not make the SDK"
  step "Configure and build for Python $python"
  run_logged "wheel-configure-$tag" cmake -S "$TOP" -B "$WHEEL_TREE" -C "$TOP/CMake/wheel/options.cmake" \
    -G Ninja -DVTK_DIR="$(tail -n 1 "$LOGS/wheel-sdk-$tag.log")" -DNEPHOSCOPE_WHEEL_TAG="$tag-$tag-manylinux_2_34_x86_64" \
    -DPython3_EXECUTABLE="$WHEEL_TOOLS" -DNEPHOSCOPE_PYVISTA_PYTHON="$WHEEL_WORK/venv-$tag/bin/python" \
    -DOpenVDB_INCLUDE_DIR="$openvdb/include" -DOpenVDB_LIBRARY="$openvdb/lib/libopenvdb.a" -DTBB_DIR="$openvdb/lib/cmake/TBB" \
    "${compiler[@]}" ||
    fail 1 "could not configure the build for Python $python"
  run_logged "wheel-build-$tag" cmake --build "$WHEEL_TREE" -j "$(nproc)" || fail 1 "could not build for Python $python"
  step "Wheel for Python $python"
  run_logged "wheel-pack-$tag" "$WHEEL_TOOLS" "$TOP/CMake/wheel/pack.py" --python "$python" --work "$WHEEL_WORK" --build "$WHEEL_TREE" \
    --output "$TOP/dist" ||
    fail 1 "could not pack the wheel"
  WHEEL=$(tail -n 1 "$LOGS/wheel-pack-$tag.log")
  say "      ${WHEEL#"$TOP"/}"
}

pack_sdist() { tree_files | "$SYSTEM_PYTHON" "$TOP/CMake/wheel/make_sdist.py" --output "$TOP/dist"; }

# The source distribution, which pip builds where VTK's SDK can be had.
make_sdist()
{
  step "Source distribution"
  run_logged wheel-sdist pack_sdist || fail 1 "could not pack the source distribution"
  SDIST=$(tail -n 1 "$LOGS/wheel-sdist.log")
  say "      ${SDIST#"$TOP"/}"
}

# Prints the interpreter of a version; fails where there is none that runs (pyenv has shims that do not).
wheel_interpreter()
{
  local interpreter
  while read -r interpreter; do
    "$interpreter" -c '' 2>/dev/null && printf '%s' "$interpreter" && return
  done < <([ "$1" != "$(wheel_own_python)" ] || printf '%s\n' "$SYSTEM_PYTHON"; type -ap "python$1")
  return 1
}

# Before anything is compiled for a test that cannot run.
require_wheel_interpreters()
{
  local python
  for python in "${WHEEL_PYTHONS[@]}"; do
    wheel_interpreter "$python" >/dev/null || fail 1 "there is no python$python on the path that runs, to test the wheel with"
  done
}

make_wheel_venv()
{
  rm -rf "$3"
  "$1" -m venv "$3" &&
    "$3/bin/python" -m pip install --no-input "$2" -r "$TOP/CMake/wheel/test-requirements.txt"
}

# test_wheel VERSION [CTEST-ARGUMENT...]: installs the wheel in a fresh environment and runs the Python tests there.
test_wheel()
{
  local python=$1 tag=cp${1/./} venv="$WHEEL_WORK/venv-cp${1/./}" interpreter status=0
  shift
  step "A fresh environment with Python $python"
  interpreter=$(wheel_interpreter "$python")
  run_logged "wheel-venv-$tag" make_wheel_venv "$interpreter" "$WHEEL" "$venv" || fail 1 "could not install the wheel"
  step "Tests of the wheel for Python $python"
  on_virtual_display env -u PYTHONPATH WHEEL="$WHEEL" PATH="$venv/bin:$PATH" ctest --test-dir "$WHEEL_TREE" \
    --output-on-failure --no-tests=error -j 3 "$@" || status=$?
  [ $status -eq 0 ] || fail $status "tests of the wheel failed (exit status $status)"
}

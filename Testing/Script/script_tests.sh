#!/usr/bin/env bash
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# Tests of the script `nephoscope`: script_tests.sh CASE. A case passes with exit status 0 and is skipped with 125.
# Programs that would change the machine are replaced by fakes that come first on PATH.
set -euo pipefail
TOP=$(cd "$(dirname "$0")/../.." && pwd)
WORK=$(mktemp -d) STATUS=0 OUT="" ERR=""
trap 'rm -rf "$WORK"' EXIT
mkdir "$WORK/fakes"

# run COMMAND...: keeps exit status, standard output and standard error in STATUS, OUT and ERR.
run()
{
  STATUS=0
  "$@" >"$WORK/out" 2>"$WORK/err" </dev/null || STATUS=$?
  OUT=$(cat "$WORK/out")
  ERR=$(cat "$WORK/err")
}

nephoscope() { run env PATH="$WORK/fakes:$PATH" "$TOP/nephoscope" "$@"; }

# expect WHAT CONDITION...: fails the test, and shows the last run, when the condition is false.
expect()
{
  local what=$1
  shift
  "$@" && return
  printf 'expected: %s\n--- exit status %s\n--- output:\n%s\n--- error:\n%s\n' "$what" "$STATUS" "$OUT" "$ERR" >&2
  exit 1
}
contains() { [[ "$1" == *"$2"* ]]; }
lacks() { [[ "$1" != *"$2"* ]]; }

# fake NAME: a program of that name, its body from standard input; $CALLS is a file where it can note its calls.
CALLS="$WORK/calls"
: >"$CALLS"
export CALLS
fake()
{
  { printf '#!/bin/bash\n'; cat; } >"$WORK/fakes/$1"
  chmod +x "$WORK/fakes/$1"
}

# A dpkg-query by which every package but $1 is installed.
fake_packages_without()
{
  export ABSENT=$1
  fake dpkg-query <<'E'
for package in "${@:3}"; do
  [ "$package" = "$ABSENT" ] || printf '%s installed\n' "$package"
done
E
}

test_usage()
{
  nephoscope
  expect "status 2 without a verb" [ $STATUS -eq 2 ]
  nephoscope frobnicate
  expect "status 2 for an unknown verb" [ $STATUS -eq 2 ]
  expect "the verb is named" contains "$ERR" "unknown verb: frobnicate"
  expect "the usage on standard error" contains "$ERR" "usage: ./nephoscope"
  expect "nothing on standard output" [ -z "$OUT" ]
  nephoscope help
  expect "status 0 for help" [ $STATUS -eq 0 ]
  local verb
  for verb in demo film test build python pvpython pvbatch pvserver paraview bench baselines wheel package docs release; do
    expect "help on $verb" contains "$OUT" $'\n'"  $verb "
  done
  nephoscope film --days 0
  expect "status 2 for a film of no days" [ $STATUS -eq 2 ]
  expect "the wish is named" contains "$ERR" "film --days wants a whole number of days, at least 1"
  nephoscope wheel --python 2.7
  expect "status 2 for a Python that there is no wheel for" [ $STATUS -eq 2 ]
  expect "the versions are named" contains "$ERR" "wheel --python wants 3.11, 3.12, 3.13 or 3.14"
  # shellcheck disable=SC2317 # called by expect
  stubs_first()
  {
    # shellcheck disable=SC2016 # expanded by the inner shell
    env "TOP=$WORK" SYSTEM_PYTHON=/usr/bin/python3 bash -c '. "$0"; parse_wheel_arguments "$@"; needs_wheel_of_stubs' "$TOP/CMake/script/wheel.sh" "$@"
  }
  expect "the wheel of the type stubs made before another" stubs_first --python 3.14
  expect "no wheel before the first" eval "! stubs_first --python $(/usr/bin/python3 -c 'import sys; print("3.%d" % sys.version_info[1])')"
  mkdir -p "$WORK/build/wheel/stubs"
  echo >"$WORK/build/wheel/stubs/__init__.pyi"
  expect "no wheel before others once there are stubs" eval '! stubs_first --python 3.14'
  mkdir -p "$WORK/Filters"
  touch -d "+1 minute" "$WORK/Filters/newer.h"
  expect "the wheel of the type stubs made again after a change" stubs_first --python 3.14
  rm -r "$WORK/Filters"
  mkdir "$WORK/shims"
  printf '#!/bin/sh\nexit 127\n' >"$WORK/shims/python3.14"
  chmod +x "$WORK/shims/python3.14"
  run env PATH="$WORK/shims:/usr/bin:/bin" "$TOP/nephoscope" --no-install wheel --python 3.14 --test
  expect "an interpreter that does not run refused before anything is made" contains "$ERR" "there is no python3.14 on the path that runs"
  nephoscope wheel 3.13
  expect "the options are named" contains "$ERR" "wheel takes --python, --sdist and --test, not 3.13"
  nephoscope release --draft rpms
  expect "the parts are named" contains "$ERR" "release makes sdist wheels debs docs, not rpms"
  nephoscope docs --links
  expect "the option is named" contains "$ERR" "docs takes --check-links, not --links"
  nephoscope test --preset
  expect "status 2 for an option without its value" [ $STATUS -eq 2 ]
}

# Without arguments the tests of Testing/long_tests.txt are left out, and each of them is a test of this build.
test_long_tests()
{
  # shellcheck source=/dev/null
  source "$TOP/CMake/script/tests.sh"
  local known
  known=$(ctest --test-dir "$NEPHOSCOPE_BUILD" --show-only | sed -n 's/^ *Test *#[0-9]*: //p')
  expect "long tests that the build has" [ -z "$(long_tests | grep -vxF -e "$known")" ]
  choose_tests
  expect "a test left out" eval "echo Script_tidy | grep -qE '${CHOSEN[1]}'"
  expect "no other test left out" eval "! echo TestTidy Script_tidyness | tr ' ' '\n' | grep -qE '${CHOSEN[1]}'"
  choose_tests --all
  expect "all tests" [ ${#CHOSEN[@]} -eq 0 ]
  choose_tests -R Script_tidy
  expect "the tests that are asked for" [ "${CHOSEN[*]}" = "-R Script_tidy" ]
}

# A failure among the output of hundreds of tests is repeated at the end.
test_failures()
{
  # shellcheck source=/dev/null
  source "$TOP/CMake/script/tests.sh"
  cat >"$WORK/CTestTestfile.cmake" <<'E'
add_test(passes echo fine)
add_test(fails sh -c "seq 1 40; exit 3")
add_test(says_nothing false)
add_test(lacks_a_word echo hello)
set_tests_properties(lacks_a_word PROPERTIES PASS_REGULAR_EXPRESSION goodbye)
add_test(takes_too_long sh -c "echo begun; sleep 20")
set_tests_properties(takes_too_long PROPERTIES TIMEOUT 1)
E
  BUILD=$WORK run report_failures
  expect "nothing without tests" [ -z "$ERR" ]
  run ctest --test-dir "$WORK" -j 5
  BUILD=$WORK run report_failures
  expect "the last lines of one that fails" contains "$ERR" $' fails failed. Its last lines:\n      | 16\n'
  expect "the very last" contains "$ERR" '| 40'
  expect "one without output" contains "$ERR" 'says_nothing failed.'
  expect "one that lacks a word" contains "$ERR" $'lacks_a_word failed. Its last lines:\n      | hello\n'
  expect "one that takes too long" contains "$ERR" $'takes_too_long failed. Its last lines:\n      | begun'
  expect "no other" lacks "$ERR" fine
}

# Each grid and length of the time series has a file of its own.
test_forecast_files()
{
  # shellcheck source=/dev/null
  source "$TOP/CMake/script/forecast.sh"
  local arguments=("" "--hours 240" "--grid=paper --hours=72" "--grid test") names=(gfs_48h gfs_240h paper_72h test_6h) i
  for i in 0 1 2 3; do
    # shellcheck disable=SC2086 # words
    run forecast_file ${arguments[i]}
    expect "the file of '${arguments[i]}'" [ "$OUT" = "$TOP/build/forecast/${names[i]}.nc" ]
  done
}

test_no_install()
{
  fake_packages_without xauth
  fake apt-get <<'E'
echo "$*" >>"$CALLS"
E
  nephoscope --no-install pvpython -c pass
  expect "status 3" [ $STATUS -eq 3 ]
  expect "the missing package alone is named" contains "$ERR" "missing Debian packages: xauth"$'\n'
  nephoscope demo --no-install
  expect "status 3, the option after the verb" [ $STATUS -eq 3 ]
  expect "no call of apt-get" [ ! -s "$CALLS" ]
}

test_no_root()
{
  fake_packages_without ninja-build
  fake id <<<'echo 1000'
  fake sudo <<<'exit 1'
  fake apt-get <<'E'
echo "$*" >>"$CALLS"
E
  nephoscope build
  expect "status 3" [ $STATUS -eq 3 ]
  expect "what to run as root" contains "$ERR" "apt-get install --no-install-recommends ninja-build"
  expect "no call of apt-get" [ ! -s "$CALLS" ]
}

test_sudo()
{
  fake_packages_without ninja-build
  fake id <<<'echo 1000'
  fake sudo <<'E'
echo "sudo $*" >>"$CALLS"
E
  fake cmake <<<'exit 9' # no build in this test, whatever state the build folder is in
  nephoscope build
  local update install
  update=$(grep -n 'DEBIAN_FRONTEND=noninteractive apt-get .* update$' "$CALLS" | cut -d : -f 1)
  install=$(grep -n 'apt-get .* install -y --no-install-recommends ninja-build$' "$CALLS" | cut -d : -f 1)
  expect "apt-get update, then install of the one package, through sudo" [ "${update:-9}" -lt "${install:-0}" ]
}

test_apt_fails()
{
  fake_packages_without ninja-build
  fake id <<<'echo 0'
  fake apt-get <<<'echo "E: the mirror is gone"; exit 100'
  nephoscope build
  expect "status 3" [ $STATUS -eq 3 ]
  expect "the log on standard error" contains "$ERR" "E: the mirror is gone"
  expect "where the log is" contains "$ERR" "build/logs/apt-install.log"
}

test_no_debian()
{
  local tool
  for tool in bash dirname readlink cat; do
    ln -s "$(command -v $tool)" "$WORK/fakes/$tool"
  done
  run env PATH="$WORK/fakes" "$TOP/nephoscope" demo
  expect "status 3" [ $STATUS -eq 3 ]
  expect "what is needed" contains "$ERR" "paraview-dev"
}

# The packages that the script names on a release: packages_of CODENAME.
packages_of()
{
  # shellcheck disable=SC2016 # expanded by the inner shell
  run env CODENAME="$1" SOURCE="$TOP" bash -euo pipefail -c '
    .() { VERSION_CODENAME=$CODENAME; }
    source "$SOURCE/CMake/script/packages.sh"
    echo " ${BUILD_PACKAGES[*]} ${MORE_PACKAGES[*]} ${RUN_PACKAGES[*]} ${TEST_PACKAGES[*]} "'
}

test_releases()
{
  packages_of bookworm
  expect "Qt 5's pictures, TetGen 1.5" contains "$OUT" " libtet1.5-dev libglew-dev "
  expect "Qt 5's pictures and help" contains "$OUT" " libqt5svg5 libqt5sql5-sqlite "
  expect "no VTK beside ParaView's own" lacks "$OUT" "libvtk9-dev"
  packages_of trixie
  expect "Qt 6's pictures and help" contains "$OUT" " qt6-svg-plugins libqt6sql6-sqlite "
  expect "no VTK beside ParaView's own" lacks "$OUT" "python3-vtk9"
  packages_of forky
  expect "the VTK that ParaView shares" contains "$OUT" " libtet-dev libvtk9-dev python3-vtk9 "
}

# Fakes by which a root can be made and entered, in $NEPHOSCOPE_ROOTS, without rights.
fake_roots()
{
  export NEPHOSCOPE_ROOTS="$WORK/roots"
  fake id <<<'echo 0'
  fake apt-config <<<'echo "Acquire::Check-Date \"false\";"; echo "Acquire::AllowWeakRepositories \"0\";"'
  fake apt-get <<<'printf "http://mirror.example/%s\n" debian-security/ debian/ other/'
  fake debootstrap <<'E'
echo "debootstrap $*" >>"$CALLS"
mkdir -p "$4/etc/apt/apt.conf.d" "$4/etc/ssl" "$4/usr/sbin"
E
  fake unshare <<'E'
[[ "$*" == *chroot* ]] || exit 0
printf '%s ' "$@" | tr '\n' ' ' >>"$CALLS"
exit "${ROOT_STATUS:-0}"
E
}

test_root()
{
  fake_roots
  nephoscope --root trixie test -L math
  expect "status 0" [ $STATUS -eq 0 ]
  expect "made from this system's mirror" grep -q "debootstrap .* trixie .*/trixie.partial http://mirror.example/debian$" "$CALLS"
  expect "the root under its name, with the tree" [ -x "$WORK/roots/trixie/nephoscope/nephoscope" ]
  expect "without what this system has built" [ ! -e "$WORK/roots/trixie/nephoscope/build" ]
  expect "the script runs there" grep -q "roots/trixie .*exec ./nephoscope .* --preset [a-z]* test -L math $" "$CALLS"
  expect "packages and their security updates" [ "$(cat "$WORK/roots/trixie/etc/apt/sources.list")" = \
    "deb http://mirror.example/debian trixie main"$'\n'"deb http://mirror.example/debian-security trixie-security main" ]
  expect "the setting of the dates alone" [ "$(cat "$WORK/roots/trixie/etc/apt/apt.conf.d/50host")" = 'Acquire::Check-Date "false";' ]
  mkdir "$WORK/roots/trixie/nephoscope/build"
  touch "$WORK/roots/trixie/nephoscope/removed"
  echo "an earlier one" >"$WORK/roots/trixie/nephoscope/LICENSE"
  touch -d 2001-01-01 "$WORK/roots/trixie/nephoscope/README.md" "$WORK/begin"
  touch -d 2037-01-01 "$WORK/roots/trixie/nephoscope/LICENSE"
  : >"$CALLS"
  ROOT_STATUS=8 nephoscope test --root=trixie
  expect "the exit status of the tests there" [ $STATUS -eq 8 ]
  expect "on which release" contains "$ERR" "on Debian trixie: exit status 8"
  expect "the root is used again" lacks "$(cat "$CALLS")" debootstrap
  expect "what it has built stays" [ -d "$WORK/roots/trixie/nephoscope/build" ]
  expect "a file that is the same keeps its time" [ ! "$WORK/roots/trixie/nephoscope/README.md" -nt "$WORK/begin" ]
  expect "one that differs is new to the build" [ -n "$(find "$WORK/roots/trixie/nephoscope/LICENSE" -mmin -5 ! -newermt "now + 1 day")" ]
  expect "what the tree no longer has is gone" [ ! -e "$WORK/roots/trixie/nephoscope/removed" ]
  mkdir "$WORK/tree"
  cp -a "$TOP/nephoscope" "$TOP/CMake" "$WORK/tree"
  mkdir -p "$WORK/roots/trixie/nephoscope/dist/folder"
  touch "$WORK/roots/trixie/nephoscope/dist/made.deb"
  run env PATH="$WORK/fakes:$PATH" "$WORK/tree/nephoscope" package --root trixie
  expect "what a verb has made there is here too" [ -f "$WORK/tree/dist/made.deb" ]
  nephoscope test --root trixie --fresh
  expect "a fresh root when asked for" grep -q debootstrap "$CALLS"
  expect "nothing built there" [ ! -e "$WORK/roots/trixie/nephoscope/build" ]
}

test_root_refused()
{
  fake_roots
  nephoscope test --root sarge
  expect "status 2 for another release" [ $STATUS -eq 2 ]
  expect "those that there are" contains "$ERR" "bookworm trixie forky"
  nephoscope --root trixie python -c pass
  expect "status 2 for a verb without roots" [ $STATUS -eq 2 ]
  NEPHOSCOPE_ROOTS="$TOP/roots" nephoscope test --root trixie
  expect "status 2 for a folder in the source tree" [ $STATUS -eq 2 ]
  fake unshare <<<'exit 1'
  nephoscope test --root trixie
  expect "status 3 where nothing can be mounted" [ $STATUS -eq 3 ]
  expect "the reason" contains "$ERR" "allowed to mount"
  fake id <<<'echo 1000'
  fake sudo <<<'exit 1'
  nephoscope test --root trixie
  expect "status 3 without root rights" [ $STATUS -eq 3 ]
  expect "the reason" contains "$ERR" "needs root rights"
  expect "nothing made" [ ! -e "$WORK/roots" ]
}

# The tree of an unpacked archive, on a machine without git.
test_no_git()
{
  local tool
  for tool in env bash dirname readlink cat; do
    ln -s "$(command -v $tool)" "$WORK/fakes/$tool"
  done
  run env PATH="$WORK/fakes" /usr/bin/python3 "$TOP/Testing/Script/TestTree.py"
  expect "success without git" [ $STATUS -eq 0 ]
  printf '#!/bin/bash\necho %q\n' "$WORK" >"$WORK/fakes/git" # an archive unpacked inside another project
  chmod +x "$WORK/fakes/git"
  run env PATH="$WORK/fakes" /usr/bin/python3 "$TOP/Testing/Script/TestTree.py"
  expect "success inside another project" [ $STATUS -eq 0 ]
}

# A CMake package one of whose Python modules has been renamed, as Debian does, is imported with the names that are there.
test_renamed_modules()
{
  local package="$WORK/usr/lib/cmake/fake-1.0" modules="$WORK/usr/lib/python3/dist-packages/fake"
  mkdir -p "$package" "$modules"
  touch "$modules/plain.so" "$modules/renamed.cpython-313-x86_64-linux-gnu.so"
  cat >"$package/FakePython-targets.cmake" <<'E'
get_filename_component(_IMPORT_PREFIX "${CMAKE_CURRENT_LIST_FILE}" PATH)
include("${CMAKE_CURRENT_LIST_DIR}/FakePython-targets-debug.cmake")
E
  cat >"$package/FakePython-targets-debug.cmake" <<'E'
set(prefix "${_IMPORT_PREFIX}")
set(locations "${_IMPORT_PREFIX}/lib/python3/dist-packages/fake/plain.so" "${_IMPORT_PREFIX}/lib/python3/dist-packages/fake/renamed.so")
message("prefix ${prefix}, locations ${locations}")
E
  cat >"$WORK/import.cmake" <<E
set(PROJECT_BINARY_DIR "$WORK/build")
include("$TOP/CMake/NephoscopePythonTargets.cmake")
nephoscope_import_python_targets("$package")
message("prefix of the caller: '\${prefix}'")
E
  run cmake -P "$WORK/import.cmake"
  expect "success" [ $STATUS -eq 0 ]
  expect "the folder that the original speaks of" contains "$ERR" "prefix $package,"
  expect "the renamed module" contains "$ERR" ";$modules/renamed.cpython-313-x86_64-linux-gnu.so"
  expect "the other as it is" contains "$ERR" "locations $package/lib/python3/dist-packages/fake/plain.so;"
  expect "a scope of its own" contains "$ERR" "prefix of the caller: ''"
  mv "$modules/renamed.cpython-313-x86_64-linux-gnu.so" "$modules/renamed.so"
  run cmake -P "$WORK/import.cmake"
  expect "no copy where nothing is renamed" lacks "$ERR" "plain.so"
}

# The gallery runner alone, with Python in place of pvbatch.
gallery()
{
  # shellcheck disable=SC2016 # expanded by the inner shell
  run env TOP="$WORK" SOURCE="$TOP" bash -euo pipefail -c '
    source "$SOURCE/CMake/script/progress.sh"
    source "$SOURCE/CMake/script/gallery.sh"
    on_virtual_display() { shift; /usr/bin/python3 "$@"; }
    build_targets() { echo "built ${*:-all}"; }
    host_environment() { WITH_PRELOAD=(); }
    render_gallery "$@"' gallery "$@"
}

# configured PACKAGE...: the step `configure` of a verb that needs these packages; the fake of cmake notes its calls.
configured()
{
  # shellcheck disable=SC2016 # expanded by the inner shell
  run env PATH="$WORK/fakes:$PATH" SOURCE="$TOP" TREE="$WORK" bash -euo pipefail -c '
    TOP=$TREE PRESET=default PACKAGES=("$@")
    source "$SOURCE/CMake/script/progress.sh"
    source "$SOURCE/CMake/script/build.sh"
    configure' configured "$@"
  expect "success" [ $STATUS -eq 0 ]
}

test_configured()
{
  fake cmake <<'E'
echo "$*" >>"$CALLS"
mkdir -p "$TREE/build"
[ -f "$TREE/build/CMakeCache.txt" ] || echo "CMAKE_HOME_DIRECTORY:INTERNAL=$TREE" >"$TREE/build/CMakeCache.txt"
touch "$TREE/build/build.ninja"
E
  fake ccache </dev/null
  configured compiler
  expect "one call" [ "$(wc -l <"$CALLS")" -eq 1 ]
  expect "ccache" grep -q LAUNCHER=ccache "$CALLS"
  configured compiler
  expect "no second call" [ "$(wc -l <"$CALLS")" -eq 1 ]
  configured compiler library
  expect "a call for a package that was not asked for before" [ "$(wc -l <"$CALLS")" -eq 2 ]
  configured compiler
  expect "no call for fewer packages" [ "$(wc -l <"$CALLS")" -eq 2 ]
  touch -d 2001-01-01 "$WORK"/build/*
  touch -d 2001-01-02 "$WORK/CMakePresets.json"
  configured compiler
  configured compiler
  expect "one call for presets that are newer" [ "$(wc -l <"$CALLS")" -eq 3 ]
}

# Compiles what a build without ccache does, several sources at a time, as far as it takes to find the errors; links nothing.
test_unity()
{
  cmake -S "$TOP" -B "$WORK/unity" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 -DBUILD_TESTING=OFF -DNEPHOSCOPE_WRAP_PYTHON=OFF \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_BUILD_TYPE=MinSizeRel -DCMAKE_CXX_FLAGS_MINSIZEREL=-fsyntax-only \
    -DCMAKE_CXX_CREATE_SHARED_LIBRARY=: -DCMAKE_CXX_CREATE_SHARED_MODULE=: \
    -DCMAKE_CXX_ARCHIVE_CREATE=: -DCMAKE_CXX_ARCHIVE_FINISH=: >/dev/null
  ninja -C "$WORK/unity" -k 0 | tail -n 100
}

test_gallery()
{
  mkdir "$WORK/Figures"
  gallery
  expect "failure without figures" [ $STATUS -ne 0 ]
  local write='import os; f = os.environ["NEPHOSCOPE_GALLERY"] + "/FILE"; open(f, "w").write("x"); print("wrote", f)'
  printf '%s\n' "${write/FILE/b c.png}" >"$WORK/Figures/02_b.py"
  printf '%s\n' "${write/FILE/a.png}" >"$WORK/Figures/01_a.py"
  gallery
  expect "success" [ $STATUS -eq 0 ]
  expect "the figures in order" contains "$(tr -d '\n' <<<"$OUT")" "a.png      02_b.py"
  expect "the file names" contains "$OUT" "wrote $WORK/Gallery/b c.png"
  gallery 02
  expect "the chosen figure alone" lacks "$OUT" "a.png"
  expect "the plugin alone is built for it" contains "$OUT" "built Nephoscope"$'\n'
  expect "nothing else is built for it" lacks "$OUT" "built all"
  mkdir "$WORK/Figures/common"
  printf 'import os\nimport pictures\n' >"$WORK/Figures/common/scene.py"
  printf 'import nephoscope\n' >"$WORK/Figures/common/pictures.py"
  printf 'import os\nif not os.environ["NEPHOSCOPE_GALLERY"]:\n    import scene\n%s\n' "${write/FILE/c.png}" >"$WORK/Figures/04_c.py"
  gallery 04
  expect "the package is built for a figure that takes a module which uses it" contains "$OUT" "built all"
  printf '%s; print(os.environ["NEPHOSCOPE_FILMS"])\n' "${write/FILE/a.png}" >"$WORK/Figures/01_a.py"
  rm "$WORK/Figures/04_c.py"
  gallery
  expect "pictures alone of the whole gallery" grep -qx no "$WORK/build/logs/figure-01_a.log"
  gallery --films 01
  expect "films when asked for" grep -qx yes "$WORK/build/logs/figure-01_a.log"
  gallery 01
  expect "the film of a figure that is named" grep -qx yes "$WORK/build/logs/figure-01_a.log"
  echo 'import nothing_of_this_name' >"$WORK/Figures/03_raises.py"
  gallery 03
  expect "failure of a figure that raises" [ $STATUS -ne 0 ]
  expect "its traceback" contains "$ERR" "ModuleNotFoundError"
  echo 'print("done")' >"$WORK/Figures/03_silent.py"
  gallery 03_s
  expect "failure of a figure that writes nothing" [ $STATUS -ne 0 ]
  printf '%s; print("(   1.0s) [pvbatch         ]   vtkOpenGLTexture.cxx:195    ERR| vtkOpenGLTexture: no image")\n' \
    "${write/FILE/e.png}" >"$WORK/Figures/03_errors.py"
  gallery 03_e
  expect "failure of a figure that reports an error and goes on" [ $STATUS -ne 0 ]
  expect "the error" contains "$ERR" "vtkOpenGLTexture: no image"
  echo 'print("wrote /nowhere/x.png")' >"$WORK/Figures/03_liar.py"
  gallery 03_l
  expect "failure of a figure that does not write what it says" [ $STATUS -ne 0 ]
}

test_release()
{
  local copy="$WORK/tree" first
  mkdir "$copy"
  (cd "$TOP" && find . \( -path './build*' -o -path ./Gallery -o -path ./dist -o -name __pycache__ -o -path ./.git \) -prune -o ! -type d -print0) |
    tar -C "$TOP" --null --no-recursion -T - -cf - | tar -C "$copy" -xf -
  release() { run "$copy/nephoscope" release "$@"; }
  release sdist
  expect "failure without a section of the changelog" [ $STATUS -ne 0 ]
  expect "which one" contains "$ERR" "CHANGELOG.md has no section [0.1.0] with its date"
  release --draft sdist
  expect "status 0 of a draft" [ $STATUS -eq 0 ]
  expect "checksums" grep -q " nephoscope-0.1.0.tar.gz$" "$copy/dist/SHA256SUMS"
  first=$(cat "$copy/dist/SHA256SUMS")
  sed -i 's/^## \[Unreleased\]/## [0.1.0] - 2026-12-01/' "$copy/CHANGELOG.md"
  release --draft sdist
  expect "another tree has another sum" [ "$first" != "$(cat "$copy/dist/SHA256SUMS")" ]
  first=$(cat "$copy/dist/SHA256SUMS")
  touch "$copy/LICENSE"
  release sdist
  expect "status 0 with a section of the changelog" [ $STATUS -eq 0 ]
  expect "the same tree makes the same file" [ "$first" = "$(cat "$copy/dist/SHA256SUMS")" ]
  tar -C "$WORK" -xzf "$copy/dist/nephoscope-0.1.0.tar.gz"
  expect "what pip reads" ls "$WORK"/nephoscope-0.1.0/{pyproject.toml,PKG-INFO,LICENSE}
  expect "no tests" [ ! -e "$WORK/nephoscope-0.1.0/Testing" ]
  expect "the sample data alone" [ "$(cd "$WORK/nephoscope-0.1.0/Data" && echo *)" = "blue_marble_2048.jpg forecast_10deg_6h.nc gfs_2p5deg_2011101100.nc" ]
  local hooks=(env -u VTK_DIR PYTHONPATH="$WORK/nephoscope-0.1.0/CMake/wheel/source" /usr/bin/python3 -S -c)
  run "${hooks[@]}" 'import build_backend as b
print(b.get_requires_for_build_wheel({"vtk": "sdk"}))'
  expect "VTK's SDK is required where it is asked for" contains "$OUT" "vtk-sdk=="
  run "${hooks[@]}" 'import build_backend as b
b.get_requires_for_build_wheel()'
  expect "no success without VTK's SDK" [ $STATUS -ne 0 ]
  expect "where it can be had" contains "$ERR" "pip install --extra-index-url https://vtk.org/"
}

test_docs()
{
  /usr/bin/python3 -c 'import sphinx, myst_parser, furo, sphinx_copybutton' 2>"$WORK/why" || { cat "$WORK/why"; exit 125; }
  nephoscope --no-install docs
  expect "status 0" [ $STATUS -eq 0 ]
  local page
  for page in index search Documentation/haze gallery/01_clouds_over_globe api/python/plotters api/vtk/vtkHaze api/paraview; do
    expect "the page $page" [ -s "$TOP/build/docs/html/$page.html" ]
  done
  expect "the docstring of a function" grep -q "Meteorological visibility" "$TOP/build/docs/html/api/python/plotters.html"
  expect "a script to download" grep -q 'href="[^"]*/01_clouds_over_globe.py"' "$TOP/build/docs/html/gallery/01_clouds_over_globe.html"
  expect "what the search finds" grep -q SetScaleHeight "$TOP/build/docs/html/searchindex.js"
}

test_python()
{
  fake python3 <<<'exit 9' # an interpreter that someone put first on PATH
  mkdir "$WORK/with space"
  ln -s "$TOP/nephoscope" "$WORK/with space/nephoscope"
  cd "$WORK/with space"
  run env PATH="$WORK/fakes:$PATH" ./nephoscope python -c 'import nephoscope; print(nephoscope.vtkGlobeGrid.__name__)'
  expect "status 0" [ $STATUS -eq 0 ]
  expect "the package, and nothing else on standard output" [ "$OUT" = vtkGlobeGrid ]
  nephoscope python -c 'raise SystemExit(7)'
  expect "the host's exit status" [ $STATUS -eq 7 ]
  [ -d "$TOP/build/venv" ] || return 0 # made where the package index can be reached
  local vtk pyvista
  vtk=$(/usr/bin/python3 -c 'from vtkmodules.vtkCommonCore import vtkVersion as v; print(v.GetVTKVersion())')
  pyvista=$(sed -n 's/^pyvista==//p' "$TOP/Plugins/PyVista/requirements.txt")
  nephoscope python -c 'import importlib.metadata as m; print(m.version("vtk"), m.version("pyvista"))'
  expect "pip is told of ParaView's VTK, and pyvista is there" [ "$OUT" = "$vtk $pyvista" ]
}

test_plugin_loaded()
{
  local script="$TOP/Testing/Script/print_plugin.py" host
  for host in pvpython pvbatch; do
    nephoscope $host "$script"
    expect "status 0 of $host" [ $STATUS -eq 0 ]
    expect "the plugin in $host" contains "$OUT" "Nephoscope loaded, 1 process"
  done
}

test_ranks()
{
  nephoscope pvbatch -n 2 "$TOP/Testing/Script/print_plugin.py"
  expect "status 0" [ $STATUS -eq 0 ]
  expect "two processes with the plugin" contains "$OUT" "Nephoscope loaded, 2 processes"
  nephoscope pvbatch -n two script.py
  expect "status 2 for a number that is none" [ $STATUS -eq 2 ]
}

# A server of two ranks, and a client that draws on it; the server ends with its client, or after a minute.
test_server()
{
  local port=$((20000 + RANDOM % 10000)) log="$WORK/server.log"
  timeout 60 "$TOP/nephoscope" pvserver -n 2 --server-port="$port" >"$log" 2>&1 &
  until grep -q "Accepting connection" "$log" || ! kill -0 $! 2>/dev/null; do sleep 0.2; done
  nephoscope pvpython "$TOP/Testing/Script/draw_on_server.py" "$port"
  expect "status 0" [ $STATUS -eq 0 ]
  expect "a picture from two ranks" contains "$OUT" "2 ranks have drawn"
}

# ParaView moves data between ranks in the form that this reads.
test_appended_xml()
{
  nephoscope python "$TOP/Testing/Script/read_appended_xml.py"
  expect "as many cells read as written" [ "$STATUS $OUT" = "0 1000 cells" ]
}

test_format()
{
  # Other versions of clang-format break lines in other ways.
  command -v clang-format-14 >/dev/null || { echo "skipped: there is no clang-format-14"; exit 125; }
  cd "$TOP"
  find Filters Plugins Representations Testing \( -name '*.cxx' -o -name '*.h' \) -print0 |
    xargs -0 clang-format-14 --dry-run -Werror
}

# by_the_day PARTS: of the lines of standard input every PARTS-th one, others tomorrow; all of them with NEPHOSCOPE_TEST_ALL=yes.
by_the_day()
{
  if [ "${NEPHOSCOPE_TEST_ALL:-no}" = yes ]; then cat; else awk -v day=$(($(date +%s) / 86400)) -v parts="$1" 'NR % parts == day % parts'; fi
}

test_by_the_day()
{
  expect "every line once in three days" [ "$(for day in 0 1 2; do date() { echo $((day * 86400)); }; seq 7 | by_the_day 3; done | sort | tr -d '\n')" = 1234567 ]
  expect "all lines where that is asked" [ "$(seq 7 | NEPHOSCOPE_TEST_ALL=yes by_the_day 3 | wc -l)" -eq 7 ]
}

# Sources are joined, as the headers of VTK take more time than ours.
test_tidy()
{
  command -v clang-tidy-14 >/dev/null || { echo "skipped: there is no clang-tidy-14"; exit 125; }
  cmake -S "$TOP" -B "$WORK/unity" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 -DBUILD_TESTING=OFF -DNEPHOSCOPE_WRAP_PYTHON=OFF \
    -DCMAKE_UNITY_BUILD=ON -DCMAKE_BUILD_TYPE=Release >/dev/null
  ninja -C "$WORK/unity" -t targets all | sed -n 's/: CUSTOM_COMMAND$//p' | grep -E '^Representations/[A-Za-z]*/[A-Za-z]*\.cxx$' >"$WORK/shaders"
  xargs -a "$WORK/shaders" ninja -C "$WORK/unity" >/dev/null
  cd "$TOP"
  find "$WORK/unity" -path '*/Unity/*_cxx.cxx' ! -path '*CS.dir*' ! -path '*/Nephoscope.dir/*' | sort | by_the_day 6 |
    xargs -P 2 -n 1 clang-tidy-14 --quiet -p "$WORK/unity" --config-file=.clang-tidy 2>"$WORK/counts"
}

# The tests in C++ of two folders or so, with the address and the undefined behaviour sanitizer.
test_sanitizers()
{
  local folders
  mapfile -t folders < <(cd "$TOP" && grep -rlE "nephoscope_add_(math|cxx|shader)_test" --include=CMakeLists.txt Filters Representations | sort | by_the_day 7)
  folders=("${folders[@]%/CMakeLists.txt}")
  echo "${folders[@]}"
  cmake -S "$TOP" -B "$WORK/san" -G Ninja -DPython3_EXECUTABLE=/usr/bin/python3 -DNEPHOSCOPE_WRAP_PYTHON=OFF -DNEPHOSCOPE_USE_PARAVIEW=OFF \
    -DVTK_DIR="$NEPHOSCOPE_VTK" -DCMAKE_UNITY_BUILD=ON -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG="-O0 -g1" \
    -DNEPHOSCOPE_SANITIZE=address,undefined >/dev/null
  local status=0 limit=240
  [ "${NEPHOSCOPE_TEST_ALL:-no}" = no ] || limit=0
  timeout $limit ninja -C "$WORK/san" -j 2 "${folders[@]/%//all}" >"$WORK/log" || status=$?
  [ $status -ne 124 ] || { echo "skipped: ${folders[*]} took more than $limit s to compile"; exit 125; }
  [ $status -eq 0 ] || { tail -n 50 "$WORK/log"; exit 1; }
  ctest --test-dir "$WORK/san" -j 2 --output-on-failure --no-tests=error -R "^($(find "$WORK/san/bin" -type f -printf '%f|'))\$"
}

test_shellcheck()
{
  command -v shellcheck >/dev/null || { echo "skipped: there is no shellcheck"; exit 125; }
  cd "$TOP"
  shellcheck -x nephoscope .ci/run CMake/script/*.sh Testing/Script/*.sh
}

"test_$1"

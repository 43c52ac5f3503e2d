# shellcheck shell=bash
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# The Debian packages that are needed, and how the missing ones get installed.
# shellcheck disable=SC2034 # read by the verbs
BUILD_PACKAGES=(
  g++ cmake ninja-build python3-dev
  paraview-dev python3-paraview # ParaView with its VTK; they bring the program `paraview` as well
  # What ParaView's CMake package looks for, and paraview-dev does not depend on:
  libopenmpi-dev libdouble-conversion-dev libx11-dev libgl-dev libfreetype-dev)
# What no figure needs; `demo` does without it unless it is there, because OpenVDB takes as long to compile as all the rest.
MORE_PACKAGES=(
  libopenvdb-dev      # OpenVDB (MPL 2.0), optional: CMake/NephoscopeOpenVDB.cmake
  qhelpgenerator-qt5) # the help pages in ParaView, optional: CMake/NephoscopeHelp.cmake
RUN_PACKAGES=(
  xvfb xauth  # the virtual display
  openmpi-bin # mpiexec
  python3-numpy python3-matplotlib python3-pil python3-venv) # of what pyvista imports, all that Debian has fit
TEST_PACKAGES=(
  libgtest-dev
  glslang-tools # the reference compiler of shaders
  shellcheck)

DOCUMENTATION_PACKAGES=(python3-sphinx python3-myst-parser furo python3-sphinx-copybutton python3-pil)
WEB_TEST_PACKAGES=(chromium) # the browser of the tests of pages and notebooks

# The name of this Debian; of other systems made from it, theirs.
debian_codename() { (. /etc/os-release 2>/dev/null && printf '%s' "${VERSION_CODENAME:-}"); }

# What differs between releases: Qt's plugins for ParaView's icons and its help window; TetGen (GNU AGPL 3, optional: CMake/NephoscopeTetGen.cmake);
# glew before VTK 9.4; whether ParaView has a VTK of its own.
case $(debian_codename) in
  bookworm) BUILD_PACKAGES+=(libtet1.5-dev libglew-dev); RUN_PACKAGES+=(libqt5svg5 libqt5sql5-sqlite); TEST_PACKAGES+=(clang-format-14 clang-tidy-14) ;;
  trixie) BUILD_PACKAGES+=(libtet1.5-dev libglew-dev); RUN_PACKAGES+=(qt6-svg-plugins libqt6sql6-sqlite) ;;
  *) BUILD_PACKAGES+=(libtet-dev libvtk9-dev python3-vtk9); RUN_PACKAGES+=(qt6-svg-plugins libqt6sql6-sqlite) ;;
esac

# Prints those of the named packages that are not installed.
missing_packages()
{
  local installed package
  # dpkg-query exits with 1 when it does not know one of the names: that one is missing.
  installed=$(dpkg-query -W -f='${Package} ${db:Status-Status}\n' "$@" 2>/dev/null || true)
  for package in "$@"; do
    grep -qxF "$package installed" <<<"$installed" || printf '%s\n' "$package"
  done
}

# Sets AS_ROOT to the words that run a command as root; fails where there is no way to become root.
find_root()
{
  AS_ROOT=()
  [ "$(id -u)" -ne 0 ] || return 0
  AS_ROOT=(sudo)
  command -v sudo >/dev/null || return 1
  # On a terminal sudo may ask for the password, once; elsewhere nothing ever asks.
  sudo -n true 2>/dev/null || { [ -t 0 ] && sudo -v; }
}

apt()
{
  "${AS_ROOT[@]}" env DEBIAN_FRONTEND=noninteractive \
    apt-get -o Acquire::Retries=3 -o DPkg::Lock::Timeout=300 "$@"
}

# ensure_packages NAME...: installs what is missing, or names it and exits with status 3. Sets PACKAGES to the names.
ensure_packages()
{
  PACKAGES=("$@")
  step "Debian packages"
  command -v dpkg-query >/dev/null ||
    fail 3 "this is no Debian: there is no dpkg-query. What is needed, by the names of Debian's packages: $*." \
      "CONTRIBUTING.md tells how to build without this script."
  local missing
  mapfile -t missing < <(missing_packages "$@")
  if [ ${#missing[@]} -eq 0 ]; then
    say_unless_quiet "      all $# are there"
    return
  fi
  local found="missing Debian packages: ${missing[*]}"
  local remedy=$'\n  '"as root: apt-get install --no-install-recommends ${missing[*]}"
  [ "$INSTALL" = yes ] || fail 3 "$found$remedy"
  command -v apt-get >/dev/null || fail 3 "$found; there is no apt-get to install them"
  find_root || fail 3 "$found; there is no way to become root here$remedy"
  say "      installing ${#missing[@]} of $#: ${missing[*]}"
  run_logged apt-update apt update || note "going on with the package lists that are there"
  run_logged apt-install apt install -y --no-install-recommends "${missing[@]}" ||
    fail 3 "could not install the Debian packages ${missing[*]}"
}

# shellcheck shell=bash
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# The Debian package for the release that this system is, and its test: ParaView and Python as they come, with the package installed.
# shellcheck disable=SC2034 # read by the verb
PACKAGE_PACKAGES=(dpkg-dev file lintian)
PACKAGE_TREE="$TOP/build/package"

# Without TetGen, whose licence, the GNU AGPL 3, would be that of the package.
configure_package()
{
  local compiler
  mapfile -t compiler < <(compiler_options)
  cmake -S "$TOP" -B "$PACKAGE_TREE" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_INSTALL_PREFIX=/usr -DBUILD_TESTING=OFF \
    -DPython3_EXECUTABLE="$SYSTEM_PYTHON" -DNEPHOSCOPE_FOR_DEBIAN="$(debian_codename)" -DNEPHOSCOPE_USE_TETGEN=OFF \
    -DNEPHOSCOPE_PYTHON_DESTINATION=lib/python3/dist-packages "${compiler[@]}"
}

# Sets PACKAGE to the file.
make_package()
{
  step "Configure and build the package"
  run_logged package-configure configure_package || fail 1 "could not configure the package"
  run_logged package-build cmake --build "$PACKAGE_TREE" -j "$(nproc)" || fail 1 "could not build the package"
  step "Debian package"
  run_logged package-pack cpack --config "$PACKAGE_TREE/CPackConfig.cmake" -B "$TOP/dist" || fail 1 "could not make the package"
  rm -rf "$TOP/dist/_CPack_Packages"
  PACKAGE=$(sed -n 's/^CPack: - package: \(.*[.]deb\) generated[.]$/\1/p' "$LOGS/package-pack.log")
  [ -f "$PACKAGE" ] || fail 1 "CPack made no package"
  say "      ${PACKAGE#"$TOP"/}"
  run_logged package-lintian lintian --fail-on error "$PACKAGE" || fail 1 "lintian finds errors in the package"
}

# Starts the hosts in a folder, without any of the variables by which this script leads them to a build.
try_package()
{
  cd "$1" && export HOME="$1/home" && mpi_environment
  on_virtual_display pvpython "$2" pvpython && on_virtual_display paraview --script="$2" &&
    on_virtual_display env LD_PRELOAD="$(dpkg -L nephoscope-paraview | grep libexpat_whole_tokens)" mpiexec -n 2 pvbatch "$2" pvbatch && on_virtual_display "$SYSTEM_PYTHON" "$2" python
}

# Removes the package. What was compiled and written meanwhile must be gone with it.
remove_package()
{
  local installed left
  mapfile -t installed < <(dpkg -L nephoscope-paraview | grep -i nephoscope)
  run_logged package-remove apt purge -y nephoscope-paraview || fail 1 "could not remove the package"
  left=$(ls -d "${installed[@]}" /usr/bin/plugins 2>/dev/null) || true
  [ -z "$left" ] || fail 1 "the package leaves behind: $left"
}

# Installs the package, tries it and removes it.
test_package()
{
  local test="$TOP/Testing/Package/TestInstalled.py" folder="$TOP/build/package/test" version settings
  step "Test of the installed package"
  find_root || fail 3 "installing the package needs root rights: run it as root, or with sudo set up, or with --root"
  run_logged package-install apt install -y --no-install-recommends "$PACKAGE" || fail 1 "could not install ${PACKAGE#"$TOP"/}"
  rm -rf "$folder"
  # A home where ParaView need not welcome anyone: its dialog would stop the script until someone closes it.
  mkdir -p "$folder/home/.config/ParaView"
  version=$(pvpython --version)
  for settings in ParaView "ParaView${version##* }"; do
    printf '[General]\nGeneralSettings.ShowWelcomeDialog=false\n' >"$folder/home/.config/ParaView/$settings.ini"
  done
  (try_package "$folder" "$test") || fail 1 "the installed package does not work"
  [ -s "$folder/paraview.png" ] || fail 1 "ParaView's window has drawn nothing"
  remove_package
  say "      ParaView, pvpython and pvbatch draw, Python has the package, and removing it leaves nothing; pictures in ${folder#"$TOP"/}"
}

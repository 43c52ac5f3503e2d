# shellcheck shell=bash
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# A virtual environment with pyvista over ParaView's own VTK. Its interpreter is /usr/bin/python3, the one that
# Debian's VTK modules are built for, whatever else is on PATH.
SYSTEM_PYTHON=/usr/bin/python3
REQUIREMENTS="$TOP/Plugins/PyVista/requirements.txt"
WEB_REQUIREMENTS="$TOP/Plugins/PyVista/requirements-web.txt"
DATA_REQUIREMENTS="$TOP/Plugins/PyVista/requirements-data.txt" # and the files that it names
export NEPHOSCOPE_VENV="$TOP/build/venv"

venv_is_current() { cmp -s "$REQUIREMENTS" "$NEPHOSCOPE_VENV/requirements.txt"; }

# An empty distribution `vtk` of the version that is there, so that no pip run in this environment fetches the
# wheel of another VTK: two of them must never meet in one process.
declare_system_vtk()
{
  "$NEPHOSCOPE_VENV/bin/python3" - <<'E'
import pathlib
import sysconfig

from vtkmodules.vtkCommonCore import vtkVersion

version = vtkVersion.GetVTKVersion()
folder = pathlib.Path(sysconfig.get_path("purelib"), f"vtk-{version}.dist-info")
folder.mkdir(exist_ok=True)
(folder / "METADATA").write_text(f"Metadata-Version: 2.1\nName: vtk\nVersion: {version}\n")
(folder / "INSTALLER").write_text("debian\n")
E
}

make_venv()
{
  rm -rf "$NEPHOSCOPE_VENV"
  "$SYSTEM_PYTHON" -m venv --system-site-packages "$NEPHOSCOPE_VENV" &&
    declare_system_vtk &&
    PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_ROOT_USER_ACTION=ignore "$NEPHOSCOPE_VENV/bin/python3" -m pip install \
      --no-input --no-deps --retries 1 --timeout 15 -r "$REQUIREMENTS" &&
    cp "$REQUIREMENTS" "$NEPHOSCOPE_VENV/requirements.txt"
}

# Makes the environment, or makes it anew when the requirements changed. Without pyvista the rest still works.
ensure_venv()
{
  step "Python environment"
  if venv_is_current; then
    say_unless_quiet "      is up to date"
  elif ! run_logged venv make_venv 2>/dev/null; then
    rm -rf "$NEPHOSCOPE_VENV"
    note "pyvista could not be installed (build/logs/venv.log says why); going on without it"
  fi
}

data_requirements() { cat "${DATA_REQUIREMENTS%data.txt}"{data,grib,netcdf,zarr}.txt; }

make_data()
{
  PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_ROOT_USER_ACTION=ignore "$NEPHOSCOPE_VENV/bin/python3" -m pip install \
    --no-input --no-deps --retries 1 --timeout 15 -r "$DATA_REQUIREMENTS" &&
    data_requirements > "$NEPHOSCOPE_VENV/requirements-data.txt"
}

# What GRIB, NetCDF and Zarr need by way of xarray, in the environment of ensure_venv. Without it the rest still works.
ensure_data()
{
  venv_is_current || return 0
  if ! data_requirements | cmp -s - "$NEPHOSCOPE_VENV/requirements-data.txt" && ! run_logged data make_data; then
    note "xarray and eccodes could not be installed (build/logs/data.log says why); going on without them"
  fi
}

make_web()
{
  PIP_DISABLE_PIP_VERSION_CHECK=1 PIP_ROOT_USER_ACTION=ignore "$NEPHOSCOPE_VENV/bin/python3" -m pip install \
    --no-input --retries 1 --timeout 15 -r "$WEB_REQUIREMENTS" &&
    cp "$WEB_REQUIREMENTS" "$NEPHOSCOPE_VENV/requirements-web.txt"
}

# What pictures in a browser need, in the environment of ensure_venv. Fails where it cannot be had: nobody asks for it by the way.
ensure_web()
{
  step "Python packages for the browser"
  venv_is_current || fail 1 "the browser needs PyVista"
  if cmp -s "$WEB_REQUIREMENTS" "$NEPHOSCOPE_VENV/requirements-web.txt"; then
    say_unless_quiet "      are up to date"
  else
    run_logged web make_web || fail 1 "trame and JupyterLab could not be installed"
  fi
}

python_interpreter()
{
  if venv_is_current; then
    printf '%s' "$NEPHOSCOPE_VENV/bin/python3"
  else
    printf '%s' "$SYSTEM_PYTHON"
  fi
}

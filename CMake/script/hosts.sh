# shellcheck shell=bash
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# The programs that the project runs in: Python and ParaView's own, with package, plugin, display and MPI settled.

# Everything a host needs to find, as environment. ParaView 5.11's programs load the plugins they find in
# PV_PLUGIN_PATH when they start; their option --plugins does not work in pvpython and pvbatch.
host_environment()
{
  local libraries
  libraries="$BUILD/$(cache_value CMAKE_INSTALL_LIBDIR)"
  export PYTHONPATH="$libraries/python3/dist-packages${PYTHONPATH:+:$PYTHONPATH}"
  export PV_PLUGIN_PATH="$libraries/nephoscope-plugins/Nephoscope${PV_PLUGIN_PATH:+:$PV_PLUGIN_PATH}"
  export NEPHOSCOPE_DATA="$TOP/Data"
  export NEPHOSCOPE_PRESET="$PRESET"
  mpi_environment
  preload_environment
}

# Sets WITH_PRELOAD to the words before a host's command; CMake/NephoscopePreload.cmake tells what is preloaded.
# Python never frees all of its memory: leaks are looked for in C++ tests only, which ask for it themselves.
preload_environment()
{
  local libraries folder
  libraries=$(cache_value NEPHOSCOPE_PRELOAD)
  folder=$(cache_value NEPHOSCOPE_PRELOAD_FOLDER)
  WITH_PRELOAD=(env)
  [ -z "$libraries" ] || WITH_PRELOAD+=("LD_PRELOAD=$libraries${LD_PRELOAD:+:$LD_PRELOAD}"
    "LD_LIBRARY_PATH=$folder${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}")
  export ASAN_OPTIONS="detect_leaks=0${ASAN_OPTIONS:+:$ASAN_OPTIONS}"
}

# More ranks than cores are fine, so is root, and so are containers that forbid process_vm_readv.
# OMPI_ is Open MPI 4, PRTE_ Open MPI 5.
mpi_environment()
{
  export OMPI_MCA_rmaps_base_oversubscribe=1 PRTE_MCA_rmaps_default_mapping_policy=:oversubscribe
  export OMPI_MCA_btl_vader_single_copy_mechanism=none
  if [ "$(id -u)" -eq 0 ]; then
    export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
    export PRTE_ALLOW_RUN_AS_ROOT=1 PRTE_ALLOW_RUN_AS_ROOT_CONFIRM=1
  fi
}

on_virtual_display()
{
  # -noreset: else the server restarts whenever its last client leaves, and the next client may meet the restart.
  PYVISTA_OFF_SCREEN=true xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$@"
}

on_any_display()
{
  if [ -n "${DISPLAY:-}" ]; then
    "$@"
  else
    on_virtual_display "$@"
  fi
}

# run_host NAME ARGUMENT...
run_host()
{
  local host=$1
  local command=("$host")
  shift
  host_environment
  [[ "${*:-}" != *Figures/* ]] || mkdir -p "$NEPHOSCOPE_GALLERY" # into which figures write
  case $host in
    python)
      ensure_venv
      command=("$(python_interpreter)") ;;
    viewer)
      ensure_venv
      ensure_web
      command=("$(python_interpreter)" -m nephoscope) ;;
    pvbatch | pvserver)
      if [ "${1:-}" = -n ]; then
        [[ "${2:-}" =~ ^[1-9][0-9]*$ ]] || usage_error "$host -n wants a number of ranks"
        command=(mpiexec -n "$2" "$host")
        shift 2
      fi ;;
  esac
  on_any_display "${WITH_PRELOAD[@]}" "${command[@]}" "$@"
}

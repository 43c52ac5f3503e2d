# shellcheck shell=bash
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# Renders Figures/*.py into Gallery/. A figure is a script for pvbatch that reads the folders from the environment
# variables NEPHOSCOPE_DATA and NEPHOSCOPE_GALLERY and prints `wrote FILE` for every file, once it is written.
export NEPHOSCOPE_GALLERY="$TOP/Gallery"

# Prints the figures whose names begin with one of the arguments; all of them without arguments.
select_figures()
{
  local figure prefix
  for figure in "$TOP"/Figures/*.py; do
    [ -e "$figure" ] || continue
    [ $# -gt 0 ] || printf '%s\n' "$figure"
    for prefix in "$@"; do
      [[ "${figure##*/}" != "$prefix"* ]] || printf '%s\n' "$figure"
    done
  done
}

# Whether a figure, or a module of Figures/common that it takes, directly or not, uses the Python package.
uses_python_package()
{
  local seen=" " todo=("$1") file module
  while [ ${#todo[@]} -gt 0 ]; do
    file=${todo[0]}
    todo=("${todo[@]:1}")
    while read -r module; do
      [ "$module" != nephoscope ] || return 0
      if [[ "$seen" != *" $module "* && -f "$TOP/Figures/common/$module.py" ]]; then
        seen+="$module "
        todo+=("$TOP/Figures/common/$module.py")
      fi
    done < <(sed -nE 's/^ *(import|from) ([a-z_]+).*/\2/p' "$file")
  done
  return 1
}

# The first picture comes soon: a figure waits only for what it needs, ParaView's plugin, or the Python package as well.
build_for_figure()
{
  if uses_python_package "$1"; then
    build_targets
  else
    build_targets Nephoscope
  fi
}

# Runs one figure; shows its `wrote` lines as they come and checks that these files were written just now.
render_figure()
{
  local figure=$1 name log file status=0
  name=figure-$(basename "$figure" .py)
  log="$LOGS/$name.log"
  touch "$LOGS/figure-started"
  on_virtual_display "${WITH_PRELOAD[@]}" pvbatch "$figure" 2>&1 </dev/null | tee "$log" |
    sed -un 's/^wrote /      wrote /p' >&3 || status=$?
  if [ $status -ne 0 ]; then
    show_failure "$name" $status
    exit 1
  fi
  # VTK reports errors, and goes on: what it draws then is no picture to keep.
  if grep -q ' ERR| ' "$log"; then
    grep ' ERR| ' "$log" | head -n 20 >&2
    fail 1 "$name has reported errors, so its picture may be wrong; the whole log: ${log#"$TOP"/}"
  fi
  grep -q '^wrote ' "$log" || fail 1 "$name wrote nothing; its log: ${log#"$TOP"/}"
  while IFS= read -r file; do
    if [ ! -s "$file" ] || [ "$file" -ot "$LOGS/figure-started" ]; then
      fail 1 "$name says that it wrote $file, but it did not"
    fi
  done < <(sed -n 's/^wrote //p' "$log")
}

# render_film DAYS [ARGUMENT of the figure...]: moving clouds over so many days, in the size of the paper's video.
render_film()
{
  local days=$1 figure="$TOP/Figures/09_moving_clouds.py"
  shift
  step "Build and film of $days days"
  host_environment
  export PYTHONUNBUFFERED=1
  mkdir -p "$NEPHOSCOPE_GALLERY" "$LOGS"
  build_for_figure "$figure"
  ensure_forecast --hours $((24 * days))
  on_virtual_display "${WITH_PRELOAD[@]}" pvbatch "$figure" --no-picture --days "$days" --size 1920 1035 --life 24 "$@" </dev/null ||
    fail 1 "the film is not complete; the same command continues it"
}

# Whether what a figure needs beside the build is there. A figure of weather data draws in the environment of ensure_data; without a network it is left out.
has_its_packages()
{
  grep -q NEPHOSCOPE_VENV "$1" || return 0
  venv_is_current || run_logged venv make_venv || true
  ensure_data
  [ -f "$NEPHOSCOPE_VENV/requirements-data.txt" ] || { note "${1##*/} is left out: it needs the Python packages for weather data"; return 1; }
}

# render_gallery [--films] [FIGURE...] [--data FILE]: films of the figures that are named, or of all with --films; else pictures.
# FILE: what figures of weather data draw in place of the sample.
render_gallery()
{
  export NEPHOSCOPE_FILMS=yes
  if [ "${1:-}" = --films ]; then
    shift
  elif [ $# -eq 0 ]; then
    NEPHOSCOPE_FILMS=no
  fi
  if [ $# -ge 2 ] && [ "${*: -2:1}" = --data ]; then
    NEPHOSCOPE_FIGURE_DATA=$(readlink -f "${*: -1}")
    [ -r "$NEPHOSCOPE_FIGURE_DATA" ] || usage_error "demo --data: no such file: ${*: -1}"
    export NEPHOSCOPE_FIGURE_DATA
    set -- "${@:1:$#-2}"
    [ $# -gt 0 ] || usage_error "demo --data wants the number of a figure of weather data before it"
  fi
  local figure figures
  mapfile -t figures < <(select_figures "$@")
  step "Build and gallery (${#figures[@]} figures)"
  [ ${#figures[@]} -gt 0 ] || fail 1 "no figure to render: Figures/ has none${*:+ whose name begins with $*}"
  host_environment
  export PYTHONUNBUFFERED=1
  mkdir -p "$NEPHOSCOPE_GALLERY" "$LOGS"
  for figure in "${figures[@]}"; do
    say "      ${figure##*/}  ($(elapsed $SECONDS))"
    build_for_figure "$figure"
    has_its_packages "$figure" || continue
    ! grep -q NEPHOSCOPE_FORECAST "$figure" || ensure_forecast
    render_figure "$figure"
  done
}

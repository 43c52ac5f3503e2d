# shellcheck shell=bash
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# The time series of wind and clouds that some figures move: made once, too large to be kept with the sources.
export NEPHOSCOPE_FORECAST="$TOP/build/forecast/gfs_48h.nc"

# The file that arguments of make_forecast.py ask for: each grid and length has its own.
forecast_file()
{
  local grid=gfs hours=
  while [ $# -gt 0 ]; do
    case $1 in
      --grid=* | --hours=*) set -- "${1%%=*}" "${1#*=}" "${@:2}"; continue ;;
      --grid) grid=${2:-} ;;
      --hours) hours=${2:-} ;;
    esac
    shift
  done
  [ -n "$hours" ] || { [ "$grid" = test ] && hours=6; } || hours=48
  printf '%s\n' "$TOP/build/forecast/${grid}_${hours}h.nc"
}

# ensure_forecast [ARGUMENT of make_forecast.py...]: it appears under its name when it is whole; interrupted, it goes on.
ensure_forecast()
{
  NEPHOSCOPE_FORECAST=$(forecast_file "$@")
  if [ -s "$NEPHOSCOPE_FORECAST" ]; then
    say_unless_quiet "      the time series of wind and clouds is there"
    return
  fi
  mkdir -p "$(dirname "$NEPHOSCOPE_FORECAST")"
  say_unless_quiet "      making the time series of wind and clouds"
  run_logged forecast "$SYSTEM_PYTHON" "$TOP/Data/forecast/make_forecast.py" "$NEPHOSCOPE_FORECAST" "$@" ||
    fail 1 "could not make the time series"
}

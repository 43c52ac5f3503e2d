# shellcheck shell=bash
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# The time series of wind and clouds that some figures move: made once, too large to be kept with the sources.
export NEPHOSCOPE_FORECAST="$TOP/build/forecast/gfs_48h.nc"

# ensure_forecast [ARGUMENT of make_forecast.py...]: it appears under its name when it is whole; interrupted, it goes on.
ensure_forecast()
{
  if [ -s "$NEPHOSCOPE_FORECAST" ]; then
    say_unless_quiet "      the time series of wind and clouds is there"
    return
  fi
  mkdir -p "$(dirname "$NEPHOSCOPE_FORECAST")"
  say_unless_quiet "      making the time series of wind and clouds"
  run_logged forecast "$SYSTEM_PYTHON" "$TOP/Data/scripts/make_forecast.py" "$NEPHOSCOPE_FORECAST" "$@" ||
    fail 1 "could not make the time series"
}

# shellcheck shell=bash
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# Numbered steps, elapsed time, and commands whose output goes to a log that is shown when they fail.
LOGS="$TOP/build/logs"
QUIET=no
STEP=0
STEPS=0
exec 3>&1 # where progress is told; the hosts move it to standard error

say() { printf '%s\n' "$*" >&3; }
say_unless_quiet() { [ "$QUIET" = yes ] || say "$@"; }
note() { printf 'nephoscope: %s\n' "$*" >&2; }
elapsed() { printf '%d:%02d' $(($1 / 60)) $(($1 % 60)); }
count_steps() { STEPS=$1; }

# fail STATUS MESSAGE...
fail()
{
  local status=$1
  shift
  note "$@"
  exit "$status"
}

# step TITLE: announces the next numbered step, with the time since the start.
step()
{
  STEP=$((STEP + 1))
  say_unless_quiet "[$STEP/$STEPS] $(elapsed $SECONDS)  $1"
}

finish() { say "$1 Total time $(elapsed $SECONDS)."; }

# While a command runs: once a second on a terminal, every 20 s elsewhere, its time and its log's last line.
# Ends when its standard input does.
heartbeat()
{
  local log=$1 started=$SECONDS interval=20 start='' end='\n' line status
  if [ -t 3 ]; then
    interval=1 start='\r\033[K' end=''
  fi
  while status=0; read -r -t $interval || status=$?; [ $status -gt 128 ]; do # read timed out
    line=$(tail -c 400 "$log" | tr '\r' '\n' | grep . | tail -n 1 | cut -c 1-80)
    # shellcheck disable=SC2059 # start and end are formats
    printf "$start      %s  %s$end" "$(elapsed $((SECONDS - started)))" "$line" >&3
  done
  [ ! -t 3 ] || printf '\r\033[K' >&3
}

# run_logged NAME COMMAND...: output to build/logs/NAME.log, its end shown on failure; returns the status.
run_logged()
{
  local name=$1 log="$LOGS/$1.log" status=0
  shift
  mkdir -p "$LOGS"
  : >"$log"
  exec 8> >(heartbeat "$log" 2>/dev/null)
  local beat=$!
  "$@" >"$log" 2>&1 </dev/null 3>&- 8>&- || status=$?
  exec 8>&-
  wait $beat || true
  [ $status -eq 0 ] || show_failure "$name" $status
  return $status
}

# show_failure NAME STATUS
show_failure()
{
  local log="$LOGS/$1.log"
  tail -n 40 "$log" >&2
  note "$1 failed with exit status $2; the whole log: ${log#"$TOP"/}"
}

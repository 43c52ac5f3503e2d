# shellcheck shell=bash
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# Which tests `./nephoscope test` runs.
LONG_TESTS="$TOP/Testing/long_tests.txt"

long_tests() { grep -v -e '^#' -e '^$' "$LONG_TESTS"; }

# choose_tests [--all] [CTEST-ARG...]: sets CHOSEN to arguments of ctest. Without any, the long tests are left out.
choose_tests()
{
  if [ $# -eq 0 ]; then
    CHOSEN=(-E "^($(long_tests | paste -s -d '|'))\$")
    return
  fi
  [ "$1" != --all ] || shift
  CHOSEN=("$@")
}

report_left_out()
{
  [ "${CHOSEN[0]:-}" != -E ] || say "      without $(long_tests | wc -l) long tests, which ./nephoscope test --all runs too"
}

# Repeats the last lines of every test that failed, so that the end of the output has the reasons. `ctest --output-on-failure` prints
# the whole output among that of the tests that ran beside it.
report_failures()
{
  local log="$BUILD/Testing/Temporary/LastTest.log"
  [ -f "$log" ] || return 0
  awk '
    / Testing: / { name = $NF; lines = 0 }
    /^<end of output>$/ { reading = 0 }
    reading && !/^-+$/ { line[lines++] = $0 }
    /^Output:$/ { reading = 1 }
    /^Test (Failed|Fail Reason|Timeout)/ {
      printf "\n      %s failed. Its last lines:\n", name
      for (i = lines > 25 ? lines - 25 : 0; i < lines; ++i) print "      | " line[i]
    }' "$log" >&2
}

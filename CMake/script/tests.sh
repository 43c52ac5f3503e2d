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

# shellcheck shell=bash
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# The documentation as a site, by Sphinx: Documentation/site has its settings and what makes pages of figures, headers and docstrings.
SITE="$TOP/build/docs"

# sphinx BUILDER ARGUMENT...: a warning is an error, and does not keep others from being told; nothing else is.
sphinx()
{
  local builder=$1
  shift
  "$SYSTEM_PYTHON" -m sphinx -q -b "$builder" -W --keep-going -c "$TOP/Documentation/site" -d "$SITE/doctrees" "$SITE/source" "$SITE/$builder" "$@"
}

# From nothing each time: else Sphinx tells of pages that have changed only.
make_site()
{
  rm -rf "$SITE"
  "$SYSTEM_PYTHON" "$TOP/Documentation/site/sources.py" "$SITE/source" && sphinx html &&
    "$SYSTEM_PYTHON" "$TOP/Documentation/site/check.py" "$SITE/html"
}

build_site()
{
  step "Site"
  run_logged docs make_site || fail 1 "could not make the site"
}

check_links()
{
  step "Links to other sites"
  run_logged docs-links sphinx linkcheck || fail 1 "there are links that lead nowhere"
}

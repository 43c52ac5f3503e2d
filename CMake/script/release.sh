# shellcheck shell=bash
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# All files of a release, in dist/: source distribution, wheels, Debian packages, documentation, checksums.
RELEASE_PYTHONS=(3.11 3.13 3.14) # of these Debian has the headers
# shellcheck disable=SC2034 # read by the verb
RELEASE_PARTS=(sdist wheels debs docs)

# The version stands in CMakeLists.txt; CITATION.cff repeats it.
release_version() { sed -nE 's/^project\(Nephoscope VERSION ([0-9.]+) .*/\1/p' "$TOP/CMakeLists.txt"; }

# A draft is of any tree; a release has its own section in the changelog, and nothing that is not committed.
check_release()
{
  local version=$1
  grep -qx "version: $version" "$TOP/CITATION.cff" || fail 1 "CITATION.cff is not of version $version"
  [ "$DRAFT" = no ] || return 0
  grep -qE "^## \[$version\] - [0-9]{4}-[0-9]{2}-[0-9]{2}$" "$TOP/CHANGELOG.md" ||
    fail 1 "CHANGELOG.md has no section [$version] with its date: give [Unreleased] that name, or make a draft: release --draft"
  [ -z "$(git -C "$TOP" status --porcelain 2>/dev/null)" ] ||
    fail 1 "there are changes that are not committed: commit them, or make a draft: release --draft"
}

release_sdist() { "$TOP/nephoscope" wheel --sdist; }

release_wheels()
{
  local python arguments=()
  for python in "${RELEASE_PYTHONS[@]}"; do
    arguments+=(--python "$python")
  done
  "$TOP/nephoscope" wheel "${arguments[@]}"
}

release_debs()
{
  local release
  for release in "${ROOT_RELEASES[@]}"; do
    "$TOP/nephoscope" --root "$release" package --test || return
  done
}

release_docs()
{
  "$TOP/nephoscope" docs && tar -C "$TOP/build/docs" -czf "$TOP/dist/nephoscope-$1-docs.tar.gz" --transform "s,^html,nephoscope-$1-docs," html
}

# write_checksums VERSION: of that version's files.
write_checksums()
{
  (cd "$TOP/dist" && find . -maxdepth 1 -type f \( -name "nephoscope[-_]$1*" -o -name "nephoscope-paraview_$1*" \) -printf '%f\n' | sort |
    xargs sha256sum >SHA256SUMS)
}

# make_release PART...
make_release()
{
  local version part
  version=$(release_version)
  check_release "$version"
  mkdir -p "$TOP/dist"
  for part in "$@"; do
    step "Release $version: $part"
    "release_$part" "$version" || fail 1 "could not make the $part of the release"
  done
  step "Checksums"
  write_checksums "$version"
  sed 's/^/      /' "$TOP/dist/SHA256SUMS"
}

# shellcheck shell=bash
# SPDX-FileCopyrightText: The Nephoscope authors
# SPDX-License-Identifier: BSD-3-Clause
# A verb on another release of Debian: in a bare root of that release, with a copy of the tree and nothing else of this system
# but its network. The root is kept, outside the source tree, with its packages and its build, until --fresh.
ROOTS="${NEPHOSCOPE_ROOTS:-${XDG_CACHE_HOME:-${HOME:-}/.cache}/nephoscope/roots}"
ROOT_RELEASES=(bookworm trixie forky)

# Prints the mirrors of Debian that this system's package lists name, as `archive URI` and `security URI`.
debian_mirrors()
{
  command -v apt-get >/dev/null || return 0
  # shellcheck disable=SC2016 # expanded by apt-get
  apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 2>/dev/null |
    sed -nE 's#^(.*/debian)/?$#archive \1#p; s#^(.*/debian-security)/?$#security \1#p' | sort -u
}

# What the root's apt takes over from this system's: its proxies, and whether it looks at dates.
apt_settings()
{
  command -v apt-config >/dev/null || return 0
  apt-config dump | grep -E '^Acquire::(Check-(Date|Valid-Until)|https?::Proxy[^ ]*) ".+";$' || true
}

# bootstrap FOLDER RELEASE MIRROR
bootstrap()
{
  local folder=$1 release=$2 mirror=$3 scripts=/usr/share/debootstrap/scripts script=()
  if ! command -v debootstrap >/dev/null; then
    "${AS_ROOT[@]}" mmdebstrap --variant=apt --include=ca-certificates "$release" "$folder" "$mirror"
    return
  fi
  # A debootstrap older than the release makes it as it makes the one in development.
  [ -e "$scripts/$release" ] || [ ! -e "$scripts/sid" ] || script=("$scripts/sid")
  "${AS_ROOT[@]}" debootstrap --variant=minbase --include=ca-certificates "$release" "$folder" "$mirror" "${script[@]}"
}

write_in_root() { "${AS_ROOT[@]}" tee "$ROOT/$1" >/dev/null; }

# write_apt_sources ARCHIVE SECURITY: the release's own packages and its security updates, as its installer sets them.
write_apt_sources()
{
  printf 'deb %s %s main\n' "$1" "$RELEASE" "$2" "$RELEASE-security" | write_in_root etc/apt/sources.list
  apt_settings | write_in_root etc/apt/apt.conf.d/50host
}

# Makes $ROOT, a bare root of $RELEASE; it appears under its name when it is whole.
make_root()
{
  local partial="$ROOT.partial" mirrors archive security
  mirrors=$(debian_mirrors)
  archive=$(sed -n 's/^archive //p' <<<"$mirrors" | head -n 1)
  security=$(sed -n 's/^security //p' <<<"$mirrors" | head -n 1)
  : "${archive:=http://deb.debian.org/debian}" "${security:=http://security.debian.org/debian-security}" # Debian's defaults
  command -v debootstrap >/dev/null || command -v mmdebstrap >/dev/null ||
    fail 3 "making a root of Debian needs debootstrap or mmdebstrap. Remedy, as root: apt-get install debootstrap"
  say "      making a bare root of Debian $RELEASE"
  "${AS_ROOT[@]}" rm -rf "$partial"
  mkdir -p "$ROOTS"
  run_logged "root-$RELEASE" bootstrap "$partial" "$RELEASE" "$archive" ||
    fail 3 "could not make a root of Debian $RELEASE in $ROOTS"
  "${AS_ROOT[@]}" mv "$partial" "$ROOT"
  write_apt_sources "$archive" "$security"
  printf '#!/bin/sh\nexit 101\n' | write_in_root usr/sbin/policy-rc.d # packages start no service
  "${AS_ROOT[@]}" chmod +x "$ROOT/usr/sbin/policy-rc.d"
}

# Prints the files of the tree, each ended by a zero byte: what git has or does not ignore; without git, all but what is built.
tree_files()
{
  if [ "$(git -C "$TOP" rev-parse --show-toplevel 2>/dev/null)" = "$TOP" ]; then
    git -C "$TOP" ls-files -z --cached --others --exclude-standard |
      while IFS= read -r -d '' file; do [ ! -e "$TOP/$file" ] || printf '%s\0' "$file"; done
  else
    (cd "$TOP" && find . \( -path './build*' -o -path ./Gallery -o -path ./dist -o -name __pycache__ -o -path ./.git \) -prune -o ! -type d -print0)
  fi
}

# keep_times OLD NEW: files of NEW that are as in OLD get their time there.
keep_times()
{
  # shellcheck disable=SC2016 # expanded by the inner shell
  "${AS_ROOT[@]}" bash -c 'cd "$2" && find . -type f -print0 | while IFS= read -r -d "" file; do
    ! cmp -s "$1/$file" "$file" || touch -r "$1/$file" "$file"
  done' bash "$1" "$2"
}

# The tree as it is now, in place of the earlier copy; what the root has built stays. A build looks at times: what differs from the earlier
# copy is of now, whatever its time is here, where branches are changed.
copy_tree_to_root()
{
  local copy="$ROOT/nephoscope" new="$ROOT/nephoscope.new"
  "${AS_ROOT[@]}" rm -rf "$new"
  "${AS_ROOT[@]}" mkdir -p "$copy" "$new"
  tree_files | tar -C "$TOP" --null --no-recursion -T - -cf - | "${AS_ROOT[@]}" tar -C "$new" --no-same-owner -xmf -
  keep_times "$copy" "$new"
  "${AS_ROOT[@]}" find "$copy" -mindepth 1 -maxdepth 1 ! -name build ! -name dist ! -name Gallery -exec rm -rf {} +
  "${AS_ROOT[@]}" find "$new" -mindepth 1 -maxdepth 1 -exec mv -t "$copy" {} +
  "${AS_ROOT[@]}" rmdir "$new"
}

# Names, proxies and certificates by which this system reaches the network. Sets NETWORK to words for `env`.
give_network_to_root()
{
  NETWORK=()
  local name certificates=${PIP_CERT:-${SSL_CERT_FILE:-}}
  for name in resolv.conf hosts; do
    [ ! -e "/etc/$name" ] || "${AS_ROOT[@]}" cp -L --remove-destination "/etc/$name" "$ROOT/etc/$name"
  done
  for name in http_proxy https_proxy no_proxy PIP_INDEX_URL PIP_EXTRA_INDEX_URL; do
    [ -z "${!name:-}" ] || NETWORK+=("$name=${!name}")
  done
  if [ -f "$certificates" ]; then
    "${AS_ROOT[@]}" cp -L "$certificates" "$ROOT/etc/ssl/host-certificates.pem"
    NETWORK+=(PIP_CERT=/etc/ssl/host-certificates.pem)
  fi
}

# Runs the script in the root. The mounts are in a namespace of their own and end with it, however it ends. The folder for temporary files is
# this system's: the numbers of virtual displays are taken there, and the displays of both systems share the network.
run_in_root()
{
  # shellcheck disable=SC2016 # expanded by the inner shells
  "${AS_ROOT[@]}" unshare --mount --propagation private bash -c '
    set -e
    root=$1
    shift
    for folder in proc sys dev tmp; do
      mkdir -p "$root/$folder"
      mount --rbind "/$folder" "$root/$folder"
    done
    exec chroot "$root" "$@"' root "$ROOT" \
    /usr/bin/env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 "TERM=${TERM:-dumb}" "${NETWORK[@]}" \
    bash -c 'cd /nephoscope && exec ./nephoscope "$@"' nephoscope "$@"
}

# keep_made VERB: the files that the verb is there to make, here too.
keep_made()
{
  [[ "$1" =~ ^(wheel|package)$ ]] || return 0
  mkdir -p "$TOP/dist"
  find "$ROOT/nephoscope/dist" -maxdepth 1 -type f -exec cp -t "$TOP/dist" {} +
}

# in_root RELEASE VERB [ARGUMENT...]
in_root()
{
  RELEASE=$1
  shift
  [[ " ${ROOT_RELEASES[*]} " == *" $RELEASE "* ]] || usage_error "--root wants one of: ${ROOT_RELEASES[*]}"
  [[ "$ROOTS" == /* ]] || usage_error "NEPHOSCOPE_ROOTS, XDG_CACHE_HOME or HOME must be an absolute path"
  [[ "$(readlink -m "$ROOTS")/" != "$TOP/"* ]] || usage_error "NEPHOSCOPE_ROOTS must be outside the source tree"
  ROOT="$ROOTS/$RELEASE"
  find_root || fail 3 "--root needs root rights: it makes a system in $ROOT and enters it. Run it as root, or with sudo set up"
  "${AS_ROOT[@]}" unshare --mount true 2>/dev/null || fail 3 "--root must be allowed to mount folders; here it is not"
  say "Debian $RELEASE in $ROOT"
  [ "$FRESH" = no ] || "${AS_ROOT[@]}" rm -rf "$ROOT"
  [ -d "$ROOT" ] || make_root
  copy_tree_to_root
  give_network_to_root
  local status=0 options=(--preset "$PRESET")
  [ "$INSTALL" = yes ] || options+=(--no-install)
  say "      running there, after $(elapsed $SECONDS): ./nephoscope $*"
  run_in_root "${options[@]}" "$@" || status=$?
  [ $status -eq 0 ] || fail $status "on Debian $RELEASE: exit status $status; its tree with build/logs is $ROOT/nephoscope"
  keep_made "$1"
  finish "Done on Debian $RELEASE; its tree is $ROOT/nephoscope."
}

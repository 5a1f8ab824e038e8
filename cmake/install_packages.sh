# Copyright (c) 2026 The authors of Geodesic_processing.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# To be sourced.  install_packages NAME... installs the Debian packages that are missing, or says in
# a sentence why it cannot and returns 1.

missing_packages()
{
  local package
  for package in "$@"; do
    [ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" = installed ] ||
      printf '%s ' "$package"
  done
}

install_packages()
{
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    echo "This script installs what is missing with apt-get, which this system does not have;" \
         "install these Debian packages' counterparts yourself and call cmake: $*" >&2
    return 1
  fi

  local missing
  missing=$(missing_packages "$@")
  [ -n "$missing" ] || return 0

  local -a as_root=()
  if [ "$(id -u)" -ne 0 ]; then
    if ! command -v sudo >/dev/null || ! { sudo -n true 2>/dev/null || { [ -t 0 ] && sudo -v; }; }
    then
      echo "Packages are missing and can be installed only by root or through sudo; ask your" \
           "administrator for: apt-get install $missing" >&2
      return 1
    fi
    as_root=(sudo)
  fi

  echo "Installing $missing"
  local log
  log=$(mktemp)
  # Package names hold no blanks: $missing is meant to be split.
  if ! { "${as_root[@]}" apt-get update &&
         "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
           apt-get install --yes --no-install-recommends $missing; } >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    rm -f "$log"
    echo "apt-get could not install $missing(its last words are above); this script is made for" \
         "Debian 12." >&2
    return 1
  fi
  rm -f "$log"
}
